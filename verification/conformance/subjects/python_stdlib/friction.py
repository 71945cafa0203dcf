# SPDX-License-Identifier: Apache-2.0
"""Friction: boundary friction of the asperities, and shear of the film between them."""

import math

ROELANDS_PRESSURE = 0.196e9  # Pa
ROELANDS_LOG_VISCOSITY = 9.67  # is added to ln of the viscosity in Pa s


def log_thickening(law, viscosity, alpha, pressure):
    """ln of the ratio of the viscosity at this pressure to the viscosity at ambient pressure."""
    if law == "ambient":
        return 0.0
    if law == "barus":
        return alpha * pressure
    scale = math.log(viscosity) + ROELANDS_LOG_VISCOSITY
    z = alpha * ROELANDS_PRESSURE / scale
    return scale * math.expm1(z * math.log1p(pressure / ROELANDS_PRESSURE))


def shear_rate(speed, slide_roll_ratio, separation):
    return slide_roll_ratio * speed / separation


def reduced_stress(law, log_x):
    """The shear stress divided by tau, the limiting or Eyring stress; log_x is ln(viscosity * rate / tau)."""
    if law == "limiting":
        return -math.expm1(-math.exp(min(log_x, 10)))
    return math.asinh(math.exp(log_x)) if log_x < 40 else math.log(2) + log_x


def shear_stress(law, stress, viscosity, log_ratio, rate):
    if rate == 0:
        return 0.0
    log_x = math.log(viscosity) - math.log(stress) + math.log(rate) + log_ratio
    return stress * reduced_stress(law, log_x)


def sheared_part(area_ratio):
    """The fraction of the nominal area that the film covers."""
    return max(0.0, 1 - area_ratio)


def boundary_friction(coefficient, asperity_share):
    return coefficient * asperity_share


def friction(point, mean_pressure):
    """The friction coefficient. `point` has the fields of friction and lubricant, the speed, separation, load shares and real area ratio."""
    pressure = point["fluid_share"] * mean_pressure
    log_ratio = log_thickening(point["viscosity_law"], point["viscosity"], point["alpha"], pressure)
    rate = shear_rate(point["speed"], point["slide_roll_ratio"], point["separation"])
    stress = shear_stress(point["fluid"], point["eyring_stress"], point["viscosity"], log_ratio, rate)
    return (boundary_friction(point["boundary_coefficient"], point["asperity_share"])
            + stress * sheared_part(point["area_ratio"]) / mean_pressure)
