# SPDX-License-Identifier: Apache-2.0
"""Sixty wrong solvers. Each slip changes modules of the right solver, one slip in a process. "1 for 2" is a wrong 1 in place of the right 2."""

import functools
import math

import fields
import films
import friction
import inlet
import liquids
import point
import solver

SLIPS = []
KINDS = {}


def slip(kind):
    """Registers a slip. `kind` is its kind, 1 to 10 as in the headings; a combination has the kind of each of its slips."""
    def register(function):
        SLIPS.append(function)
        KINDS[function.__name__] = kind
        return function
    return register


def change(module, name):
    """A decorator: the decorated function replaces the module's function `name`, and gets the right function as first argument."""
    def replace(wrong):
        setattr(module, name, functools.partial(wrong, getattr(module, name)))
    return replace


def edit(table, name, place, number):
    row = list(table[name])
    row[place] = number
    table[name] = tuple(row)


def summits_with(**wrong):
    """Replaces members of the answer of `summits` by what these functions of (m0, m2, m4, right answer) return."""
    @change(liquids, "summits")
    def summits(right, m0, m2, m4):
        answers = right(m0, m2, m4)
        return answers | {name: of(m0, m2, m4, answers) for name, of in wrong.items()}


def thermal(p0, E, S, beta, viscosity, speed, conductivity, first=6.6, a=0.42, b=0.64, c=0.83, sign=-1):
    L = beta * viscosity * speed**2 / conductivity
    return (1 + sign * first * p0 / E * L**a) / (1 + 0.213 * (1 + 2.23 * S**c) * L**b)


# 1. Wrong definition of an input

@slip("1")
def speeds_summed_in_line_films():
    """The line films take u1 + u2 for the speed, twice the mean: take the mean."""
    @change(films, "line_film")
    def line_film(right, name, speed, *rest):
        return right(name, 2 * speed, *rest)

    @change(films, "moes_numbers")
    def moes_numbers(right, speed, *rest):
        return right(2 * speed, *rest)


@slip("1")
def thermal_modulus_of_contact():
    """Gupta's 13.2 p0/E' has E* in place of E' = 2E*: take 2E* there."""
    films.thermal_reduction = functools.partial(thermal, first=13.2)


@slip("1")
def gradient_of_face_for_m2():
    """m2 is the mean square gradient of the face, twice that of a profile's slope: take the profile's m2."""
    @change(liquids, "summits")
    def summits(right, m0, m2, m4):
        return right(m0, 2 * m2, m4)


@slip("1")
def sliding_over_sum_of_speeds():
    """The slide-roll ratio is read as sliding speed over u1 + u2, so that the shear rate is doubled: divide by the mean speed."""
    @change(friction, "shear_rate")
    def shear_rate(right, speed, ratio, separation):
        return right(2 * speed, ratio, separation)


# 2. Wrong exponents, digits exchanged

@slip("2")
def pan_hamrock_minimum_constant():
    """The constant 1.714 of Pan and Hamrock's minimum film is copied as 1.741: mend the digits."""
    edit(films.LINES, "pan_hamrock_minimum", 0, 1.741)


@slip("2")
def pan_hamrock_minimum_exponent():
    """G^0.568 of Pan and Hamrock's minimum film is copied as G^0.586: mend the exponent."""
    edit(films.LINES, "pan_hamrock_minimum", 2, 0.586)


@slip("2")
def thermal_exponent():
    """L^0.64 of Gupta's denominator is copied as L^0.46: mend the exponent."""
    films.thermal_reduction = functools.partial(thermal, b=0.46)


@slip("2")
def index_coefficient():
    """The coefficient c = 33.196 of L from 3.8 to 4.4 mm2/s is copied from table X2.1 as 33.916: mend the digits."""
    rows = list(liquids.INDEX_OILS)
    rows[1] = (4.4e-6, (3.38095, -15.4952, 33.916), rows[1][2])
    liquids.INDEX_OILS = tuple(rows)


# 3. Factors

@slip("3")
def density_without_root_three():
    """The density of summits is m4/(6 pi m2), without the root of 3 in the denominator: divide by it."""
    summits_with(summit_density=lambda m0, m2, m4, right: m4 / (6 * math.pi * m2))


