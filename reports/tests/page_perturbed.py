# SPDX-License-Identifier: Apache-2.0
"""Changes the numbers of report.json: parts of a whole may become 0, 1 or nearly so, and each yes may become a no.

A page that is made of the changed numbers shows which field stands in which cell, even where real numbers are equal. It
also takes branches of the templates that the real numbers do not take.
"""
import random

# Members that keep their values: other values refer to them, or a picture of the page is made of them.
KEPT = {"level", "edges", "digits", "least_load_number", "is_over_speeds", "is_counted", "counts"}
DIVISORS = {"value", "reported", "computed", "ns"}  # never 0
PARTS = (0.0, 1.0, 0.9996, 0.99951, 0.0004, 0.001, 0.05, 0.9, 0.91)
FACTORS = (0.2, 0.93, 1.49, 1.7, 9.0, 1e-7, 1e6)
WORDS = ("verdict", "reported_lies", "standing")


def named(value, name=None):
    """All values that are neither dictionaries nor lists, with their names."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from named(one, key)
    elif isinstance(value, list):
        for one in value:
            yield from named(one, name)
    else:
        yield name, value


def changed(value, draw, words=(), name=None):
    """The value with other numbers in it. A text whose name is in `words` becomes one of the words of this name."""
    if isinstance(value, dict):
        made = {key: changed(one, draw, words, key) for key, one in value.items()}
        if made.keys() == {"value", "error"} and value["error"]:
            made["error"] = made["value"] * draw.choice((1e-5, 0.0199, 0.0201, 0.5))
        return made
    if name in KEPT or value is None:
        return value
    if isinstance(value, list):
        return [changed(one, draw, words) for one in value]
    if name in words and value:
        return draw.choice(words[name])
    if isinstance(value, bool):
        return draw.random() < 0.6
    if isinstance(value, int):
        return value + draw.randint(0, 12000) if value > 3 else draw.randint(0, 3)
    if name == "factor" and value != 0:
        return draw.choice((0.4, 0.93, 1.04, 1.49, 1.51, 2.4, 40)) * draw.uniform(0.999, 1.001)
    if isinstance(value, float):
        is_part = 0 <= value <= 1 and name is not None and name not in DIVISORS and draw.random() < 0.5
        return draw.choice(PARTS) if is_part else value * draw.uniform(0.7, 1.4) * (draw.choice(FACTORS) if draw.random() < 0.3 else 1)
    return value


def perturbed(report, seed):
    """A report whose groups fit together. Of the findings about the software the last seed − 1 fail.

    The report always names a part that was not run, because a page that is made without gnuplot always has that table.
    """
    draw = random.Random(seed)
    made = changed(report, draw, {name: sorted({value for key, value in named(report) if key == name and value}) for name in WORDS})
    made["not_run"] = made["not_run"] or [{"what": "What the page asked for", "why": "it was not there", "how_to": "`make it`,"}]
    made["planted_faults"]["catalogue"] = len(made["planted_faults"]["faults"]) + seed - 1
    for one in made["mutants"]["rooms"]:
        one["ran"] = draw.randint(0, one["drawn"]) if seed == 2 else one["drawn"]
    for one in made["ledger"]["arguments"]:
        one["agreeing"] = sum(way["agrees"] for way in one["candidates"])
    software = [one for one in made["findings"] if one["about"] == "software"]
    for i, one in enumerate(software):
        one["standing"] = "fails" if len(software) - i < seed else draw.choice(("holds", "missed"))
    return made
