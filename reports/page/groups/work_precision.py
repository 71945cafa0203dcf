# SPDX-License-Identifier: Apache-2.0
"""Ways of doing a job, timed and judged: the fastest ones, and the tables for gnuplot."""
import re

from baselines import copied, count, from_baseline, number, number_or_none, run_of, text
from group import Group, Missing, finding, printable
from numbers_text import exact

OURS = "tribocheck"


def grouped(rows, key):
    """The rows of each value of `key`, in the order of the file."""
    groups = {}
    for row in rows:
        groups.setdefault(text(row[key]), []).append(row)
    return groups


def jobs_of(baseline):
    jobs = grouped(baseline["error_against_work"], "job")
    for job in jobs:  # files and figures are named after jobs
        if not re.fullmatch(r"[A-Za-z0-9_]+", job):
            shown = printable(job[:60]) + ("…" if len(job) > 60 else "")
            raise Missing(f'work_precision.json: the job "{shown}" is not named by letters, digits and _ alone')
    return jobs


def fastest_ways(rows):
    """The fastest way of each family, among ways that were judged and failed nowhere, in the order of the file."""
    ways = {}
    for row in rows:
        if number(row["failures"]) > 0 or row["max_ulp"] is None:
            continue
        way = (copied(row, text, "family", "name") | copied(row, number, "ns", "max_ulp") |
               copied(row, number_or_none, "evaluations"))
        if way["family"] not in ways or way["ns"] < ways[way["family"]]["ns"]:
            ways[way["family"]] = way
    return ways


DRAWN = 8  # series in a diagram, which draws the first blocks of a file


def drawn_first(rows, error="max_ulp"):
    """The rows, first those of the DRAWN series that a diagram shows: ours point by point, the best series of each family, then
    further ones. A series is better if it fails nowhere, then by the least product of error and time. The control is never drawn."""
    merits = {}
    for row in rows:
        if row["family"] != "control" and row[error] is not None:
            merit = (number(row["failures"] if "failures" in row else row["no_numbers"]) > 0, number(row[error]) * number(row["ns"]))
            merits[row["series"]] = min(merits.get(row["series"], merit), merit)
    ranked = sorted(merits, key=lambda series: merits[series])
    families = {row["series"]: row["family"] for row in rows}
    best = {families[series]: series for series in reversed(ranked)}
    scalar = [series for series in ranked if series == f"{OURS}: scalar"]
    chosen = list(dict.fromkeys([*scalar, *best.values(), *ranked]))[:DRAWN]
    return [row for row in rows if row["series"] in chosen] + [row for row in rows if row["series"] not in chosen]


def fastest_as_exact(rows, ours):
    """The fastest way of other families that failed nowhere, and whose greatest error is that of our fastest way or less."""
    ways = fastest_ways([row for row in rows if row["max_ulp"] is not None and number(row["max_ulp"]) <= ours["max_ulp"]])
    others = [way | {"times_ours": way["ns"] / ours["ns"]} for family, way in ways.items() if family != OURS]
    return min(others, key=lambda way: way["ns"], default=None)


def job_of(name, rows):
    """The fastest ways beside ours, and the fastest alternative."""
    ways = fastest_ways(rows)
    ours = ways.get(OURS)
    timed = {family: way | {"times_ours": way["ns"] / ours["ns"] if ours else None} for family, way in ways.items()}
    others = [way for family, way in timed.items() if family != OURS]
    return {"job": name, "ours": ours, "fastest_alternative": min(others, key=lambda way: way["ns"], default=None),
            "as_exact": ours and fastest_as_exact(rows, ours),
            "is_counted": any(row["family"] != OURS and row["evaluations"] is not None for row in rows),
            "ways": list(timed.values())}


def contest(jobs):
    """How many times as long as ours the fastest alternative takes, over the jobs that have both."""
    both = [(job["ours"], job["fastest_alternative"]) for job in jobs if job["ours"] and job["fastest_alternative"]]
    times = [other["times_ours"] for _, other in both]
    as_exact = [job["as_exact"]["times_ours"] for job in jobs if job["as_exact"]]
    return {"jobs": len(both), "less_exact": sum(other["max_ulp"] > ours["max_ulp"] for ours, other in both),
            "least_times_ours": min(times, default=None), "greatest_times_ours": max(times, default=None),
            "as_exact": {"jobs": len(as_exact), "least_times_ours": min(as_exact, default=None),
                         "greatest_times_ours": max(as_exact, default=None)}}


