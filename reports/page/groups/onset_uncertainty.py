# SPDX-License-Identifier: Apache-2.0
"""The uncertainty of the paper's onset speeds, by the shipped sweeps, which run while the report is made."""
import math

import ledger
import scenes
from group import Group, Missing, finding

RESULT = "sweep/onset_uncertainty.h5"
COMPARED = "onset.film_maximum.speed"
MOST_DEVIATIONS = 3.5  # nine comparisons exceed it by chance once in 200 times


def as_printed(table, path=""):
    """The tables of a scene, from those of a sweep: each varied input has its printed number."""
    made = {}
    for name, one in table.items():
        field = f"{path}{name}"
        if field in ("speed", "accept") or not isinstance(one, (dict, list)):
            made[name] = one
        elif "printed" in one:
            made[name] = float(one["printed"])
        elif not path and isinstance(one, dict):
            made[name] = as_printed(one, f"{field}.")
        else:
            raise Missing(f"a sweep of onsets has to vary {field} by `printed` alone")
    return made


def read_sweep(places, surface):
    sweep = scenes.read(places.scenes / f"sweeps/onset_{surface}.toml")
    if sweep.get("id") != surface:
        raise Missing(f"{places.scenes}/sweeps/onset_{surface}.toml has the id {sweep.get('id')}, not {surface}")
    if not sweep.get("sweep", {}).get("sensitivity"):
        raise Missing(f"{places.scenes}/sweeps/onset_{surface}.toml asks for no sensitivity")
    return sweep


def run_sweeps(asked):
    """The answer of `tribocheck sweep`, with no columns but the onset speeds."""
    paths = [asked.places.scenes / f"sweeps/onset_{surface}.toml" for surface in ledger.SURFACES]
    result = asked.places.out / RESULT
    result.parent.mkdir(parents=True, exist_ok=True)
    answer = asked.program.answer("sweep", *paths, "-o", result, "--force")
    del answer["warnings"]  # the page has its own table of where scenes lie outside of the model
    for scene, path in zip(answer["scenes"], paths):
        scene["file"] = asked.places.shown(path)
        del scene["cells"]  # no grid is crossed with the draws
        scene["columns"] = [column for column in scene["columns"] if column["name"].endswith(".speed")]
    return answer


def quantile(value, level):
    """A quantile with its interval, whose ends are infinite where too few values bound them."""
    found = next(one for one in value["quantiles"] if one["level"] == level)
    return tuple(end if found[name] is None else found[name] for name, end in (("value", math.inf), ("low", -math.inf), ("high", math.inf)))


def part_below(value, speed):
    """The part of the cases below a speed, from the counts of the histogram; linear within a bar."""
    edges, below = value["histogram"]["edges"], 0.0
    for low, high, count in zip(edges, edges[1:], value["histogram"]["counts"]):
        below += count * min(max((speed - low) / (high - low), 0.0), 1.0)
    return below / value["count"]


def place_of(value, speed):
    if not value["count"]:
        return "no onsets"
    if speed < value["least"]:
        return "below all"
    if speed > value["greatest"]:
        return "above all"
    return "among them"


def speeds_of(asked, sweep, columns, reported):
    """The onset speeds of a surface by each criterion, and where the reported one lies among them."""
    printed, low, high = reported
    criteria = [name.split(".")[1] for name in columns]
    settings = sweep["sweep"]
    scene = as_printed({name: one for name, one in sweep.items() if name != "sweep"})
    onsets, = scenes.onsets(asked.program, [scene], criteria, settings.get("departure", scenes.DEPARTURE))
    return [{"criterion": criterion, "column": name, "as_printed": onsets[criterion]["speed"],
             "reported_lies": place_of(value, printed),
             "cases_below_reported": part_below(value, printed) if value["count"] else None,
             "reported_is_within_95_percent": high >= quantile(value, 0.025)[0] and low <= quantile(value, 0.975)[0]}
            for criterion, (name, value) in zip(criteria, columns.items())]


def agreement(columns, drawn):
    """Compares the ledger's print-precision draws with those of this sweep. Finds the greatest distance between their
    quantiles at 2.5 %, 50 % and 97.5 %, as a part of the quantile and in standard deviations of sampling."""
    farthest = in_deviations = 0.0
    for surface in ledger.SURFACES:
        value, other = columns[surface][COMPARED], drawn["onset_speed"][surface]
        for level, end in ((0.025, "low"), (0.5, "median"), (0.975, "high")):
            ours, low, high = quantile(value, level)
            distance = abs(ours - other[end])
            # The interval of this sweep spans 2 · 1.96 standard deviations of independent draws.
            deviation = (high - low) / (2 * 1.96) * math.sqrt(1 + value["count"] / drawn["draws"])
            if not 0 < deviation < math.inf:
                raise Missing(f"the {surface} surface has too few onset speeds for the interval of their quantile at {100 * level:g} %")
            farthest = max(farthest, distance / other[end])
            in_deviations = max(in_deviations, distance / deviation)
    return {"column": COMPARED, "ledger_draws": drawn["draws"], "farthest": farthest, "in_deviations": in_deviations,
            "most_deviations": MOST_DEVIATIONS, "agree": in_deviations <= MOST_DEVIATIONS}


def onset_uncertainty(asked):
    sweeps = {surface: read_sweep(asked.places, surface) for surface in ledger.SURFACES}
    answer = run_sweeps(asked)
    columns = {scene["id"]: {column["name"]: column["values"][0] for column in scene["columns"]} for scene in answer["scenes"]}
    surfaces = []
    for surface in ledger.SURFACES:
        reported = ledger.reported(asked.places, "onset_speed", surface)
        if reported is None:
            raise Missing(f"no onset speed of the {surface} surface is reported in claims.tsv")
        if COMPARED not in columns[surface]:
            raise Missing(f"onset_{surface}.toml does not ask for the onset by film_maximum")
        surfaces.append({"surface": surface, "reported": dict(zip(("value", "low", "high"), reported)),
                         "speeds": speeds_of(asked, sweeps[surface], columns[surface], reported)})
    compared = agreement(columns, asked.ledger.result()[0]["uncertainty"][0])
    return Group({"inputs_drawn": len(answer["scenes"][0]["inputs"]), "surfaces": surfaces, "agreement": compared, "sweep": answer},
                 [finding("onset_speeds_drawn", "uncertainty", "paper", "measured"),
                  finding("onset_speeds_drawn_twice", "uncertainty", "software", "holds" if compared["agree"] else "fails")],
                 files=[(RESULT, None)])