@slip("3")
def line_shear_of_mean_pressure():
    """The greatest shear of a line is 0.300 of the mean pressure in place of the peak pressure (4/pi is missing)."""
    @change(solver, "hertz_line")
    def hertz_line(right, load, E, R):
        answers = right(load, E, R)
        return answers | {"peak_shear": solver.line_shear_over_peak() * answers["mean_pressure"]}


@slip("3")
def williamson_without_four_thirds():
    """K of Greenwood and Williamson misses the 4/3 of Hertz' load of a summit."""
    @change(solver, "stiffness")
    def stiffness(right, asperity, *rest):
        return right(asperity, *rest) * (1 if asperity == solver.TRIPP else 0.75)


@slip("3")
def tripp_count_half():
    """The count of Greenwood and Tripp's contacts is 2 pi n^2 beta sigma A F_1, half of the right number: take 4 pi."""
    @change(solver, "summit_count")
    def summit_count(right, asperity, *rest):
        return right(asperity, *rest) * (0.5 if asperity == solver.TRIPP else 1)


# 4. Signs, reciprocals

@slip("4")
def thermal_numerator_sign():
    """Gupta's numerator is 1 + 13.2 (p0/E') L^0.42: the right sign is minus."""
    films.thermal_reduction = functools.partial(thermal, sign=1)


@slip("4")
def damiens_ratio_upside_down():
    """Damiens' law gets h_oil/h_ff for r = h_ff/h_oil: take the reciprocal."""
    @change(inlet, "damiens")
    def damiens(right, r, exponent):
        return right(1 / r, exponent)


@slip("4")
def offset_of_planes_added():
    """The moments are taken at lambda + delta in place of lambda - delta: the offset has the wrong sign."""
    solver.moment_argument = lambda lam, delta: lam + delta


@slip("4")
def index_ratio_upside_down():
    """Above an index of 100, N is log(U/H)/log Y, which has the wrong sign: take log(H/U)."""
    @change(liquids, "viscosity_index")
    def viscosity_index(right, at_40, at_100):
        value = right(at_40, at_100)
        return 100 + (1 / (1 + 0.00715 * (value - 100)) - 1) / 0.00715 if value > 100 else value


# 5. Branches, conditions

@slip("5")
def index_linear_above_hundred():
    """The second formula, for U below H (index above 100), is missing: the linear one is used everywhere."""
    @change(liquids, "viscosity_index")
    def viscosity_index(right, at_40, at_100):
        zero, hundred = liquids.index_oils(at_100)
        return 100 * (zero - 1e6 * at_40) / (zero - hundred)


@slip("5")
def ellipse_axes_by_size():
    """a_x is always the smaller axis, also where R_y < R_x: exchange the axes there."""
    @change(solver, "hertz_ellipse")
    def hertz_ellipse(right, F, E, Rx, Ry):
        return right(F, E, *sorted((Rx, Ry)))


@slip("5")
def roelands_regime_missing():
    """viscous_rigid_roelands has no branch and falls through to Barus' viscous_rigid law: add the branch."""
    @change(films, "regime_film")
    def regime_film(right, regime, *rest):
        return right(regime.replace("roelands", "barus"), *rest)


@slip("5")
def boundary_word_from_ninety_percent():
    """The regime is called boundary from an asperity share of 0.9 on: the limit is 0.99."""
    @change(solver, "regime")
    def regime(right, asperity_share, fluid_share):
        return "boundary" if asperity_share > 0.9 else right(asperity_share, fluid_share)


# 6. Clamps, floors, early returns, defaults

@slip("6")
def roelands_pressure_clamp():
    """Roelands' viscosity is clamped to that at 1 GPa: remove the clamp of the pressure."""
    @change(liquids, "roelands")
    def roelands(right, viscosity, alpha, pressure):
        return right(viscosity, alpha, min(pressure, 1e9))


@slip("6")
def line_films_floor():
    """The line films are not allowed to be below 1 nm: remove the floor."""
    @change(films, "line_film")
    def line_film(right, name, *given):
        return max(right(name, *given), 1e-9)


@slip("6")
def nearly_round_is_round():
    """An ellipse whose radii differ by less than 10 % is taken for a circle: remove the early return."""
    @change(solver, "axes_ratio")
    def axes_ratio(right, alpha):
        return 1.0 if alpha < 1.1 else right(alpha)


