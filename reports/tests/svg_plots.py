# SPDX-License-Identifier: Apache-2.0
"""Reads the plots of an SVG that gnuplot drew: the places of the axes' ticks, and the strokes of each series."""
import math
import re
import typing
import xml.etree.ElementTree as xml

SVG = "{http://www.w3.org/2000/svg}"
PAIR = re.compile(r"(-?[\d.]+),(-?[\d.]+)")
PLOT = re.compile(r"_plot_\d+[a-z]?$")  # the id of a series
NEAR = 0.08  # px: coordinates have two digits


class Series(typing.NamedTuple):
    title: str
    colours: set
    lines: list  # ends of strokes, and corners of filled shapes: [(x, y)] in px
    points: list


class Plot:
    """A panel: its labelled ticks as {label: px}, the places of all of them, its series, and the lines of its grid."""

    def __init__(self):
        self.labels, self.places, self.series, self.grid = {"x": {}, "y": {}}, {"x": set(), "y": set()}, [], []

    def box(self, axes):
        """Left, right, top and bottom of the panel: the ends of its grid's lines, or `axes` where it has no grid."""
        across = [x for pair in self.grid if pair[0][1] == pair[1][1] for x, _ in pair] or [axes["xmin"], axes["xmax"]]
        along = [y for pair in self.grid if pair[0][0] == pair[1][0] for _, y in pair] or [axes["ytop"], axes["ybot"]]
        return min(across), max(across), min(along), max(along)


def number(label):
    """The number of a tick's label, or None. The label of 10⁻³ is "10|−3"; "25 (smooth)" gives 25."""
    label = label.replace("−", "-").strip()
    power = re.fullmatch(r"(?:([\d.]+)×)?10\|(-?\d+)\|?", label)
    if power:
        return float(power[1] or 1) * 10.0**int(power[2])
    found = re.match(r"[-+]?[\d.]+(e[-+]?\d+)?(?= \(|$)", label)
    return float(found[0]) if found else None


def spans(element):
    return "|".join(one.text or "" for one in element.iter(SVG + "tspan"))


def whole_text(element):
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip()


def pairs(text):
    return [(float(x), float(y)) for x, y in PAIR.findall(text or "")]


def rgb(text):
    found = re.findall(r"\d+", text or "")
    return int.from_bytes(bytes(map(int, found)), "big") if len(found) == 3 else 0


def series_of(group, title):
    made = Series(title, set(), [], [])
    for one in group.iter():
        if one.tag == SVG + "path" and one.get("class") != "gridline":
            made.lines.extend(pairs(one.get("d")))
            made.colours.add(rgb(one.get("stroke")))
        elif one.tag == SVG + "polygon":
            made.lines.extend(pairs(one.get("points")))
            made.colours.add(rgb(one.get("fill")))
        elif one.tag == SVG + "use":
            made.points.extend(pairs(one.get("transform"))[:1])
            made.colours.add(rgb(one.get("color")))
    return made


def canvas_of(root):
    return next(one for one in root.iter(SVG + "g") if one.get("id", "").endswith("_canvas"))


def read(path):
    """The panels of a picture in their order, and the axes of the last one, from the attribute data-axes of the picture."""
    root = xml.parse(path).getroot()
    axes = {name: float(value) for name, value in re.findall(r"(\w+)=([-+.\de]+)", root.get("data-axes"))}
    plots = [Plot()]
    for child in canvas_of(root):
        if PLOT.search(child.get("id", "")):
            title = child.find(SVG + "title")
            plots[-1].series.append(series_of(child, "" if title is None or title.text == child.get("id") else title.text))
            continue
        path = child.find(SVG + "path")
        marks = pairs(path.get("d")) if path is not None else []
        label = child.find(f"{SVG}g/{SVG}text")
        if path is not None and path.get("class") == "gridline":
            plots[-1].grid += [marks[i:i + 2] for i in range(0, len(marks) - 1, 2)]
        if len(marks) >= 2 and label is not None and child[0].tag == SVG + "path":
            (x, y), (x_end, y_end) = marks[-2:]
            axis, place = ("y", y) if y == y_end else ("x", x)
            if plots[-1].series and 4 <= abs(x - x_end) + abs(y - y_end) <= 20:
                plots.append(Plot())
            plots[-1].places[axis].add(place)
            plots[-1].labels[axis].setdefault(spans(label), place)
    return [one for one in plots if one.series], axes


