# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the Hertz contact and in the flooded film."""

import math

from catalogue import replaces
import solver

HERTZ, FILM = "hertz_point", "hamrock_dowson_central"


# Hertz

@replaces(solver, "hertz_point", HERTZ, "2E* for E* in the Hertz contact")
def hertz_modulus_doubled(right, F, E, R):
    return right(F, 2 * E, R)


@replaces(solver, "hertz_point", HERTZ, "E*/2 for E* in the Hertz contact, as if 2E* had been given")
def hertz_modulus_halved(right, F, E, R):
    return right(F, E / 2, R)


@replaces(solver, "approach", HERTZ, "2E* for E* in the approach alone")
def hertz_approach_modulus_doubled(right, F, E, R):
    return right(F, 2 * E, R)


@replaces(solver, "hertz_point", HERTZ, "R/2 for R in the Hertz contact of a ball on a flat")
def hertz_half_radius(right, F, E, R):
    return right(F, E, R / 2)


@replaces(solver, "hertz_point", HERTZ, "R in mm in the Hertz contact, all else in SI")
def hertz_radius_in_mm(right, F, E, R):
    return right(F, E, 1000 * R)


@replaces(solver, "nominal_area", HERTZ, "nominal area a^2, without pi")
def hertz_area_without_pi(right, radius):
    return radius * radius


@replaces(solver, "peak_over_mean_pressure", HERTZ, "peak pressure equal to the mean pressure, without 3/2")
def hertz_peak_without_3_2(right):
    return 1.0


# Film

@replaces(solver, "hamrock_dowson_central", FILM, "R/2 for R in the film of a ball on a flat")
def film_half_radius(right, speed, viscosity, alpha, F, E, R, k):
    return right(speed, viscosity, alpha, F, E, R / 2, k)


@replaces(solver, "hamrock_dowson_central", FILM, "R in mm in the film, all else in SI")
def film_radius_in_mm(right, speed, viscosity, alpha, F, E, R, k):
    return right(speed, viscosity, alpha, F, E, 1000 * R, k)


@replaces(solver, "hamrock_dowson_central", FILM, "sum of the surface speeds for their mean in the film")
def film_speed_sum(right, speed, viscosity, alpha, F, E, R, k):
    return right(2 * speed, viscosity, alpha, F, E, R, k)


@replaces(solver, "film_numbers", FILM, "E* for 2E* in U of the film")
def film_modulus_in_speed(right, *given):
    U, G, W = right(*given)
    return 2 * U, G, W


@replaces(solver, "film_numbers", FILM, "E* for 2E* in G of the film")
def film_modulus_in_material(right, *given):
    U, G, W = right(*given)
    return U, G / 2, W


@replaces(solver, "film_numbers", FILM, "E* for 2E* in W of the film")
def film_modulus_in_load(right, *given):
    U, G, W = right(*given)
    return U, G, 2 * W


@replaces(solver, "film_numbers", FILM, "E* for 2E* in U, G and W of the film")
def film_modulus_single(right, speed, viscosity, alpha, F, E, R):
    return right(speed, viscosity, alpha, F, E / 2, R)


@replaces(solver, "film_numbers", FILM, "4E* for 2E* in U, G and W of the film")
def film_modulus_doubled(right, speed, viscosity, alpha, F, E, R):
    return right(speed, viscosity, alpha, F, 2 * E, R)


@replaces(solver, "film_constant", FILM, "0.6 for 0.61 in the film constant")
def film_constant_0_6(right, k):
    return 2.69 - (2.69 - right(k)) * 0.6 / 0.61


@replaces(solver, "film_constant", FILM, "film constant 2.69, its bracket dropped")
def film_constant_without_bracket(right, k):
    return 2.69


@replaces(solver, "hamrock_dowson_central", FILM,
          "minimum film 3.63 U^0.68 G^0.49 W^-0.073 (1 - exp(-0.68k)) for the central one")
def film_minimum(right, speed, viscosity, alpha, F, E, R, k):
    U, G, W = solver.film_numbers(speed, viscosity, alpha, F, E, R)
    return R * 3.63 * U**0.68 * G**0.49 * W**-0.073 * -math.expm1(-0.68 * k)
