# SPDX-License-Identifier: Apache-2.0
"""Compares the closures of starvation with solved starved films of circles, and shows solved films of the paper's three surfaces."""
import csv
import itertools
import math

from baselines import from_baseline, number, number_or_none
from group import Group, Missing, finding
from numbers_text import exact
from scenes import DEPARTURE

CLOSURES = ("flooded_inlet", "starved_inlet", "printed_exponents", "damiens")
SURFACES = ("smooth", "medium", "rough")
LEAST_SUPPLY, GREATEST_SUPPLY, SUPPLY_STEPS = 0.2, 5.0, 160
CURVE_STEPS = 200  # over the speeds of a surface
SEARCH_STEPS = 500  # between the neighbours of the greatest point
LEAST_EXPONENT, GREATEST_EXPONENT = 0.1, 50.0


# --- The table.

def damiens_ratio(supply, exponent):
    """ρ/(1 + ρ^γ)^(1/γ)."""
    return supply / math.pow(1 + math.pow(supply, exponent), 1 / exponent)


def damiens_exponent(supply, ratio):
    """The γ with which Damiens' closure gives the ratio, which rises with γ; None if no γ from LEAST_EXPONENT to GREATEST_EXPONENT does."""
    low, high = LEAST_EXPONENT, GREATEST_EXPONENT
    if not damiens_ratio(supply, low) < ratio < damiens_ratio(supply, high):
        return None
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if damiens_ratio(supply, middle) < ratio else (low, middle)
    return (low + high) / 2


