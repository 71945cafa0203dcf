# SPDX-License-Identifier: Apache-2.0
"""The published scenes, solved: their inputs, curves and onsets, compared with what the paper reports."""
import math
import typing

import curves
import ledger
import scenes
from group import Group, finding
from numbers_text import exact
from published import Published

TOLD = ("speed", "film", "film_parameter", "asperity_load_share", "real_area_ratio", "summit_count", "friction")
QUANTITIES = ("onset_speed", "onset_film_parameter", "slow_asperity_share")


# The misprints that change an input of a scene.
ERRATA = {"surface.summit_radius": "E17", "surface.offset_planes": "E9", "bodies.effective_modulus": "E2",
          "bodies.reduced_radius": "E18", "friction.boundary_coefficient": "E20", "friction.fluid": "E19",
          "friction.viscosity": "E20", "closures.starvation": "E11"}
# The choices of E9: the offset of the summits' planes, divided by D_d. The last one is that of two equal faces, if the printed
# D_d/σ_s is that of one face and the printed σ_s that of their sum.
OFFSETS = {"m = 1": 1.0, "m = 2": 2.0, "equal faces": math.sqrt(2)}
SUPPLIES = ("inlet_film", "inlet_film_ratio", "inlet_flow")


class Case(typing.NamedTuple):
    """One of the six scenes, solved: a surface with the contact of Greenwood and Tripp (GT), or Greenwood and Williamson (GW)."""
    source: Published
    solved: curves.Solved

    @property
    def surface(self):
        return self.source.surface

    @property
    def model(self):
        return self.source.model

    def of_contact(self, name):
        return self.source.about.contact[name]["value"]

    def reported(self, claims, quantity):
        """The paper's printed number for the quantity, as a row of claims.tsv; None where none is printed."""
        return next((row for row in claims if (row["rule"], row["quantity"], row["surface"]) == ("number", quantity, self.surface)
                     and row["model"] in (self.model, "both")), None)


def told(point):
    return point and {name: point[name] for name in TOLD}


def equal_share_speed(case):
    """The first speed at which the film carries half the load. The asperities' share falls with speed up to the onset, and
    rises beyond it."""
    contact, onset = case.solved.contact, case.solved.at_onset

    def holds(speed):
        share = contact.at(speed)["asperity_load_share"]
        return share is not None and share <= 0.5
    return curves.first_speed(contact.low, onset["speed"] if onset else contact.high, holds)


def least_friction(case):
    """The least friction, of the curve's points and of the minimum between them."""
    frictions = [point["friction"] for point in case.solved.curve if point["friction"] is not None]
    interior = case.solved.onsets["friction_minimum"]["speed"]
    if frictions and interior is not None:
        frictions += [one for one in [case.solved.contact.at(interior)["friction"]] if one is not None]
    return min(frictions, default=None)


def supply_of(about):
    """A scene without a supply is flooded."""
    given = ((kind, about.input(f"supply.{kind}")) for kind in SUPPLIES)
    kind, value = next((one for one in given if one[1] is not None), ("flooded", 0.0))
    return {"kind": kind, "value": value}


def inputs_of(cases):
    """Rows of the inputs for which at least one scene has a value."""
    rows = []
    for name, entry in cases[0].about.inputs.items():
        values = {case.stem: case.about.input(name) for case in cases if case.about.input(name) is not None}
        if values:
            rows.append({"field": name, "unit": entry["unit"], "meaning": entry["meaning"], "erratum": ERRATA.get(name),
                         "values": values})
    return rows


def scene_of(case):
    about, one = case.source.about, case.solved
    return {
        "file": case.source.file, "surface": case.surface, "model": case.model, "load": about.input("load"),
        "supply": supply_of(about), "starvation": about.input("closures.starvation"),
        "slowest": told(one.slowest), "fastest": told(one.curve[-1]), "onset": told(one.at_onset), "collapse": told(one.at_collapse),
        "mean_pressure": case.of_contact("mean_pressure"), "peak_pressure": case.of_contact("peak_pressure"),
        "contact_share": min(1.0, case.of_contact("share_without_film")), "equal_share_speed": equal_share_speed(case),
        "least_friction": least_friction(case)}


