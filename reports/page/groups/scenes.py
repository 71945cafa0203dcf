# SPDX-License-Identifier: Apache-2.0
"""Reads scenes, changes them and asks the program about them."""
import contextlib
import json
import math
import pathlib
import tempfile
import tomllib
import typing

from group import Missing

DEPARTURE = 0.05  # the ε of film_departure


def read(path):
    """A scene's or a sweep's file as tables. Raises Missing."""
    try:
        with path.open("rb") as file:
            return tomllib.load(file)
    except (OSError, ValueError, RecursionError) as error:
        raise Missing(f"{path}: {error}") from error


def file_text(path):
    """The text of a file, with its own line ends."""
    return path.read_bytes().decode("utf-8")


def text_of(scene):
    """A scene as JSON, which has no infinity: a word stands for it."""
    def told(value):
        if isinstance(value, dict):
            return {name: told(one) for name, one in value.items()}
        if isinstance(value, float) and math.isinf(value):
            return "inf" if value > 0 else "-inf"
        return value
    return json.dumps(told(scene))


class About(typing.NamedTuple):
    """A scene as `tribocheck solve --about` tells it: entries with value, unit and meaning, by their names."""
    inputs: dict
    contact: dict
    outputs: dict
    work: dict

    def input(self, name):
        """The value of an input; None where the scene has none."""
        return self.inputs[name]["value"]

    @property
    def speeds(self):
        """The least and the greatest, m/s."""
        listed = self.input("speed")
        if listed is None:
            return self.input("speed.from"), self.input("speed.to")
        speeds = [float(one) for one in str(listed).split(",")]
        return min(speeds), max(speeds)

    @property
    def has_friction_inputs(self):
        return None not in (self.input("lubricant.eyring_stress"), self.input("friction.boundary_coefficient"))


def abouts(answer):
    """An About for each scene of an answer of `tribocheck solve --about`."""
    return [About(*({one["name"]: one for one in scene[part]} for part in About._fields)) for scene in json.loads(answer)["scenes"]]


@contextlib.contextmanager
def files_of(scenes):
    """The paths of these scenes, written for the program."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [pathlib.Path(folder, f"{i}.json") for i in range(len(scenes))]
        for path, scene in zip(paths, scenes):
            path.write_text(text_of(scene), encoding="utf-8")
        yield paths


def onsets(program, scenes, criteria=(), departure=DEPARTURE):
    """The onsets of each scene by the criterion's name, as `tribocheck onset` answers; `speed` is None where there is none.

    Without criteria the onsets by all of them.
    """
    named = [word for criterion in criteria for word in ("--criterion", criterion)]
    named += ["--departure", repr(departure)] if not criteria or "film_departure" in criteria else []
    with files_of(scenes) as paths:
        rows = program.answer("onset", *paths, *named, whole=float)["onsets"]
    count = len(rows) // len(scenes)
    return [{row["criterion"]: row for row in rows[i:i + count]} for i in range(0, len(rows), count)]


def points(scene, *speeds):
    """Lines that ask `tribocheck stream` for all outputs of a scene, each at a speed."""
    start = text_of({name: one for name, one in scene.items() if name not in ("outputs", "speed")}).removesuffix("}")
    return [f'{start}, "speed": {speed!r}}}' for speed in speeds]


def limits_passed(program, paths):
    """The limits of the model's validity that at least one of the scenes goes beyond, whether accepted or not; `paths` by their names."""
    rows = {}
    answer = program.answer("contact", *paths.values())
    for name, scene in zip(paths, answer["scenes"], strict=True):
        for limit in scene["validity"]:
            row = rows.setdefault(limit["word"], {key: limit[key] for key in (
                "word", "assumption", "unit", "least", "greatest", "source")} | {"values": {}, "is_passed": False})
            row["values"][name] = limit["value"]
            row["is_passed"] |= limit["holds"] not in ("yes", "not known")
    return [{key: value for key, value in row.items() if key != "is_passed"} for row in rows.values() if row["is_passed"]]
