# SPDX-License-Identifier: Apache-2.0
"""Film laws other than Hamrock and Dowson's central one, films of the lubrication regimes, and thermal reduction factors."""

import math

# C, a, b, c, m, n of h/R_x = C U^a G^b W^c (1 - m exp(-n k)). Laws of lines have no m and n.
POINTS = {
    "hamrock_dowson_minimum": (3.63, 0.68, 0.49, -0.073, 1, 0.68),
    "hamrock_dowson_soft_central": (7.32, 0.64, 0, -0.22, 0.72, 0.28),
    "hamrock_dowson_soft_minimum": (7.43, 0.65, 0, -0.21, 0.85, 0.31),
}
LINES = {
    "dowson_higginson_minimum": (2.65, 0.7, 0.54, -0.13),
    "dowson_toyoda_central": (3.06, 0.69, 0.56, -0.1),
    "pan_hamrock_minimum": (1.714, 0.694, 0.568, -0.128),
    "pan_hamrock_central": (2.922, 0.692, 0.47, -0.166),
    "ertel_grubin": (1.95, 8 / 11, 8 / 11, -1 / 11),
}


def groups(speed, viscosity, alpha, load_per_length, E, R):
    """U, G and W, with E' = 2E*. For a point load_per_length is the load over R_x."""
    E = 2 * E
    return viscosity * speed / (E * R), alpha * E, load_per_length / (E * R)


def line_film(name, *given):
    C, a, b, c = LINES[name]
    U, G, W = groups(*given)
    return given[-1] * C * U**a * G**b * W**c


def point_film(name, speed, viscosity, alpha, load, E, Rx, ellipticity):
    C, a, b, c, m, n = POINTS[name]
    U, G, W = groups(speed, viscosity, alpha, load / Rx, E, Rx)
    return Rx * C * U**a * G**b * W**c * (1 - m - m * math.expm1(-n * ellipticity))


def soft_film(name, speed, viscosity, *rest):
    return point_film(name, speed, viscosity, 1.0, *rest)


def norm(p, *numbers):
    """(sum of x^p)^(1/p), by logarithms."""
    logs = [p * math.log(x) for x in numbers]
    greatest = max(logs)
    return math.exp((greatest + math.log(sum(math.exp(x - greatest) for x in logs))) / p)


def moes_numbers(*given):
    """Moes' M and L of a line contact, and the film thickness at H = 1."""
    U, G, W = groups(*given)
    return W / math.sqrt(2 * U), G * (2 * U) ** 0.25, given[-1] * math.sqrt(2 * U)


def moes_line(*given):
    M, L, unit = moes_numbers(*given)
    rigid, elastic = 3 / M, 2.621 * M**-0.2
    s = (7 + 8 * math.exp(-2 * elastic / rigid)) / 5
    isoviscous = norm(7 / 3, rigid, elastic)
    piezoviscous = norm(-7 / 2, 1.287 * L ** (2 / 3), 1.311 * M**-0.125 * L**0.75)
    return unit * norm(s, isoviscous, piezoviscous)


def nijenbanning_venner_moes(speed, viscosity, alpha, load, E, Rx, Ry, exponent, bracket):
    U, G, W = groups(speed, viscosity, alpha, load / Rx, E, Rx)
    M, L, D = W / (2 * U) ** 0.75, G * (2 * U) ** 0.25, Rx / Ry
    Q = 1 + 0.006 * math.log(D) + 0.63 * D ** (4 / 7)
    rigid = 145 * (1 + 0.796 * D ** (14 / 15)) ** (-15 / 7) / D / M**2
    elastic = 3.18 * Q**-0.56 * D ** (-1 / 15) * M ** (-2 / 15)
    rigid_piezoviscous = 1.29 * (L / (1 + 0.691 * D)) ** (2 / 3)
    elastic_piezoviscous = 1.48 * Q**-0.35 * D ** (-1 / 24) * M ** (-1 / 12) * L**0.75
    s = 1.5 * (1 + math.exp(-1.2 * elastic / (rigid if exponent == "ei_over_ri" else elastic_piezoviscous)))
    limited = norm(-4, elastic, 1.8 / D)
    isoviscous = norm(1.5, rigid, limited) if bracket == "three_halves" else norm(1.5 * s, rigid, limited) ** (1 / s)
    return Rx * math.sqrt(2 * U) * norm(s, isoviscous, norm(-8, rigid_piezoviscous, elastic_piezoviscous))


def viscous_rigid_roelands(g_V, alpha):
    return 141 * g_V**0.375 * -math.expm1(-0.0387 * alpha)


def regime_film(regime, g_V, g_E, alpha, k):
    if regime == "isoviscous_rigid":
        phi = 3 * alpha / (3 * alpha + 2)
        return 128 * alpha * (phi * (0.131 * math.atan(alpha / 2) + 1.683)) ** 2
    if regime == "viscous_rigid_roelands":
        return viscous_rigid_roelands(g_V, alpha)
    if regime == "isoviscous_elastic":
        return 8.7 * g_E**0.67 * (1 - 0.85 * math.exp(-0.31 * k))
    side = -math.expm1(-0.68 * k)
    return 1.66 * g_V ** (2 / 3) * side if regime == "viscous_rigid_barus" else 3.42 * g_V**0.49 * g_E**0.17 * side


def rolling_reduction(beta, viscosity, speed, conductivity):
    """Murch and Wilson's thermal reduction factor. It holds for pure rolling, and does not depend on the pressure."""
    return 3.94 / (3.94 + (beta * viscosity * speed**2 / conductivity) ** 0.62)


def thermal_reduction(p0, E, S, beta, viscosity, speed, conductivity):
    L = beta * viscosity * speed**2 / conductivity
    return (1 - 6.6 * p0 / E * L**0.42) / (1 + 0.213 * (1 + 2.23 * S**0.83) * L**0.64)
