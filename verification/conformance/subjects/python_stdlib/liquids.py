# SPDX-License-Identifier: Apache-2.0
"""Computes densities and viscosities of liquids, and the summits of a rough face from its spectral moments."""

import math


def density(pressure):
    """The density divided by the density at ambient pressure."""
    return (5.9e8 + 1.34 * pressure) / (5.9e8 + pressure)


def barus(viscosity, alpha, pressure):
    return viscosity * math.exp(alpha * pressure)


def roelands(viscosity, alpha, pressure):
    scale = math.log(viscosity) + 9.67
    return viscosity * math.exp(scale * ((1 + pressure / 0.196e9) ** (alpha * 0.196e9 / scale) - 1))


def carreau_yasuda(rest, high, time, rate, a, n):
    return high + (rest - high) * (1 + (time * rate) ** a) ** ((n - 1) / a)


def chart(viscosity):
    """The height of a viscosity in the chart of ASTM D341: log log(nu + 0.7), nu in mm2/s."""
    return math.log10(math.log10(1e6 * viscosity + 0.7))


def viscosity_of(height):
    return 1e-6 * (10 ** (10**height) - 0.7)


def chart_temperature(kelvin):
    return math.log10(kelvin)


def astm_d341(T1, nu1, T2, nu2, T):
    B = (chart(nu1) - chart(nu2)) / (chart_temperature(T2) - chart_temperature(T1))
    A = chart(nu1) + B * chart_temperature(T1)
    return viscosity_of(A - B * chart_temperature(T))


# Each row has its greatest viscosity at 100 degrees, in m2/s, and the coefficients of L and of H, quadratics in mm2/s (ASTM D2270, table X2.1).
INDEX_OILS = (
    (3.8e-6, (1.14673, 1.7576, -0.109), (0.84155, 1.5521, -0.077)),
    (4.4e-6, (3.38095, -15.4952, 33.196), (0.78571, 1.7929, -0.183)),
    (5e-6, (2.5, -7.2143, 13.812), (0.82143, 1.5679, 0.119)),
    (6.4e-6, (0.101, 16.635, -45.469), (0.04985, 9.1613, -18.557)),
    (7e-6, (3.35714, -23.5643, 78.466), (0.22619, 7.7369, -16.656)),
    (7.7e-6, (0.01191, 21.475, -72.87), (0.79762, -0.7321, 14.61)),
    (9e-6, (0.41858, 16.1558, -56.04), (0.05794, 10.5156, -28.24)),
    (12e-6, (0.88779, 7.5527, -16.6), (0.26665, 6.7015, -10.81)),
    (15e-6, (0.7672, 10.7972, -38.18), (0.20073, 8.4658, -22.49)),
    (18e-6, (0.97305, 5.3135, -2.2), (0.28889, 5.9741, -4.93)),
    (22e-6, (0.97256, 5.25, -0.98), (0.24504, 7.416, -16.73)),
    (28e-6, (0.91413, 7.4759, -21.82), (0.20323, 9.1267, -34.23)),
    (40e-6, (0.87031, 9.7157, -50.77), (0.18411, 10.1015, -46.75)),
    (55e-6, (0.84703, 12.6752, -133.31), (0.17029, 11.4866, -80.62)),
    (70e-6, (0.85921, 11.1009, -83.19), (0.1713, 11.368, -76.94)),
    (math.inf, (0.83531, 14.6731, -216.246), (0.16841, 11.8493, -96.947)))


def index_oils(at_100):
    """Viscosities at 40 degrees, in mm2/s, of the oils of index 0 and 100 that have the viscosity `at_100` at 100 degrees."""
    y = 1e6 * at_100
    return next([a * y * y + b * y + c for a, b, c in oils] for end, *oils in INDEX_OILS if at_100 <= end)


def viscosity_index(at_40, at_100):
    zero, hundred = index_oils(at_100)
    if 1e6 * at_40 >= hundred:
        return 100 * (zero - 1e6 * at_40) / (zero - hundred)
    return 100 + ((hundred / (1e6 * at_40)) ** (1 / math.log10(1e6 * at_100)) - 1) / 0.00715


def summits(m0, m2, m4):
    bandwidth = m0 * m4 / m2**2
    height_sd = math.sqrt((1 - 0.8968 / bandwidth) * m0)
    return {"bandwidth": bandwidth, "summit_density": m4 / (6 * math.pi * math.sqrt(3) * m2),
            "summit_radius": 0.375 * math.sqrt(math.pi / m4), "summit_height_sd": height_sd,
            "summit_plane_offset": 4 * math.sqrt(m0 / (math.pi * bandwidth)) / height_sd}
