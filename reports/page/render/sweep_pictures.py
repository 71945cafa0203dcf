#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of a sweep's result. The content of the result decides which pictures there are.

  onset_distribution    histograms of the onset speed, a lane for each scene and criterion
  sensitivity_<column>  Sobol indices of a scalar column, the greatest on top
  film_map…             a grid of one field, with its points kept and three speeds or more: the film over speed and the field;
                        a grid of two fields: the film over both
  film_curves…          the film over one field of a grid that has too few values for a map
  curve_band_<column>   median and 95 % band of an output over speed, if fields are drawn; beside a grid, a band for each set

`tribocheck sweep --pictures` calls this; the report draws two of them. RESULT is what
`tribocheck sweep show --format json` prints, with the cases of `grid`; - is stdin. Prints what was drawn, as JSON.
"""
import argparse
import json
import math
import pathlib
import re
import typing

import drawing
from numbers_text import NO_ENTRY, exact, grouped, percent, rounded

OF_SURFACES = {"rough": 0xD86400, "medium": 0x006B50, "smooth": 0x003468}  # the colours of colour() in style.gp
# After Okabe and Ito.
COLOURS = (0x003468, 0xD86400, 0x006B50, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x8C6D00, 0x000000)
NAN, INFINITY = math.nan, math.inf


class Picture(typing.NamedTuple):
    stem: str
    script: str
    heading: str
    subtitle: str
    height: int
    blocks: str  # the picture's data: blocks of tab-separated rows

    def drawn(self, folder="."):
        return {"script": self.script, "data": folder, "name": self.stem, "height": self.height,
                "title": drawing.enhanced(self.heading), "subtitle": self.subtitle}


# --- Texts and numbers of the data files.

def row(*cells):
    return "\t".join(one if isinstance(one, str) else exact(one) for one in cells) + "\n"


def cell(text, longest=40):
    """A text of the user on one line. After `longest` characters it is cut and gets an ellipsis."""
    text = "".join(" " if ord(sign) < 0x20 or ord(sign) == 0x7f else "'" if sign == '"' else sign for sign in text)
    text = text if len(text) <= longest else text[:longest] + "…"
    return text if text.strip(" ") else "–"  # in an empty cell gnuplot would repeat the cell of the row before


def in_words(name):
    return name.replace("_", " ")


def field_words(path):
    """lubricant.pressure_viscosity becomes pressure viscosity."""
    return in_words(path.rpartition(".")[2])


def column_words(column):
    """onset.film_maximum.speed becomes onset speed (film maximum)."""
    onset, _, quantity = column.rpartition(".")
    if not onset:
        return in_words(column)
    quantity = "onset speed" if quantity == "speed" else f"{in_words(quantity)} at the onset"
    return f"{quantity} ({field_words(onset)})"


def with_capital(words):
    return words[:1].upper() + words[1:]


def file_name(kind, column):
    return f"{kind}_{column}".replace(".", "_")


def colours(result):
    """The colour of each scene. The paper's surfaces have the same colours as in its figures."""
    ids = [scene["id"] for scene in result["scenes"]]
    free = [one for one in COLOURS if one not in [OF_SURFACES.get(id) for id in ids]]
    others = iter(free[i % len(free)] for i in range(len(ids)))
    return [OF_SURFACES[id] if id in OF_SURFACES else next(others) for id in ids]


