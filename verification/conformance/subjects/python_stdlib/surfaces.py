# SPDX-License-Identifier: Apache-2.0
"""Rough faces, bodies that adhere, and the shear stress below a contact: pure functions, SI units."""

import math


def plasticity_index(E, hardness, height_sd, radius):
    return E / hardness * math.sqrt(height_sd / radius)


def kogut_etsion_load(interference):
    factor, power = (1, 1.5) if interference < 1 else (1.03, 1.425) if interference < 6 else (1.4, 1.263)
    return factor * interference**power


def persson_contact_area(pressure, E, gradient):
    return math.erf(math.sqrt(2) * pressure / (E * gradient))


def patir_cheng_pressure_flow(film_ratio):
    return 1 - 0.9 * math.exp(-0.56 * film_ratio)


def lambda_ratio(film, first, second):
    rough = math.hypot(first, second)
    return {"composite_roughness": rough, "lambda_ratio": film / rough}


def jkr_radius(load, work, E, R):
    pull = 3 * math.pi * work * R
    return math.cbrt(3 * R / (4 * E) * (load + pull + math.sqrt(pull * (2 * load + pull))))


def pull_off_force(theory, work, R):
    return {"jkr": 1.5, "dmt": 2}[theory] * math.pi * work * R


def subsurface_shear(pressure, radius, depth, nu):
    zeta = depth / radius
    arc = zeta * (math.pi / 2 - math.atan(zeta))
    return pressure / 2 * (1.5 / (1 + zeta**2) - (1 + nu) * (1 - arc))
