# SPDX-License-Identifier: Apache-2.0
"""Errors of the published fits to Hertz' ellipse over the ratio of the radii. The fits are those of
reference/mistakes.toml, by which `tribocheck verify --subject` explains wrong answers."""
import json
import math

import scenes
from group import Group, Missing
from numbers_text import exact

GREATEST_RATIO, MODERATE_RATIO = 1e4, 10.0
RATIO_STEPS = 320  # steps of α, even in its logarithm
LOAD, MODULUS, RADIUS = 50.0, 107.9e9, 9.5e-3  # N, Pa, m: the errors depend on the ratio alone
TOLD = {"ellipticity": "ellipticity", "semi_axis_x": "semi-axis a_x", "peak_pressure": "peak pressure", "approach": "approach"}


def of_fits(ratio, numbers):
    """k = c α^e, and its integrals K = f + g ln α, E = h + i/α."""
    c, e, f, g, h, i = numbers
    return c * math.pow(ratio, e), f + g * math.log(ratio), h + i / ratio


def of_logarithms(ratio, _):
    """k by a fit, K of this k by the arithmetic-geometric mean, and E by a fit."""
    k = 1 + math.sqrt(math.log(16 * ratio) * ratio / 2) - math.sqrt(math.log(4)) - 0.16 * math.log(ratio)
    greater, less = 1.0, 1 / k
    while greater - less > 1e-8 * greater:
        greater, less = (greater + less) / 2, math.sqrt(greater * less)
    second = math.pi / 2 / (k * k) * (1 + 2 * (k * k - 1) / math.pi + 0.25 * math.log(k))
    return k, math.pi / (greater + less), second


# The authors of each fit, by its name in mistakes.toml.
AUTHORS = {"ellipse-fit-1.0339": "Brewe and Hamrock, 1977", "ellipse-fit-2/π": "Hamrock and Brewe, 1983",
           "ellipse-fit-1.03": "k: Hamrock and Dowson, 1976; K and E: Hamrock and Brewe, 1983",
           "ellipse-fit-logarithms": "Nijenbanning, Venner and Moes, 1994"}
FORMULAS = {"ellipse_of_fits": of_fits, "ellipse_of_logarithms": of_logarithms}


def fits_of(places):
    """The fits of k that have fits of the integrals, too. Fits named …-of-k are left out: they have the integrals of their k."""
    try:
        return [one for one in scenes.read(places.reference / "mistakes.toml")["mistake"]
                if one["function"] == "hertz_ellipse" and one["name"].startswith("ellipse-fit-") and not one["name"].endswith("-of-k")]
    except (LookupError, TypeError, AttributeError) as error:
        raise Missing(f"reference/mistakes.toml has another shape: {error}") from error


def formula_of(fit):
    """The formula in the text of the fit: "k = 1.0339 α^0.636"."""
    _, start, rest = fit["text"].partition("k = ")
    return start + rest.partition(" in place")[0].partition(", ")[0] if start else fit["name"]


def ellipse_of(fit, ratio):
    """The results of the fit at R_y/R_x."""
    formula = fit["formula"]
    k, first, second = FORMULAS[formula["name"]](RADIUS * ratio / RADIUS, formula.get("numbers"))
    reduced = 1 / (1 / RADIUS + 1 / (RADIUS * ratio))
    minor = math.cbrt(3 * second * LOAD * reduced / (math.pi * k * MODULUS))
    return {"semi_axis_x": minor, "ellipticity": k, "peak_pressure": 1.5 * (LOAD / (math.pi * k * minor * minor)),
            "approach": minor * minor * first / (2 * reduced * second)}


def ellipse_fits(asked):
    fits = fits_of(asked.places)
    if not fits:
        raise Missing("reference/mistakes.toml has no fits to Hertz' ellipse")
    ratios = [math.pow(GREATEST_RATIO, step / RATIO_STEPS) for step in range(RATIO_STEPS + 1)]
    right = asked.program.ask(*(json.dumps({"function": "hertz_ellipse", "load": LOAD, "effective_modulus": MODULUS,
                                            "radius_x": RADIUS, "radius_y": RADIUS * ratio}) for ratio in ratios))
    told, blocks = [], []
    for fit in fits:
        errors = {name: [] for name in TOLD}
        for ratio, one in zip(ratios, right):
            got = ellipse_of(fit, ratio)
            for name in TOLD:
                errors[name].append(got[name] / one[name] - 1)
        blocks.append(f'"{formula_of(fit)}"\n' + "".join("\t".join(map(exact, row)) + "\n" for row in zip(ratios, *errors.values())))
        moderate = sum(ratio <= MODERATE_RATIO for ratio in ratios)
        told.append({"name": formula_of(fit), "text": fit["text"], "authors": AUTHORS.get(fit["name"], "")} | {
            name: {quantity: max(map(abs, all_errors[:count])) for quantity, all_errors in errors.items()}
            for name, count in (("greatest", len(ratios)), ("moderate", moderate))})
    heading = "\t".join(["R_y/R_x", *TOLD.values()])
    return Group({"greatest_ratio": GREATEST_RATIO, "moderate_ratio": MODERATE_RATIO, "fits": told}, files=[
        ("data/ellipse_fits.blocks.tsv",
         f"# relative errors of fits to Hertz' ellipse, each a block\n# {heading}\n" + "\n\n".join(blocks))])
