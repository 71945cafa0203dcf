# SPDX-License-Identifier: Apache-2.0
"""Draws mutants by room, and writes a drawn place as a patch."""
import collections
import hashlib

ROOMS = {"formulas": 60, "engine": 60, "judging": 60, "page's data": 40, "page's templates and pictures": 40, "film": 40,
         "sweep": 40, "scene": 40, "catalogue": 40, "program": 40, "benchmarks": 40}
CONTEXT = 30  # a patch has at least this many characters on each side


def name_of(place):
    text = "\0".join(str(place[key]) for key in ("file", "begin", "end", "operator", "replacement"))
    return hashlib.sha256(text.encode()).hexdigest()[:10]


def overlap(one, two):
    """Whether two mutants of one file change the same text, or edit the same declaration."""
    spans = [[(place["begin"], place["end"]), *((a, b) for a, b, _ in place.get("edits", ()))] for place in (one, two)]
    return any(a <= d and c <= b for a, b in spans[0] for c, d in spans[1])


def draw(places, sizes, seed, dropped=()):
    """The mutants of each room, in an order that depends on the seed alone. If a room has five operators or more, no operator
    gives more than a fifth. The place of a dropped mutant goes to the next one."""
    drawn, by_file = [], collections.defaultdict(list)
    for room, size in sizes.items():
        # A hash gives the order, so that a place that comes or goes moves no other place.
        rows = sorted((place for place in places if place["room"] == room),
                      key=lambda place: hashlib.sha256(f"{seed} {name_of(place)}".encode()).digest())
        operators = {place["operator"] for place in rows}
        most = size // 5 if len(operators) >= 5 else size
        used, taken = collections.Counter(), 0
        for place in rows:
            if taken == size:
                break
            if used[place["operator"]] == most or name_of(place) in dropped:
                continue
            if any(overlap(place, other) for other in by_file[place["file"]]):
                continue
            by_file[place["file"]].append(place)
            drawn.append({**place, "id": name_of(place)})
            used[place["operator"]] += 1
            taken += 1
    return drawn


def patch(place, text):
    """The patch of a place: `find`, which stands once in the text, `replace`, the line, and the original text."""
    whole = text.encode()
    begin, end = (len(whole[:place[key]].decode()) for key in ("begin", "end"))
    context = CONTEXT
    while True:
        a, b = max(0, begin - context), min(len(text), end + context)
        find = text[a:b]
        if text.count(find) == 1:
            return {"find": find, "replace": text[a:begin] + place["replacement"] + text[end:b],
                    "line": text.count("\n", 0, begin) + 1, "original": text[begin:end]}
        context *= 2