def offsets(program, cases):
    """The paper's main numbers by GT for each choice of E9. The scenes have that offset on one plane."""
    made = []
    for name, planes in OFFSETS.items():
        contacts = []
        for case in cases:
            scene = case.solved.contact.scene
            offset = planes * scene["surface"]["summit_plane_offset"]
            contacts.append(scene | {"surface": scene["surface"] | {"offset_planes": 1, "summit_plane_offset": offset}})
        onsets = scenes.onsets(program, contacts, ("film_maximum",))
        slowest = program.ask(*(line for one in contacts for line in scenes.points(one, one["speed"]["from"])))
        made.append({"name": name, "offset": contacts[0]["surface"]["summit_plane_offset"], "surfaces": {
            case.surface: {"slow_asperity_share": point["asperity_load_share"], "onset_speed": onset["film_maximum"]["speed"]}
            for case, onset, point in zip(cases, onsets, slowest)}})
    return made


# --- Computed beside reported.

def judged(computed, value, last_digit):
    """The verdict on a number that the paper prints, as the ledger judges it (verification/reproduction/claims.hpp)."""
    half = last_digit / 2 * (1 + 1e-9)  # the slack is the rounding of the decimals
    if value - half <= computed <= value + half:
        return "reproduced"
    factor = computed / value
    if factor > 0 and abs(factor - 1) <= 0.1:
        return "within 10 %"
    return "order only" if factor > 0 and abs(math.log(factor)) <= math.log(10) / 2 else "not reproduced"


def row_of(case, claims, quantity, criterion, computed, none):
    claim = case.reported(claims, quantity)
    value = claim and float(claim["value"])
    is_compared = computed is not None and claim is not None
    row = {"surface": case.surface, "model": case.model, "criterion": criterion, "computed": computed, "reported": value,
           "factor": computed / value if is_compared else None,
           "verdict": judged(computed, value, float(claim["last_digit"])) if is_compared else None}
    return row if computed is not None else row | {"none": none}


def rows_of(cases, claims, quantity):
    if quantity == "slow_asperity_share":
        return [row_of(case, claims, quantity, None, case.solved.slowest["asperity_load_share"], "") for case in cases]
    name = {"onset_speed": "speed", "onset_film_parameter": "film_parameter"}[quantity]
    return [row_of(case, claims, quantity, criterion, onset[name], onset.get("undefined", {}).get("speed"))
            for case in cases for criterion, onset in case.solved.onsets.items()]


def comparison(quantity, rows):
    """The finding on the compared numbers. Of several onset criteria only film_maximum counts."""
    counted = [row for row in rows if row["verdict"] and row["criterion"] in (None, "film_maximum")]
    agreeing = sum(row["verdict"] == "reproduced" for row in counted)
    factors = [row["factor"] for row in counted]
    standing = "absent" if not counted else "holds" if agreeing == len(counted) else "differs"
    return ({"rows": rows, "counted": len(counted), "agreeing": agreeing,
             "factors": [min(factors), max(factors)] if factors else []}, finding(quantity, "comparison", "paper", standing))


# --- Figure 4: film against speed, u^0.67 while the inlet is flooded, u^−1 once it starves. The second slope needs an oil
# supply that is carried in at a constant rate, and a closure with h* → h_oil.

class SlopeCurve(typing.NamedTuple):
    change: str  # the difference from the scene's file
    solved: curves.Solved

    def slope(self, low, high):
        """d ln h*/d ln u between two speeds a thousandth apart; None where the film has collapsed."""
        film_low, film_high = (point["film"] for point in self.solved.contact.solve(low, high))
        return math.log(film_high / film_low) / math.log(high / low) if film_low > 0 and film_high > 0 else None

    @property
    def slopes(self):
        low, high = self.solved.contact.low, self.solved.contact.high
        return {"first_slope": self.slope(low, low * 1.001), "last_slope": self.slope(high / 1.001, high)}


