# SPDX-License-Identifier: Apache-2.0
"""Scenes solved over their speeds, and the tables of points that figures are drawn from."""
import dataclasses
import math

import scenes
from numbers_text import exact

POINTS = 601


def first_speed(low, high, holds):
    """The least speed at which something holds, by bisection down to neighbouring doubles.

    `holds` is false up to some speed, and true from there to `high`. The answer is `low` if it holds there, and None if it
    does not hold at `high`. 0 < low ≤ high.
    """
    if holds(low):
        return low
    if not holds(high):
        return None
    while True:
        middle = math.sqrt(low) * math.sqrt(high)
        if not low < middle < high:
            middle = low + (high - low) / 2  # rounding may put the geometric mean some units outside
        if not low < middle < high:
            return high
        low, high = (low, middle) if holds(middle) else (middle, high)


@dataclasses.dataclass
class Contact:
    """A scene and its range of speeds; the program is asked for its operating points."""
    program: object
    scene: dict  # as the scene's file has it
    low: float  # m/s
    high: float

    def solve(self, *speeds):
        """The operating points at these speeds, each a dict of its outputs by name. An undefined output is None."""
        answers = self.program.ask(*scenes.points(self.scene, *speeds))
        return [{"speed": speed} | answer for speed, answer in zip(speeds, answers)]

    def at(self, speed):
        return self.solve(speed)[0]

    def contains(self, speed):
        return speed is not None and self.low <= speed <= self.high


@dataclasses.dataclass
class Solved:
    contact: Contact
    curve: list  # of points with ascending speeds, closely spaced where the film drops into its collapse
    onsets: dict  # by their criteria, as `tribocheck onset` answers
    at_collapse: dict | None  # the first collapsed point of the range
    at_onset: dict | None  # film_maximum, if it lies within the range

    @property
    def slowest(self):
        return self.curve[0]


def before_collapse(contact, collapse):
    """Points just below a collapse at u_c, at speeds u_c (1 − 10^−e). There the film goes as (u_c − u)^(2/3), so that
    points with evenly spaced e are evenly spaced on logarithmic axes."""
    speeds = [collapse * (1 - math.pow(10, -eighths / 8)) for eighths in range(8, 65)]
    return contact.solve(*(speed for speed in speeds if contact.low < speed < contact.high))


def solved(contacts, criteria=()):
    """Solves each contact, with its onsets by these criteria, or by all if none is given."""
    program = contacts[0].program
    with scenes.files_of([{name: one for name, one in contact.scene.items() if name != "outputs"} |
                          {"speed": {"from": contact.low, "to": contact.high, "count": POINTS}} for contact in contacts]) as paths:
        rows = program.answer("curve", *paths, whole=float)["points"]
    onsets = scenes.onsets(program, [contact.scene for contact in contacts], criteria)
    found = []
    for i, contact in enumerate(contacts):
        curve = rows[i * POINTS:(i + 1) * POINTS]
        speed = first_speed(contact.low, contact.high, lambda speed: contact.at(speed)["inlet"] == "collapsed")
        at_collapse = None if speed is None else contact.at(speed)
        if at_collapse:
            curve = sorted([*curve, *before_collapse(contact, speed), at_collapse], key=lambda point: point["speed"])
        maximum = onsets[i]["film_maximum"]["speed"] if "film_maximum" in onsets[i] else None
        at_onset = contact.at(maximum) if contact.contains(maximum) else None
        found.append(Solved(contact, curve, onsets[i], at_collapse, at_onset))
    return found


class Tables:
    """Writes the files of points. `outputs`: name, unit and meaning of each column after the speed."""

    def __init__(self, version, outputs):
        self.version, self.outputs = version, outputs
        self.columns = "\t".join(["speed [m/s]", *(f"{one['name']} [{one['unit']}]" if one["unit"] else one["name"]
                                                   for one in outputs)])
        self.notes = "# NaN: undefined\n" + "".join(f"# {one['name']}: {one['meaning']}\n" for one in outputs)

    def header(self, what, made_from):
        return f"# {what}\n# tribocheck {self.version}, from {made_from}\n"

    def cells(self, point):
        return "\t".join(value if isinstance(value, str) else exact(value)
                         for value in (point["speed"], *(point.get(one["name"]) for one in self.outputs)))

    def curve(self, what, made_from, curve):
        lines = "".join(self.cells(point) + "\n" for point in curve)
        return self.header(what, made_from) + f"{self.notes}# {self.columns}\n{lines}"

    def named(self, what, made_from, points, name="name"):
        """A file of points with names; points that are None are left out."""
        lines = "".join(f"{title}\t{self.cells(point)}\n" for title, point in points if point)
        return self.header(what, made_from) + f"# {name}\t{self.columns}\n{lines}"
