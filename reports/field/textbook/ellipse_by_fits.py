# SPDX-License-Identifier: Apache-2.0
"""Hertz' ellipse by the fits of D. E. Brewe and B. J. Hamrock (1977) in place of the elliptic integrals."""

from math import log, pi


def hertz_ellipse(load, effective_modulus, radius_x, radius_y):
    swap = radius_x > radius_y  # the fits are for R_y above R_x
    small, large = sorted((radius_x, radius_y))
    ratio, R = large / small, 1 / (1 / small + 1 / large)
    k, E, K = 1.0339 * ratio**0.636, 1.0003 + 0.5968 / ratio, 1.5277 + 0.6023 * log(ratio)
    major = (3 * k**2 * E * load * R / (pi * effective_modulus)) ** (1 / 3)
    minor, mean = major / k, load * k / (pi * major**2)
    approach = K * (9 / (8 * E * R) * (load / (pi * k * effective_modulus)) ** 2) ** (1 / 3)
    x, y = (major, minor) if swap else (minor, major)
    return {"semi_axis_x": x, "semi_axis_y": y, "ellipticity": y / x, "mean_pressure": mean,
            "peak_pressure": 1.5 * mean, "approach": approach}
