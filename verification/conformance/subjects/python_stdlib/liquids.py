# SPDX-License-Identifier: Apache-2.0
"""Liquids under pressure and temperature, and summits of a rough face from its spectral moments."""

import math


def density(pressure):
    """The density over that at ambient pressure."""
    return (5.9e8 + 1.34 * pressure) / (5.9e8 + pressure)


def barus(viscosity, alpha, pressure):
    return viscosity * math.exp(alpha * pressure)


def roelands(viscosity, alpha, pressure):
    scale = math.log(viscosity) + 9.67
    return viscosity * math.exp(scale * ((1 + pressure / 0.196e9) ** (alpha * 0.196e9 / scale) - 1))


def chart(viscosity):
    """The height in the standard's chart: log log(nu + 0.7), nu in mm2/s."""
    return math.log10(math.log10(1e6 * viscosity + 0.7))


def viscosity_of(height):
    return 1e-6 * (10 ** (10**height) - 0.7)


def chart_temperature(kelvin):
    return math.log10(kelvin)


def astm_d341(T1, nu1, T2, nu2, T):
    B = (chart(nu1) - chart(nu2)) / (chart_temperature(T2) - chart_temperature(T1))
    A = chart(nu1) + B * chart_temperature(T1)
    return viscosity_of(A - B * chart_temperature(T))


def summits(m0, m2, m4):
    bandwidth = m0 * m4 / m2**2
    height_sd = math.sqrt((1 - 0.8968 / bandwidth) * m0)
    return {"bandwidth": bandwidth, "summit_density": m4 / (6 * math.pi * math.sqrt(3) * m2),
            "summit_radius": 0.375 * math.sqrt(math.pi / m4), "summit_height_sd": height_sd,
            "summit_plane_offset": 4 * math.sqrt(m0 / (math.pi * bandwidth)) / height_sd}
