# SPDX-License-Identifier: Apache-2.0
"""Sixty wrong solvers. Each function below puts its slip into the imported modules of the right solver.

Forty have one slip (SINGLES), twenty have two or three at once (COMBINATIONS). Brackets after a wrong number hold the right one.
"""

import math

import fields
import films
import friction
import inlet
import liquids
import moments
import point
import solver
import subject

SINGLES = []
COMBINATIONS = []


def single(slip):
    SINGLES.append(slip)
    return slip


def combination(slip):
    COMBINATIONS.append(slip)
    return slip


def put(module):
    """A decorator: the decorated function replaces the module's function of the same name."""
    return lambda function: setattr(module, function.__name__, function)


def after(module, name, change):
    """The function `name` of the module then returns change(its right result, *arguments)."""
    right = getattr(module, name)
    setattr(module, name, lambda *given: change(right(*given), *given))


def before(module, name, change):
    """The function `name` of the module then gets the arguments that change(*arguments) returns."""
    right = getattr(module, name)
    setattr(module, name, lambda *given: right(*change(*given)))


def index_row(end, of_zero=None, of_hundred=None):
    """Replaces the coefficients of L or H in the row of INDEX_OILS that ends at the viscosity `end`, in m2/s."""
    liquids.INDEX_OILS = tuple((row[0], of_zero or row[1], of_hundred or row[2]) if row[0] == end else row
                               for row in liquids.INDEX_OILS)


# 1: wrong definition of an input

@single
def one_poisson_ratio_for_both():
    """The effective modulus takes the mean of both Poisson's ratios for both bodies; each body needs its own."""
    before(solver, "effective_modulus",
           lambda E1, nu1, E2, nu2: (E1, (nu1 + nu2) / 2, E2, (nu1 + nu2) / 2))


@single
def inlet_flow_over_sum_of_speeds():
    """The inlet film is the flow over the sum of both speeds, twice the entrainment speed; divide by the mean."""
    after(point, "inlet_film", lambda film, scene: film / 2 if scene.get("supply.inlet_flow") is not None else film)


@single
def moes_material_with_single_modulus():
    """Moes' L of the line is made with alpha E* in place of 2 alpha E*; M and U are right."""
    after(films, "moes_numbers", lambda numbers, *given: (numbers[0], numbers[1] / 2, numbers[2]))


@single
def offset_over_rms_height():
    """The offset of the summit plane is divided by sqrt(m0), the face's rms height, not by the summits' own sd."""
    after(liquids, "summits", lambda result, m0, m2, m4: {
        **result, "summit_plane_offset":
        result["summit_plane_offset"] * result["summit_height_sd"] / math.sqrt(m0)})


# 2: wrong exponent, digits exchanged

@single
def pan_hamrock_load_exponent():
    """pan_hamrock_central has W^-0.116 in place of W^-0.166."""
    films.LINES["pan_hamrock_central"] = (2.922, 0.692, 0.47, -0.116)


@single
def gupta_digits_exchanged():
    """Gupta's denominator has 0.231 in place of 0.213."""
    @put(films)
    def thermal_reduction(p0, E, S, beta, viscosity, speed, conductivity):
        L = beta * viscosity * speed**2 / conductivity
        return (1 - 6.6 * p0 / E * L**0.42) / (1 + 0.231 * (1 + 2.23 * S**0.83) * L**0.64)


@single
def index_digits_of_one_row():
    """In the viscosity index, f of the row from 9 to 12 mm2/s is -18.01 in place of -10.81."""
    index_row(12e-6, of_hundred=(0.26665, 6.7015, -18.01))


def rigid_film(alpha, a=0.131, b=1.683):
    phi = 3 * alpha / (3 * alpha + 2)
    return 128 * alpha * (phi * (a * math.atan(alpha / 2) + b)) ** 2


@single
def rigid_film_digits_exchanged():
    """regime_film, isoviscous_rigid: 1.638 in place of 1.683."""
    after(films, "regime_film", lambda film, regime, g_V, g_E, alpha, k:
          rigid_film(alpha, b=1.638) if regime == "isoviscous_rigid" else film)


# 3: a factor missing or double

@single
def tripp_area_with_pi_once():
    """Greenwood and Tripp's real area has pi (n beta sigma)^2 F_2 in place of pi^2 (n beta sigma)^2 F_2."""
    after(solver, "real_area_ratio", lambda area, asperity, *rest: area / math.pi if asperity == solver.TRIPP else area)


