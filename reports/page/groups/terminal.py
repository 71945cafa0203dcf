# SPDX-License-Identifier: Apache-2.0
"""The verdict in short, for the terminal."""
import collections

import numbers_text as numbers
from group import printable

WORDS = {"fails": "FAILS", "missed": "missed", "absent": "not run"}


def with_unit(number, unit):
    return number if numbers.NO_ENTRY in (number, unit) else f"{number} {unit}"


def headline_row(item):
    """A number of the paper beside the computed one, under the corrected reading."""
    result = item["readings"]["corrected"]
    factor = result.get("factor")
    verdict = result["verdict"] + (f": {result['none']}" if result.get("none") else "")
    return [printable(cell) for cell in (
        item["label"], with_unit(numbers.unrounded(item["reported"]), item["unit"]),
        with_unit(numbers.rounded(result["computed"], 4), item["unit"]),
        numbers.NO_ENTRY if factor is None else f"{numbers.rounded(factor, 3)} times",
        verdict + ("" if result["decided"] else "; the margin is below the numerical error"))]


def headline(ledger):
    """The first numbers of the paper, in columns two blanks apart."""
    items = {item["item"]: item for item in ledger["items"]}
    rows = [["number", "paper", "computed", "against the paper", "verdict"],
            *(headline_row(items[name]) for name in ledger["headline"] if name in items)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    text = "The paper's numbers, and what comes out (misprints mended but for E13 and E26)\n"
    for row in rows:
        cells = (f"{cell:{'>' if 0 < i < 3 else '<'}{width}}" for i, (cell, width) in enumerate(zip(row, widths)))
        text += "  ".join(cells).rstrip(" ") + "\n"
    return text + "\n"


def verdict(report):
    text, ledger = "", report.get("ledger", {})
    if "summary" in ledger:
        scores = [one["score"] for one in ledger["readings"] if one["name"] in ("corrected", "m = 2", "equal faces")]
        text = headline(ledger) + printable(f"The paper: {ledger['summary']}. This is with the offset D_d (E9, m = 1); depending on E9 "
                                            f"{min(scores)} to {max(scores)} are reproduced.") + "\n"
    about = [one for one in report["findings"] if one["about"] == "software"]
    count = collections.Counter(one["standing"] for one in about)
    several = {"mutants": ("mutants", "goals_missed"), "sweep_speed": ("sweep_speed", "targets_missed")}  # others have one target
    targets = sum(report[several[one["id"]][0]][several[one["id"]][1]] if one["id"] in several else 1
                  for one in about if one["standing"] == "missed")
    missed = f"{count['missed']} {'misses' if count['missed'] == 1 else 'miss'} {targets} target{'' if targets == 1 else 's'}"
    text += (f"This software: {count['holds']} checks hold, {count['fails']} fail, {missed if targets else 'no check misses a target'}, "
             f"{count['absent']} did not run.\n")
    return text + "".join(printable(f"  {WORDS[one['standing']]}: {one['id']}: {one.get('why', '')}") + "\n"
                          for one in report["findings"] if one["standing"] in WORDS)
