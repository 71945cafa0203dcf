# SPDX-License-Identifier: Apache-2.0
"""Films that formulas give for a circle beside the solved one, over the numbers M of load and L of material, in two liquids."""
import itertools
import json
import math
import statistics
import typing

from group import Group, Missing, finding
from line_films import rows_of
from numbers_text import exact

# Bodies of steel and a mineral oil, as those of the table of the compressible liquid: some formulas depend on U a little.
PRESSURE_VISCOSITY, MODULUS = 20e-9, 115.4e9  # 1/Pa, Pa
TABLES = {"barus, incompressible": "point_films.csv", "roelands, compressible": "point_films_compressible.csv"}
WITHIN = 0.1
# Any circle: its formulas' films tell in which ratio they stand to each other.
BALL, BALL_SPEED = "ball_on_flat", 10.0  # m/s
# Questions to `tribocheck stream`, by the name in `tribocheck film`.
ASKED = {"hamrock_dowson_central": {"function": "hamrock_dowson_central", "reduced_radius": 1},
         "hamrock_dowson_minimum": {"function": "hamrock_dowson_minimum", "radius_x": 1}} | {
    name: {"function": "nijenbanning_venner_moes", "radius_x": 1, "radius_y": 1, **reading} for name, reading in {
        "nijenbanning_venner_moes": {}, "nijenbanning_three_halves_of_s": {"bracket": "three_halves_of_s"},
        "nijenbanning_ei_over_ep": {"exponent": "ei_over_ep"},
        "nijenbanning_ei_over_ep_of_s": {"exponent": "ei_over_ep", "bracket": "three_halves_of_s"}}.items()}
# Their films of circles are multiples of this one: the powers of U, G and W are the same.
CHITTENDEN, CHITTENDENS_POWERS = "chittenden_", "hamrock_dowson_minimum"


class Formula(typing.NamedTuple):
    name: str  # as `tribocheck film` has it
    quantity: str  # "central" or "minimum"
    question: dict
    multiple: float = 1.0


class Film(typing.NamedTuple):
    """A solved circle: film numbers (h/R)(2U)^(−1/2), and their errors."""
    load: float
    material: float
    film: dict
    error: dict


def formulas_of(program, places):
    """The formulas of circles beside which `tribocheck film` puts a solved ball, without those of liquids of constant viscosity."""
    ball, = program.answer("film", places.reference / f"scenes/{BALL}.toml", "--speed", BALL_SPEED, "--tolerance", 1e-2)["films"]
    films = {one["name"]: one["film"] for one in ball["formulas"]}
    made = []
    for one in ball["formulas"]:
        name, quantity = one["name"], one["stands_for"].removesuffix("_film")
        if name in ASKED:
            made.append(Formula(name, quantity, ASKED[name]))
        elif name.startswith(CHITTENDEN):
            made.append(Formula(name, quantity, ASKED[CHITTENDENS_POWERS], films[name] / films[CHITTENDENS_POWERS]))
    return made


def films_of(path):
    """The flooded circles with L > 0 of the material numbers that all load numbers have."""
    try:
        films = [Film(float(row["load_number"]), float(row["material_number"]), *(
            {name: float(row[name + end]) for name in ("central", "minimum")} for end in ("", "_error")))
            for row in rows_of(path) if float(row["radius_ratio"]) == 1 and not row["supply"] and float(row["material_number"]) > 0]
    except (KeyError, TypeError, ValueError) as error:
        raise Missing(f"{path.name} has a row that is no film: {error}") from error
    loads = {one.load for one in films}
    films = [one for one in films if loads == {other.load for other in films if other.material == one.material}]
    if not films:
        raise Missing(f"{path.name} has no flooded circles")
    return sorted(films)


def numbers_of(program, formula, films):
    """The film numbers of a formula, by circles whose E*, R and viscosity are 1."""
    twice = [math.pow(one.material / (2 * PRESSURE_VISCOSITY * MODULUS), 4) for one in films]  # 2U
    answers = program.ask(*(json.dumps(formula.question | {
        "speed": u, "viscosity": 1, "pressure_viscosity": one.material / math.pow(u, 0.25) / 2, "load": 2 * one.load * math.pow(u, 0.75),
        "effective_modulus": 1}) for one, u in zip(films, twice)))
    return [formula.multiple * answer["value"] / math.sqrt(u) for answer, u in zip(answers, twice)]


def widest_block(errors):
    """Of errors by (M, L): the ends of the block of neighbouring M and L with the most contacts in which no error exceeds WITHIN;
    None where no contact is within."""
    loads, materials = (sorted({place[i] for place in errors}) for i in (0, 1))

    def ends(numbers):
        return list(itertools.combinations_with_replacement(range(len(numbers)), 2))
    best, found = 0, None
    for (a, b), (c, d) in itertools.product(ends(loads), ends(materials)):
        count = (b - a + 1) * (d - c + 1)
        if count > best and all(abs(errors[place]) <= WITHIN for place in itertools.product(loads[a:b + 1], materials[c:d + 1])):
            best, found = count, {"contacts": count, "least_load": loads[a], "greatest_load": loads[b], "least_material": materials[c],
                                  "greatest_material": materials[d]}
    return found


def judged(liquid, films, errors):
    worst, at = max(zip(errors, films), key=lambda one: abs(one[0]))
    return {"liquid": liquid, "median": statistics.median(errors), "median_size": statistics.median(map(abs, errors)),
            "worst": {"error": worst, "load_number": at.load, "material_number": at.material},
            "contacts_within": sum(abs(error) <= WITHIN for error in errors),
            "within": widest_block({(one.load, one.material): error for one, error in zip(films, errors)})}


def point_films(asked):
    films = {liquid: films_of(asked.places.reference / "ehl" / name) for liquid, name in TABLES.items()}
    formulas, blocks = [], []
    for formula in formulas_of(asked.program, asked.places):
        errors = {liquid: [number / one.film[formula.quantity] - 1
                           for number, one in zip(numbers_of(asked.program, formula, of), of)] for liquid, of in films.items()}
        formulas.append({"name": formula.name, "quantity": formula.quantity,
                         "liquids": [judged(liquid, films[liquid], of) for liquid, of in errors.items()]})
        blocks.append(f'"{formula.name}"\n' + "".join(
            f"{exact(one.load)}\t{exact(one.material)}\t{liquid.split(',')[0].title()}\t{100 * error:.4g}\n"
            for liquid, of in errors.items() for one, error in zip(films[liquid], of)))
    told = [{"liquid": liquid, "contacts": len(of), "loads": sorted({one.load for one in of}), "materials": sorted({one.material for one in of}),
             "greatest_error": {name: max(one.error[name] / one.film[name] for one in of) for name in ("central", "minimum")}}
            for liquid, of in films.items()]
    return Group({"pressure_viscosity": PRESSURE_VISCOSITY, "effective_modulus": MODULUS, "within": WITHIN, "liquids": told,
                  "formulas": formulas}, [finding("point_films", "film-points", "software", "measured")],
                 files=[("data/point_film_errors.blocks.tsv", "# errors of formulas for the film of a circle against the solved film, each formula "
                         "a block\n# load number M\tmaterial number L\tliquid\terror [%]\n" + "\n\n".join(blocks))])
