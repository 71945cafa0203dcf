# SPDX-License-Identifier: Apache-2.0
"""The paper's claims under each reading, as `tribocheck reproduce` judges them, and the data of their figures."""
import math

import scenes
from group import Group, Missing, Refused, finding, not_run
from numbers_text import exact
from program import members

SURFACES = ("rough", "medium", "smooth")
# READINGS are those that the command has by itself; GAP is one more.
READINGS = ("corrected", "offset_planes=2", "offset_planes=equal_faces", "literal", "best")
GAP = "gap=point"
COLUMNS = ("item", "quantity", "surface", "model", "rule", "value", "last_digit")


def claims_of(places):
    """The rows of claims.tsv: each item as the paper prints it. Raises Refused if the file is no such table."""
    path = places.scenes / "claims.tsv"
    try:
        lines = path.read_text(encoding="utf-8", errors="replace").split("\n")
    except OSError as error:
        raise Refused(f"{path}: cannot be read") from error
    heading, *rows = [line.split("\t") for line in lines if line and not line.startswith("#")] or [[]]
    for column in COLUMNS:
        if column not in heading:
            raise Refused(f"{path}: no column {column}")
    for row in rows:
        if len(row) != len(heading):
            raise Refused(f"{path}: a row of {len(row)} cells under {len(heading)} columns: " + "\t".join(row))
    claims = [dict(zip(heading, row)) for row in rows]
    for claim in claims:
        for column in ("value", "last_digit"):
            if claim["rule"] == "number" and not is_number(claim[column]):
                raise Refused(f"{path}: row {claim['item']}: {claim[column]} is no number in {column}")
    return claims


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def reported(places, quantity, surface):
    """The first printed number of a quantity, with half of its last digit down and up; None where none is printed."""
    for row in claims_of(places):
        if (row["quantity"], row["surface"], row["rule"]) == (quantity, surface, "number"):
            value, half = float(row["value"]), float(row["last_digit"]) / 2
            return value, value - half, value + half
    return None


def reproduced(program, places):
    """The answer of `tribocheck reproduce`, and the changes since the committed ledger, or why these are not known."""
    readings = [word for one in (*READINGS, GAP) for word in ("--reading", one)]
    arguments = ("reproduce", "--published", places.scenes, "--format", "json", *readings, "--ledger")
    try:
        answer, complaints = program.said(*arguments, places.reference / "baselines/ledger.csv")
    except Missing as missing:
        answer, _ = program.said(*arguments, "none")
        return with_circular_gap(members(answer)), {"missing": str(missing)}
    changes = {name: [line.removeprefix(start) for line in complaints if line.startswith(start)]
               for name, start in (("verdicts_changed", "verdict changed: "), ("numbers_moved", "number moved: "))}
    return with_circular_gap(members(answer)), changes


def with_circular_gap(told):
    """The answer without the reading GAP; the main numbers by GAP become the member circular_gap. GAP has the gap of a circular
    contact at the inlet (E13); the corrected reading keeps the printed gap of a line."""
    reading = next(one for one in told["readings"] if one["departures"] == GAP)
    name = reading["name"]
    items = {one["item"]: one["readings"][name] for one in told["items"]}
    onsets = [items[f"C1.{surface}"] for surface in SURFACES]
    parameter = items["C2.smooth"]
    gap = {"score": reading["score"], "film_parameter": parameter["computed"], "verdict": parameter["verdict"],
           "onset_speed": {surface: one["computed"] for surface, one in zip(SURFACES, onsets)},
           "onset_factors": [one["factor"] for one in onsets],
           "onset_verdict": next(one["verdicts"][name] for one in told["claims"] if one["claim"] == "C1")}
    if name == GAP:  # not already among the command's own readings
        told["readings"].remove(reading)
        for one in (*(claim["verdicts"] for claim in told["claims"]), *(item["readings"] for item in told["items"]),
                    *(row["scores"] for row in told["tolerances"])):
            del one[name]
        for claim in told["claims"]:
            claim["undecided"] = [one for one in claim["undecided"] if one != name]
    return told | {"circular_gap": gap}


def comparison(committed):
    """The finding on changed verdicts, and the entry on a ledger that is missing."""
    if "missing" in committed:
        why = committed["missing"]
        return (finding("committed_ledger", "claims", "software", "absent", why),
                [not_run("Comparison with the committed ledger", why, "`make ledger`")])
    changed = committed["verdicts_changed"]
    return finding("committed_ledger", "claims", "software", "fails" if changed else "holds",
                   f"verdict changed: {changed[0]}" if changed else ""), []


def row(cells):
    return "\t".join(map(exact, cells)) + "\n"


def ends(interval):
    return interval["low"], interval["high"]