def pale(colour):
    parts = [(colour >> shift) & 0xFF for shift in (16, 8, 0)]
    red, green, blue = (part + (0xFF - part) * 11 // 20 for part in parts)
    return red << 16 | green << 8 | blue


def readable_unit(unit, values):
    """A unit in which numbers have few zeros, and its factor: nm where all values are films, GPa where they are pressures."""
    greatest = max((abs(value) for value in values if value is not None), default=0)
    if unit == "Pa" and greatest >= 1e5:
        return ("GPa", 1e-9) if greatest >= 1e8 else ("MPa", 1e-6)
    if unit != "m" or greatest == 0 or greatest >= 1e-2:
        return unit, 1
    return ("nm", 1e9) if greatest < 1e-5 else ("µm", 1e6)


def axis_label(words, unit):
    return f"{words} ({unit or '–'})"


def with_room(low, high, part):
    """The range of a logarithmic axis, with a little room at both ends."""
    factor = (high / low)**part if high > low else 1.1
    return low / factor, high * factor


def quantile(value, level):
    found = next((one["value"] for one in value.get("quantiles", ()) if one["level"] == level), None)
    return NAN if found is None else found


def column_of(scene, name):
    return next((column for column in scene["columns"] if column["name"] == name), None)


# --- Grids crossed with distributions.

MOST_CURVES = 8


def apart(result):
    """The result with a scene for each set of grid values, because a band over all sets would be as wide as the grid. If that
    makes more than MOST_CURVES scenes, the result stays as it is; a scene without `cells` stays, too."""
    cells = [scene.get("cells", []) for scene in result["scenes"]]
    if sum(max(1, len(of_scene)) for of_scene in cells) > MOST_CURVES:
        return result
    scenes = []
    for scene, of_scene in zip(result["scenes"], cells):
        for one in of_scene:
            values = re.sub(r"(^|, )\w+\.", r"\1", one["values"])  # without the tables' names
            scenes.append({**scene, "id": values if len(cells) == 1 else f"{scene['id']}, {values}", "of_grid": values,
                           "cases": scene["cases"] // len(of_scene), "columns": one["columns"], "sets": 1})
        scenes += [] if of_scene else [scene]
    return {**result, "scenes": scenes}


def mixed_words(scenes):
    """A remark for a subtitle: several sets of grid values widen the spread. Empty if there is one set."""
    sets = max((scene.get("sets", 1) for scene in scenes), default=1)
    return f", over all {sets} sets of grid values, which widen it" if sets > 1 else ""


def legend(scene):
    return cell(scene["id"], 60 if "of_grid" in scene else 24)


# --- The spread of onset speeds.

NAME_ROOM, GAP, PEAK = 0.55, 0.15, 0.82  # in units of a lane: room of a scene's name, gap to the next scene, greatest bar


def bins_of(value):
    """Low end, high end and cases per logarithm of speed. Two bins of the result make one, so that the shape shows."""
    edges, counts = value["histogram"]["edges"], value["histogram"]["counts"]
    for i in range(0, len(counts), 2):
        low, high = edges[i], edges[min(i + 2, len(counts))]
        yield low, high, sum(counts[i:i + 2]) / math.log(high / low) if low > 0 else 0


def outline(base, value, colour):
    """The density of cases over the logarithm of the speed. The highest bar is PEAK high."""
    bins = list(bins_of(value))
    greatest = max((density for _, _, density in bins), default=0)
    text = "".join(row(speed, base, base + PEAK * density / greatest, colour)
                   for low, high, density in bins if low > 0 and greatest > 0 for speed in (low, high))
    return text or row(NAN, base, base, colour)


def height_at(value, speed):
    """The height of the outline at a speed, over its greatest height."""
    bins = list(bins_of(value))
    greatest = max((density for _, _, density in bins), default=0)
    here = next((density for low, high, density in bins if low <= speed < high), 0)
    return here / greatest if greatest > 0 else 0


def numbers_beside(value):
    """Median and 95 % interval: 0.0934 (0.0810 to 0.108)."""
    if value["count"] == 0:
        return "no onset in any case"
    middle, low, high = (rounded(quantile(value, level), 3) for level in (0.5, 0.025, 0.975))
    return f"{middle} ({low} to {high})"


def no_onset_in(value):
    if value["count"] == 0 or value["undefined"] == 0:
        return "-"  # gnuplot knows no empty cell
    return f"no onset in {rounded(100 * value['undefined'] / (value['count'] + value['undefined']), 2)} % of the cases"


def onset_distribution(result, reported=()):
    """`reported`: the printed onset speed of a scene, with the least and the greatest number that round to it."""
    result = apart(result)
    colour = colours(result)
    base, lanes, scenes, outlines, ends, cases = 0, [], [], [], [], 0
    for scene, own in reversed(list(zip(result["scenes"], colour))):
        speeds = [column for column in scene["columns"] if column["name"].startswith("onset.")
                  and column["name"].endswith(".speed") and len(column["values"]) == 1]
        if not speeds:
            continue
        bottom = base
        for column in reversed(speeds):
            value = column["values"][0]
            ends += value["histogram"]["edges"]
            median = quantile(value, 0.5)
            lanes.append(row(base, cell(scene["id"]), in_words(column["name"].split(".")[-2]), own, median,
                             quantile(value, 0.025), quantile(value, 0.975), height_at(value, median),
                             numbers_beside(value), no_onset_in(value)))
            outlines.append("\n\n" + outline(base, value, own))
            base += 1
        mark = next((one for one in reported if one["scene"] == scene["id"]), None)
        marks = [mark["value"], mark["low"], mark["high"]] if mark else [NAN] * 3
        ends += marks[1:] if mark else []
        scenes.append(row(cell(scene["id"], 60), base + 0.2, bottom, base, *marks, own))
        cases += scene["cases"]
        base += NAME_ROOM + GAP
    ends = [one for one in ends if one > 0]
    if not ends:
        return None
    top = base - GAP
    blocks = ("# low\thigh\ttop\treported\n" + row(*with_room(min(ends), max(ends), 0.02), top, 1 if reported else 0) +
              "\n\n# base\tscene\tcriterion\tcolour\tmedian\tquantile_0.025\tquantile_0.975\theight_at_median\ttext\t"
              "missing\n" + "".join(lanes) +
              "\n\n# scene\tname_at\tbottom\ttop\treported\treported_low\treported_high\tcolour\n" + "".join(scenes) +
              "".join(outlines))
    return Picture("onset_distribution", "sweep_onset_distribution.gp", "How the onset speeds scatter",
                   f"{grouped(cases)} cases, over the logarithm of the speed; each lane to the same height{mixed_words(result['scenes'])}",
                   round(78 + 92 + 50 * (top + 0.12)), blocks)


# --- The fields that cause the variance.

DRAWN_FROM = 0.005
BAR, BETWEEN = 18, 14  # points


def indices_of(scene, name):
    """The Sobol indices of each variable; empty where the column has none."""
    column = column_of(scene, name)
    if column is None or len(column["values"]) != 1:
        return {}
    indices = column["values"][0].get("sensitivity", {}).get("variables", {})
    return indices if any(one["total"]["value"] is not None for one in indices.values()) else {}


def ranked(result, name):
    """All variables of all scenes with their greatest total, the greatest first."""
    greatest = {}
    for scene in result["scenes"]:
        for variable, one in indices_of(scene, name).items():
            greatest[variable] = max(greatest.get(variable, 0), one["total"]["value"] or 0)
    return sorted(greatest.items(), key=lambda one: -one[1])


def total_text(scene, name, variable):
    """0.712 ± 0.011; 0.712 alone if the error is not known, or less than half of the last digit."""
    total = indices_of(scene, name).get(variable, {}).get("total", {})
    value, high = total.get("value"), total.get("high")
    if value is None:
        return NO_ENTRY
    return f"{value:.3f}".replace("-", "−") + (
        "" if high is None or high - value < 0.0005 else f" ± {high - value:.3f}")


def with_ends(index):
    if index["value"] is None:
        return NAN, NAN, NAN
    return (index["value"], *(end if end is not None else unbounded
                              for end, unbounded in ((index["low"], -INFINITY), (index["high"], INFINITY))))


def fewer_groups(subjects, name):
    """A remark for a subtitle. A group of cases is left out if one of its cases has no value of the column."""
    parts = [(column_of(scene, name)["values"][0]["sensitivity"]["groups"], scene["draws"]) for scene, _, _ in subjects]
    groups, draws = min(parts, key=lambda part: part[0] / part[1])
    return f"; {grouped(groups)} of {grouped(draws)} groups have it" if groups < draws else ""


def sensitivity(result, name):
    all_colours = colours(result)
    subjects = [(scene, colour, indices_of(scene, name)) for scene, colour in zip(result["scenes"], all_colours)]
    subjects = [one for one in subjects if one[2]]
    rows = ranked(result, name)
    shown = [variable for variable, greatest in rows if greatest >= DRAWN_FROM]
    if not shown:
        return None
    between = BETWEEN / BAR  # in units of a bar
    top = (len(subjects) + between) * len(shown)
    y, right, variables, bars = top - between / 2, 1, "", ""
    for variable in shown:
        variables += row(y - len(subjects) / 2, cell(field_words(variable), 30))
        for scene, colour, indices in subjects:
            y -= 1
            if variable not in indices:
                continue
            total = with_ends(indices[variable]["total"])
            right = max(right, total[2]) if math.isfinite(total[2]) else right
            bars += row(y + 0.5, 0.42, *with_ends(indices[variable]["first_order"]), *total, colour, pale(colour),
                        cell(scene["id"]), variable)
        y -= between
    scenes = "".join(row(cell(scene["id"], 24), colour, pale(colour)) for scene, colour, _ in subjects)
    blocks = ("# right\ttop\n" + row(right * 1.02, top) + "\n\n# y\tvariable\n" + variables +
              "\n\n# y\thalf_height\tfirst_order\tfirst_order_low\tfirst_order_high\ttotal\ttotal_low\ttotal_high\t"
              "colour\tpale\tscene\tvariable\n" + bars + "\n\n# scene\tcolour\tpale\n" + scenes)
    left_out = len(rows) - len(shown)
    key_rows = math.ceil((len(subjects) + 2 if len(subjects) > 1 else 2) / 3)
    return Picture(file_name("sensitivity", name), "sweep_sensitivity.gp",
                   f"What carries the variance: {column_words(name)}",
                   "Sobol indices, with 95 % intervals of the totals" + fewer_groups(subjects, name) +
                   (f"; below {DRAWN_FROM} and left out: {left_out} input{'s' if left_out > 1 else ''}"
                    if left_out else ""),
                   round(max(78 + 92 + 22 * key_rows + BAR * top, 480)), blocks)


# --- Bands over speed.

LOG_FROM_RATIO = 20


def is_band(scene, column):
    return (scene["design"] != "factorial" and column is not None and len(column["values"]) > 1
            and "words" not in column["values"][0])


def without_value(values):
    """For the legend: the greatest part, over all speeds, of cases without a value, such as friction without a film."""
    missing = [value["undefined"] / (value["count"] + value["undefined"]) for value in values]
    if not any(missing):
        return ""
    first = next(value["speed"] for value, part in zip(values, missing) if part)
    return f": no film and no value in up to {percent(max(missing), 2)} of the cases, from {rounded(first, 3)} m/s on"


def linear_range(low, high):
    """The range of a linear axis that holds low and high. It begins at 0 if 0 ≤ low < high/2."""
    low = 0 if 0 <= low < high / 2 else low
    room = 0.04 * (high - low)
    return low - room if low else 0, high + (room if room > 0 else 1)


def curve_band(result, name):
    result = apart(result)
    bands = [(scene, column_of(scene, name), colour) for scene, colour in zip(result["scenes"], colours(result))]
    bands = [one for one in bands if is_band(*one[:2])]
    if not bands:
        return None
    columns = [(column["unit"], [value[end] for value in column["values"] for end in ("least", "greatest") if value[end] is not None])
               for _, column, _ in bands]
    unit, factor = min((readable_unit(*one) for one in columns if one[1]), key=lambda one: one[1], default=(None, 1))
    speeds, shown, scenes, curves = [], [], "", ""
    for number, (scene, column, colour) in enumerate(bands, 1):
        scenes += row(number, legend(scene), colour, legend(scene) + without_value(column["values"]))
        curves += "\n\n# speed\tquantile_0.025\tquantile_0.5\tquantile_0.975\n"
        for value in column["values"]:
            # Where most cases have no value, the quantiles of the rest do not describe the scene.
            is_of_few = value["undefined"] > value["count"]
            band = [NAN if is_of_few else factor * quantile(value, level) for level in (0.025, 0.5, 0.975)]
            speeds.append(value["speed"])
            shown += [one for one in band if math.isfinite(one)]
            curves += row(value["speed"], *band)
    if not shown:
        return None
    low, high = min(shown), max(shown)
    is_log = low > 0 and high > LOG_FROM_RATIO * low
    ends = with_room(low, high, 0.03) if is_log else linear_range(low, high)
    words = column_words(name)
    is_part = any(value["undefined"] for _, column, _ in bands for value in column["values"])
    return Picture(file_name("curve_band", name), "sweep_curve_band.gp", with_capital(words + " over speed"),
                   "lines: medians; bands: 95 % of the cases " +
                   ("that have a value, where most cases have one" if is_part else "at each speed") + mixed_words([scene for scene, _, _ in bands]), 640,
                   "# low\thigh\tbottom\ttop\tlog\tlabel\tlabel_across\n" +
                   row(min(speeds), max(speeds), *ends, 1 if is_log else 0, axis_label(words, unit), "entrainment speed u (m/s)") +
                   "\n\n# number\tscene\tcolour\tlegend\n" + scenes + curves)


# --- The film over speed and one field.

MOST_COLUMNS, MOST_ROWS = 120, 90  # an SVG with so many polygons still opens


def thinned(count, most):
    some = min(count, most)
    return [i * (count - 1) // (some - 1) for i in range(some)]


def speed_of_greatest(speeds, films):
    """The speed at the top of the parabola, in logarithms, through the greatest film and its neighbours. NaN if the
    greatest film is at an end; its own speed if a neighbour has no film."""
    at = films.index(max(films))
    if at == 0 or at + 1 >= len(films):
        return NAN
    if not films[at - 1] > 0 or not films[at + 1] > 0:
        return speeds[at]
    before, after = math.log(speeds[at - 1] / speeds[at]), math.log(speeds[at + 1] / speeds[at])
    fall_before, fall_after = math.log(films[at - 1] / films[at]) / before, math.log(films[at + 1] / films[at]) / after
    curvature = (fall_after - fall_before) / (after - before)
    if curvature >= 0:
        return speeds[at]
    slope = fall_before - curvature * before
    return speeds[at] * math.exp(min(max(-slope / (2 * curvature), before), after))


FLAT = 0.01


def end_of_floor(speeds, films):
    """The speed up to which the film stays as it is at the least speed, because asperities carry all of the load. NaN if
    the film changes at once."""
    flat = 0
    while flat + 1 < len(films) and films[0] > 0 and abs(films[flat + 1] / films[0] - 1) < FLAT:
        flat += 1
    return speeds[flat] if flat else NAN


def is_face(path):
    """Is `path` the radius of a face? Such a radius is negative if the face is concave."""
    return re.fullmatch(r"bodies\.(first|second)_radius_[xy]", path) is not None


FILMS = {"film": "film h*", "solved_film.central": "solved central film", "solved_film.minimum": "solved minimum film"}
ZERO_CELSIUS = 273.15  # K
LEAST_VALUES = 3  # of an axis of a map
SMOOTH = 48  # If a map has fewer values, colours are interpolated between them.


class Axis(typing.NamedTuple):
    """An axis of a map: its title and the places of the values, in the order in which they are drawn."""
    label: str
    words: str
    values: list
    factor: float = 1  # from SI units
    zero: float = 0  # in SI units: 273.15 K if °C are shown
    is_speed: bool = False

    def shown(self):
        return [self.factor * (one - self.zero) for one in self.values]

    def is_log(self):
        return self.zero == 0 and self.values[0] > 0 and self.values[-1] > 3 * self.values[0]


def axis_of(field, values):
    """The axis of a field; None where it has too few values, or where they pass through infinity."""
    # A flat face has no place on an axis of radii: its radius is infinite, null in JSON. From convex to concave faces
    # the radius passes through infinity, not through 0, so that no axis has both.
    values = sorted({at for at in values if at is not None})
    if not values or is_face(field["path"]) and values[0] < 0 < values[-1]:
        return None
    unit, factor = readable_unit(field["unit"], [values[0], values[-1]])
    words = field_words(field["path"])
    if unit == "K":
        return Axis(axis_label(words, "°C"), words, values, zero=ZERO_CELSIUS)
    return Axis(axis_label(words, unit), words, values, factor)


def speed_axis(speeds):
    return Axis("entrainment speed u (m/s)", "speed", speeds, is_speed=True)


def at_speed(speed):
    return f" at {rounded(speed, 3)} m/s"


def film_map(scene, stem, column, across, up, films, where):
    """`films`: the film (m) at each pair of values of the two axes."""
    label = FILMS[column]
    shown, table, ridge, floor, has_gaps, has_ridge, on_floor = [], "", "", "", False, False, 0
    for i in thinned(len(up.values), MOST_ROWS):
        at, row_of_films = up.shown()[i], [films.get((x, up.values[i]), NAN) for x in across.values]
        row_of_films = [NAN if one is None else one for one in row_of_films]
        for j in thinned(len(across.values), MOST_COLUMNS):
            here = 1e9 * row_of_films[j] if row_of_films[j] > 0 else NAN  # a collapsed film has no logarithm: a hole
            has_gaps = has_gaps or math.isnan(here)
            shown += [] if math.isnan(here) else [here]
            table += row(across.shown()[j], at, here)
        table += "\n"
        greatest = speed_of_greatest(across.values, row_of_films) if across.is_speed else NAN
        has_ridge = has_ridge or not math.isnan(greatest)
        ridge += row(greatest, at)
        end = end_of_floor(across.values, row_of_films) if column == "film" and across.is_speed else NAN
        floor += row(end, at)
        on_floor += sum(x <= end for x in across.values) / len(across.values)
    if not shown or not min(shown) < max(shown):
        return None
    floor_part = percent(on_floor / len(thinned(len(up.values), MOST_ROWS)), 2)
    has_flat = any(None in values for values in scene["grid"]["fields"])
    gap = "it has collapsed" if column == "film" else "not solved"
    subtitle = (f"{drawing.enhanced(cell(scene['id']))}: {len(across.values)} × {len(up.values)} points{where}" +
                ("; flat faces are left out" if has_flat else "") + ("; orange: the greatest film" if has_ridge else "") +
                (f"; white: {gap}" if has_gaps else "") +
                (f"; left of black, {floor_part}: a floor, asperities carry the load" if on_floor else ""))
    heading = "Film" if column == "film" else with_capital(label)
    return Picture(stem, "sweep_film_map.gp", f"{heading} over {across.words} and {up.words}", subtitle, 720,
                   "# low\thigh\tbottom\ttop\tlog\tleast\tgreatest\tlabel\tlabel_across\tlog_across\tfilm\tlabel_every\tinterpolated\n" +
                   row(across.shown()[0], across.shown()[-1], up.shown()[0], up.shown()[-1], int(up.is_log()), min(shown),
                       max(shown), up.label, across.label, int(across.is_speed or across.is_log()), axis_label(label, "nm"),
                       max(4, min(60, len(across.values))), max(1, SMOOTH // max(len(across.values), len(up.values)))) +
                   "\n\n# speed\tfield\tfilm_nm\n" + table + "\n# speed\tfield, of the greatest film\n" + ridge +
                   ("\n\n# speed\tfield, at the end of the floor\n" + floor if on_floor else ""))


def film_curves(scene, stem, across, curves):
    """`curves`: for each curve's name, its films (m) at the values of the axis."""
    shown = [1e9 * one for films in curves.values() for one in films if one is not None and one > 0]
    if not shown or not 0 < len(curves) <= MOST_CURVES:
        return None
    low, high = min(shown), max(shown)
    is_log = high > LOG_FROM_RATIO * low
    scenes = text = ""
    for number, (name, films) in enumerate(curves.items(), 1):
        scenes += row(number, cell(scene["id"], 24), COLOURS[number - 1], cell(name, 60))
        text += "\n\n# field\tfilm_nm\tfilm_nm\tfilm_nm\n" + "".join(
            row(at, *[1e9 * film if film is not None and film > 0 else NAN] * 3) for at, film in zip(across.shown(), films))
    return Picture(stem, "sweep_curve_band.gp", f"Film over {across.words}", drawing.enhanced(cell(scene["id"])), 640,
                   "# low\thigh\tbottom\ttop\tlog\tlabel\tlabel_across\n" +
                   row(across.shown()[0], across.shown()[-1], *(with_room(low, high, 0.03) if is_log else linear_range(low, high)),
                       int(is_log), "film (nm)", across.label) +
                   "\n\n# number\tscene\tcolour\tlegend\n" + scenes + text)


def value_text(field, value):
    if field["unit"] == "K":
        return f"{field_words(field['path'])} {rounded(value - ZERO_CELSIUS, 3)} °C"
    unit, factor = readable_unit(field["unit"], [value])
    return f"{field_words(field['path'])} {rounded(factor * value, 3)} {unit}".rstrip(" ")


def grid_pictures(scene, number):
    """Maps of a grid over speed and its field, or over its two fields; curves where an axis has too few values."""
    grid = scene.get("grid")
    if not grid:
        return []
    fields, speeds = scene["inputs"], grid["speeds"]
    axes = [axis_of(field, values) for field, values in zip(fields, grid["fields"])]
    if None in axes:
        return []
    suffix = "" if number == 1 else f"_{number}"
    cases = list(zip(*grid["fields"]))
    made = []
    if len(axes) == 1 and len(speeds) >= LEAST_VALUES and len(axes[0].values) >= LEAST_VALUES:
        for column, films in grid["films"].items():
            at = {(speed, case[0]): film for case, row_of_films in zip(cases, films) for speed, film in zip(speeds, row_of_films)}
            stem = "film_map" + ("" if column == "film" else "_" + column.rpartition(".")[2]) + suffix
            made.append(film_map(scene, stem, column, speed_axis(speeds), axes[0], at, ""))
        return made
    if len(axes) == 2 and min(len(axis.values) for axis in axes) >= LEAST_VALUES:
        for column, films in grid["films"].items():
            for i, speed in enumerate(speeds):
                at = {case: row_of_films[i] for case, row_of_films in zip(cases, films)}
                stem = "film_map" + ("" if column == "film" else "_" + column.rpartition(".")[2]) + (f"_speed_{i + 1}" if i else "") + suffix
                made.append(film_map(scene, stem, column, *axes, at, at_speed(speed)))
        return made
    longest = max(range(len(axes)), key=lambda i: len(axes[i].values))
    if len(axes[longest].values) < LEAST_VALUES:
        return []
    curves = {}
    for column, films in grid["films"].items():
        for i, speed in enumerate(speeds):
            for other in axes[1 - longest].values if len(axes) == 2 else [None]:
                at = {case[longest]: row_of_films[i] for case, row_of_films in zip(cases, films)
                      if other is None or case[1 - longest] == other}
                name = FILMS[column] + at_speed(speed) + ("" if other is None else ", " + value_text(fields[1 - longest], other))
                curves[name] = [at.get(value) for value in axes[longest].values]
    return [film_curves(scene, "film_curves" + suffix, axes[longest], curves)]


# --- All of them.

def pictures(result):
    names = dict.fromkeys(column["name"] for scene in result["scenes"] for column in scene["columns"])
    made = [onset_distribution(result), *(sensitivity(result, name) for name in names)]
    number = 1
    for scene in result["scenes"]:
        of_grid = grid_pictures(scene, number)
        made += of_grid
        number += any(of_grid)
    made += [curve_band(result, name) for name in names]
    return [one for one in made if one]


def write_blocks(picture, folder):
    path = folder / f"{picture.stem}.blocks.tsv"
    drawing.write_text(path, picture.blocks)
    return path


def draw_all(result, folder):
    """The paths of drawn pictures, and why the others were not drawn."""
    written, undrawn = [], []
    for picture in pictures(result):
        write_blocks(picture, folder)
        for kind in ("svg", "png"):
            target = folder / f"{picture.stem}.{kind}"
            why = drawing.draw(picture.drawn(), folder, target)
            if not why:
                written.append(str(target))
                continue
            target.unlink(missing_ok=True)  # an old picture would not belong to the new data
            if why == drawing.NO_GNUPLOT:
                return written, [f"{why}: no pictures (Debian: apt-get install gnuplot-nox)"]
            undrawn.append(f"{target}: {why}")
    return written, undrawn


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=pathlib.Path, metavar="RESULT")
    parser.add_argument("folder", type=pathlib.Path, help="for the pictures and their data")
    arguments = parser.parse_args()
    result = drawing.read_data(arguments.result)
    try:
        written, undrawn = draw_all(result, arguments.folder)
    except OSError as error:
        written, undrawn = [], [f"cannot write {error.filename or arguments.folder}: {error.strerror}"]
    print(json.dumps({"written": written, "undrawn": undrawn}))


if __name__ == "__main__":
    main()
