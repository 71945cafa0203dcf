#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the errors that the film solver states, on random contacts.

The program film_survey solves 300 line contacts to four tolerances. It writes a row for each contact and tolerance, with
each film, its stated error, and how far it is from the film that is solved to 1e-6. With --points it solves 200 point
contacts to the tolerance that the solver promises. It compares the films of 60 of them, 20 beyond M = 500, with films on
cells of half the size and a grid of twice the length. This script runs the program in parts on all processors. Finished
parts stay in build/film_survey/<the program's digest>, so that a stopped run goes on where it was. Then the script writes
the results with commit and environment. The exit code is 1 if a film lies outside its stated error, if a looser tolerance
was harder to meet, or if more than one line contact in a hundred, or one point contact in twenty, was refused.

  verification/gates/film_survey.py build/release/verification/tests/film_survey --out reference/baselines/film_survey.json
"""
import argparse
import concurrent.futures
import csv
import datetime
import hashlib
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/gates/faults"))
import plant  # noqa: E402
FILMS = ("central", "minimum", "at_greatest_pressure")
PART = 10  # line contacts in a run; a run has only one point contact, because memory is measured for the whole run
HELD, HELD_BEYOND_500 = 60, 20
# The groups of point contacts, each with a function that tells whether a row belongs to it.
GROUPS = {"circles": lambda row: row["radius_ratio"] == "1" and row["supply"] == "0",
          "ellipses": lambda row: row["radius_ratio"] != "1",
          "starved": lambda row: row["supply"] != "0"}


def rows_of_part(program, seed, what, first, end, folder, until=float("inf")):
    """The rows of a part. There are none if the part has no file yet and the time `until` is over."""
    path = folder / f"{what}_{seed}_{first}_{end}.csv"
    if not path.exists():
        if time.monotonic() > until:
            return []
        said = subprocess.run([program, what, str(first), str(end), str(seed)], stdout=subprocess.PIPE, text=True, check=True)
        path.with_suffix(".part").write_text(said.stdout)
        path.with_suffix(".part").rename(path)
    return list(csv.DictReader(path.open()))


def judged(rows):
    """The number of judged films, those that are off by more than they state, and the median of stated over true errors. A film is
    judged if the error of the finer film is below a third of the stated one, or if the film is off by more than both errors together."""
    cautions, outside = [], []
    for row in rows:
        for film in FILMS:
            stated, off, known = (float(row[f"{film}_{what}"]) for what in ("error", "off", "known"))
            if not known < stated / 3 and not off > stated + known:
                continue
            cautions.append(stated / off if off > 0 else float("inf"))
            if off > stated:
                outside.append({"contact": int(row["contact"]), "film": film, "factor": round(off / stated, 2)})
    return {"judged": len(cautions), "outside": outside,
            "median_stated_over_true": round(statistics.median(cautions), 2) if cautions else None}


def summary(rows):
    """The summary of line contacts, with one entry per tolerance from the coarsest."""
    tolerances = []
    contacts = {}
    for row in rows:
        contacts.setdefault(row["contact"], []).append(row)
    for tolerance in sorted({row["tolerance"] for row in rows}, key=float, reverse=True):
        of = [row for row in rows if row["tolerance"] == tolerance]
        tolerances.append({
            "tolerance": float(tolerance), "refused": sum(row["solved"] == "0" for row in of),
            "not_met": sum(row["met"] == "0" for row in of), **judged(of),
            "mean_work": round(statistics.fmean(float(row["work"]) for row in of))})
    violations = 0
    for of in contacts.values():
        of.sort(key=lambda row: float(row["tolerance"]))
        violations += sum(tight["solved"] > loose["solved"] or tight["met"] > loose["met"]
                          or float(loose["work"]) > float(tight["work"]) for tight, loose in zip(of, of[1:]))
    return {"contacts": len(contacts), "looser_is_harder": violations, "tolerances": tolerances}


def to_be_held(drawn):
    """The numbers of the contacts that are compared with finer films: the first 20 beyond M = 500, and the first 40 others."""
    beyond = [row["contact"] for row in drawn if float(row["load_number"]) > 500]
    others = [row["contact"] for row in drawn if float(row["load_number"]) <= 500]
    return set(beyond[:HELD_BEYOND_500] + others[:HELD - HELD_BEYOND_500])


def summary_of_points(drawn, rows):
    """The summary of point contacts: the solved ones by groups, and the errors of the held films. Seconds are those of one processor."""
    solved, held = ([row for what, row in rows if what == one] for one in ("solved", "held"))
    groups = {}
    for name, is_in in GROUPS.items():
        of = [row for row in solved if is_in(row)]
        seconds = [float(row["seconds"]) for row in of] or [0]
        nodes = [int(row["nodes"]) for row in of]
        groups[name] = {
            "drawn": sum(map(is_in, drawn)), "run": len(of), "solved": sum(row["solved"] == "1" for row in of),
            "met": sum(row["met"] == "1" for row in of), "median_seconds": round(statistics.median(seconds), 1),
            "greatest_seconds": round(max(seconds)), "greatest_nodes": max(nodes, default=0),
            "greatest_megabytes": max((int(row["megabytes"]) for row in of), default=0)}
    what_of = lambda row: {"contact": int(row["contact"]), "load_number": float(row["load_number"]), "reason": row["reason"]}
    chosen = to_be_held(drawn)
    by_load = {}
    for name, is_in in (("up to M = 500", lambda row: float(row["load_number"]) <= 500),
                        ("beyond M = 500", lambda row: float(row["load_number"]) > 500)):
        of = [row for row in held if is_in(row)]
        by_load[name] = {"chosen": sum(row["contact"] in chosen for row in drawn if is_in(row)), "run": len(of),
                         "films": sum(row["solved"] == "1" for row in of) * len(FILMS), **judged(of)}
    return {"solved": groups, "refused": [what_of(row) for row in solved if row["solved"] == "0"],
            "not_met": [what_of(row) for row in solved if row["solved"] == "1" and row["met"] == "0"], "held": by_load}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--points", action="store_true", help="point contacts in place of lines")
    parser.add_argument("--contacts", type=int, help="default: 300 lines, 200 points")
    parser.add_argument("--seed", type=int, default=45, help="seed of the random contacts; seeds 48 to 50 served to tune the stated errors")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="no part begins after so many")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    folder = ROOT / "build/film_survey" / hashlib.sha256(arguments.program.read_bytes()).hexdigest()[:16]
    folder.mkdir(parents=True, exist_ok=True)
    count = arguments.contacts or (200 if arguments.points else 300)
    until = time.monotonic() + 60 * arguments.minutes
    run = lambda *part: rows_of_part(arguments.program, arguments.seed, *part, folder, until)
    drawn = []
    if arguments.points:
        drawn = rows_of_part(arguments.program, arguments.seed, "drawn", 0, count, folder)
        chosen = to_be_held(drawn)
        # Cheap contacts come first. The others keep their random order, so that a random part of them is left out.
        contacts = [(what, int(row["contact"])) for is_dear in (False, True) for what in ("solved", "held") for row in drawn
                    if (float(row["load_number"]) > 200) == is_dear and (what == "solved" or row["contact"] in chosen)]
        parts = [(what, one, one + 1) for what, one in contacts]
    else:
        parts = [("lines", first, min(first + PART, count)) for first in range(0, count, PART)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(arguments.workers) as pool:
        futures = {pool.submit(run, *part): part[0] for part in parts}
        for done, part in enumerate(concurrent.futures.as_completed(futures), 1):
            rows += [(futures[part], row) for row in part.result()]
            print(f"{done} of {len(parts)} parts", file=sys.stderr)
    rows.sort(key=lambda one: (one[0], int(one[1]["contact"])))
    what = ("point contacts solved to 1e-3 up to M = 200, to 3e-3 beyond; some, on at most 55 000 nodes up to M = 200, on at most "
            "150 000 beyond, held to cells of half the size and a grid of twice the length" if arguments.points
            else "line contacts solved to four tolerances, held to their films to 1e-6")
    made = {"what": what, "commit": plant.commit(), "date": datetime.date.today().isoformat(),
            "environment": plant.environment(), "seed": arguments.seed,
            **(summary_of_points(drawn, rows) if arguments.points else summary([row for _, row in rows]))}
    text = json.dumps(made, indent=1) + "\n"
    (arguments.out.write_text if arguments.out else sys.stdout.write)(text)
    if arguments.points:
        bad = sum(len(one["outside"]) for one in made["held"].values()) + (20 * len(made["refused"]) > count)
    else:
        bad = made["looser_is_harder"] + sum(len(one["outside"]) + (100 * one["refused"] > count) for one in made["tolerances"])
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