def table_of(places):
    """The contacts of the table by load and material number, each with its ratios ℛ of starved to flooded film over the supplies."""
    path = places.reference / "ehl/point_films.csv"
    try:
        with path.open(encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        films = {}
        for row in rows:
            if float(row["radius_ratio"]) == 1 and row["central"]:
                key = float(row["load_number"]), float(row["material_number"])
                films.setdefault(key, {})[float(row["supply"] or "inf")] = float(row["central"]), float(row["central_error"])
    except OSError as error:
        raise Missing(f"`{places.shown(path)}` is not there") from error
    except (ValueError, KeyError, TypeError) as error:
        raise Missing(f"`{places.shown(path)}` has another shape: {error}") from error
    contacts = []
    for (load, material), of in sorted(films.items()):
        flooded = of.pop(math.inf, None)
        if flooded is None or not of:
            continue
        points = []
        for supply, (film, error) in sorted(of.items()):
            ratio = film / flooded[0]
            off = ratio * (error / film + flooded[1] / flooded[0])
            exponent, less = damiens_exponent(supply, ratio), damiens_exponent(supply, ratio - off)
            points.append({"supply": supply, "ratio": ratio, "error": off, "exponent": exponent,
                           "exponent_error": None if exponent is None or less is None else exponent - less})
        contacts.append({"load_number": load, "material_number": material, "points": points})
    if not contacts:
        raise Missing("reference/ehl/point_films.csv has no starved films")
    return contacts


def ratios_of(program, closures_and_supplies):
    """The ratio that each closure gives, by `tribocheck stream`."""
    return [one["value"] for one in program.ask(*(
        f'{{"function": "starvation_ratio", "closure": "{closure}", "flooded_over_inlet": {1 / supply!r}}}'
        for closure, supply in closures_and_supplies))]


def judged(program, contacts):
    """For each supply: the least and the greatest of the ratios, of the exponents, and of the closures' deviations from the ratios."""
    supplies = sorted({point["supply"] for one in contacts for point in one["points"]})
    asked = list(itertools.product(CLOSURES, supplies))
    given = dict(zip(asked, ratios_of(program, asked)))
    rows = []
    for supply in supplies:
        points = [point for one in contacts for point in one["points"] if point["supply"] == supply]
        ratios, exponents = [one["ratio"] for one in points], [one["exponent"] for one in points if one["exponent"] is not None]
        row = {"supply": supply, "contacts": len(points), "ratio": {"least": min(ratios), "greatest": max(ratios)},
               "error": max(one["error"] for one in points),
               "exponent": {"least": min(exponents, default=None), "greatest": max(exponents, default=None),
                            "error": max((one["exponent_error"] for one in points if one["exponent_error"] is not None), default=None)},
               "closures": {}}
        for closure in CLOSURES:
            off = [given[closure, supply] / ratio - 1 for ratio in ratios]
            row["closures"][closure] = {"least": min(off), "greatest": max(off)}
        rows.append(row)
    return rows


# --- The paper's surfaces.

def estimate(value):
    return number(value["value"]), number(value["error"])


def points_of(rows):
    points = []
    for row in rows:
        film, error = estimate(row["central_film"])
        flooded, _ = estimate(row["flooded_central_film"])
        ratio, ratio_error = estimate(row["film_ratio"])
        points.append({
            "speed": number(row["speed"]), "load_number": number(row["load_number"]), "material_number": number(row["material_number"]),
            "film": film, "error": error, "flooded": flooded, "ratio": ratio, "ratio_error": ratio_error,
            "exponent": number_or_none(row["damiens_exponent"]), "closures": {name: number(row["closures"][name]) for name in CLOSURES},
            **{name: number_or_none(row.get(name)) for name in ("film_parameter", "asperity_load_share", "friction")}})
    if len(points) < 4 or any(one["speed"] >= two["speed"] for one, two in itertools.pairwise(points)):
        raise ValueError("a surface has fewer than four speeds, or they do not rise")
    return points


def interpolated(places, values, at):
    """The value at a place, by the cubic through the four neighbouring values."""
    first = min(max(sum(place <= at for place in places) - 2, 0), len(places) - 4)
    near = range(first, first + 4)
    return sum(values[i] * math.prod((at - places[k]) / (places[i] - places[k]) for k in near if k != i) for i in near)


def falls_below(points, ratio_of, level):
    """The speed at which a ratio, which falls with the speed, falls below the level; None where it does not within the speeds."""
    places, values = [math.log(one["speed"]) for one in points], [ratio_of(one) for one in points]
    for i, (before, after) in enumerate(itertools.pairwise(values)):
        if before >= level > after:
            low, high = places[i], places[i + 1]
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if interpolated(places, values, middle) >= level else (low, middle)
            return math.exp((low + high) / 2)
    return None


def greatest_within(points, value_of):
    """The speed at which the cubic around the greatest point is greatest; None where that point is at an end."""
    values, places = [value_of(one) for one in points], [math.log(one["speed"]) for one in points]
    i = max(range(len(values)), key=values.__getitem__)
    if i in (0, len(values) - 1):
        return None
    low, high = places[i - 1], places[i + 1]
    tried = [low + (high - low) * step / SEARCH_STEPS for step in range(SEARCH_STEPS + 1)]
    return math.exp(max(tried, key=lambda place: interpolated(places, values, place)))


def surface_of(name, points):
    level = 1 - DEPARTURE

    def film_of(closure):
        return lambda one: one["closures"][closure] * one["flooded"]
    layer = points[-1]["layer"]
    shared = [one for one in points if one["friction"] is not None]
    return {
        "surface": name, "layer": layer, "speeds": len(points), "slowest": points[0]["speed"], "fastest": points[-1]["speed"],
        "rises": sum(two["film"] - one["film"] > one["error"] + two["error"] for one, two in itertools.pairwise(points)),
        "film_maximum": greatest_within(points, lambda one: one["film"]),
        "least_ratio": min(one["ratio"] for one in points), "greatest_of_layer": max(one["film"] for one in points) / layer,
        "film_departure": {
            "speed": falls_below(points, lambda one: one["ratio"], level),
            "low": falls_below(points, lambda one: one["ratio"] - one["ratio_error"], level),
            "high": falls_below(points, lambda one: one["ratio"] + one["ratio_error"], level)},
        "friction_minimum": greatest_within(shared, lambda one: -one["friction"]) if len(shared) > 3 else None,
        "closures": {closure: {"departs_before": points[0]["closures"][closure] < level,
                               "film_departure": falls_below(points, lambda one, of=closure: one["closures"][of], level),
                               "film_maximum": greatest_within(points, film_of(closure)),
                               # Only by flooded_inlet the film vanishes: where the flooded film is as thick as the layer.
                               "collapse": None if all(one["closures"][closure] > 0 for one in points) else
                               falls_below(points, lambda one: one["layer"] / one["flooded"], 1)}
                     for closure in CLOSURES}}


def surfaces_of(baseline):
    found = {}
    for name in SURFACES:
        points = points_of(baseline["surfaces"][name])
        for one, row in zip(points, baseline["surfaces"][name]):
            one["layer"] = number(row["inlet_film"])
        found[name] = points
    return found


def blocks(what, heading, rows_of_surfaces):
    return f"# {what}, each surface a block\n# " + "\t".join(heading) + "\n" + "\n\n".join(
        f'"{name}"\n' + "".join("\t".join(map(exact, row)) + "\n" for row in rows) for name, rows in rows_of_surfaces.items())


def film_files(program, surfaces):
    yield ("data/paper_films.blocks.tsv", blocks(
        "solved films of the paper's surfaces over the layer of oil at the inlet", ["speed", "film/layer", "its error"],
        {name: [(one["speed"], one["film"] / one["layer"], one["error"] / one["layer"]) for one in points]
         for name, points in surfaces.items()}))
    curves = {}
    for name, points in surfaces.items():
        places, thick = [math.log(one["speed"]) for one in points], [math.log(one["flooded"] / one["layer"]) for one in points]
        at = [places[0] + (places[-1] - places[0]) * step / CURVE_STEPS for step in range(CURVE_STEPS + 1)]
        flooded = [math.exp(interpolated(places, thick, place)) for place in at]
        given = [ratios_of(program, [(closure, 1 / one) for one in flooded]) for closure in CLOSURES]
        curves[name] = [(math.exp(place), film, *(ratio * film for ratio in ratios)) for place, film, *ratios in zip(at, flooded, *given)]
    yield ("data/paper_closures.blocks.tsv", blocks(
        "films of the paper's surfaces over the layer of oil, by closures at the solved flooded film", ["speed", "flooded", *CLOSURES], curves))


def ratio_files(program, contacts):
    blocks = []
    for one in contacts:
        rows = "".join("\t".join(map(exact, (p["supply"], p["ratio"], p["error"], math.nan if p["exponent"] is None else p["exponent"]))) + "\n"
                       for p in one["points"])
        blocks.append(f'"M = {one["load_number"]:g}, L = {one["material_number"]:g}"\n{rows}')
    yield ("data/starved_ratios.blocks.tsv", "# central film of a circle over the flooded one, each contact a block\n"
           "# supply\tratio\terror\tDamiens' exponent\n" + "\n\n".join(blocks))
    supplies = [LEAST_SUPPLY * math.pow(GREATEST_SUPPLY / LEAST_SUPPLY, i / SUPPLY_STEPS) for i in range(SUPPLY_STEPS + 1)]
    given = [ratios_of(program, [(closure, supply) for supply in supplies]) for closure in CLOSURES]
    yield ("data/starved_closures.tsv", "# ratio by each closure\n# supply\t" + "\t".join(CLOSURES) + "\n" +
           "".join("\t".join(map(exact, row)) + "\n" for row in zip(supplies, *given)))


def starved_films(asked):
    contacts = table_of(asked.places)
    surfaces = from_baseline(asked.places, "paper_films.json", surfaces_of)
    told = [surface_of(name, points) for name, points in surfaces.items()]
    numbers = {"materials": sorted({one["material_number"] for one in contacts}), "loads": sorted({one["load_number"] for one in contacts}),
               "departure": DEPARTURE, "supplies": judged(asked.program, contacts), "surfaces": told}
    return Group(numbers, [finding("starved_films", "film-starved", "paper", "measured")],
                 files=[*film_files(asked.program, surfaces), *ratio_files(asked.program, contacts)])