@single
def shear_of_mean_pressure():
    """Greatest shear of a line contact: 0.300283 is multiplied by the mean pressure, not by the peak pressure."""
    after(solver, "hertz_line", lambda result, *given: {
        **result, "peak_shear": solver.line_shear_over_peak() * result["mean_pressure"]})


@single
def moes_load_without_root_two():
    """Moes' M of the line is W/sqrt(U) in place of W/sqrt(2U); L and H are right."""
    after(films, "moes_numbers", lambda numbers, *given: (numbers[0] * math.sqrt(2), *numbers[1:]))


@single
def summit_density_without_root_three():
    """The density of summits is m4/(6 pi m2): the root of 3 is missing in the denominator."""
    after(liquids, "summits", lambda result, *given: {
        **result, "summit_density": result["summit_density"] * math.sqrt(3)})


# 4: sign or reciprocal

@single
def concave_faces_as_convex():
    """reduced_radius takes the radii's magnitudes: a concave face (radius below 0) counts as a convex one."""
    before(solver, "radius_of_gap", lambda R1, R2: (abs(R1), abs(R2)))


@single
def astm_sign_of_seven_tenths():
    """ASTM D341 with log log(nu - 0.7) in place of log log(nu + 0.7), and + 0.7 on the way back."""
    @put(liquids)
    def chart(viscosity):
        return math.log10(math.log10(1e6 * viscosity - 0.7))

    @put(liquids)
    def viscosity_of(height):
        return 1e-6 * (10 ** (10**height) + 0.7)


@single
def index_ratio_inverted():
    """Above 100, N of the viscosity index is log(U/H)/log Y in place of log(H/U)/log Y."""
    def change(index, at_40, at_100):
        hundred = liquids.index_oils(at_100)[1]
        if 1e6 * at_40 >= hundred:
            return index
        return 100 + ((1e6 * at_40 / hundred) ** (1 / math.log10(1e6 * at_100)) - 1) / 0.00715
    after(liquids, "viscosity_index", change)


@single
def ellipticity_of_film_upside_down():
    """The film of an elliptical contact gets k = a_x/a_y in place of a_y/a_x; hertz_ellipse itself is right."""
    after(point, "smooth_contact", lambda contact, scene: (contact[0], 1 / contact[1], contact[2])
          if scene["bodies.radius_y"] is not None else contact)


# 5: a branch or condition that is wrong

@single
def boundary_below_a_tenth():
    """The regime is boundary where the fluid carries less than 0.1 of the load; it should be less than 0.01."""
    after(solver, "regime", lambda word, asperity, fluid: "boundary" if fluid < 0.1 else word)


@single
def index_has_no_branch_above_hundred():
    """The viscosity index uses 100(L - U)/(L - H) above 100 too; there it needs the formula with N."""
    @put(liquids)
    def viscosity_index(at_40, at_100):
        zero, hundred = liquids.index_oils(at_100)
        return 100 * (zero - 1e6 * at_40) / (zero - hundred)


@single
def x_always_the_minor_axis():
    """hertz_ellipse puts the minor axis along x always; where R_y < R_x the axes have to be exchanged."""
    def change(result, *given):
        x, y = sorted((result["semi_axis_x"], result["semi_axis_y"]))
        return {**result, "semi_axis_x": x, "semi_axis_y": y, "ellipticity": y / x}
    after(solver, "hertz_ellipse", change)


@single
def full_inlet_starves_nothing():
    """A scene whose inlet film is thicker than the flooded film counts as not starved; the closure holds there too."""
    after(point, "starved", lambda pair, scene, film:
          (1.0, 0.0) if (point.inlet_film(scene) or 0) >= film else pair)


# 6: clamps, floors, guards, early returns, defaults

@single
def barus_exponent_capped():
    """Barus' exponent alpha p is cut off at 25, against overflow; it is physical up to 70."""
    @put(liquids)
    def barus(viscosity, alpha, pressure):
        return viscosity * math.exp(min(alpha * pressure, 25))


@single
def film_at_least_a_nanometre():
    """hamrock_dowson_central returns 1 nm where the film is thinner."""
    after(solver, "hamrock_dowson_central", lambda film, *given: max(film, 1e-9))


