#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws one solved contact: its pressure with Hertz' pressure, and its film with the films of the formulas. For an ellipse two maps
above these plots show film and pressure over the whole contact, and the plots are along its middle line.

`tribocheck film --picture` calls this. DATA is one film of the output of `tribocheck film --profile --format json`. For an
ellipse that film must have its fields. Prints as JSON which file was written, or why none was drawn.
"""
import bisect
import math

import drawing
from numbers_text import rounded

NAMES = {"moes_line": "Moes", "ertel_grubin": "Ertel–Grubin", "dowson_higginson_minimum": "Dowson–Higginson",
         "dowson_toyoda_central": "Dowson–Toyoda", "pan_hamrock_minimum": "Pan–Hamrock",
         "pan_hamrock_central": "Pan–Hamrock", "hamrock_dowson_central": "Hamrock–Dowson",
         "hamrock_dowson_minimum": "Hamrock–Dowson", "hamrock_dowson_soft_central": "Hamrock–Dowson, soft",
         "hamrock_dowson_soft_minimum": "Hamrock–Dowson, soft",
         **dict.fromkeys(("nijenbanning_venner_moes", "nijenbanning_three_halves_of_s", "nijenbanning_ei_over_ep",
                          "nijenbanning_ei_over_ep_of_s"), "Nijenbanning et al."),
         **dict.fromkeys(("chittenden_central_431", "chittenden_central_430", "chittenden_minimum_368"), "Chittenden et al.")}
HEIGHT = 840
MAP_WIDTH, MAP_HEIGHT, MAP_ROOM = 300, 560, 128  # a map's greatest width and height, and the height of the texts above and below it, in points
MAP_FILM, MAP_PRESSURE = 1.8, 1.15  # colours end near these multiples of the central film and of Hertz' peak, or near a lower greatest pressure
MAP_PRESSED = 0.06  # a map shows at least the places where the pressure is above this part of its maximum
LABEL_GAP = 0.06  # the least distance of two labels, as a part of the film's axis
LAWS = {"barus": "Barus", "roelands": "Roelands", "incompressible": "incompressible",
        "dowson_higginson": "compressible (Dowson and Higginson)"}


def window(contact):
    """The ends of the picture's axis, in half-widths. They enclose the pressure, with a small margin on each side."""
    width, peak = contact["half_width"], max(contact["profile"]["pressure"])
    pressed = [x/width for x, p in zip(contact["profile"]["x"], contact["profile"]["pressure"]) if p > 0.02*peak]
    margin = 0.06*(pressed[-1] - pressed[0])
    return min(-1.5, pressed[0] - margin), max(1.4, pressed[-1] + margin)


def spread(labels, low, high, gap):
    """Moves labels as little as possible so that they do not overlap. Returns [(place, label)]."""
    placed = []  # clusters: [mean place, labels]
    for place, label in sorted(labels, key=lambda pair: pair[0]):
        place = min(max(place, low), high)
        placed.append([place, [(place, label)]])
        while len(placed) > 1 and placed[-1][0] - placed[-2][0] < gap*(len(placed[-1][1]) + len(placed[-2][1]))/2:
            members = placed[-2][1] + placed.pop()[1]
            placed[-1] = [sum(p for p, _ in members)/len(members), members]
    result = []
    for middle, members in placed:
        half = gap*(len(members) - 1)/2
        middle = min(max(middle, low + half), high - half)
        result += [(middle - half + gap*i, label) for i, (_, label) in enumerate(members)]
    return result


def spike_note(contact):
    """The place and pressure of a spike whose height is not resolved, in m and Pa, and its label. Without such a spike they are zeros and a blank."""
    if contact["spike_pressure"] is not None or contact["spike_place"] is None:
        return 0.0, 0.0, " "
    place = contact["spike_place"]["value"]
    x, pressure = contact["profile"]["x"], contact["profile"]["pressure"]
    return place, pressure[min(range(len(x)), key=lambda i: abs(x[i] - place))], "height not resolved"


def signed(per_cent):
    text = f"{per_cent:+.1f}".replace("-", "−")
    return "0.0" if text[1:] == "0.0" else text


