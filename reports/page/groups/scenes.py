# SPDX-License-Identifier: Apache-2.0
"""Scenes, changed and asked."""
import contextlib
import json
import math
import pathlib
import tempfile
import tomllib

from group import Missing

DEPARTURE = 0.05  # the ε of film_departure


def read(path):
    """A scene's or a sweep's file as tables. Raises Missing."""
    try:
        with path.open("rb") as file:
            return tomllib.load(file)
    except (OSError, ValueError) as error:
        raise Missing(f"{path}: {error}") from error


def file_text(path):
    """All of a file, with its own line ends."""
    return path.read_bytes().decode("utf-8")


def text_of(scene):
    """A scene as JSON, which has no infinity: there it is a word."""
    def told(value):
        if isinstance(value, dict):
            return {name: told(one) for name, one in value.items()}
        if isinstance(value, float) and math.isinf(value):
            return "inf" if value > 0 else "-inf"
        return value
    return json.dumps(told(scene))


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
        rows = program.answer("onset", *paths, *named, whole=float)
    count = len(rows) // len(scenes)
    return [{row["criterion"]: row for row in rows[i:i + count]} for i in range(0, len(rows), count)]


def point(scene, speed):
    """A line that asks `tribocheck stream` for all outputs of a scene at a speed."""
    return text_of({name: one for name, one in scene.items() if name != "outputs"} | {"speed": speed})