@single
def full_film_from_three():
    """load_sharing returns the flooded film at once where it is above 3 sd, although asperities may still carry load there."""
    right = solver.load_sharing

    @put(solver)
    def load_sharing(asperity, flooded, *rest):
        return flooded if flooded > 3 else right(asperity, flooded, *rest)


@single
def thermal_reduction_at_least_three_tenths():
    """Gupta's thermal reduction is never below 0.3: a floor that should not be there."""
    after(films, "thermal_reduction", lambda reduction, *given: max(reduction, 0.3))


# 7: units

@single
def index_row_by_wrong_unit():
    """The viscosity index compares Y in m2/s with row ends in mm2/s, so that it always takes the first row."""
    @put(liquids)
    def index_oils(at_100):
        y = 1e6 * at_100
        return [a * y * y + b * y + c for a, b, c in liquids.INDEX_OILS[0][1:]]


@single
def peak_shear_in_megapascals():
    """hertz_line gives the peak shear in MPa, not in Pa."""
    after(solver, "hertz_line", lambda result, *given: {**result, "peak_shear": 1e-6 * result["peak_shear"]})


@single
def kelvins_taken_for_degrees():
    """ASTM D341 adds 273.15 to temperatures that are in kelvins already."""
    before(liquids, "chart_temperature", lambda kelvin: (kelvin + 273.15,))


@single
def eyring_stress_in_megapascals():
    """The scene's Eyring or limiting stress is taken as MPa, though it is in Pa: friction uses 1e6 times it."""
    before(friction, "shear_stress", lambda law, stress, *rest: (law, 1e6 * stress, *rest))


# 8: numerics

def trapezoid_moment(order, d, step, reach):
    """F_n(d) by the trapezoid rule from d to d + reach."""
    places = [j * step for j in range(round(reach / step) + 1)]
    terms = [x**order * moments.density(x + d) for x in places]
    return step * (sum(terms) - (terms[0] + terms[-1]) / 2)


@single
def moments_by_coarse_trapezoid():
    """Gaussian moments by the trapezoid rule with steps of 0.5 from d to d + 8: too coarse for small d."""
    right = moments.log_moment

    @put(moments)
    def log_moment(order, d):
        return math.log(trapezoid_moment(order, d, 0.5, 8)) if -4 < d < 30 else right(order, d)


@single
def axes_ratio_stops_early():
    """The bisection for the ellipse's k ends when its bracket is narrower than 0.02; it has to go on."""
    @put(solver)
    def axes_ratio(alpha):
        low, high = 1.0, solver.beyond(lambda k: solver.radii_ratio(k) < alpha, 1.0)
        while high - low > 0.02:
            middle = (low + high) / 2
            low, high = (middle, high) if solver.radii_ratio(middle) < alpha else (low, middle)
        return (low + high) / 2


@single
def tail_by_one_minus_erf():
    """Gaussian moments of whole orders rest on (1 - erf)/2, which cancels for large d: take erfc, or integrate."""
    right = moments.gaussian_moment

    @put(moments)
    def gaussian_moment(order, d):
        if order != int(order):
            return right(order, d)
        tail = 0.5 * (1 - math.erf(d / math.sqrt(2)))
        first = moments.density(d) - d * tail
        return (tail, first, tail - d * first)[int(order)]


@single
def moment_cache_with_rounded_key():
    """gaussian_moment keeps its values by (n, d rounded to a tenth): each d gets the value of the first d with this key."""
    right, kept = moments.gaussian_moment, {}

    @put(moments)
    def gaussian_moment(order, d):
        key = order, round(d, 1)
        if key not in kept:
            kept[key] = right(order, d)
        return kept[key]


# 9: another author's law, fit or reading

@single
def axes_by_hamrock_brewe_fit():
    """The ellipse's k is Hamrock and Brewe's fit 1.0339 alpha^0.636, not the solution of Hertz' equation."""
    @put(solver)
    def axes_ratio(alpha):
        return 1.0339 * alpha**0.636


def tripp_fit(d):
    return 4.4086e-5 * (4 - d) ** 6.804 if d < 4 else 0.0


@single
def tripp_load_by_fit():
    """F_5/2 is the usual fit 4.4086e-5 (4 - d)^6.804, 0 beyond d = 4, in place of the integral."""
    after(moments, "log_moment", lambda value, order, d: solver.safe_log(tripp_fit(d)) if order == 2.5 else value)
    after(moments, "gaussian_moment", lambda value, order, d: tripp_fit(d) if order == 2.5 else value)


