# SPDX-License-Identifier: Apache-2.0
"""Scenes: operating points, Stribeck curves, onsets of starvation, and solved films."""
from __future__ import annotations

import dataclasses
import json
import math
import numbers
import os
import pathlib
from typing import Any, Iterable, Iterator, Mapping, NamedTuple

import numpy
import numpy.typing

from . import _library


class Points:
    """Operating points: an array for the speed and for each output, by its name, as `.speed` and `.film`.

    The arrays have the shape of the speeds that were asked for. An undefined number, for example where the film has
    collapsed, is NaN; an undefined word is "". `dict(points)` has all arrays by name, and pandas.DataFrame takes it.
    Words become texts when they are first read.
    """

    __slots__ = ("_columns", "_words")

    def __init__(self, columns: dict[str, Any], words: dict[str, numpy.ndarray]) -> None:
        self._columns, self._words = columns, words

    def __getattr__(self, name: str) -> Any:
        """The column of an output."""
        if name in Points.__slots__:  # not set yet, for example in pickle
            raise AttributeError(name)
        if name not in self._columns:
            raise AttributeError(f"no output {name} was computed; there are: {', '.join(self)}")
        return self[name]

    def __getitem__(self, name: str) -> Any:
        """The column of an output, as points["film"]."""
        column = self._columns[name]
        if column.dtype.kind == "i":  # codes; the code of an undefined word is -1, the last text
            column = self._columns[name] = self._words[name][column]
        return column

    def keys(self) -> Iterable[str]:
        """The names: speed, and those of the outputs."""
        return self._columns.keys()

    def __iter__(self) -> Iterator[str]:
        """Iterates over the names."""
        return iter(self._columns)

    def __dir__(self) -> list[str]:
        """All attributes, also the names."""
        return [*super().__dir__(), *self]

    def __eq__(self, other: object) -> bool:
        """Whether all columns are the same; NaN equals NaN."""
        if not isinstance(other, Points):
            return NotImplemented
        return self.keys() == other.keys() and all(
            numpy.array_equal(one := self[name], other[name], equal_nan=one.dtype.kind == "f") for name in self)

    def __repr__(self) -> str:
        """Names and columns."""
        return f"{type(self).__name__}({', '.join(f'{name}={self[name]!r}' for name in self)})"


class Curve(Points):
    """The points of a Stribeck curve, from the least speed to the greatest."""

    __slots__ = ()

    def plot(self, axes: Any = None, outputs: Iterable[str] = ("friction", "film", "asperity_load_share")) -> Any:
        """Draws outputs against the logarithm of the speed, with matplotlib, and returns the axes, one for each output.

            >>> scene.curve().plot()    # doctest: +SKIP

        axes    a list with one for each output that is drawn; without it a new figure is made
        outputs names; those that the curve does not have are left out
        """
        outputs = [name for name in outputs if name in self]
        if not outputs:
            raise ValueError(f"nothing to draw; the curve has: {', '.join(self)}")
        if axes is None:
            try:
                from matplotlib import pyplot
            except ImportError as error:
                raise ImportError("Curve.plot() needs matplotlib, which is not installed: python3-matplotlib on Debian, "
                                  "or `pip install matplotlib`") from error
            axes = pyplot.subplots(len(outputs), sharex=True, squeeze=False)[1].ravel()
        for name, one in zip(outputs, axes, strict=True):
            one.semilogx(self.speed, self[name])
            one.set_ylabel(name + (" [m]" if name in ("film", "film_flooded", "separation", "minimum_film") else ""))
        axes[-1].set_xlabel("speed [m/s]")
        return axes


class Onset(NamedTuple):
    """The onset of starvation by one criterion. Where it has none, the numbers are NaN, and `reason` says why."""

    speed: float  # m/s
    film: float  # m
    film_parameter: float  # film over summit_height_sd
    reason: str