class TwoSlopes:
    """Variations of a scene. `knee` is the middle of its speeds on a logarithmic axis, where the flooded film meets that of
    the flow, h_oil = q/u."""

    def __init__(self, base):
        contact, scene = base.solved.contact, base.solved.contact.scene
        self.knee = math.sqrt(contact.low) * math.sqrt(contact.high)
        film = contact.at(self.knee)["film_flooded"]
        self.flow = film * self.knee
        changed = {"flooded": ("no supply", {name: one for name, one in scene.items() if name != "supply"})}
        for closure in ("starved_inlet", "damiens"):
            changed[closure] = (f"supply.inlet_flow = {exact(self.flow)} m2/s, closures.starvation = {closure}", scene | {
                "supply": {"inlet_flow": self.flow}, "closures": scene.get("closures", {}) | {"starvation": closure}})
        found = curves.solved([curves.Contact(contact.program, one, contact.low, contact.high) for _, one in changed.values()],
                              ["film_maximum"])
        self.curves = {name: SlopeCurve(change, one) for (name, (change, _)), one in zip(changed.items(), found)}
        self.curves["paper"] = SlopeCurve("as the scene file", base.solved)
        # The guides stand a little above the curves, on both sides of the knee.
        third = math.cbrt(self.knee / contact.low)
        self.guides = [self.guide(base.of_contact("speed_power"), film * 1.7, contact.low * third, self.knee / third),
                       self.guide(-1.0, film * 1.7, self.knee * math.sqrt(third), self.knee * third * math.sqrt(third))]

    def guide(self, slope, film, low, high):
        """The line u^slope through a film at the knee: its speeds, films and slope."""
        return [(speed, film * math.pow(speed / self.knee, slope), slope) for speed in (low, math.sqrt(low * high), high)]

    @property
    def told(self):
        return {"inlet_flow": self.flow, "knee": self.knee, "curves": {name: one.slopes for name, one in self.curves.items()}}


def slope_files(tables, slopes, file):
    files = [(f"data/figure_04_{name}.tsv", tables.curve("Film against speed", f"{file}: {one.change}", one.solved.curve))
             for name, one in slopes.curves.items() if name != "paper"]
    guides = "".join("".join("\t".join(map(exact, place)) + "\n" for place in line) + "\n\n" for line in slopes.guides)
    files.append(("data/figure_04_guides.tsv", tables.header("Lines of constant slope beside the curves of Figure 4", file) +
                  f"# speed [m/s]\tfilm [m]\tslope of ln film in ln speed\n{guides}"))  # gnuplot reads the blocks by index
    files.append(("data/figure_04_marks.tsv", tables.named(
        "Onset of starvation (film_maximum) on the curves of Figure 4", file,
        [(name, one.solved.at_onset) for name, one in slopes.curves.items() if name != "paper"], "curve")))
    return files


# --- The data of the figures.

def ratio_file(tables, gt, gw):
    """The ratio of the films at the speeds where neither film has collapsed."""
    text = tables.header("Film with GW over film with GT, up to the collapse", f"{gw.source.file} and {gt.source.file}")
    text += "# speed [m/s]\tfilm with GW/film with GT\n"
    others = gt.solved.contact.solve(*(point["speed"] for point in gw.solved.curve))
    for point, other in zip(gw.solved.curve, others):
        if "collapsed" in (point["inlet"], other["inlet"]):
            break
        text += f"{exact(point['speed'])}\t{exact(point['film'] / other['film'])}\n"
    return "data/figure_11_ratio.tsv", text