@single
def limiting_by_hyperbolic_tangent():
    """The limiting stress is approached as tanh(x) (another law of Bair and Winer's kind), not as 1 - exp(-x)."""
    after(friction, "reduced_stress", lambda value, law, log_x:
          math.tanh(math.exp(min(log_x, 10))) if law == "limiting" else value)


@single
def roelands_with_fixed_exponent():
    """Roelands' z is 0.6, a usual value of mineral oils, in place of the z that follows from alpha."""
    @put(liquids)
    def roelands(viscosity, alpha, pressure):
        return viscosity * math.exp((math.log(viscosity) + 9.67) * ((1 + pressure / 0.196e9) ** 0.6 - 1))


# 10: inputs or words of the scene ignored, exchanged or taken from elsewhere

@single
def roelands_friction_by_barus():
    """The word "roelands" of friction.viscosity is ignored: the film's viscosity follows Barus' law."""
    before(friction, "log_thickening", lambda law, *rest: ("barus" if law == "roelands" else law, *rest))


@single
def offset_planes_ignored():
    """surface.offset_planes is ignored: the offset always counts once, not 0, 1 or 2 times."""
    point.plane_offset = lambda scene: scene["surface.summit_plane_offset"]


@single
def friction_under_whole_pressure():
    """The film's viscosity is that at Hertz' whole mean pressure, not at the fluid's share of it."""
    before(friction, "friction", lambda given, mean_pressure: ({**given, "fluid_share": 1.0}, mean_pressure))


@single
def inlet_ratio_of_flooded_film():
    """supply.inlet_film_ratio is multiplied by the flooded film, not by the sd of the summits' heights."""
    after(point, "starved", lambda pair, scene, film: pair if scene["supply.inlet_film_ratio"] is None else
          inlet.starved(scene["closures.starvation"], 1 / scene["supply.inlet_film_ratio"],
                        scene["closures.damiens_exponent"]))


# Two or three at once

@combination
def first_poisson_ratio_and_half_approach():
    """effective_modulus takes nu1 for both bodies; hertz_point's approach is a^2/(2R) in place of a^2/R."""
    before(solver, "effective_modulus", lambda E1, nu1, E2, nu2: (E1, nu1, E2, nu1))
    after(solver, "approach", lambda value, *given: value / 2)


@combination
def central_film_speed_and_load():
    """hamrock_dowson_central has U^0.76 in place of U^0.67, and its W has E* in place of 2E*."""
    @put(solver)
    def hamrock_dowson_central(speed, viscosity, alpha, F, E, R, ellipticity):
        U, G, W = solver.film_numbers(speed, viscosity, alpha, F, E, R)
        return R * solver.film_constant(ellipticity) * U**0.76 * G**0.53 * (2 * W) ** -0.067


@combination
def moments_by_table_that_ends():
    """Gaussian moments come from a table of step 0.25 with linear interpolation, and are 0 from d = 4 on."""
    right = moments.gaussian_moment

    @put(moments)
    def gaussian_moment(order, d):
        if d >= 4:
            return 0.0
        left = math.floor(d / 0.25)
        part = d / 0.25 - left
        return (1 - part) * right(order, 0.25 * left) + part * right(order, 0.25 * (left + 1))


@combination
def moes_exponential_and_constant():
    """moes_line has exp(-EI/RI) in s, without the 2, and EP has 1.131 in place of 1.311."""
    @put(films)
    def moes_line(*given):
        M, L, unit = films.moes_numbers(*given)
        rigid, elastic = 3 / M, 2.621 * M**-0.2
        s = (7 + 8 * math.exp(-elastic / rigid)) / 5
        isoviscous = films.norm(7 / 3, rigid, elastic)
        piezoviscous = films.norm(-7 / 2, 1.287 * L ** (2 / 3), 1.131 * M**-0.125 * L**0.75)
        return unit * films.norm(s, isoviscous, piezoviscous)


@combination
def index_digits_of_two_rows():
    """Viscosity index: e of the row from 15 to 18 mm2/s is 5.7941 (5.9741), c from 28 to 40 is -57.07 (-50.77)."""
    index_row(18e-6, of_hundred=(0.28889, 5.7941, -4.93))
    index_row(40e-6, of_zero=(0.87031, 9.7157, -57.07))


