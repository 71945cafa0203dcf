# SPDX-License-Identifier: Apache-2.0
"""The contents that each picture of the report's page has to draw, from the columns of its data and from report.json.

A picture is a list of panels. A panel is a tuple: whether x is logarithmic, whether y is (or the values at the ends of a y axis without
ticks), the series in the order of the plot, and whether points may lie outside of the panel. A series is a tuple: its name in the legend,
its colour, its points, and whether gnuplot adds strokes of its own (caps of error bars, corners of boxes). A name or colour may be None.
"""
import itertools
import math
import re

from page_tables import quantile, sig
from report_files import table
from svg_plots import NEAR, Axis, absent, contours, fills_of, looks, number, read, texts

COLOURS = {"rough": 0xD86400, "medium": 0x006B50, "smooth": 0x003468, "ball_on_flat": 0x003468, "bearing_outer_ring": 0x006B50,
           "gear_flank": 0xD86400}
SURFACES, GREY = ("rough", "medium", "smooth"), 0x666666
FOOT, TOP = "foot", "top"  # in place of a y: the lower and the upper end of a panel
SMOOTH = COLOURS["smooth"]


SPEED, FILM = "entrainment speed u (m/s)", "film h* (nm)"
WORK = ("CPU time a point (ns)", "true error (ulp): greatest, and down to the mean")
AXES = {  # titles of the axes: the x axis, and the y axis of each panel
    "figure_04": (SPEED, FILM), "figure_07": (SPEED, "real area / nominal area, Ar/Anom (–)"), "figure_08": (SPEED, "summits in contact (–)"),
    "figure_09": (SPEED, "share of the load (–)"), "figure_10": (SPEED, FILM), "figure_11": (SPEED, FILM, "film with GW / film with GT (–)"),
    "figure_12": (SPEED, "friction coefficient μ (–)", "film parameter λ = h*/σs (–)"),
    "stribeck_of_machines": (SPEED, "friction coefficient μ (–)", "film parameter λ = h*/σs (–)", "load share of the asperities (–)"),
    "onset_against_roughness": ("standard deviation of summit heights σs (nm)", "speed at the onset of starvation (m/s)"),
    "share_against_roughness": ("standard deviation of summit heights σs (nm)", "load share of the asperities"),
    "readings_by_score": ("claims reproduced, of 17", "readings"), "onset_distribution": ("onset speed (m/s)",),
    "sensitivity_onset_film_maximum_speed": ("part of the variance",),
    "line_film_errors": ("load number M (–)", "material number L (–)", "error of the formula's film (%): (formula − solved)/solved"),
    "point_film_errors": ("load number M (–)", "liquid, and material number L (–)", "error of the formula's film (%)"),
    "line_film_profile": ("place across the contact x/b (–); the surfaces move to the right", "pressure p/p0 (–)", "film h (µm)"),
    "ellipse_fits": ("ratio of the radii α = Ry/Rx", "|error| of k (%)", "|error| of ax (%)", "|error| of p0 (%)"),
    "paper_films": (SPEED, "smooth: h*/hoil (–)", "medium: h*/hoil (–)", "rough: h*/hoil (–)"),
    "starved_ratios": ("layer of oil over the flooded film ρ (–)", "starved over flooded film ℛ (–)", "exponent γ of Damiens (–)"),
    **{f"{films}_growth": ("cells N of the grid", "CPU time (s)", "memory (MB)") for films in ("line_film", "point_film")},
    **{f"work_{films}": ("CPU time a contact (s)", "greatest relative error (–)") for films in ("line_film", "point_film")}}


def series(title, colour, points, adds=False):
    return title, colour, points, adds


def keys(*titles):
    return [series(title, None, []) for title in titles]


def column(rows, x, y, factor=1):
    return [(float(row[x]), y if y in (FOOT, TOP) else factor * float(row[y])) for row in rows]


