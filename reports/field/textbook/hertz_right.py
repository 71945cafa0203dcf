# SPDX-License-Identifier: Apache-2.0
"""Hertz' point and line as K. L. Johnson prints them, with E* and the reduced radius."""

from math import pi, sqrt


def effective_modulus(first_modulus, first_poisson_ratio, second_modulus, second_poisson_ratio):
    return 1 / ((1 - first_poisson_ratio**2) / first_modulus + (1 - second_poisson_ratio**2) / second_modulus)


def hertz_point(load, effective_modulus, reduced_radius):
    a = (3 * load * reduced_radius / (4 * effective_modulus)) ** (1 / 3)
    mean = load / (pi * a**2)
    return {"radius": a, "mean_pressure": mean, "peak_pressure": 1.5 * mean, "approach": a**2 / reduced_radius}


def hertz_line(load_per_length, effective_modulus, reduced_radius):
    b = sqrt(4 * load_per_length * reduced_radius / (pi * effective_modulus))
    peak = 2 * load_per_length / (pi * b)
    return {"half_width": b, "mean_pressure": pi / 4 * peak, "peak_pressure": peak}