@slip("6")
def default_ellipticity():
    """The default of the ellipticity is 1.03, of Hamrock and Dowson's fit for a ball, and not 1."""
    for name, row in fields.FUNCTIONS.items():
        if "ellipticity" in row:
            row["ellipticity"] = ("above 0", 1.03)
    fields.SCENE["bodies.ellipticity"] = ("above 0", 1.03)


# 7. Units

@slip("7")
def walther_answer_in_mm2_per_s():
    """ASTM D341 answers in mm2/s: multiply by 1e-6."""
    @change(liquids, "viscosity_of")
    def viscosity_of(right, height):
        return 1e6 * right(height)


@slip("7")
def index_exponent_in_m2_per_s():
    """N = log(H/U)/log Y has Y in m2/s, where mm2/s is meant."""
    @change(liquids, "viscosity_index")
    def viscosity_index(right, at_40, at_100):
        zero, hundred = liquids.index_oils(at_100)
        ratio = hundred / (1e6 * at_40)
        return 100 + (ratio ** (1 / math.log10(at_100)) - 1) / 0.00715 if ratio > 1 else right(at_40, at_100)


@slip("7")
def summit_density_per_mm2():
    """The density of summits is given in 1/mm2: multiply by 1e6."""
    summits_with(summit_density=lambda m0, m2, m4, right: 1e-6 * right["summit_density"])


@slip("7")
def kelvin_by_273():
    """Temperatures come from Celsius by 273 in place of 273.15, 0.15 K too low."""
    @change(liquids, "chart_temperature")
    def chart_temperature(right, kelvin):
        return right(kelvin - 0.15)


# 8. Numerics

@slip("8")
def elliptic_integrals_coarse():
    """The elliptic integrals are by Simpson's rule with 20 intervals, too few for a slender ellipse."""
    @change(solver, "complete_integrals")
    def complete_integrals(right, parameter, complement):
        n, first, second = 20, 0.0, 0.0
        for i in range(n + 1):
            weight = math.pi / (6 * n) * (1 if i in (0, n) else 4 if i % 2 else 2)
            root = math.sqrt(1 - parameter * math.sin(math.pi / 2 * i / n) ** 2)
            first += weight / root
            second += weight * root
        return first, second, (first - second) / first


@slip("8")
def sharing_stops_early():
    """Load sharing is a fixed-point iteration with A at most 0.9999, and 20 steps are too few: iterate to convergence."""
    @change(solver, "load_sharing")
    def load_sharing(right, asperity, flooded, K, delta, exponent=None):
        lam = flooded
        for _ in range(20):
            A = min(math.exp(min(solver.log_share(asperity, K, delta, lam), 0)), 0.9999)
            lam = 0.5 * (lam + flooded * (1 - A) ** -(exponent or solver.film_exponent()))
        return lam


@slip("8")
def index_table_interpolated():
    """L and H come from a table at whole mm2/s with linear interpolation between: too coarse."""
    @change(liquids, "index_oils")
    def index_oils(right, at_100):
        low = math.floor(1e6 * at_100)
        part = 1e6 * at_100 - low
        return [(1 - part) * a + part * b for a, b in zip(right(1e-6 * low), right(1e-6 * (low + 1)))]


@slip("8")
def ellipse_cache_key_rounded():
    """The shape of the ellipse is cached by R_y/R_x rounded to one decimal: take the unrounded ratio as the key."""
    shapes = {}

    @change(solver, "ellipse_shape")
    def ellipse_shape(right, alpha):
        key = round(alpha, 1)
        if key not in shapes:
            shapes[key] = right(alpha)
        return shapes[key]


# 9. Another author's law

@slip("9")
def dowson_higginson_of_1959():
    """dowson_higginson_minimum is the older fit 1.6 U^0.7 G^0.6 W^-0.13: take 2.65 U^0.7 G^0.54 W^-0.13."""
    films.LINES["dowson_higginson_minimum"] = (1.6, 0.7, 0.6, -0.13)


