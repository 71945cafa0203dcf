#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The picture of Stribeck curves: friction, film and load share against speed, a panel each, with the film's
maximum and with measured points.

`tribocheck curve --picture` calls this. DATA is what curve_picture() of curve_picture.cpp makes. Prints what was
drawn, as JSON.
"""
import drawing
from numbers_text import rounded
from sweep_pictures import (LOG_FROM_RATIO, NAN, axis_label, cell, colours, in_words, linear_range, readable_unit, row,
                            with_capital, with_room)

WORDS = {"friction": "friction coefficient μ", "film": "film h*", "film_flooded": "flooded film h_{ff}",
         "film_parameter": "film parameter λ", "asperity_load_share": "asperity load share A"}
PANEL, HEAD, FOOT = 230, 78, 150  # points: a panel, and the room above and below the panels
ONSET, END, MEASURED, OFF_CURVE = 1, 2, 3, 4  # kinds of marks


def values_of(data, panel):
    """All defined values of a panel."""
    curves = [values[panel] for scene in data["scenes"] for values in scene["values"]]
    return [one for one in curves if one is not None] + [one["value"] for one in data["measured"] if one["panel"] == panel]


def axis(name, unit, values):
    """The title of an axis, its two ends, whether it is logarithmic, and the factor from SI to its unit."""
    unit, factor = readable_unit(unit, values)
    label = axis_label(WORDS.get(name, in_words(name)), unit)
    shown = [factor * one for one in values]
    positive = [one for one in shown if one > 0]
    if name.endswith("_load_share"):
        return label, 0, 1, False, factor
    if name != "friction" and positive and max(positive) > LOG_FROM_RATIO * min(positive):
        return label, *with_room(min(positive), max(positive), 0.05), True, factor
    return label, *linear_range(min([0, *shown]), max(shown, default=1) or 1), False, factor


def drawn_values(values, axes):
    """The values in the units of the axes; NaN for a value that is undefined or that a logarithmic axis cannot show."""
    return [NAN if one is None or is_log and not one > 0 else factor * one
            for one, (*_, is_log, factor) in zip(values, axes)]


def standing(values, is_collapsed, panels):
    """The values of a point. A film that has collapsed is not drawn as one of 0 nm."""
    return [None if is_collapsed and panel["name"] in ("film", "film_parameter") else one for one, panel in zip(values, panels)]


def last_film(scene):
    """The place in the curve of the last point before the film collapses, if it does."""
    first = next((i for i, is_collapsed in enumerate(scene["collapsed"]) if is_collapsed), 0)
    return first - 1 if first else None


def marks_of(data, axes, colour):
    marks = []
    for scene, own in zip(data["scenes"], colour):
        if scene["onset"]:
            marks.append((ONSET, scene["onset"]["speed"], own, *drawn_values(scene["onset"]["values"], axes)))
        end = last_film(scene)
        if end is not None:
            marks.append((END, scene["speed"][end], own, *drawn_values(scene["values"][end], axes)))
    for one in data["measured"]:
        values = [one["value"] if panel == one["panel"] else None for panel in range(len(axes))]
        marks.append((MEASURED if one["is_on_curve"] else OFF_CURVE, one["speed"], 0, *drawn_values(values, axes)))
    return marks


def blocks(data):
    axes = [axis(panel["name"], panel["unit"], values_of(data, i)) for i, panel in enumerate(data["panels"])]
    colour = colours(data)
    marks = marks_of(data, axes, colour)
    speeds = [speed for scene in data["scenes"] for speed in scene["speed"]] + [one["speed"] for one in data["measured"]]
    made = ["# low\thigh\tonsets\tends\tmeasured\toff the curve\n" +
            row(min(speeds), max(speeds), *(sum(mark[0] == kind for mark in marks) for kind in (ONSET, END, MEASURED, OFF_CURVE))),
            "# label\tbottom\ttop\tlog\n" + "".join(row(label, low, high, int(is_log)) for label, low, high, is_log, _ in axes),
            "# scene\tcolour\n" + "".join(row(cell(scene["id"], 60 if len(data["scenes"]) <= 3 else 24), own) for scene, own in zip(data["scenes"], colour)),
            "# kind\tspeed\tcolour\ta value for each panel\n" + ("".join(row(*mark) for mark in marks) or row(0, NAN, 0, *[NAN] * len(axes)))]
    for scene in data["scenes"]:
        made.append("# speed\ta value for each panel\n" + "".join(
            row(speed, *drawn_values(standing(values, is_collapsed, data["panels"]), axes))
            for speed, values, is_collapsed in zip(scene["speed"], scene["values"], scene["collapsed"])))
    return "\n\n".join(made)


def missing_text(data):
    """Which panels lack a part of a curve, and why: "no friction where Λ is below 3: the faces touch"."""
    panels = {}
    for scene in data["scenes"]:
        for name, reason in scene["missing"].items():
            panels.setdefault(reason.split(",")[0], {})[in_words(name)] = None
    return [f"no {' or '.join(names)} where {reason}" for reason, names in panels.items()]


def subtitle_of(data):
    scenes, found = data["scenes"], [scene["onset"]["speed"] for scene in data["scenes"] if scene["onset"]]
    texts = []
    if found:
        texts.append("dot: film maximum" + (f", at {rounded(found[0], 3)} m/s" if len(scenes) == 1 else ""))
    if data["measured"]:
        texts.append("squares: measured")
    texts += missing_text(data)
    return with_capital("; ".join(texts)) or " "


def drawn(data, folder):
    scenes = data["scenes"]
    title = f"{cell(scenes[0]['id'], 60)}: Stribeck curve" if len(scenes) == 1 else "Stribeck curves"
    return {"script": "curve.gp", "data": folder, "name": "curve", "height": HEAD + FOOT + PANEL * len(data["panels"]),
            "title": drawing.enhanced(title), "subtitle": drawing.enhanced(subtitle_of(data))}


if __name__ == "__main__":
    drawing.draw_one(__doc__, "curve", blocks, drawn)
