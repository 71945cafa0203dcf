#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The picture of one solved contact, a line or the middle of an ellipse: its pressure beside Hertz', and its film beside the formulas'.

`tribocheck film --picture` calls this. DATA is one film of what `tribocheck film --profile --format json`
prints. Prints what was drawn, as JSON.
"""
import drawing
from numbers_text import rounded

NAMES = {"moes_line": "Moes", "ertel_grubin": "Ertel–Grubin", "dowson_higginson_minimum": "Dowson–Higginson",
         "dowson_toyoda_central": "Dowson–Toyoda", "pan_hamrock_minimum": "Pan–Hamrock",
         "pan_hamrock_central": "Pan–Hamrock", "hamrock_dowson_central": "Hamrock–Dowson",
         "hamrock_dowson_minimum": "Hamrock–Dowson", "hamrock_dowson_soft_central": "Hamrock–Dowson, soft bodies",
         "hamrock_dowson_soft_minimum": "Hamrock–Dowson, soft bodies",
         "nijenbanning_venner_moes": "Nijenbanning–Venner–Moes"}
HEIGHT = 840
LABEL_GAP = 0.06  # part of the film's axis between two labels
LAWS = {"barus": "Barus", "roelands": "Roelands", "incompressible": "incompressible",
        "dowson_higginson": "compressible (Dowson and Higginson)"}


def window(contact):
    """The ends of the picture's axis in half-widths: the pressure, and a little room beside it."""
    width, peak = contact["half_width"], max(contact["profile"]["pressure"])
    pressed = [x/width for x, p in zip(contact["profile"]["x"], contact["profile"]["pressure"]) if p > 0.02*peak]
    margin = 0.06*(pressed[-1] - pressed[0])
    return min(-1.5, pressed[0] - margin), max(1.4, pressed[-1] + margin)


def spread(labels, low, high, gap):
    """Labels at places as near to their own as possible without overlap: [(place, label)]."""
    placed = []  # clusters: [mean place, labels]
    for place, label in sorted(labels, key=lambda pair: pair[0]):
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
    """The place and pressure of the spike, in m and Pa, and its label."""
    if contact["spike_pressure"] is not None or contact["spike_place"] is None:
        return 0.0, 0.0, " "
    place = contact["spike_place"]["value"]
    x, pressure = contact["profile"]["x"], contact["profile"]["pressure"]
    return place, pressure[min(range(len(x)), key=lambda i: abs(x[i] - place))], "height not resolved"


def signed(per_cent):
    text = f"{per_cent:+.1f}".replace("-", "−")
    return "0.0" if text[1:] == "0.0" else text


def axes(contact):
    """The greatest pressure and film that are shown, in Pa and m. Where the load bends the bodies little, Hertz'
    pressure is far above that of the film; and a formula that is far off would press the film flat."""
    pressure = max(contact["profile"]["pressure"])
    if contact["peak_pressure"] < 3*pressure:
        pressure = max(pressure, contact["peak_pressure"])
    solved = contact["film_at_greatest_pressure"]["value"]
    films = [one["film"] for one in drawn_formulas(contact) if one["film"] < 2*solved]
    return 1.12*pressure, 1.45*max(solved, *films)


def row(*cells):
    return "\t".join(one if isinstance(one, str) else repr(one) for one in cells) + "\n"


def formula_text(contact, formula):
    """The formula's name and its difference from the drawn film, and in brackets, where it was fitted to another liquid, that
    from the film of that liquid; a ? where that liquid is not known."""
    liquid = contact["assumptions"]
    own = f"{liquid['viscosity']}, {'in' if liquid['density'] == 'incompressible' else ''}compressible"
    known = formula["deviation_percent"]
    of_fit = "" if formula["fitted_to"] == own else " (?)" if known is None else f" ({signed(known)} %)"
    return f"{NAMES.get(formula['name'], formula['name'])} {signed(formula['this_liquid_deviation_percent'])} %{of_fit}"


def drawn_formulas(contact):
    """The formulas with a film; of a point contact, whose laws are of stiff and of soft bodies, the nearest for each film."""
    known = [one for one in contact["formulas"] if one["film"] is not None]
    if contact["ellipticity"] is None:
        return known
    return [min((one for one in known if one["stands_for"] == film), key=lambda one: abs(one["this_liquid_deviation_percent"]))
            for film in dict.fromkeys(one["stands_for"] for one in known)]


def blocks(contact):
    """Tab-separated blocks: the axes; the profile; Hertz' pressure; the formulas' films."""
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
    return "\n\n".join([head, "".join(solved), "".join(hertz), "".join(formulas) or row(-1.0, -1.0, "0", " ")])


def pressure_text(pressure):
    return f"{rounded(pressure/1e9, 3)} GPa" if pressure >= 1e8 else f"{rounded(pressure/1e6, 3)} MPa"


def drawn(contact, data):
    conditions, is_line = contact["assumptions"], contact["ellipticity"] is None
    liquid = f"{LAWS[conditions['viscosity']]}, {LAWS[conditions['density']]}"
    text = (f"M = {rounded(contact['load_number'], 3)}, L = {rounded(contact['material_number'], 3)}; "
            f"Hertz: {'half-width' if is_line else 'semi-axis'} {rounded(1e6*contact['half_width'], 3)} µm, {pressure_text(contact['peak_pressure'])}; {liquid}")
    beside = "" if is_line else f", its middle; least film {rounded(1e6*contact['minimum_film']['value'], 3)} µm beside it"
    room = 40 if is_line else 20
    title = contact["id"] if len(contact["id"]) <= room else contact["id"][:room] + "…"
    return {"script": "film.gp", "data": data, "name": "film", "height": HEIGHT,
            "title": drawing.enhanced(f"{title}: {'line' if is_line else 'point'} contact at {contact['speed']:.4g} m/s{beside}"),
            "subtitle": drawing.enhanced(text)}


if __name__ == "__main__":
    drawing.draw_one(__doc__, "film", blocks, drawn)
