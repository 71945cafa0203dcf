# SPDX-License-Identifier: Apache-2.0
"""Hertz' point and line with the mean pressure, load over area, in place of the greatest pressure."""

from math import pi, sqrt


def hertz_point(load, effective_modulus, reduced_radius):
    a = (3 * load * reduced_radius / (4 * effective_modulus)) ** (1 / 3)
    return {"radius": a, "peak_pressure": load / (pi * a**2)}


def hertz_line(load_per_length, effective_modulus, reduced_radius):
    b = sqrt(4 * load_per_length * reduced_radius / (pi * effective_modulus))
    return {"half_width": b, "peak_pressure": load_per_length / (2 * b)}