FILMS = ("line_film", "point_film")  # films of line contacts and of circles, each measured on its own


def films_of(baseline, films):
    """Every way, the growth of time and memory with our solver and with a dense matrix, and the time on threads."""
    return run_of(baseline[f"{films}_run"]) | {
        "ways": [copied(row, text, "family", "name") | copied(row, number, "ns") |
                 copied(row, number_or_none, "steps", "max_relative", "mean_relative") |
                 copied(row, count, "no_numbers", "judged") for row in baseline[films]],
        "exponents": [copied(row, text, "solver", "quantity") | copied(row, number, "exponent", "uncertainty") |
                      copied(row, count, "from_cells", "to_cells") for row in baseline[f"{films}_exponents"]],
        "largest": [copied(rows[-1], text, "solver") | copied(rows[-1], number, "cells", "kernel_ns", "step_ns", "bytes")
                    for rows in grouped(baseline[f"{films}_growth"], "solver").values()],  # one grid of each solver
        "threads": [copied(row, count, "threads") | copied(row, number, "ns") for row in baseline.get(f"{films}_threads", [])]}


def cell(value):
    """A value of the baseline in a table; a text must also fit between quotes."""
    if isinstance(value, str):
        return printable(value).replace('"', "'")
    return exact(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else "NaN"


def blocks(table, name, key, columns, rows):
    """A file of blocks, one for each value of `key` in the order of the rows, two blank lines between."""
    titled = {}
    for row in rows:
        line = "\t".join(cell(row[column]) for column in columns)
        titled.setdefault(cell(text(row[key])), []).append(line + "\n")
    heading = "\t".join(columns.values())
    return (f"data/work_precision/{name}.blocks.tsv",
            f"# reference/baselines/work_precision.json, {table}\n# {heading}\n" +
            "\n\n".join(f'"{title}"\n{"".join(lines)}' for title, lines in titled.items()))


# The columns of each table with their headings, which have the units.
WAYS = {"job": "job", "family": "family", "series": "series", "name": "way", "ns": "CPU time a point [ns]",
        "evaluations": "evaluations a point", "max_ulp": "greatest error [ulp]",
        "p99_ulp": "99th percentile of the error [ulp]", "mean_ulp": "mean error [ulp]", "failures": "failures",
        "no_numbers": "no numbers", "judged": "cases judged"}
# For each table: the file's name, the column by which rows are put into blocks, and the columns.
TABLES = {name: told for films in FILMS for name, told in {
    films: (films, "series", {
        "job": "job", "family": "family", "series": "series", "name": "way", "ns": "CPU time a contact [ns]",
        "steps": "steps of Newton's method a contact", "max_relative": "greatest relative error",
        "mean_relative": "mean relative error", "no_numbers": "no numbers", "judged": "numbers judged"}),
    f"{films}_growth": (f"{films}_growth", "solver", {
        "solver": "solver", "cells": "cells", "kernel_ns": "CPU time for the matrix of influences [ns]",
        "step_ns": "CPU time of a step of Newton's method [ns]", "bytes": "bytes"}),
    f"{films}_exponents": (f"{films}_exponents", "solver", {
        "solver": "solver", "quantity": "quantity", "exponent": "exponent of the cells", "uncertainty": "its standard error",
        "from_cells": "fitted from cells", "to_cells": "fitted to cells"}),
}.items()}


def compared(baseline):
    by_job = jobs_of(baseline)
    jobs = [job_of(name, rows) for name, rows in by_job.items()]
    alternatives = contest(jobs)
    data = run_of(baseline)
    data["environment"] |= copied(baseline["environment"], text, "instruction_set")
    data |= {"alternatives": alternatives, "jobs": jobs, **{films: films_of(baseline, films) for films in FILMS}}
    found = finding("work_precision", "work-precision", "software", "measured")
    if not alternatives["jobs"]:
        found = finding("work_precision", "work-precision", "software", "absent",
                        "No job has both our way and an alternative without failures.")
    return Group(data, [found], files=[
        *(blocks("error_against_work", name, "series", WAYS, drawn_first(rows)) for name, rows in by_job.items()),
        *(blocks(table, name, key, columns, drawn_first(baseline[table], "max_relative") if table in FILMS else baseline[table])
          for table, (name, key, columns) in TABLES.items())])


def work_precision(asked):
    return from_baseline(asked.places, "work_precision.json", compared)
