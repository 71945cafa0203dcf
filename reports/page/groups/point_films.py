# SPDX-License-Identifier: Apache-2.0
"""Compares films that formulas give with solved films: for circles over the load number M and the material number L, in two liquids, and
for ellipses of several shapes."""
import itertools
import json
import math
import statistics
import typing

from group import Group, Missing, finding
from line_films import rows_of
from numbers_text import exact

# Steel and a mineral oil, as in the table of the compressible liquid. They give U from L: some formulas depend on U a little at the same M and L.
PRESSURE_VISCOSITY, MODULUS = 20e-9, 115.4e9  # 1/Pa, Pa
TABLES = {"barus, incompressible": "point_films.csv", "roelands, compressible": "point_films_compressible.csv"}
WITHIN = 0.1
# Any contact whose film is soon solved. It gives the ratios of films by formulas that have the same powers.
CONTACT = {"load": 4, "speed": 1, "bodies": {"effective_modulus": MODULUS, "radius_x": 0.01},
           "lubricant": {"viscosity": 0.02, "pressure_viscosity": 2e-9}}
# Questions to `tribocheck stream`, each by the name that its formula has in `tribocheck film`.
ASKED = {name: {"function": name} for name in ("hamrock_dowson_central", "hamrock_dowson_minimum")} | {
    name: {"function": "nijenbanning_venner_moes", **reading} for name, reading in {
        "nijenbanning_venner_moes": {}, "nijenbanning_three_halves_of_s": {"bracket": "three_halves_of_s"},
        "nijenbanning_ei_over_ep": {"exponent": "ei_over_ep"},
        "nijenbanning_ei_over_ep_of_s": {"exponent": "ei_over_ep", "bracket": "three_halves_of_s"}}.items()}
# Films by formulas whose names begin with CHITTENDEN are multiples of the film by CHITTENDENS_POWERS in contacts of one shape, because
# the powers of U, G and W are the same.
CHITTENDEN, CHITTENDENS_POWERS = "chittenden_", "hamrock_dowson_minimum"


class Formula(typing.NamedTuple):
    name: str  # as `tribocheck film` has it
    quantity: str  # "central" or "minimum"
    question: dict
    multiple: float = 1.0


class Film(typing.NamedTuple):
    """A solved contact: film numbers (h/R_x)(2U)^(−1/2), and their errors."""
    load: float
    material: float
    film: dict
    error: dict


def formulas_of(program, ratio):
    """The formulas that `tribocheck film` compares with a solved contact of this R_y/R_x. Those for liquids of constant viscosity are left
    out."""
    scene = CONTACT | {"bodies": CONTACT["bodies"] | {"radius_y": ratio * CONTACT["bodies"]["radius_x"]}}
    contact, = program.answer("film", "-", "--tolerance", 1e-2, text=json.dumps(scene))["films"]
    films = {one["name"]: one["film"] for one in contact["formulas"]}
    made = []
    for one in contact["formulas"]:
        name, quantity = one["name"], one["stands_for"].removesuffix("_film")
        if name in ASKED:
            made.append(Formula(name, quantity, ASKED[name]))
        elif name.startswith(CHITTENDEN):
            made.append(Formula(name, quantity, ASKED[CHITTENDENS_POWERS], films[name] / films[CHITTENDENS_POWERS]))
    return made


def films_of(path):
    """The flooded contacts with L > 0 by their R_y/R_x. A material number is left out unless the table has it at every load number."""
    by_ratio = {}
    try:
        for row in rows_of(path):
            if not row["supply"] and float(row["material_number"]) > 0:
                by_ratio.setdefault(float(row["radius_ratio"]), []).append(Film(float(row["load_number"]), float(row["material_number"]), *(
                    {name: float(row[name + end]) for name in ("central", "minimum")} for end in ("", "_error"))))
    except (KeyError, TypeError, ValueError) as error:
        raise Missing(f"{path.name} has a row that is no film: {error}") from error
    for ratio, films in by_ratio.items():
        loads = {one.load for one in films}
        by_ratio[ratio] = sorted(one for one in films if loads == {other.load for other in films if other.material == one.material})
    if not by_ratio.get(1.0):
        raise Missing(f"{path.name} has no flooded circles")
    return by_ratio


def numbers_of(program, formula, ratio, films):
    """The film numbers of a formula at M and L of the films. It is asked for contacts whose E*, R_x and viscosity are 1."""
    twice = [math.pow(one.material / (2 * PRESSURE_VISCOSITY * MODULUS), 4) for one in films]  # 2U
    answers = program.ask(*(json.dumps(formula.question | {
        "speed": u, "viscosity": 1, "pressure_viscosity": one.material / math.pow(u, 0.25) / 2, "load": 2 * one.load * math.pow(u, 0.75),
        "effective_modulus": 1, "radius_x": 1, "radius_y": ratio}) for one, u in zip(films, twice)))
    return [formula.multiple * answer["value"] / math.sqrt(u) for answer, u in zip(answers, twice)]


def widest_block(errors):
    """Finds the block of neighbouring M and L with the most contacts whose errors, given by (M, L), are all at most WITHIN. Returns its ends,
    or None if no error is so small."""
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


def errors_of(program, formula, ratio, films):
    return [number / one.film[formula.quantity] - 1 for number, one in zip(numbers_of(program, formula, ratio, films), films)]


def ellipses(program, films):
    """The least and the greatest error of each formula, for each shape of the solved ellipses."""
    shapes = []
    for ratio in sorted(set(films) - {1.0}):
        errors = {formula.name: errors_of(program, formula, ratio, films[ratio]) for formula in formulas_of(program, ratio)}
        shapes.append({"radius_ratio": ratio, "loads": sorted({one.load for one in films[ratio]}),
                       "materials": sorted({one.material for one in films[ratio]}),
                       "formulas": [{"name": name, "least": min(of), "greatest": max(of)} for name, of in errors.items()]})
    return shapes


def point_films(asked):
    tables = {liquid: films_of(asked.places.reference / "ehl" / name) for liquid, name in TABLES.items()}
    films = {liquid: of[1.0] for liquid, of in tables.items()}
    formulas, blocks = [], []
    for formula in formulas_of(asked.program, 1):
        errors = {liquid: errors_of(asked.program, formula, 1, of) for liquid, of in films.items()}
        formulas.append({"name": formula.name, "quantity": formula.quantity,
                         "liquids": [judged(liquid, films[liquid], of) for liquid, of in errors.items()]})
        blocks.append(f'"{formula.name}"\n' + "".join(
            f"{exact(one.load)}\t{exact(one.material)}\t{liquid.split(',')[0].title()}\t{100 * error:.4g}\n"
            for liquid, of in errors.items() for one, error in zip(films[liquid], of)))
    told = [{"liquid": liquid, "contacts": len(of), "loads": sorted({one.load for one in of}), "materials": sorted({one.material for one in of}),
             "greatest_error": {name: max(one.error[name] / one.film[name] for one in of) for name in ("central", "minimum")}}
            for liquid, of in films.items()]
    return Group({"pressure_viscosity": PRESSURE_VISCOSITY, "effective_modulus": MODULUS, "within": WITHIN, "liquids": told,
                  "formulas": formulas, "ellipses": ellipses(asked.program, next(iter(tables.values())))}, [finding("point_films", "film-points", "software", "measured")],
                 files=[("data/point_film_errors.blocks.tsv", "# errors of formulas for the film of a circle against the solved film, each formula "
                         "a block\n# load number M\tmaterial number L\tliquid\terror [%]\n" + "\n\n".join(blocks))])