@combination
def roelands_pressure_and_density():
    """roelands_viscosity has p_R = 0.169 GPa (0.196); dowson_higginson_density has 9.5e8 in place of 5.9e8."""
    @put(liquids)
    def roelands(viscosity, alpha, pressure):
        scale = math.log(viscosity) + 9.67
        return viscosity * math.exp(scale * ((1 + pressure / 0.169e9) ** (alpha * 0.169e9 / scale) - 1))

    @put(liquids)
    def density(pressure):
        return (9.5e8 + 1.34 * pressure) / (9.5e8 + pressure)


@combination
def friction_pressure_and_area():
    """Friction: viscosity at the whole mean pressure (not the fluid's share), and the film sheared over the whole area
    (not 1 - real area)."""
    friction_under_whole_pressure()
    friction.sheared_part = lambda area_ratio: 1.0


@combination
def moment_far_left_and_summit_count():
    """Gaussian moments left of d = -3 are (-d)^n; Greenwood and Tripp's summit count has 2 pi in place of 4 pi."""
    right = moments.log_moment

    @put(moments)
    def log_moment(order, d):
        return order * math.log(-d) if d < -3 else right(order, d)
    after(solver, "summit_count", lambda count, asperity, *rest: count / 2 if asperity == solver.TRIPP else count)


@combination
def wolveridge_constant_and_damiens_default():
    """Wolveridge's 2.7 psi is 2.17 psi, and damiens has the exponent 2 where none is given (3)."""
    inlet.log_film_ratio = lambda t: (math.log(4.34 / math.pi) + t if t < -30 else
                                      math.log(2 / math.pi * math.atan(2.17 * math.exp(min(t, 700)))))
    inlet.film_parts = lambda t: (math.exp(inlet.log_film_ratio(t)),
                                  2 / math.pi * math.atan(math.exp(-max(t, -700)) / 2.17))
    fields.FUNCTIONS["starvation_ratio"]["damiens_exponent"] = ("above 0", 2.0)
    fields.SCENE["closures.damiens_exponent"] = ("above 0", 2.0)


@combination
def gupta_modulus_and_slip_exponent():
    """Gupta: 13.2 p0/E* in place of 13.2 p0/(2E*), and S^0.38 in place of S^0.83."""
    @put(films)
    def thermal_reduction(p0, E, S, beta, viscosity, speed, conductivity):
        L = beta * viscosity * speed**2 / conductivity
        return (1 - 13.2 * p0 / E * L**0.42) / (1 + 0.213 * (1 + 2.23 * S**0.38) * L**0.64)


@combination
def ellipse_integrals_and_approach():
    """hertz_ellipse: the integrals stop after two steps of the mean, and the approach has K and E exchanged."""
    @put(solver)
    def complete_integrals(parameter, complement):
        mean, root, power, total = 1.0, math.sqrt(complement), 0.5, 0.5 * parameter
        for _ in range(2):
            half = (mean - root) / 2
            mean, root = (mean + root) / 2, math.sqrt(mean * root)
            power *= 2
            total += power * half * half
        first = math.pi / (mean + root)
        return first, first * (1 - total), total

    @put(solver)
    def approach_of_ellipse(F, E, Rx, Ry, k, first, second):
        R = solver.radius_of_both(Rx, Ry)
        return solver.minor_axis(F, E, R, k, second) ** 2 * second / (2 * R * first)


@combination
def boundary_friction_whole_and_default_slip():
    """Boundary friction is not weighted by the asperities' share; the slide-roll ratio is 0 where none is given (1)."""
    friction.boundary_friction = lambda coefficient, asperity_share: coefficient
    fields.SCENE["friction.slide_roll_ratio"] = ("from 0", 0.0)


@combination
def astm_constant_and_unit():
    """ASTM D341 has 0.6 in place of 0.7 on both ways, and its result is in mm2/s, not in m2/s."""
    liquids.chart = lambda viscosity: math.log10(math.log10(1e6 * viscosity + 0.6))
    liquids.viscosity_of = lambda height: 10 ** (10**height) - 0.6