def surfaces_data(asked, told, contacts):
    """The onset speeds and asperity shares of each surface by varied inputs, and those that the paper reports."""
    print_precision, plausible = told["uncertainty"][:2]
    onsets = scenes.onsets(asked.program, contacts, ("film_maximum", "friction_minimum"))
    text = ("# Onset speeds (m/s) and asperity shares at the lowest speed, corrected reading, with the intervals of 95 % that "
            "varied inputs give\n"
            "# surface\tsd_nm\tonset_median\tonset_plausible_low\tonset_plausible_high\tonset_print_low\tonset_print_high\t"
            "onset_reported\treported_low\treported_high\tfilm_maximum\tfriction_minimum\tshare_plausible_low\t"
            "share_plausible_high\tshare_print_low\tshare_print_high\tshare_reported\tshare_reported_low\tshare_reported_high\n")
    for name, scene, onset in zip(SURFACES, contacts, onsets):
        text += f"{name}\t" + row((
            1e9 * scene["surface"]["summit_height_sd"], print_precision["onset_speed"][name]["median"],
            *ends(plausible["onset_speed"][name]), *ends(print_precision["onset_speed"][name]),
            *(reported(asked.places, "onset_speed", name) or (None,) * 3),
            onset["film_maximum"]["speed"], onset["friction_minimum"]["speed"],
            *ends(plausible["slow_asperity_share"][name]), *ends(print_precision["slow_asperity_share"][name]),
            *(reported(asked.places, "slow_asperity_share", name) or (None,) * 3)))
    return "data/ledger_surfaces.tsv", text


def law_data(asked, smooth):
    """Onsets and shares at constant n·β·σ_s, with σ_s from 20 to 125 nm."""
    surface = smooth["surface"]
    factors = [0.8 * math.pow(6.25, i / 60) for i in range(61)]
    contacts = [smooth | {"surface": surface | {"summit_height_sd": surface["summit_height_sd"] * factor,
                                                "summit_density": surface["summit_density"] / factor}} for factor in factors]
    onsets = scenes.onsets(asked.program, contacts, ("film_maximum", "film_departure"))
    slowest = asked.program.ask(*(line for one in contacts for line in scenes.points(one, one["speed"]["from"])))
    text = ("# Closed forms at constant n·β·σ_s, corrected reading: onset speeds (m/s), asperity share at the lowest speed\n"
            "# sd_nm\tfilm_maximum\tfilm_departure_0.05\tslow_asperity_share\n")
    for scene, onset, point in zip(contacts, onsets, slowest):
        text += row((1e9 * scene["surface"]["summit_height_sd"], onset["film_maximum"]["speed"], onset["film_departure"]["speed"],
                     point["asperity_load_share"]))
    return "data/ledger_law.tsv", text


def scores_data(told):
    text = "# Of all readings, how many reproduce how many claims\n# claims\treadings\twho\n"
    for score, count in enumerate(told["ranking"]["readings_by_score"]):
        who = ", ".join(one["name"] for one in told["readings"] if one["score"] == score)
        text += f"{score}\t{count}\t{who or '-'}\n"
    return "data/ledger_scores.tsv", text


def table_data(told):
    """The rows of `tribocheck reproduce --format csv`."""
    verdicts = {one["claim"]: one["verdicts"] for one in told["claims"]}
    text = ("reading,departures,item,claim,computed,other_end,numerical_error,holds_at,reported,factor,verdict,claim_verdict,"
            "margin,margin_of,margin_error,decided,beyond_collapse,met_by\n")
    for reading in told["readings"]:
        for item in told["items"]:
            name, result = reading["name"], item["readings"][reading["name"]]
            margin, computed = result.get("margin"), result["computed"]
            text += ",".join((
                name, reading["departures"], item["item"], item["claim"], csv_number(computed),
                csv_number(result.get("other_end", computed)), csv_error(result.get("numerical_error")),
                csv_number(float(result.get("holds_at", computed is not None))), csv_number(item["reported"]),
                csv_number(result.get("factor")), result["verdict"], verdicts[item["claim"]][name],
                csv_number(margin and margin["distance"]), margin["of"] if margin else "", csv_error(margin and margin["error"]),
                "yes" if result["decided"] else "no", " ".join(result.get("beyond_collapse", [])),
                csv_number(item["met_by"]))) + "\n"
    return "data/ledger.csv", text


def csv_number(value):
    return "" if value is None else exact(value)


def csv_error(value):
    """An error with two digits: only its size is known."""
    return "" if value is None else f"{value:.2g}"


def ledger(asked):
    told, committed = asked.ledger.result()
    contacts = [scenes.read(asked.places.scenes / f"{name}.toml") for name in SURFACES]
    reproduces_all = told["readings"][0]["score"] == len(told["claims"])
    all_independent = all(one["reproduced"] for one in told["independent"])
    compared, left_out = comparison(committed)
    found = [finding("claims", "claims", "paper", "holds" if reproduces_all else "differs"),
             finding("readings", "readings", "paper", "measured"),
             finding("independent_numbers", "uncertainty", "software", "measured" if all_independent else "fails"), compared]
    return Group(told | {"committed": committed}, found, left_out, [
        surfaces_data(asked, told, contacts), law_data(asked, contacts[SURFACES.index("smooth")]), scores_data(told),
        table_data(told)])
