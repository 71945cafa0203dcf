# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the effective modulus and in the reduced radius of two bodies."""

import math

from catalogue import replaces
import solver

MODULUS, RADIUS = "effective_modulus", "reduced_radius"


# Effective modulus

@replaces(solver, "effective_modulus", MODULUS, "E' = 2E* for E*: 2/E' is the sum of (1-nu^2)/E")
def bodies_modulus_doubled(right, E1, nu1, E2, nu2):
    return 2 / ((1 - nu1**2) / E1 + (1 - nu2**2) / E2)


@replaces(solver, "effective_modulus", MODULUS, "half of E*")
def bodies_modulus_halved(right, *bodies):
    return right(*bodies) / 2


@replaces(solver, "plane_strain_modulus", MODULUS, "E for E/(1-nu^2) of each body")
def bodies_modulus_without_poisson(right, E, nu):
    return E


@replaces(solver, "plane_strain_modulus", MODULUS, "E/(1-nu) for E/(1-nu^2) of each body")
def bodies_modulus_one_minus_nu(right, E, nu):
    return E / (1 - nu)


@replaces(solver, "effective_modulus", MODULUS, "the first body alone, the second one as if rigid")
def bodies_modulus_of_first(right, E1, nu1, E2, nu2):
    return E1 / (1 - nu1**2)


@replaces(solver, "effective_modulus", MODULUS, "E/(2(1-nu^2)) of the first body, as if both were alike")
def bodies_modulus_of_alike(right, E1, nu1, E2, nu2):
    return E1 / (2 * (1 - nu1**2))


@replaces(solver, "effective_modulus", MODULUS, "Poisson's ratio of the first body for both")
def bodies_modulus_one_poisson(right, E1, nu1, E2, nu2):
    return E1 * E2 / (E1 + E2) / (1 - nu1**2)


@replaces(solver, "effective_modulus", MODULUS, "mean of E/(1-nu^2) of the two bodies")
def bodies_modulus_mean(right, E1, nu1, E2, nu2):
    return (E1 / (1 - nu1**2) + E2 / (1 - nu2**2)) / 2


@replaces(solver, "effective_modulus", MODULUS, "E* in GPa, all else in SI")
def bodies_modulus_in_gpa(right, *bodies):
    return right(*bodies) / 1e9


# Reduced radius

@replaces(solver, "radius_of_gap", RADIUS, "R1 R2/(R2 - R1) for R1 R2/(R1 + R2), a concave face has the wrong sign")
def bodies_radius_difference(right, R1, R2):
    return 1 / (1 / R1 - 1 / R2) if R1 != R2 else math.inf


@replaces(solver, "radius_of_gap", RADIUS, "sign of a concave face ignored")
def bodies_radius_without_sign(right, R1, R2):
    return right(abs(R1), abs(R2))


@replaces(solver, "radius_of_gap", RADIUS, "sum of the radii for R1 R2/(R1 + R2)")
def bodies_radius_sum(right, R1, R2):
    return R1 + R2


@replaces(solver, "radius_of_gap", RADIUS, "mean of the radii for R1 R2/(R1 + R2)")
def bodies_radius_mean(right, R1, R2):
    return (R1 + R2) / 2


@replaces(solver, "radius_of_gap", RADIUS, "2 R1 R2/(R1 + R2), the harmonic mean of the radii")
def bodies_radius_harmonic_mean(right, R1, R2):
    return 2 / (1 / R1 + 1 / R2)


@replaces(solver, "radius_of_gap", RADIUS, "radius of the first face alone, the second one as if flat")
def bodies_radius_of_first(right, R1, R2):
    return R1


@replaces(solver, "reduced_radius", RADIUS, "R_x and R_y exchanged")
def bodies_radius_exchanged(right, R1x, R2x, R1y, R2y):
    return right(R1y, R2y, R1x, R2x)


@replaces(solver, "sum_of_curvatures", RADIUS, "mean curvature (1/R_x + 1/R_y)/2 for the sum in R")
def bodies_radius_of_mean_curvature(right, Rx, Ry):
    return (Rx + Ry) / (2 * Rx * Ry)


@replaces(solver, "sum_of_curvatures", RADIUS, "sqrt(R_x R_y) for R")
def bodies_radius_geometric_mean(right, Rx, Ry):
    return 1 / math.sqrt(Rx) / math.sqrt(Ry)


@replaces(solver, "reduced_radius", RADIUS, "radii in mm, all else in SI")
def bodies_radius_in_mm(right, *radii):
    return right(*(1000 * radius for radius in radii))