@slip("9")
def moes_exponent_of_points():
    """s of moes_line is that of Moes' point contacts, 1.5 (1 + exp(-1.2 EI/RI)): it is (7 + 8 exp(-2 EI/RI))/5."""
    @change(films, "moes_line")
    def moes_line(right, *given):
        M, L, unit = films.moes_numbers(*given)
        rigid, elastic = 3 / M, 2.621 * M**-0.2
        s = 1.5 * (1 + math.exp(-1.2 * elastic / rigid))
        return unit * films.norm(s, films.norm(7 / 3, rigid, elastic),
                                 films.norm(-7 / 2, 1.287 * L ** (2 / 3), 1.311 * M**-0.125 * L**0.75))


@slip("9")
def density_of_other_fit():
    """The density is the other fit 1 + 0.6e-9 p/(1 + 1.7e-9 p): take (5.9e8 + 1.34 p)/(5.9e8 + p)."""
    @change(liquids, "density")
    def density(right, pressure):
        return 1 + 0.6e-9 * pressure / (1 + 1.7e-9 * pressure)


@slip("9")
def axes_by_hamrock_brewe():
    """The ratio of the axes is Hamrock and Brewe's approximation alpha^(2/pi), and not the root of the exact equation."""
    @change(solver, "axes_ratio")
    def axes_ratio(right, alpha):
        return alpha ** (2 / math.pi)


# 10. Inputs and words ignored, exchanged, taken from elsewhere

@slip("10")
def regime_by_film_parameter():
    """The regime is told by the film parameter (below 1 boundary, above 3 elastohydrodynamic): take the load shares."""
    @change(point, "solve")
    def solve(right, scene, outputs):
        values, undefined = right(scene, [*outputs, "film_parameter"] if "regime" in outputs else outputs)
        if "regime" in values and values["regime"] != "collapsed":
            lam = values["film_parameter"]
            values["regime"] = "boundary" if lam < 1 else "mixed" if lam < 3 else "elastohydrodynamic"
        return {name: values[name] for name in outputs}, undefined


@slip("10")
def friction_viscosity_word_ignored():
    """friction.viscosity is ignored, and the viscosity always follows Barus' law: obey the word."""
    @change(friction, "log_thickening")
    def log_thickening(right, law, *rest):
        return right("barus", *rest)


@slip("10")
def sharing_exponent_of_usual_film():
    """Load sharing has the exponent 0.14 of the usual film law with every law: take a - b of the law of the scene."""
    point.sharing_exponent = lambda law: None


@slip("10")
def inlet_film_ratio_of_flooded_film():
    """supply.inlet_film_ratio multiplies the flooded film: it must multiply summit_height_sd."""
    @change(point, "starved")
    def starved(right, scene, film):
        ratio = scene.get("supply.inlet_film_ratio")
        if ratio is None:
            return right(scene, film)
        return inlet.starved(scene["closures.starvation"], 1 / ratio, scene["closures.damiens_exponent"])


# Two or three at once

@slip("2, 2")
def two_line_laws_miscopied():
    """ertel_grubin has the exponents 3/4 for 8/11 (of G and U), and dowson_toyoda_central 3.60 for 3.06."""
    films.LINES["ertel_grubin"] = (1.95, 0.75, 0.75, -1 / 11)
    edit(films.LINES, "dowson_toyoda_central", 0, 3.60)


@slip("2, 2")
def two_soft_laws_miscopied():
    """hamrock_dowson_soft_central has 7.23 for 7.32, and hamrock_dowson_soft_minimum 0.58 for 0.85 in 1 - 0.85 exp(-0.31 k)."""
    edit(films.POINTS, "hamrock_dowson_soft_central", 0, 7.23)
    edit(films.POINTS, "hamrock_dowson_soft_minimum", 4, 0.58)


@slip("3, 4")
def ellipse_approach_and_ellipticity():
    """The ellipse's approach misses the 1/2, and the ellipticity is a_x/a_y, the reciprocal."""
    @change(solver, "approach_of_ellipse")
    def approach_of_ellipse(right, *given):
        return 2 * right(*given)

    @change(solver, "hertz_ellipse")
    def hertz_ellipse(right, *given):
        answers = right(*given)
        return answers | {"ellipticity": answers["semi_axis_x"] / answers["semi_axis_y"]}


@slip("1, 2")
def thermal_digits_and_mean_pressure():
    """Gupta's factor has S^0.38 for S^0.83, and takes the given p0 for the mean pressure, so that it uses 3/2 p0 as the peak."""
    films.thermal_reduction = functools.partial(thermal, first=9.9, c=0.38)