@combination
def line_width_and_mean_pressure():
    """hertz_line's b has E* in the formula for E' (b^2 = 8wR/(pi E*)); the mean pressure is w/b, without the 2."""
    @put(solver)
    def hertz_line(load, E, R):
        b = math.sqrt(8 * load * R / (math.pi * E))
        peak = 2 * load / (math.pi * b)
        return {"half_width": b, "mean_pressure": load / b, "peak_pressure": peak,
                "peak_shear": solver.line_shear_over_peak() * peak}


@combination
def three_of_summits():
    """Summits: density m4/(4 pi sqrt(3) m2) (6 pi), radius 0.357 sqrt(pi/m4) (0.375), sd with 0.8698 (0.8968)."""
    @put(liquids)
    def summits(m0, m2, m4):
        bandwidth = m0 * m4 / m2**2
        sd = math.sqrt((1 - 0.8698 / bandwidth) * m0)
        return {"bandwidth": bandwidth, "summit_density": m4 / (4 * math.pi * math.sqrt(3) * m2),
                "summit_radius": 0.357 * math.sqrt(math.pi / m4), "summit_height_sd": sd,
                "summit_plane_offset": 4 * math.sqrt(m0 / (math.pi * bandwidth)) / sd}


@combination
def three_regimes():
    """regime_film: phi of isoviscous_rigid is 1 + 2/(3 alpha), not its reciprocal; viscous_rigid_barus has g_V^(3/2),
    not ^(2/3); viscous_elastic looks at alpha where it needs k."""
    @put(films)
    def regime_film(regime, g_V, g_E, alpha, k, right=films.regime_film):
        if regime == "isoviscous_rigid":
            return 128 * alpha * ((1 + 2 / (3 * alpha)) * (0.131 * math.atan(alpha / 2) + 1.683)) ** 2
        if regime == "viscous_rigid_barus":
            return 1.66 * g_V**1.5 * -math.expm1(-0.68 * k)
        return right(regime, g_V, g_E, alpha, alpha if regime == "viscous_elastic" else k)


@combination
def load_sharing_stops_and_exponent():
    """load_sharing iterates lam = (lam + lam0 (1 - A)^-0.14)/2 and stops at steps below 1 % of lam;
    greenwood_williamson's A has the exponent 1/2 of greenwood_tripp."""
    solver.share_exponent = lambda asperity: 0.5

    @put(solver)
    def load_sharing(asperity, flooded, K, delta, exponent=None):
        floor = solver.floor_of(asperity, K, delta)
        lam = max(flooded, floor) * 1.02 + 1e-3
        for _ in range(200):
            fluid = -math.expm1(min(solver.log_share(asperity, K, delta, lam), -1e-15))
            step = (flooded * fluid ** -(exponent or 0.14) - lam) / 2
            lam = max(lam + step, floor * (1 + 1e-12))
            if abs(step) < 0.01 * lam:
                break
        return lam


@combination
def soft_brackets_and_minimum_exponent():
    """The soft film laws have each other's bracket (0.72, 0.28; 0.85, 0.31); hamrock_dowson_minimum has G^0.94."""
    films.POINTS |= {"hamrock_dowson_soft_central": (7.32, 0.64, 0, -0.22, 0.85, 0.31),
                     "hamrock_dowson_soft_minimum": (7.43, 0.65, 0, -0.21, 0.72, 0.28),
                     "hamrock_dowson_minimum": (3.63, 0.68, 0.94, -0.073, 1, 0.68)}


@combination
def three_of_the_inlet():
    """The inlet film is flow over the sum of speeds; the inlet is called flooded from 0.9 on, not 0.95;
    closure starved_inlet is answered by flooded_inlet."""
    inlet_flow_over_sum_of_speeds()
    after(solver, "inlet_state", lambda word, ratio: "flooded" if ratio >= 0.9 else word)
    before(inlet, "starved", lambda closure, *rest: (
        "flooded_inlet" if closure == "starved_inlet" else closure, *rest))


@combination
def line_load_and_sharing_exponent():
    """The film laws of lines take the load, not the load per length; load sharing has the exponent 0.14 with all laws."""
    @put(point)
    def flooded_film(scene, contact, right=point.flooded_film):
        film = right(scene, contact)
        law = scene["closures.film"]
        return film * scene["bodies.length"] ** films.LINES[law][3] if law in films.LINES else film
    point.sharing_exponent = lambda law: None


SLIPS = SINGLES + COMBINATIONS