def blocks(path):
    """Yields the name and the rows of each block. The last commented line of the file has the names of the columns."""
    names = [line for line in path.read_text().splitlines() if line.startswith("# ")][-1][2:].split("\t")
    names = [name.split(" [")[0] for name in names]
    for block in re.split(r"\n\n\n", path.read_text()):
        lines = [line for line in block.splitlines() if line and line[0] != "#"]
        yield lines[0].strip('"'), [dict(zip(names, line.split("\t"), strict=True)) for line in lines[1:]]


class Data:
    def __init__(self, out, report):
        self.out, self.report = out, report
        self.marks = table(out / "data/marks.tsv")
        self.words = {}  # texts beside the points of each picture

    def curve(self, stem, y, factor=1):
        return column([row for row in table(self.out / f"data/curve_{stem}.tsv") if row["inlet"] != "collapsed"], "speed", y, factor)

    def mark(self, event, surface, model, y, factor=1):
        return column([row for row in self.marks if (row["event"], row["surface"], row["model"]) == (event, surface, model)], "speed", y, factor)

    # --- The paper's figures.

    def over_speed(self, y, events=("printed", "onset", "collapse"), factor=1):
        found = [series(f"{s} (GT)", COLOURS[s], self.curve(s, y, factor)) for s in SURFACES]
        found.append(series("smooth (GW)", SMOOTH, self.curve("smooth_gw", y, factor)))
        for event in events:
            found += [series("", COLOURS[s], self.mark(event, s, "GT", y, factor)) for s in SURFACES]
            found.append(series("", SMOOTH, self.mark(event, "smooth", "GW", y, factor)))
        return found

    KEYS = keys("onset (film maximum)", "collapse", "past it, as printed")

    def figure_07(self):
        return [(True, False, self.over_speed("real_area_ratio") + self.KEYS, False)]

    def figure_08(self):
        return [(True, True, self.over_speed("summit_count") + self.KEYS, False)]

    def figure_09(self):
        both = ("asperity_load_share", "fluid_load_share")
        lines = [series(f"{name}, {s}", COLOURS[s], self.curve(s, y)) for name, y in zip(("asperities", "fluid"), both) for s in SURFACES]
        marks = [series("", COLOURS[s], self.mark(event, s, "GT", y)) for event in ("printed", "onset", "collapse") for s in SURFACES for y in both]
        return [(True, False, lines + marks + self.KEYS, False)]

    def figure_10(self):
        lines = self.over_speed("film", (), 1e9)[:3]
        marks = [series("", COLOURS[s], self.mark(event, s, "GT", y, 1e9)) for event, y in
                 (("reported", "film"), ("onset", "film"), ("collapse", FOOT)) for s in SURFACES]
        return [(True, True, lines + marks + keys("onset (film maximum)", "onset speed as the paper reports it", "collapse: film 0"), True)]

    def figure_11(self):
        marks = [series("", SMOOTH, self.mark(event, "smooth", model, y, 1e9)) for event, y in (("onset", "film"), ("collapse", FOOT))
                 for model in ("GT", "GW")]
        ratio = column(table(self.out / "data/figure_11_ratio.tsv"), "speed", "film with GW/film with GT")
        upper = [series("", 0x4A93C0, self.curve("smooth", "film", 1e9)), series("", 0x222222, self.curve("smooth_gw", "film", 1e9)), *marks]
        lower = [series("smooth (GT)", None, []), series("smooth (GW)", None, []), series("ratio of the films", SMOOTH, ratio),
                 series("equal", GREY, [(1e-4, 1), (3, 1)], True), *keys("onset (film maximum)", "collapse: film 0")]
        return [(True, True, upper, True), (True, False, lower, True)]

    def figure_12(self):
        def panel(y, foot):
            found = self.over_speed(y, ())
            found += [series("", COLOURS[s], self.mark("reported", s, "GT", y)) for s in SURFACES]
            found += [series("", COLOURS[s], self.mark("onset", s, "GT", y)) for s in SURFACES] + [series("", SMOOTH, self.mark("onset", "smooth", "GW", y))]
            return found + [series("", COLOURS[s], self.mark("collapse", s, "GT", foot)) for s in SURFACES]
        upper = [series("", *one[1:]) for one in panel("friction", TOP)]
        lower = panel("film_parameter", "film_parameter")
        lower.insert(4, series("λ = 1.4, reported", GREY, [(1e-4, 1.4), (3, 1.4)], True))
        return [(True, False, upper, True), (True, False, lower + keys("onset (film maximum)", "onset speed, reported", "collapse"), False)]

    def figure_04(self):
        names = {"flooded": "flooded inlet (no supply)", "starved_inlet": "starved_inlet, constant flow", "damiens": "damiens, constant flow"}
        lines = [series(title, SMOOTH, column(table(self.out / f"data/figure_04_{name}.tsv"), "speed", "film", 1e9)) for name, title in names.items()]
        guides = [list(group) for _, group in itertools.groupby(table(self.out / "data/figure_04_guides.tsv"), lambda row: row["slope of ln film in ln speed"])]
        self.words["figure_04"] = [(f"slope {row['slope of ln film in ln speed'].replace('-', '−')}", float(row["speed"]), 1e9 * float(row["film"]))
                                   for row in (rows[1] for rows in guides)]
        lines.append(series("the paper's closure, constant hoil", SMOOTH, self.curve("smooth", "film", 1e9)))
        lines += [series("", GREY, column(rows, "speed", "film", 1e9)) for rows in guides] + keys("", "")
        lines.append(series("", SMOOTH, column(table(self.out / "data/figure_04_marks.tsv"), "speed", "film", 1e9)))
        lines.append(series("onset (film maximum)", SMOOTH, self.mark("onset", "smooth", "GT", "film", 1e9)))
        return [(True, True, lines + [series("collapse: film 0", SMOOTH, self.mark("collapse", "smooth", "GT", FOOT))], True)]

    # --- The figures of the ledger and of the contacts.

    def over_roughness(self, what, law, is_log, more=()):
        rows = table(self.out / "data/ledger_surfaces.tsv")
        ends = [f"{what}_{inputs}_{end}" for inputs in ("plausible", "print") for end in ("low", "high")]
        edges = [column(rows, "sd_nm", end) for end in ends]
        found = [series("plausible inputs, 95 %", 0xDCE6EE, edges[0] + edges[1]), series("print precision, 95 %", 0x9FBAD0, edges[2] + edges[3])]
        found += [series("", 0x6A8FB0, edge) for edge in edges]
        found += [series(title, colour, column(table(self.out / "data/ledger_law.tsv"), "sd_nm", y)) for title, colour, y in law]
        found += [series(title, colour, column(rows, "sd_nm", y)) for title, colour, y in more]
        names = [f"{what}_reported" if what == "share" else "onset_reported",
                 *(f"{'share_' if what == 'share' else ''}reported_{end}" for end in ("low", "high"))]
        reported = [point for name in names for point in column(rows, "sd_nm", name)]
        return [(True, is_log, found + [series("reported, with its print precision", None, reported, True)], False)]

    def onset_against_roughness(self):
        return self.over_roughness("onset", [("film maximum, closed form", 0x0072B2, "film_maximum"),
                                             ("film 5 % below the flooded one", 0x009E73, "film_departure_0.05")], True,
                                   [("least friction", 0xCC79A7, "friction_minimum")])

    def share_against_roughness(self):
        return self.over_roughness("share", [("corrected reading", 0x0072B2, "slow_asperity_share")], False)

    def readings_by_score(self):
        counts = [(score, count) for score, count in enumerate(self.report["ledger"]["ranking"]["readings_by_score"]) if count]
        return [(False, True, [series("", 0x6A8FB0, [(score + side, count) for score, count in counts for side in (-0.35, 0.35)]), *keys("")], False)]

    def stribeck_of_machines(self):
        titles = {"ball_on_flat": "ball on a flat (circle)", "bearing_outer_ring": "bearing's outer ring (ellipse)", "gear_flank": "gear's flank (line)"}
        marks = {row["name"]: row for row in table(self.out / "data/contact_marks.tsv")}
        panels = []
        for y, is_log in (("friction", False), ("film_parameter", True), ("asperity_load_share", False)):
            last = y == "asperity_load_share"
            lines = [series(titles[s] if last else "", COLOURS[s], column(table(self.out / f"data/contact_{s}.tsv"), "speed", y)) for s in titles]
            lines += [series("", COLOURS[s], column([marks[s]], "speed", y)) for s in titles]
            panels.append((True, is_log, lines + (keys("least friction") if last else []), False))
        return panels

    # --- The figures of films, fits and work.

    def line_film_profile(self):
        rows = table(self.out / "data/line_film_profile.tsv")
        upper = [series("", 0xD55E00, column(rows, "x/b", "p/p0")), series("", 0x0072B2, column(rows, "x/b", "Hertz' p/p0"))]
        return [(False, False, upper, True), (False, False, [series("solved", 0xD55E00, column(rows, "x/b", "film")), *keys("dry contact of Hertz")], True)]

    def ellipse_fits(self):
        found = list(blocks(self.out / "data/ellipse_fits.blocks.tsv"))
        colours = (0xD55E00, 0x0072B2, 0x009E73, 0)
        return [(True, True, [series(title if last else None, colour, [(x, abs(y)) for x, y in column(rows, "R_y/R_x", of, 100)])
                              for (title, rows), colour in zip(found, colours)], True)
                for of, last in (("ellipticity", False), ("semi-axis a_x", False), ("peak pressure", True))]

    CLOSURES = {"flooded_inlet": 0x0072B2, "starved_inlet": 0x009E73, "printed_exponents": 0xCC79A7, "damiens": 0xD55E00}

    def paper_films(self):
        panels = []
        films = dict(blocks(self.out / "data/paper_films.blocks.tsv"))
        for surface, rows in blocks(self.out / "data/paper_closures.blocks.tsv"):
            last = surface == "rough"
            found = [series("flooded film, solved" if last else None, GREY, column(rows, "speed", "flooded"))]
            found += [series(name if last else None, colour, column(rows, "speed", name)) for name, colour in self.CLOSURES.items()]
            found.append(series("starved film, solved" if last else None, 0, column(films[surface], "speed", "film/layer"), True))
            found += [series(title if last else None, 0x7B3294, [(x, 0.06) for x, _ in self.mark(event, surface, "GT", "film")])
                      for title, event in (("onset, reported", "reported"), ("onset (film maximum)", "onset"))]
            panels.append((True, False, found, True))
        return panels

    def starved_ratios(self):
        curves = table(self.out / "data/starved_closures.tsv")
        found = list(blocks(self.out / "data/starved_ratios.blocks.tsv"))
        upper = [series("", colour, column(curves, "supply", name)) for name, colour in self.CLOSURES.items()]
        upper += [series("", 0, column(rows, "supply", "ratio"), True) for _, rows in found]
        lower = keys(*self.CLOSURES) + [series(title, 0x444444, column(rows, "supply", "Damiens' exponent")) for title, rows in found]
        return [(True, False, upper, True), (True, False, lower, True)]

    def line_film_growth(self, films="line_film"):
        found = list(blocks(self.out / f"data/work_precision/{films}_growth.blocks.tsv"))
        fits = {title: {row["quantity"]: f"N^{float(row['exponent of the cells']):.2f} ± {float(row['its standard error']):.1g}" for row in rows}
                for title, rows in blocks(self.out / f"data/work_precision/{films}_exponents.blocks.tsv")}
        upper = [series(f"{title} {words}: {fits[title][fit]}", None, column(rows, "cells", of, 1e-9)) for words, of, fit in (
            ("step", "CPU time of a step of Newton's method", "step_ns"), ("matrix", "CPU time for the matrix of influences", "kernel_ns"))
            for title, rows in found]
        return [(True, True, upper, False),
                (True, True, [series(f"{title}: {fits[title]['bytes']}", None, column(rows, "cells", "bytes", 1e-6)) for title, rows in found], False)]

    def point_film_growth(self):
        return self.line_film_growth("point_film")

    def work(self, name):
        stem, of_evaluations = re.fullmatch(r"work_(.*?)(_evaluations)?", name).groups()
        of_films = stem in ("line_film", "point_film")
        everything = list(blocks(self.out / f"data/work_precision/{stem}.blocks.tsv"))
        found = [one for one in everything if not of_films or "_minimum" not in one[0]][:8]  # only these are drawn
        x, factor = ("CPU time a contact", 1e-9) if of_films else ("CPU time a point", 1)
        x, y = "evaluations a point" if of_evaluations else x, "greatest relative error" if of_films else "greatest error"

        def points(rows, of=y):
            return [(factor * a, b) for a, b in column(rows, x, of)]
        bars = [] if of_evaluations or of_films else [series("", None, points(rows) + points(rows, "mean error"), True) for _, rows in found]
        shown = [one for one in found if not of_evaluations or one[1][0][x] != "NaN"]
        missing, title = ("no numbers", "no number in some cases") if of_films else ("failures", "failures in some cases")
        failing = [row for _, rows in (everything if of_films else found) for row in rows if float(row[missing]) > 0]
        return [(True, True, bars + [series(name, None, points(rows)) for name, rows in shown] +
                 [series(title, 0, points(failing))] * (bool(failing) or not of_films), False)]

    # --- The figures of the sweep, from report.json alone.

    def sensitivity_onset_film_maximum_speed(self):
        found = self.report["onset_uncertainty"]
        scenes = found["sweep"]["scenes"]
        of = [next(one for one in scene["columns"] if one["name"] == found["agreement"]["column"])["values"][0]["sensitivity"]["variables"]
              for scene in scenes]
        order = sorted(of[0], key=lambda name: -max(one[name]["total"]["value"] for one in of))
        shown = [name for name in order if max(one[name]["total"]["value"] for one in of) >= 0.005]
        height = (len(scenes) + 14 / 18) * len(shown)
        bars, rows = [], []
        self.words["sensitivity_onset_film_maximum_speed"] = [
            (name.split(".")[-1].replace("_", " "), None, height - (len(scenes) + 14 / 18) * (i + 0.5)) for i, name in enumerate(shown)]
        for i, (name, scene) in enumerate(itertools.product(shown, range(len(scenes)))):
            rows.append((height - 7 / 18 - i - 14 / 18 * (i // len(scenes)) - 0.5, of[scene][name]))
        for kind in ("total", "first_order"):
            bars.append(series("", None, [(max(0, one[kind]["value"]), y + side) for y, one in rows for side in (-0.42, 0.42)], True))
        bars += [series("", colour, [(one["total"][end], y) for y, one in rows for end in ("low", "high")], True) for colour in (0xFFFFFF, 0x222222)]
        return [(False, (0, height), bars + keys("", *(one["id"] for one in scenes), "alone (first order)", "with all others (total)"), True)]

    def onset_distribution(self):
        found = self.report["onset_uncertainty"]
        reported = {one["surface"]: one["reported"] for one in found["surfaces"]}
        base, boxes, outlines, bars, medians, marks = 0, [], [], [], [], []
        for scene in reversed(found["sweep"]["scenes"]):
            lanes = [one["values"][0] for one in reversed(scene["columns"]) if re.fullmatch(r"onset\.\w+\.speed", one["name"])]
            ends = [base, base + len(lanes)]
            boxes += [(reported[scene["id"]][end], y) for end in ("low", "high") for y in ends]
            marks += [(reported[scene["id"]]["value"], y) for y in ends]
            self.words.setdefault("onset_distribution", []).append((scene["id"], None, ends[1] + 0.2))
            names = [one["name"].split(".")[1].replace("_", " ") for one in reversed(scene["columns"]) if one["name"].endswith(".speed")]
            for name, value in zip(names, lanes, strict=True):
                low, middle, high = (sig(quantile(value, level), 3) for level in (0.025, 0.5, 0.975))
                self.words["onset_distribution"] += [(text, None, base + 0.2) for text in (name, f"{middle} ({low} to {high})")]
                if value["undefined"]:
                    part = sig(100 * value["undefined"] / (value["count"] + value["undefined"]), 2)
                    self.words["onset_distribution"].append((f"no onset in {part} % of the cases", None, base))
                edges, counts = value["histogram"]["edges"], value["histogram"]["counts"]
                bins = [(edges[i], edges[min(i + 2, len(counts))], sum(counts[i:i + 2])) for i in range(0, len(counts), 2)]
                high = max(count / math.log(to / low) for low, to, count in bins)
                middle = quantile(value, 0.5)
                heights = [(low, to, 0.82 * count / math.log(to / low) / high) for low, to, count in bins]
                outlines.append(series("", COLOURS[scene["id"]], [(at, base + up) for low, to, height in heights
                                                                       for at in (low, to) for up in (0, height)]))
                bars += [(quantile(value, level), base) for level in (0.025, 0.975)]
                medians += [(middle, base), (middle, base + next(0.8 * height / 0.82 for low, to, height in heights if low <= middle < to))]
                base += 1
            base += 0.7
        found = [series("", 0xE6E6E6, boxes), *outlines, series("", 0x222222, bars, True), series("", 0xFFFFFF, medians),
                 series("", 0x222222, marks), *keys("reported", "rounds to it")]
        return [(True, (-0.12, base - 0.15), found, False)]


def map_differences(path, data):
    """Yields the faults of the six maps: a contour (dashed below 0) where the table's errors do not pass a level, a label or track off its place."""
    rows = table(data.out / "data/line_film_errors.tsv")
    tracks = [point for _, block in blocks(data.out / "data/line_film_tracks.blocks.tsv") for point in column(block, "load number M", "material number L")]
    loads, materials = (sorted({float(row[name]) for row in rows}) for name in ("load number M", "material number L"))
    at = {(float(row["load number M"]), float(row["material number L"])): row for row in rows}
    plots = [one for one in read(path)[0] if one.labels["x"]]
    labels = list(blocks(data.out / "data/line_film_labels.blocks.tsv"))
    for plot, (name, told), strokes in zip(plots, labels, contours(path, "bdfhjl"), strict=True):
        across, up = Axis({one: x for one, x in plot.labels["x"].items() if number(one) and "+" not in one}, True), Axis(plot.labels["y"], True)

        def around(load, material):
            """The errors at the corners of the table's cell around a place. The cell is widened a little, because places are rounded."""
            some = [[one for low, one, high in zip([0, *grid], grid, [*grid[1:], math.inf]) if low / 1.002 <= value <= high * 1.002]
                    for grid, value in ((loads, load), (materials, material))]
            return [float(at[place][name]) for place in itertools.product(*some)]
        yield from (f"{name}: a tick's label is {axis.far:.2f} px from its place" for axis in (across, up) if axis.far > 0.05)
        for is_dashed, is_thick, points in strokes["lines"]:
            levels = [0] if is_thick else [(-1 if is_dashed else 1) * one for one in (2, 5, 10, 20, 30, 50, 70)]
            for x, y in points:
                errors = around(across.value(x), up.value(y))
                if not any(min(errors) - 0.01 <= level <= max(errors) + 0.01 for level in levels):
                    yield f"{name}: a contour at ({x}, {y}) where the errors are {min(errors)} to {max(errors)}"
        for row in told:
            x, y = across.place(float(row["load number M"])), up.place(float(row["material number L"]))
            errors = around(float(row["load number M"]), float(row["material number L"]))
            if not min(errors) - 0.01 <= float(row["error"]) <= max(errors) + 0.01:
                yield f"{name}: the label {row['text']} stands where the errors are {min(errors)} to {max(errors)}"
            if not any(text == row["text"].strip('"') and abs(a - x) < 1 and abs(b - y) < 8 for text, a, b in strokes["texts"]):
                yield f"{name}: the label {row['text']} is not at its place"
        wanted = [(across.place(x), up.place(y)) for x, y in tracks if loads[0] < x < loads[-1] and materials[0] < y < materials[-1]]
        yield from (f"{name}: no track at {one}" for one in absent(wanted, strokes["tracks"])[:1])


def cell_differences(path, data):
    """Yields the faults of the nine panels of cells. Each M, liquid and L has one cell, with the error as a number; there are no other cells. A
    cell is blue where the formula's film is too thin and orange where it is too thick, and its colour is stronger for a greater error."""
    plots = [one for one in read(path)[0] if "2000" in one.labels["x"]]
    found, written = dict(blocks(data.out / "data/point_film_errors.blocks.tsv")), texts(path)
    order = [one["name"] for one in data.report["point_films"]["formulas"]]
    panels = [order[i] for i in (0, 2, 3, 6, 4, 7, 1, 8, 5)]  # left: the power laws; right: readings of Nijenbanning's law
    if len(plots) != len(panels) or set(found) != set(panels):
        yield f"{len(plots)} panels of {len(found)} formulas"
        return
    for at, (plot, name) in enumerate(zip(plots, panels)):
        across, rows = Axis(plot.labels["x"], True), plots[at - at % 2].labels["y"]  # only the left panels name their rows
        corners = plot.series[0].lines
        cells = [tuple(f(one[i] for one in corners[n:n + 4]) for i in (0, 1) for f in (min, max)) for n in range(0, len(corners), 4)]
        fills = fills_of(path, at)
        if len(cells) != len(found[name]) or len(fills) != len(cells):
            yield f"{name}: {len(cells)} cells of {len(found[name])} errors"
            continue
        seen = []
        for row in found[name]:
            x, y, error = across.place(float(row["load number M"])), rows[f"{row['liquid']} {row['material number L']}"], float(row["error"])
            here = [(cell, fill) for cell, fill in zip(cells, fills) if cell[0] < x < cell[1] and cell[2] < y < cell[3]]
            text = "0" if abs(error) < 0.5 else f"{'−' if error < 0 else '+'}{abs(error):.0f}"
            if len(here) != 1:
                yield f"{name}: {len(here)} cells at {row}"
                continue
            (left, right, top, bottom), fill = here[0]
            warmth = (fill >> 16) - (fill & 0xFF)  # red less blue
            seen.append((error, warmth))
            if abs(error) > 1 and (warmth > 0) != (error > 0):
                yield f"{name}: the colour {fill:#x} at {row}"
            if not any(one == text and left < a < right and top < b < bottom for one, a, b in written):
                yield f"{name}: no {text} at {row}"
        for sign in (-1, 1):  # one scale: warmth grows with the error
            ordered = sorted((sign * error, sign * warmth) for error, warmth in seen if sign * error > 0)
            yield from (f"{name}: the colours of {a} and {b} are out of order" for a, b in itertools.pairwise(ordered) if a[1] > b[1] + 2)


def differing(plot, box, across, up, wanted, leaves):
    """Yields the differences of one panel: other names or colours, points that are not drawn, and strokes where no point is."""
    left, right, top, bottom = box
    shown = [one for one in plot.series if one.title or one.lines or one.points]
    wanted = [one for one in wanted if one[0] or any(math.isfinite(y) for _, y in one[2] if y not in (FOOT, TOP)) or
              any(y in (FOOT, TOP) for _, y in one[2])]
    if len(shown) != len(wanted):
        yield f"{len(shown)} series, not {len(wanted)}"
        return
    for drawn, (title, colour, points, adds) in zip(shown, wanted):
        name = f"{drawn.title!r} for {title!r}: "
        places = [(across.place(x), {FOOT: bottom, TOP: top}[y] if y in (FOOT, TOP) else up.place(y)) for x, y in points]
        places = [(x, y) for x, y in places if math.isfinite(x) and math.isfinite(y)]
        inside = [(x, y) for x, y in places if left - NEAR <= x <= right + NEAR and top - NEAR <= y <= bottom + NEAR]
        seen = [(x, y) for x, y in drawn.lines + drawn.points if left - NEAR <= x <= right + NEAR and top - NEAR <= y <= bottom + NEAR]
        between = [(x, y) for x, y in seen if min(x - left, right - x, y - top, bottom - y) > NEAR]
        if title is not None and drawn.title != title:
            yield name + "another name"
        if colour is not None and inside and drawn.colours != {colour}:
            yield name + f"colours {sorted(map(hex, drawn.colours))}, not {colour:#x}"
        if len(inside) < len(places) and not leaves:
            yield name + f"{len(places) - len(inside)} points lie outside"
        for words, these, among in (("not drawn: ", inside, seen), ("drawn, but of no point: ", [] if adds else between, places)):
            far = absent(these, among)
            if far:
                yield name + f"{len(far)} places {words}{far[0]}"


def differences(path, name, data):
    """The differences of a picture from its required contents, each as one line."""
    written = texts(path)
    said = [f"no axis is named {one}" for one in AXES.get(name, ("evaluations a point", "true error (ulp), greatest") if "_evaluations" in name else WORK)
            if one not in [text for text, _, _ in written]]
    said += looks(path)
    if name == "line_film_errors":
        return said + list(map_differences(path, data))
    if name == "point_film_errors":
        return said + list(cell_differences(path, data))
    panels = getattr(data, name)() if hasattr(data, name) else data.work(name)
    plots, axes = read(path)
    if len(plots) != len(panels):
        return [f"{len(plots)} panels, not {len(panels)}"]
    for at, (plot, (x_log, y_log, wanted, leaves)) in enumerate(zip(plots, panels), 1):
        below = next(one for one in plots[at - 1:] if any(number(label) is not None for label in one.labels["x"]))
        left, right, top, bottom = plot.box(axes)
        across, up = Axis(below.labels["x"], x_log), (
            Axis(plot.labels["y"], y_log) if isinstance(y_log, bool) else Axis({f"{y_log[0]:.9f}": bottom, f"{y_log[1]:.9f}": top}, False))
        if plot.places["x"] != below.places["x"]:
            said.append(f"panel {at}: ticks stand elsewhere than in the panel below")
        said += [f"panel {at}: a tick's label is {axis.far:.2f} px from its place" for axis in (across, up) if axis.far > 0.05]
        said += [f"panel {at}: {label!r} has a hyphen for a minus" for ticks in plot.labels.values() for label in ticks if "-" in label]
        for text, x, y in data.words.get(name, ()):  # within 25 px of y, and within 95 px of x where it is given
            if not any(text == one and (x is None or abs(a - across.place(x)) < 95) and abs(b - up.place(y)) < 25 for one, a, b in written):
                said.append(f"panel {at}: {text!r} is not written at {x}, {y}")
        said += [f"panel {at}: {one}" for one in differing(plot, (left, right, top, bottom), across, up, wanted, leaves)]
    return said