@slip("1, 3")
def summit_offset_and_radius():
    """The offset of the planes is divided by sqrt(m0), not by sigma_s; the summit radius is 3/(8 sqrt(m4)), without sqrt(pi)."""
    summits_with(summit_plane_offset=lambda m0, m2, m4, right: 4 / math.sqrt(math.pi * right["bandwidth"]),
                 summit_radius=lambda m0, m2, m4, right: 0.375 / math.sqrt(m4))


@slip("2, 2")
def roelands_two_constants():
    """roelands_viscosity has 9.76 for 9.67, and p_R = 1.98e8 Pa for 1.96e8 Pa."""
    @change(liquids, "roelands")
    def roelands(right, viscosity, alpha, pressure):
        scale = math.log(viscosity) + 9.76
        return viscosity * math.exp(scale * ((1 + pressure / 1.98e8) ** (alpha * 1.98e8 / scale) - 1))


@slip("6, 1")
def barus_guard_and_whole_pressure():
    """barus_viscosity limits alpha p to 30, and friction thickens by the whole mean pressure, not the fluid's share of it."""
    @change(liquids, "barus")
    def barus(right, viscosity, alpha, pressure):
        return viscosity * math.exp(min(alpha * pressure, 30))

    @change(friction, "friction")
    def whole(right, given, mean_pressure):
        return right({**given, "fluid_share": 1.0}, mean_pressure)


@slip("1, 10")
def friction_peak_pressure_and_whole_area():
    """Friction thickens by the peak pressure (3/2 of the mean one), and shears the whole area, not the part that the asperities leave."""
    @change(friction, "log_thickening")
    def log_thickening(right, law, viscosity, alpha, pressure):
        return right(law, viscosity, alpha, 1.5 * pressure)
    friction.sheared_part = lambda area_ratio: 1.0


@slip("9, 1, 3")
def friction_tanh_sliding_and_flow():
    """limiting is stress times tanh(x) for 1 - exp(-x); the slide-roll ratio is over u1 + u2; the inlet film is flow/(2u) for flow/u."""
    @change(friction, "reduced_stress")
    def reduced_stress(right, law, log_x):
        return math.tanh(math.exp(min(log_x, 10))) if law == "limiting" else right(law, log_x)

    @change(point, "inlet_film")
    def inlet_film(right, scene):
        film = right(scene)
        return film / 2 if scene.get("supply.inlet_flow") is not None else film
    sliding_over_sum_of_speeds()


@slip("10, 10")
def starvation_words_and_exponent():
    """starved_inlet and printed_exponents are exchanged, and damiens has always the exponent 3."""
    other = {"starved_inlet": "printed_exponents", "printed_exponents": "starved_inlet"}

    @change(inlet, "starved")
    def starved(right, closure, r, exponent):
        return right(other.get(closure, closure), r, 3.0)


@slip("2, 3")
def starvation_two_constants():
    """Wolveridge's 2.7 is copied as 2.07, and Crook's constant misses the root: 3/8 for 3/(4 sqrt 2)."""
    inlet.crook_constant = lambda: 3 / 8

    def log_film_ratio(t):
        if t < -30:
            return math.log(4.14 / math.pi) + t
        return math.log(2 / math.pi * math.atan(2.07 * math.exp(min(t, 700))))
    inlet.log_film_ratio = log_film_ratio
    inlet.film_parts = lambda t: (math.exp(log_film_ratio(t)), -math.expm1(log_film_ratio(t)))


@slip("2, 2")
def index_two_constants():
    """0.00715 of the index above 100 is copied as 0.00751, and b of H from 18 to 22 mm2/s as 7.461 for 7.416."""
    rows = list(liquids.INDEX_OILS)
    rows[10] = (22e-6, (0.97256, 5.25, -0.98), (0.24504, 7.461, -16.73))
    liquids.INDEX_OILS = tuple(rows)

    @change(liquids, "viscosity_index")
    def viscosity_index(right, at_40, at_100):
        value = right(at_40, at_100)
        return 100 + (value - 100) * 0.00715 / 0.00751 if value > 100 else value