def as_printed(case, point):
    """The point. If it has collapsed without a floor, its shares are the limits A(0) and 1 − A(0), as the paper draws them."""
    if point is None or point["regime"] != "collapsed":
        return point
    share = case.of_contact("share_without_film")
    return point | {"asperity_load_share": share, "fluid_load_share": 1 - share}


def marks_of(case, claims):
    reported, one = case.reported(claims, "onset_speed"), case.solved
    marks = [("slowest", one.slowest), ("reported", one.contact.at(float(reported["value"])) if reported else None),
             ("onset", one.at_onset), ("collapse", as_printed(case, one.at_collapse))]
    if one.curve[-1]["regime"] == "collapsed":  # the ends of the line that a printed curve follows beyond its collapse
        marks += [("printed", as_printed(case, one.at_collapse)), ("printed", as_printed(case, one.curve[-1]))]
    return [(event, point) for event, point in marks if point]


def marks_file(tables, cases, claims):
    text = tables.header(
        "Points to mark: the lowest speed, the onset speed that the paper reports, the onset of starvation (film_maximum) and "
        "the collapse of the film where they lie within the speeds, and both ends of what the paper draws past a collapse; of "
        "these two the shares are the limits A(0) and 1 − A(0), which balance no load", "the scenes of the curves and claims.tsv")
    text += f"{tables.notes}# event\tsurface\tmodel\t{tables.columns}\n"
    for case in cases:
        text += "".join(f"{event}\t{case.surface}\t{case.model}\t{tables.cells(point)}\n"
                        for event, point in marks_of(case, claims))
    return "data/marks.tsv", text


def comparison_file(tables, comparisons):
    text = tables.header("Computed beside reported; speeds in m/s, film parameters and shares without a unit",
                         "the scenes of the curves and claims.tsv")
    text += ("# NaN: no such onset, or no number in the paper; the verdict says which\n"
             "# quantity\tsurface\tmodel\tcriterion\tcomputed\treported\tcomputed/reported\tverdict\n")
    for quantity, (compared, _) in comparisons.items():
        for row in compared["rows"]:
            numbers = (exact(row[name]) for name in ("computed", "reported", "factor"))
            text += "\t".join((quantity, row["surface"], row["model"], row["criterion"] or "-", *numbers,
                               row.get("none") or row["verdict"] or "no number in the paper")) + "\n"
    return "data/comparison.tsv", text


def paper(asked):
    places, tables, claims = asked.places, asked.tables, ledger.claims_of(asked.places)
    found = curves.solved([curves.Contact(asked.program, scenes.read(places.scenes / f"{one.stem}.toml"), *one.about.speeds)
                           for one in asked.published])
    cases = {source.stem: Case(source, one) for source, one in zip(asked.published, found)}
    slopes = TwoSlopes(cases["smooth"])
    comparisons = {quantity: comparison(quantity, rows_of(cases.values(), claims, quantity)) for quantity in QUANTITIES}
    data = {"scenes": {stem: scene_of(case) for stem, case in cases.items()}, "inputs": inputs_of(asked.published),
            "departure": scenes.DEPARTURE, "comparisons": {quantity: compared for quantity, (compared, _) in comparisons.items()},
            "offsets": offsets(asked.program, [case for case in cases.values() if case.model == "GT"]), "two_slopes": slopes.told,
            "limits_passed": scenes.limits_passed(asked.program, {name: places.scenes / f"{name}.toml" for name in ledger.SURFACES})}
    files = [(f"data/curve_{stem}.tsv", tables.curve("Stribeck curve", case.source.file, case.solved.curve))
             for stem, case in cases.items()]
    files += [*slope_files(tables, slopes, cases["smooth"].source.file), ratio_file(tables, cases["smooth"], cases["smooth_gw"]),
              marks_file(tables, cases.values(), claims), comparison_file(tables, comparisons)]
    files += [(f"data/scenes/{stem}.toml", scenes.file_text(places.scenes / f"{stem}.toml")) for stem in cases]
    return Group(data, [found for _, found in comparisons.values()], files=files)