@dataclasses.dataclass(frozen=True, slots=True)
class Measured:
    """A number with its possible error. It prints as `3.008330e-08 ± 2.9e-13 m`. Calculate with its `.value`."""

    value: float
    error: float
    unit: str

    def __str__(self) -> str:
        if not self.error > 0:
            return f"{self.value:g} {self.unit}".rstrip()
        digits = math.ceil(math.log10(abs(self.value) / self.error)) + 1 if self.value else 1
        return f"{self.value:#.{min(max(digits, 3), 12)}g} ± {self.error:.1e} {self.unit}".rstrip()

    def __float__(self) -> float:
        return self.value


class Profile(NamedTuple):
    """Pressure and film along the middle of a contact, arrays over the nodes of the finest grid."""

    x: numpy.ndarray  # m, along the direction of entrainment from the middle of the contact
    pressure: numpy.ndarray  # Pa
    film: numpy.ndarray  # m


class Film:
    """A contact that is solved. Its numbers with an error have `.value`, `.error` and `.unit`:

        central                 m   film in the middle
        minimum                 m   the least film
        at_greatest_pressure    m   film where the pressure is greatest
        friction                    of the oil over the load; needs lubricant.eyring_stress
        spike_pressure          Pa  of a line contact
        spike_place             m
        flooded_central         m   of a starved contact: its central film with a flooded inlet
        film_ratio                  of a starved contact: central over flooded_central

    Where one is undefined its value is NaN, and `undefined` is a dict of the reasons, by name. `profile` has x, pressure and
    film along the middle. `formulas` lists each formula's film; `half_width`, `peak_pressure`, `load_number` (M),
    `material_number` (L), `tolerance`, `grids`, `cells`, `assumptions` and the rest are as in `tribocheck film --format
    json`. `reason` is empty, or says which error was reached if it is not the tolerance. `warnings`: the limits that
    the scene exceeds. str() has a line for each number with an error.
    """

    central: Measured
    minimum: Measured
    at_greatest_pressure: Measured
    friction: Measured
    spike_pressure: Measured
    spike_place: Measured
    profile: Profile
    speed: float
    tolerance: float
    formulas: list[dict[str, Any]]

    def __init__(self, film: Mapping[str, Any], warnings: list[str]) -> None:
        self.reason = ""
        self.undefined: dict[str, str] = {}
        self.warnings = warnings
        self.measured: dict[str, Measured] = {}
        for name, value in film.items():
            if name == "undefined":
                self.undefined = {_short(one): reason for one, reason in value.items()}
            elif name == "profile":
                self.profile = Profile(*(numpy.array(value[one]) for one in Profile._fields))
            elif isinstance(value, dict) and "error" in value or name in film.get("undefined", ()):
                one = value or {"value": math.nan, "error": math.nan}
                unit = {"spike_pressure": "Pa", "friction": "", "film_ratio": ""}.get(name, "m")
                self.measured[_short(name)] = Measured(one["value"], one["error"], unit)
            else:
                setattr(self, name, value)

    def __getattr__(self, name: str) -> Any:
        measured = self.__dict__.get("measured", {})
        if name in measured:
            return measured[name]
        raise AttributeError(f"a Film of this contact has no {name}; its numbers are: {', '.join(measured)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.measured]

    def __str__(self) -> str:
        rows = [f"{self.id} at {self.speed:g} m/s, solved"]
        rows += [f"  {name:<22}{one}" for name, one in self.measured.items() if name not in self.undefined]
        rows += [f"  {name:<22}undefined: {reason}" for name, reason in self.undefined.items()]
        return "\n".join(rows + ([f"  {self.reason}"] if self.reason else []))

    __repr__ = __str__


def _short(name: str) -> str:
    """central_film is .central, film_at_greatest_pressure .at_greatest_pressure."""
    return name.removesuffix("_film").removeprefix("film_") if name != "film_ratio" else name


class Scene:
    """One contact: load, bodies, roughness, oil and speeds, as `tribocheck` reads it from a file.

        >>> scene = tribocheck.Scene("scene.toml")
        >>> scene.solve([0.01, 0.1]).film
        array([7.06938833e-09, 2.58012092e-08])
        >>> scene.onset()["film_maximum"].speed
        0.1176...

    source  the path of a file in TOML or JSON, such a text (with a line end, or of JSON), or a dict of the same shape.
            model/README.md, section 1, has all fields with units, ranges and defaults

    A faulty scene raises ValueError with a line for each fault: the field, its value and what is allowed. A Scene does not
    change: another load is another Scene.

    id        its name
    outputs   those that it asks for, a dict {name: meaning, with its unit}
    speeds    how many speeds it has
    warnings  the limits of the model that it exceeds, and notes on what has no effect: texts
    text      as the library reads it
    """

    __slots__ = ("text", "id", "speeds", "outputs", "warnings", "_words")  # so that scene.load = 60 is an error

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any]) -> None:
        name, place = "scene", "scene"
        if isinstance(source, Mapping):
            self.text = json.dumps(source, default=_plain)
        elif isinstance(source, str) and ("\n" in source or source.lstrip().startswith("{")):
            self.text = source
        elif isinstance(source, (str, os.PathLike)):
            name, place = pathlib.Path(source).stem, os.fspath(source)
            try:
                self.text = pathlib.Path(source).read_text(encoding="utf-8")
            except UnicodeDecodeError:
                raise ValueError(f"{place}: the file is no text in UTF-8") from None
        else:
            raise TypeError(f"a scene is a path, a text or a dict, not {type(source).__name__}")
        if "\0" in self.text:
            raise ValueError("a scene has no sign 0")
        try:
            about = json.loads(_library.describe_scene(self.text))
        except ValueError as error:
            raise ValueError("\n".join(place + line.removeprefix("scene") for line in str(error).split("\n"))) from None
        self.id: str = about["id"] or name  # as the program names it
        self.speeds: int = about["speeds"]
        self.outputs: dict[str, str] = {one["name"]: f"{one['meaning']}, {one['unit'] or '-'}" for one in about["outputs"] if one["asked"]}
        self._words = {one["name"]: numpy.array([*one["words"], ""]) for one in about["outputs"] if one["words"]}
        self.warnings: list[str] = [*about["notes"], *(one["text"] for one in about["warnings"])]

    def __repr__(self) -> str:
        return f"<tribocheck.Scene {self.id!r}, {self.speeds} speed{'' if self.speeds == 1 else 's'}>"

    def solve(self, speeds: numpy.typing.ArrayLike | None = None, outputs: Iterable[str] | None = None) -> Points:
        """The operating points at these speeds, with the bits of `tribocheck solve`.

            >>> scene.solve(numpy.logspace(-3, 0, 200), outputs=["film", "regime"]).regime[150]
            'mixed'

        speeds   m/s, above 0: a number or an array; without it the scene's own
        outputs  names, whether the scene asks for them or not; without it those that it asks for

        A speed that is NaN, infinite or not above 0 raises ValueError with its index. Other threads run during
        the call, and Ctrl-C ends it. A million points take some 50 ms, and some 30 more where an output that is a word is
        first read.
        """
        given = _library.speeds(self.text, False, self.speeds) if speeds is None else numpy.asarray(speeds)
        return Points(self._columns(given, outputs), self._words)

    def curve(self, outputs: Iterable[str] | None = None) -> Curve:
        """The Stribeck curve as `tribocheck curve` has it: over the scene's range of speeds, evenly in their logarithm, or at
        its list of them. Its method plot() draws it.

            >>> curve = scene.curve()
            >>> curve.speed[1]
            0.1
        """
        return Curve(self._columns(_library.speeds(self.text, True, self.speeds), outputs), self._words)

    def _columns(self, speeds: numpy.ndarray, outputs: Iterable[str] | None) -> dict[str, Any]:
        if isinstance(outputs, str):
            raise TypeError(f"outputs: a list of names, as [{outputs!r}]")
        names = [one for one in dict.fromkeys(self.outputs if outputs is None else outputs) if one != "speed"]
        found = _library.solve(self.text, speeds, names, [one in self._words for one in names])
        return {"speed": numpy.asarray(speeds, float)[()], **{name: column[()] for name, column in zip(names, found, strict=True)}}

    def onset(self, departure: float = 0.05) -> dict[str, Onset]:
        """Where starvation sets in, by each criterion: film_maximum, film_departure, friction_minimum and asperity_minimum, with
        the bits of `tribocheck onset`. Each has speed in m/s, film in m, film_parameter and reason, which says why there is none.

            >>> scene.onset(departure=0.1)["film_departure"].speed > scene.onset()["film_departure"].speed
            True

        departure  for film_departure: the part by which the film is thinner there than the flooded film, above 0 and below 1
        """
        if isinstance(departure, bool) or not isinstance(departure, numbers.Real):
            raise TypeError(f"departure: {departure!r} is no number; allowed: a number above 0 and below 1")
        def number(row: Mapping[str, Any], name: str) -> float:
            return math.nan if row[name] is None else row[name]

        return {row["criterion"]: Onset(*(number(row, name) for name in Onset._fields[:3]), next(iter(row.get("undefined", {}).values()), ""))
                for row in json.loads(_library.onset(self.text, departure))["onsets"]}