@slip("2, 6")
def walther_constant_and_no_extrapolation():
    """ASTM D341 has 0.8 for 0.7 in log log(nu + 0.7), and does not extrapolate: T is held between T1 and T2."""
    liquids.chart = lambda viscosity: math.log10(math.log10(1e6 * viscosity + 0.8))
    liquids.viscosity_of = lambda height: 1e-6 * (10 ** (10**height) - 0.8)

    @change(liquids, "astm_d341")
    def astm_d341(right, T1, nu1, T2, nu2, T):
        return right(T1, nu1, T2, nu2, min(max(T, min(T1, T2)), max(T1, T2)))


@slip("2, 3")
def sharing_exponent_and_root():
    """The film's exponent in load sharing is 0.2 for 0.14, and Greenwood and Tripp's share is K F_5/2 without the root."""
    solver.film_exponent = lambda: 0.2
    solver.share_exponent = lambda asperity: 1.0


@slip("3, 3")
def tripp_load_and_area_factors():
    """K of Greenwood and Tripp has 8 for 16 (the factor that belongs to E' = 2E*), and its area pi n^2 for pi^2 n^2."""
    @change(solver, "stiffness")
    def stiffness(right, asperity, *rest):
        return right(asperity, *rest) * (0.5 if asperity == solver.TRIPP else 1)

    @change(solver, "real_area_ratio")
    def real_area_ratio(right, asperity, *rest):
        return right(asperity, *rest) / (math.pi if asperity == solver.TRIPP else 1)


@slip("1, 10")
def ellipse_points_by_reduced_radius():
    """The film law of an elliptic contact gets R, with 1/R = 1/R_x + 1/R_y, in place of R_x, and always the ellipticity 1."""
    @change(point, "smooth_contact")
    def smooth_contact(right, scene):
        radius, ellipticity, pressure = right(scene)
        if scene["bodies.radius_y"] is None:
            return radius, ellipticity, pressure
        return solver.radius_of_both(radius, scene["bodies.radius_y"]), 1.0, pressure


@slip("1, 2")
def half_length_and_regime_limits():
    """bodies.length is taken as half of the line's length, so that F/L is halved; the limits of the regimes are 0.05 for 0.01."""
    @change(point, "solve")
    def solve(right, scene, outputs):
        length = scene["bodies.length"]
        return right(scene if length is None else {**scene, "bodies.length": 2 * length}, outputs)

    @change(solver, "regime")
    def regime(right, asperity_share, fluid_share):
        if fluid_share < 0.05:
            return "boundary"
        return "elastohydrodynamic" if asperity_share < 0.05 else "mixed"


@slip("4, 2, 2")
def three_regimes_miscopied():
    """phi of isoviscous_rigid is 1/(1 + 2 alpha/3); isoviscous_elastic has g_E^(2/3) for g_E^0.67; viscous_elastic 3.24 for 3.42."""
    @change(films, "regime_film")
    def regime_film(right, regime, g_V, g_E, alpha, k):
        value = right(regime, g_V, g_E, alpha, k)
        if regime == "isoviscous_rigid":
            return value * ((1 + 2 / (3 * alpha)) / (1 + 2 * alpha / 3)) ** 2
        return value * {"isoviscous_elastic": g_E ** (2 / 3 - 0.67), "viscous_elastic": 3.24 / 3.42}.get(regime, 1)


@slip("4, 1, 9")
def three_films_miscopied():
    """pan_hamrock_central has W^+0.166; pan_hamrock_minimum has E* for E'; hamrock_dowson_minimum has the central film's 1 - 0.61 exp(-0.73 k)."""
    edit(films.LINES, "pan_hamrock_central", 3, 0.166)
    edit(films.POINTS, "hamrock_dowson_minimum", 4, 0.61)
    edit(films.POINTS, "hamrock_dowson_minimum", 5, 0.73)

    @change(films, "line_film")
    def line_film(right, name, speed, viscosity, alpha, load, E, R):
        return right(name, speed, viscosity, alpha, load, E / 2 if name == "pan_hamrock_minimum" else E, R)


@slip("6, 2")
def ellipse_guard_and_line_constant():
    """hertz_ellipse limits R_y/R_x to 100 where it looks for the axes, and hertz_line has 1.27 for 4/pi (too few digits)."""
    @change(solver, "axes_ratio")
    def axes_ratio(right, alpha):
        return right(min(alpha, 100.0))
    solver.line_peak_over_mean = lambda: 1.27
