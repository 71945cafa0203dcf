# SPDX-License-Identifier: Apache-2.0
"""Slips that were written after the two sets, for causes that `tribocheck verify` has named since."""

import functools
import math

import fields
import films
import friction
import liquids
import point
import solver

SLIPS = []


def slip(function):
    SLIPS.append(function)
    return function


@slip
def line_film_and_its_sharing_exponent():
    """dowson_toyoda_central has U^0.68 in place of U^0.69, and load sharing with it has the exponent 0.2 in place of 0.69 - 0.56."""
    row = films.LINES["dowson_toyoda_central"]
    films.LINES["dowson_toyoda_central"] = (row[0], 0.68, *row[2:])

    def sharing_exponent(right, law):
        return 0.2 if law == "dowson_toyoda_central" else right(law)
    point.sharing_exponent = functools.partial(sharing_exponent, point.sharing_exponent)


def change(module, name):
    """Replaces a function of the module by the decorated one, which gets the right one first."""
    def replace(wrong):
        setattr(module, name, functools.partial(wrong, getattr(module, name)))
    return replace


@slip
def stiffness_kept_without_load():
    """The stiffness K of the asperities is kept under a key that has neither the load nor the contact's area."""
    kept = {}

    @change(solver, "stiffness")
    def wrong(right, asperity, density, summit_radius, sd, F, E, area):
        return kept.setdefault((asperity, density, summit_radius, sd, E), right(asperity, density, summit_radius, sd, F, E, area))


@slip
def closures_kept_where_left_out():
    """The options under closures, but for the film, stand in a global object, so that a point that leaves one out gets the last one given."""
    kept = {}

    @change(fields, "read")
    def wrong(right, given, allowed):
        result = right(given, allowed)
        if allowed is fields.SCENE:
            options = [name for name in result if name.startswith("closures.") and name != "closures.film"]
            kept.update({name: result[name] for name in options if name in given})
            result.update({name: kept[name] for name in options if name in kept})
        return result


@slip
def moes_exponent_is_static():
    """The exponent s of Moes' line formula is set at the first call and kept for all later ones."""
    kept = []

    @change(films, "moes_line")
    def wrong(right, *given):
        M, L, unit = films.moes_numbers(*given)
        rigid, elastic = 3 / M, 2.621 * M**-0.2
        kept.append((7 + 8 * math.exp(-2 * elastic / rigid)) / 5)
        piezoviscous = films.norm(-7 / 2, 1.287 * L ** (2 / 3), 1.311 * M**-0.125 * L**0.75)
        return unit * films.norm(kept[0], films.norm(7 / 3, rigid, elastic), piezoviscous)


@slip
def moes_norms_of_whole_numbers():
    """The exponents 7/3 and -7/2 of the sums in Moes' line formula are integer divisions, 2 and -3."""
    @change(films, "norm")
    def wrong(right, p, *numbers):
        return right({7 / 3: 2, -7 / 2: -3}.get(p, p), *numbers)


@slip
def chart_of_old_and_rounded_zero():
    """The viscosity chart adds 0.6 in place of 0.7, and temperatures come back from degrees Celsius with 273 in place of 273.15."""
    change(liquids, "chart")(lambda right, viscosity: math.log10(math.log10(1e6 * viscosity + 0.6)))
    change(liquids, "viscosity_of")(lambda right, height: 1e-6 * (10 ** (10**height) - 0.6))
    change(liquids, "chart_temperature")(lambda right, kelvin: math.log10(kelvin - 273.15 + 273))


@slip
def roelands_exponent_of_two_decimals():
    """Roelands' exponent z is rounded to two decimals, as data sheets print it."""
    @change(liquids, "roelands")
    def wrong(right, viscosity, alpha, pressure):
        scale = math.log(viscosity) + 9.67
        z = round(alpha * 0.196e9 / scale, 2)
        return viscosity * math.exp(scale * ((1 + pressure / 0.196e9) ** z - 1))


@slip
def minimum_film_of_converted_ellipticity():
    """The minimum film converts the given ellipticity once more, by 1.0339 k^0.636."""
    @change(films, "point_film")
    def wrong(right, name, *given):
        if name == "hamrock_dowson_minimum":
            given = (*given[:-1], 1.0339 * given[-1] ** 0.636)
        return right(name, *given)


@slip
def friction_of_smooth_film_and_no_zero():
    """The film is sheared over the smooth flooded film, a slide-roll ratio of 0 becomes the default 1, and roelands falls through to barus."""
    smooth = []

    @change(point, "flooded_film")
    def watched(right, *given):
        smooth[:] = [right(*given)]
        return smooth[0]
    change(friction, "shear_rate")(lambda right, speed, ratio, separation: (ratio or 1.0) * speed / smooth[0])
    change(friction, "log_thickening")(lambda right, law, *rest: right("ambient" if law == "ambient" else "barus", *rest))


@slip
def index_by_e_of_next_row_and_not_below_zero():
    """The viscosity index has the natural logarithm above 100, the row of the table after the right one, and no number below 0."""
    @change(liquids, "index_oils")
    def wrong_row(right, at_100):
        y = 1e6 * at_100
        row = next(i for i, oils in enumerate(liquids.INDEX_OILS, 1) if at_100 <= oils[0])
        return [a * y * y + b * y + c for a, b, c in liquids.INDEX_OILS[min(row, len(liquids.INDEX_OILS) - 1)][1:]]

    @change(liquids, "viscosity_index")
    def wrong(right, at_40, at_100):
        zero, hundred = liquids.index_oils(at_100)
        if 1e6 * at_40 >= hundred:
            return max(0.0, 100 * (zero - 1e6 * at_40) / (zero - hundred))
        return 100 + ((hundred / (1e6 * at_40)) ** (1 / math.log(1e6 * at_100)) - 1) / 0.00715


@slip
def summits_of_a_square_metre():
    """The number of summits is that of a square metre."""
    change(solver, "summit_count")(lambda right, asperity, roughness, density, area, d: right(asperity, roughness, density, 1.0, d))
