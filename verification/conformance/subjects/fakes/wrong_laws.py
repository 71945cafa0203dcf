# SPDX-License-Identifier: Apache-2.0
"""Mistakes in films by other laws, in regimes and heated inlets, in liquids, and in summits."""

import math

from catalogue import replaces
import films
import liquids

MINIMUM, TOYODA, MOES, REGIME = "hamrock_dowson_minimum", "dowson_toyoda_central", "moes_line", "regime_film"
THERMAL, DENSITY, ROELANDS = "gupta_thermal_reduction", "dowson_higginson_density", "roelands_viscosity"
D341, SUMMITS = "astm_d341_viscosity", "summits_from_spectral_moments"


def only_of(name):
    """Makes a mistake in the law of this name alone."""
    def choose(wrong):
        return lambda right, law, *given: wrong(right, law, *given) if law == name else right(law, *given)
    return choose


def law_mistake(kind, name, description):
    def register(wrong):
        chosen = only_of(name)(wrong)
        chosen.__name__ = wrong.__name__
        return replaces(films, kind, name, description)(chosen)
    return register


# Films

@law_mistake("point_film", MINIMUM, "central film for the minimum one")
def law_central_for_minimum(right, law, speed, viscosity, alpha, F, E, R, k):
    U, G, W = films.groups(speed, viscosity, alpha, F / R, E, R)
    return R * 2.69 * U**0.67 * G**0.53 * W**-0.067 * (1 - 0.61 * math.exp(-0.73 * k))


@law_mistake("point_film", MINIMUM, "1/k for k in the minimum film")
def law_ellipticity_inverted(right, law, *given):
    return right(law, *given[:-1], 1 / given[-1])


@law_mistake("point_film", MINIMUM, "W^+0.49 for W^-0.073 in the minimum film")
def law_load_exponent(right, law, speed, viscosity, alpha, F, E, R, k):
    U, G, W = films.groups(speed, viscosity, alpha, F / R, E, R)
    return right(law, speed, viscosity, alpha, F, E, R, k) * W**0.563


@law_mistake("point_film", "hamrock_dowson_soft_minimum", "central film of soft bodies for the minimum one")
def law_soft_central_for_minimum(right, law, *given):
    return right("hamrock_dowson_soft_central", *given)


@law_mistake("line_film", TOYODA, "minimum film of a line for the central one")
def line_minimum_for_central(right, law, *given):
    return right("dowson_higginson_minimum", *given)


@law_mistake("line_film", TOYODA, "E* for 2E* in the film of a line")
def line_modulus_single(right, law, speed, viscosity, alpha, load, E, R):
    return right(law, speed, viscosity, alpha, load, E / 2, R)


@law_mistake("line_film", TOYODA, "diameter of the cylinder for R in the film of a line")
def line_diameter(right, law, *given):
    return right(law, *given[:-1], 2 * given[-1])


@law_mistake("line_film", TOYODA, "load number of a point, (F/L)/(E'R^2), in the film of a line")
def line_load_of_a_point(right, law, speed, viscosity, alpha, load, E, R):
    return right(law, speed, viscosity, alpha, load / R, E, R)


@replaces(films, "moes_numbers", MOES, "U for 2U in Moes' M, L and H")
def moes_single_speed(right, speed, *rest):
    return right(speed / 2, *rest)


@replaces(films, "viscous_rigid_roelands", REGIME, "1.41 for 141 in the regime of rigid bodies by Roelands' law")
def regime_hundredth(right, g_V, alpha):
    return 1.41 * g_V**0.375 * (1 - math.exp(-0.0387 * alpha))


@replaces(films, "thermal_reduction", THERMAL, "slide-roll ratio in percent in the heated inlet")
def thermal_percent(right, p0, E, S, *rest):
    return right(p0, E, 100 * S, *rest)


# Liquids

@replaces(liquids, "density", DENSITY, "1 + 0.6e-9 p/(1 + 1.7e-9 p) for the density")
def density_rounded(right, p):
    return 1 + 0.6e-9 * p / (1 + 1.7e-9 * p)


@replaces(liquids, "roelands", ROELANDS, "5.1e-9 p for p/0.196e9 in Roelands' viscosity")
def roelands_rounded(right, viscosity, alpha, p):
    scale = math.log(viscosity) + 9.67
    return viscosity * math.exp(scale * ((1 + 5.1e-9 * p) ** (alpha / 5.1e-9 / scale) - 1))


@replaces(liquids, "roelands", ROELANDS, "pressure in GPa in Roelands' viscosity, all else in SI")
def roelands_giga(right, viscosity, alpha, p):
    return right(viscosity, alpha, p / 1e9)


@replaces(liquids, "astm_d341", D341, "log log nu for log log(nu + 0.7)")
def d341_without_offset(right, T1, nu1, T2, nu2, T):
    Z1, Z2 = (math.log(math.log(1e6 * nu)) for nu in (nu1, nu2))
    return 1e-6 * math.exp(math.exp(Z1 + (Z2 - Z1) * math.log(T / T1) / math.log(T2 / T1)))


@replaces(liquids, "chart_temperature", D341, "temperatures in degrees Celsius for kelvin")
def d341_celsius(right, kelvin):
    return right(max(kelvin - 273.15, 1e-3))


# Summits

@replaces(liquids, "summits", SUMMITS, "root mean squares for the spectral moments")
def summits_of_roots(right, *moments):
    return right(*map(math.sqrt, moments))


@replaces(liquids, "summits", SUMMITS, "standard deviation of all heights for that of the summits")
def summits_sd_of_heights(right, m0, m2, m4):
    return {**right(m0, m2, m4), "summit_height_sd": math.sqrt(m0)}