def film(scene: Scene | str | os.PathLike[str] | Mapping[str, Any], speed: float | None = None, tolerance: float | None = None, *,
         viscosity: str | None = None, density: str | None = None, flooded: bool = False) -> Film:
    """The film and the pressure of a smooth contact, solved from the Reynolds equation, as `tribocheck film` solves it.

        >>> film = tribocheck.film("reference/scenes/roller.toml", speed=0.5)
        >>> print(film.central)
        3.008330e-08 ± 2.9e-13 m

    scene      a Scene, or what tribocheck.Scene() takes; its roughness is not used
    speed      m/s; without it the scene's one
    tolerance  relative, of the films, from 1e-6 to 1e-2; without it 1e-4 for a line contact, 1e-3 for a point contact
    viscosity  the law "barus" or "roelands"; without it the scene's, else Barus'
    density    "incompressible", the default, or "dowson_higginson"
    flooded    takes the inlet as flooded, whatever the scene's supply; refused where it has none

    A line contact takes some tenths of a second, a point contact from a second to minutes; Ctrl-C ends it. An argument that is
    not allowed raises ValueError. A contact that is not solved raises RuntimeError with the reason.
    """
    if not isinstance(scene, Scene):
        scene = Scene(scene)
    if speed is None and scene.speeds != 1:
        raise ValueError(f"speed: the scene has {scene.speeds} speeds; allowed: one number above 0, in m/s")
    request: dict[str, Any] = {"profile": True, "flooded": flooded}
    for name, value in (("speed", speed), ("tolerance", tolerance)):
        if value is not None:
            if isinstance(value, (bool, str)) or numpy.ndim(value):
                raise TypeError(f"{name}: {value!r} is no number")
            if not math.isfinite(float(value)):
                raise ValueError(f"{name}: {value} is not allowed; allowed: a finite number")
            request[name] = float(value)
    request |= {name: value for name, value in (("viscosity", viscosity), ("density", density)) if value is not None}
    document = json.loads(_library.film(scene.text, json.dumps(request)))
    if document["films"][0]["central_film"] is None:
        raise RuntimeError(f"{scene.id}: not solved: {document['films'][0]['reason']}")
    return Film(document["films"][0] | {"id": scene.id}, [one["text"] for one in document["warnings"]])


def _plain(value: Any) -> Any:
    """A number or an array of numpy, for JSON."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a scene has no {type(value).__name__}")
