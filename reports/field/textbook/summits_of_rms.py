# SPDX-License-Identifier: Apache-2.0
"""Summits by J. I. McCool (1987), with the rms height of the face for the summits' standard deviation."""

from math import pi, sqrt


def summits_from_spectral_moments(m0, m2, m4):
    bandwidth = m0 * m4 / m2**2
    return {"bandwidth": bandwidth, "summit_density": m4 / m2 / (6 * pi * sqrt(3)),
            "summit_radius": 3 / 8 * sqrt(pi / m4), "summit_height_sd": sqrt(m0)}


def lambda_ratio(minimum_film, first_roughness, second_roughness):
    rms = sqrt(first_roughness**2 + second_roughness**2)
    return {"composite_roughness": rms, "lambda_ratio": minimum_film / rms}