def axes(contact):
    """The greatest pressure and film that are shown, in Pa and m. Hertz' peak counts only below three times the solved pressure, and a
    formula's film only below twice the solved film: greater ones would leave too little room for the solved curves."""
    pressure = max(contact["profile"]["pressure"])
    if contact["peak_pressure"] < 3*pressure:
        pressure = max(pressure, contact["peak_pressure"])
    solved = contact["film_at_greatest_pressure"]["value"]
    films = [one["film"] for one in drawn_formulas(contact) if one["film"] < 2*solved]
    return 1.12*pressure, 1.45*max(solved, *films)


def row(*cells):
    return "\t".join(one if isinstance(one, str) else repr(one) for one in cells) + "\n"


def formula_text(contact, formula):
    """The formula's name and the difference of its film from the solved film, in per cent; for a starved contact, from its flooded film. If
    the formula was fitted to another liquid, its difference from the solved film of that liquid follows in brackets; if unknown, a ?."""
    liquid = contact["assumptions"]
    own = f"{liquid['viscosity']}, {'in' if liquid['density'] == 'incompressible' else ''}compressible"
    known = formula["deviation_percent"]
    of_fit = "" if formula["fitted_to"] == own else " (?)" if known is None else f" ({signed(known)} %)"
    return f"{NAMES.get(formula['name'], formula['name'])} {signed(formula['this_liquid_deviation_percent'])} %{of_fit}"


def drawn_formulas(contact):
    """The formulas that give a film. A point contact has formulas for stiff and for soft bodies: only the one that is nearest to the solved
    film is kept for each kind of film."""
    known = [one for one in contact["formulas"] if one["film"] is not None]
    if contact["ellipticity"] is None:
        return known
    return [min((one for one in known if one["stands_for"] == film), key=lambda one: abs(one["this_liquid_deviation_percent"]))
            for film in dict.fromkeys(one["stands_for"] for one in known)]


def blocks(contact):
    """Tab-separated blocks: the axes, the profile, Hertz' pressure, the films of the formulas and, for an ellipse, the maps."""
    width, profile, peak = contact["half_width"], contact["profile"], contact["peak_pressure"]
    low, high = window(contact)
    pressure_top, film_top = axes(contact)
    unit, name = (1e9, "GPa") if pressure_top > 1e8 else (1e6, "MPa")
    place, height, note = spike_note(contact)
    head = row(1e6*width*low, 1e6*width*high, pressure_top/unit, 1e6*film_top, 1e6*place, height/unit, note, name)
    solved = [row(1e6*x, p/unit, 1e6*h) for x, p, h in zip(profile["x"], profile["pressure"], profile["film"])]
    hertz = [row(1e6*width*i/200, peak/unit*max(0, 1 - (i/200)**2)**0.5) for i in range(-200, 201)]
    shown = [(one["film"], one) for one in drawn_formulas(contact) if one["film"] < film_top]
    formulas = [row(1e6*one["film"], 1e6*place, "1" if one["stands_for"] == "minimum_film" else "0",
                    formula_text(contact, one))
                for place, one in spread(shown, 0.2*film_top, 0.8*film_top, LABEL_GAP*film_top)]
    maps = Maps(contact).blocks(unit) if "fields" in contact else []
    return "\n\n".join([head, "".join(solved), "".join(hertz), "".join(formulas) or row(-1.0, -1.0, "0", " "), *maps])


def nice(step):
    """The smallest number that is 1, 2 or 5 times a power of ten and is not below `step`."""
    power = 10**math.floor(math.log10(step))
    return next(one*power for one in (1, 2, 5, 10) if one*power >= step*(1 - 1e-9))