class Axis:
    """The map from values to px, from the labels and places of ticks. `far` is the greatest distance of a tick from it, in px."""

    def __init__(self, labels, is_log):
        self.f = math.log if is_log else float
        known = [(self.f(value), place) for value, place in ((number(label), place) for label, place in labels.items())
                 if value is not None and (value > 0 or not is_log)]
        (a, at), (b, to) = min(known), max(known)
        self.slope, self.start, self.first = (to - at) / (b - a), at, a
        self.far = max(abs(self.start + self.slope * (value - a) - place) for value, place in known)

    def place(self, value):
        try:
            return self.start + self.slope * (self.f(value) - self.first)
        except ValueError:  # the logarithm of 0
            return math.inf

    def value(self, place):
        found = self.first + (place - self.start) / self.slope
        return math.exp(found) if self.f is math.log else found


def texts(path):
    """Each text of a picture, and the place of its start, middle or end in px."""
    return [(whole_text(one), *pairs(one.get("transform"))[0]) for one in xml.parse(path).getroot().iter(SVG + "g")
            if one.find(SVG + "text") is not None and one.get("transform")]


def fills_of(path, at):
    """The colours of the filled shapes of a panel, in their order; panels count from 0."""
    groups = [one for one in canvas_of(xml.parse(path).getroot()) if one.get("id", "").endswith(f"_plot_1{chr(ord('a') + at)}")]
    return [rgb(one.get("fill")) for group in groups for one in group.iter(SVG + "polygon")]


def absent(these, among):
    """Those of the first places that have none of the second ones near them."""
    cells = {(round(x * 10) + i, round(y * 10) + j) for x, y in among for i in (-1, 0, 1) for j in (-1, 0, 1)}
    return [(x, y) for x, y in these if (round(x * 10), round(y * 10)) not in cells]


def looks(path):
    """Strokes that are too thin to be seen, and axes of decades without ticks between them, each as one line."""
    ticks = {"x": [], "y": []}
    for child in canvas_of(xml.parse(path).getroot()):
        is_of_plot, title = PLOT.search(child.get("id", "")), child.find(SVG + "title")
        is_named = title is not None and title.text != child.get("id")
        for group in child.iter(SVG + "g"):
            for one in group.findall(SVG + "path"):
                marks = pairs(one.get("d"))
                if is_of_plot:
                    is_guide = not is_named or one.get("stroke-dasharray") is not None or rgb(one.get("stroke")) == 0x666666
                    width, least = float(group.get("stroke-width") or 1), 0.6 if is_guide else 1.4
                    if "fill" not in one.attrib and width < least:
                        yield f"a stroke of {width} px, not {least} or more, in {child.get('id')}"
                elif len(marks) % 2 == 0:
                    for (x, y), (x_end, y_end) in zip(marks[::2], marks[1::2]):
                        if 0 < abs(x - x_end) + abs(y - y_end) <= 8:
                            ticks["y" if y == y_end else "x"].append(y if y == y_end else x)
    for plot in read(path)[0]:
        for axis, labels in plot.labels.items():
            known = sorted((number(label), place) for label, place in labels.items() if number(label) is not None)
            decades = [(a, at, b, to) for (a, at), (b, to) in zip(known, known[1:]) if a > 0 and math.isclose(b, 10 * a)]
            for a, at, b, to in decades if len(decades) >= 2 else []:
                wanted = [at + (to - at) * math.log10(one) for one in range(2, 10)]
                if any(min((abs(place - one) for place in ticks[axis]), default=math.inf) > NEAR for one in wanted):
                    yield f"no ticks at the numbers between {a:g} and {b:g} on the {axis} axis"


def contours(path, letters):
    """For each letter, of the plots whose names end with it: black lines (is dashed, is thick, places), places of coloured lines, and texts."""
    root = xml.parse(path).getroot()
    for letter in letters:
        made = {"lines": [], "tracks": [], "texts": []}
        for group in (one for one in root.iter(SVG + "g") if re.search(rf"_plot_\d+{letter}$", one.get("id", ""))):
            for around in group.iter(SVG + "g"):
                if around.get("transform") and around.find(SVG + "text") is not None:
                    made["texts"].append((whole_text(around), *pairs(around.get("transform"))[0]))
                for one in around.findall(SVG + "path"):
                    if "fill" not in one.attrib and rgb(one.get("stroke")):
                        made["tracks"] += pairs(one.get("d"))
                    elif "fill" not in one.attrib:
                        made["lines"].append((one.get("stroke-dasharray") is not None, float(around.get("stroke-width", 1)) > 2.5, pairs(one.get("d"))))
        yield made
