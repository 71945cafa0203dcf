# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the starved inlet and in friction."""

import math

from catalogue import replaces
import friction
import inlet

INLET, POINT = "starvation_ratio", "operating_point"


# Starved inlet

@replaces(inlet, "starved", INLET, "Wolveridge's ratio taken as h*/h_oil instead of h*/h_ff")
def inlet_ratio_to_oil(right, closure, r, exponent):
    ratio, deficit = right(closure, r, exponent)
    if closure == "damiens":
        return ratio, deficit
    return ratio / r, 1 - ratio / r


@replaces(inlet, "crook_constant", INLET, "the gap of a circular contact for Crook's of a line contact")
def inlet_circular_gap(right):
    return right() * math.pi / 4


@replaces(inlet, "starved", INLET, "the exponents as printed (printed_exponents) for flooded_inlet")
def inlet_printed_exponents(right, closure, r, exponent):
    return right("printed_exponents" if closure == "flooded_inlet" else closure, r, exponent)


# Friction

@replaces(friction, "log_thickening", POINT, "viscosity at ambient pressure for Barus' law")
def friction_viscosity_ambient(right, law, *given):
    return right("ambient" if law == "barus" else law, *given)


@replaces(friction, "log_thickening", POINT, "log10 for ln of the viscosity in Roelands' law")
def friction_roelands_log10(right, law, viscosity, alpha, pressure):
    if law != "roelands":
        return right(law, viscosity, alpha, pressure)
    scale = math.log10(viscosity) + friction.ROELANDS_LOG_VISCOSITY
    z = alpha * friction.ROELANDS_PRESSURE / scale
    return scale * ((1 + pressure / friction.ROELANDS_PRESSURE) ** z - 1)


@replaces(friction, "reduced_stress", POINT, "limiting shear stress for Eyring's law")
def friction_limiting_for_eyring(right, law, log_x):
    return right("limiting", log_x)


@replaces(friction, "shear_rate", POINT, "slide-roll ratio ignored: sliding speed u for S u")
def friction_slide_roll_ignored(right, speed, slide_roll_ratio, separation):
    return right(speed, 1.0, separation)


@replaces(friction, "boundary_friction", POINT, "mu_b (1-A) for mu_b A in friction")
def friction_boundary_by_fluid_share(right, coefficient, asperity_share):
    return right(coefficient, 1 - asperity_share)


@replaces(friction, "sheared_part", POINT, "real area of contact not subtracted from the sheared area")
def friction_area_not_subtracted(right, area_ratio):
    return 1.0