class Maps:
    """Film and pressure over an ellipse. Chooses the part that is drawn, and computes one value for each point of the picture."""

    def __init__(self, contact):
        self.contact, fields = contact, contact["fields"]
        width, tall = contact["half_width"], contact["ellipticity"]*contact["half_width"]
        self.x, self.y = fields["x"], fields["y"]
        least = MAP_PRESSED*max(fields["pressure"])
        pressed = [divmod(i, len(self.x)) for i, p in enumerate(fields["pressure"]) if p > least]
        self.left = max(min(-1.4*width, 1.06*self.x[min(i for _, i in pressed)]), self.x[0])
        self.right = min(1.4*width, self.x[-1])
        self.side = min(max(1.3*tall, 1.06*self.y[max(j for j, _ in pressed)]), self.y[-1])
        shape = 2*self.side/(self.right - self.left)
        self.wide = min(MAP_WIDTH, MAP_HEIGHT/shape)
        self.high = self.wide*shape

    @staticmethod
    def between(places, low, high, count):
        """For each of `count` evenly spaced places from `low` to `high`: the index of the node before it, and its distance from that node
        as a part of the cell."""
        result = []
        for k in range(count):
            place = low + (high - low)*k/(count - 1)
            i = min(max(bisect.bisect_right(places, place) - 1, 0), len(places) - 2)
            result.append((i, (place - places[i])/(places[i + 1] - places[i])))
        return result

    def rows(self, to_film, to_pressure):
        across, along = round(self.high/2) + 1, round(self.wide) + 1
        columns, fields, count = self.between(self.x, self.left, self.right, along), self.contact["fields"], len(self.x)
        half = []
        for k, (j, up) in enumerate(self.between(self.y, 0, self.side, across)):
            y, values = 1e6*self.side*k/(across - 1), []
            for name, unit in (("film", to_film), ("pressure", to_pressure)):
                below, above = (fields[name][n*count:(n + 1)*count] for n in (j, j + 1))
                line = [unit*(a + up*(b - a)) for a, b in zip(below, above)]
                values.append([line[i] + part*(line[i + 1] - line[i]) for i, part in columns])
            half.append((y, values))
        places = [1e6*(self.left + (self.right - self.left)*k/(along - 1)) for k in range(along)]
        lines = [(-y, values) for y, values in reversed(half[1:])] + half
        return "\n".join("".join(f"{x:.6g}\t{y:.6g}\t{h:.6g}\t{p:.6g}\n" for x, h, p in zip(places, *values)) for y, values in lines)

    def blocks(self, pressure_unit):
        contact, fields = self.contact, self.contact["fields"]
        least, most = min(fields["film"]), MAP_FILM*contact["central_film"]["value"]
        unit, name = (1e9, "nm") if most < 2e-6 else (1e6, "µm")
        top, cut = max(fields["pressure"]), MAP_PRESSURE*contact["peak_pressure"]
        width, tall = 1e6*contact["half_width"], 1e6*contact["half_width"]*contact["ellipticity"]
        place = fields["film"].index(least)
        at = 1e6*self.x[place % len(self.x)], 1e6*self.y[place//len(self.x)]
        step, pressure_step = nice((most - least)*unit/12), nice(min(top, cut)/pressure_unit/10)
        head = row(1e6*self.left, 1e6*self.right, nice(62e6*(self.right - self.left)/self.wide), 1e6*self.side,
                   self.wide, self.high, least*unit, 2*step*math.ceil(most*unit/(2*step)), step,
                   2*pressure_step*math.ceil(min(top, cut)/pressure_unit/(2*pressure_step)), pressure_step, str(int(top > cut)), name)
        ellipse = (row(width*math.cos(math.pi*i/90), tall*math.sin(math.pi*i/90)) for i in range(181))
        return [head, self.rows(unit, 1/pressure_unit), "".join(ellipse), row(*at) + row(at[0], -at[1])]


def pressure_text(pressure):
    return f"{rounded(pressure/1e9, 3)} GPa" if pressure >= 1e8 else f"{rounded(pressure/1e6, 3)} MPa"


def drawn(contact, data):
    conditions, is_line = contact["assumptions"], contact["ellipticity"] is None
    liquid = f"{LAWS[conditions['viscosity']]}, {LAWS[conditions['density']]}"
    text = (f"M = {rounded(contact['load_number'], 3)}, L = {rounded(contact['material_number'], 3)}; "
            f"Hertz: {'half-width' if is_line else 'semi-axis'} {rounded(1e6*contact['half_width'], 3)} µm, {pressure_text(contact['peak_pressure'])}; {liquid}")
    if conditions["inlet"] == "starved":
        text += f"; behind {rounded(1e9*contact['inlet_film'], 3)} nm of oil, formulas off the flooded film"
    beside = "" if is_line else f"; least film {rounded(1e9*contact['minimum_film']['value'], 3)} nm"
    room = 40 if is_line else 20
    title = contact["id"] if len(contact["id"]) <= room else contact["id"][:room] + "…"
    return {"script": "film.gp", "data": data, "name": "film", "height": HEIGHT if is_line else HEIGHT + MAP_ROOM + round(Maps(contact).high),
            "title": drawing.enhanced(f"{title}: {'line' if is_line else 'point'} contact at {contact['speed']:.4g} m/s{beside}"),
            "subtitle": drawing.enhanced(text)}


if __name__ == "__main__":
    drawing.draw_one(__doc__, "film", blocks, drawn)
