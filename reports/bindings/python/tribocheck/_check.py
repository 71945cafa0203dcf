# SPDX-License-Identifier: Apache-2.0
"""A solver's functions held to certified values, within its own process."""
import collections
import inspect
import json
import re

import numpy

from . import _library
from ._functions import catalogue

Verdict = collections.namedtuple("Verdict", "names holds text")
verdicts = []  # of all checks of this process, for the plug-in of pytest


class _Unit:
    """A unit in place of the SI unit: x in this unit is zero + one * x in the SI unit."""

    def __init__(self, name, text, si):
        self.zero, self.one = (_library.number(f"{number} {text}", si or "%") for number in (0, 1))
        if self.one is None:
            raise ValueError(f'units: "{text}" is no unit of {name}; allowed: {si or "%"}, or another unit of the same quantity')
        self.one -= self.zero

    def given(self, number):
        return (number - self.zero) / self.one

    def taken(self, number):
        return self.zero + self.one * number


class _Solver:
    """Asks one function of the solver."""

    def __init__(self, name, function, arguments, units):
        self.function, self.arguments = function, arguments
        entry = catalogue.get(name, {"parameters": [], "results": []})
        self.results = [one["name"] for one in entry["results"]]
        self.units = {one["name"]: _Unit(one["name"], units[one["name"]], one["unit"])
                      for one in [*entry["parameters"], *entry["results"]] if one["name"] in units}
        self.is_point = name not in catalogue
        try:  # the catalogue's default is for an argument that the question lacks and that has no default in the function
            needed = [one.name for one in inspect.signature(function).parameters.values()
                      if one.default is one.empty and one.kind in (one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)]
        except ValueError:  # a function written in C has no signature
            needed = [self.arguments.get(one["name"], one["name"]) for one in entry["parameters"]]
        self.defaults = {one["name"]: one["default"] for one in entry["parameters"]
                         if "default" in one and self.arguments.get(one["name"], one["name"]) in needed}

    def answers(self, questions):
        """The answer to each question, without its id. Questions with the same arguments and words are asked together, as arrays."""
        if self.is_point:
            return [self._answer(self._fields, {key: value for key, value in one.items() if key != "id"}) for one in questions]
        questions = [self.defaults | one for one in questions]
        groups = collections.defaultdict(list)
        for place, one in enumerate(questions):
            groups[tuple((key, value if isinstance(value, str) else None) for key, value in one.items()
                         if key not in ("id", "function"))].append(place)
        answers = [None] * len(questions)
        for key, places in groups.items():
            asked = [questions[place] for place in places]
            for place, answer in zip(places, self._together(key, asked), strict=True):
                answers[place] = answer
        return answers

    def _together(self, key, asked):
        """Asks the questions at once, as arrays, or one by one if the function takes no arrays."""
        count = len(asked)
        try:
            with numpy.errstate(all="ignore"):
                fields = self._fields(**self._given(key, lambda name: numpy.array([float(one[name]) for one in asked])))
            columns = {name: _column(value, count) for name, value in fields.items()}
            return [{name: column[i] for name, column in columns.items() if column[i] is not None} for i in range(count)]
        except Exception:  # this error is not told: the questions are asked one by one, and errors there are told
            return [self._answer(lambda one: self._fields(**self._given(key, lambda name: float(one[name]))), one) for one in asked]

    def _given(self, key, numbers):
        given = {}
        for name, word in key:
            value = numbers(name) if word is None else word
            given[self.arguments.get(name, name)] = self.units[name].given(value) if name in self.units else value
        return given

    @staticmethod
    def _answer(ask, question):
        try:
            return {name: value for name, value in ((name, _column(value, 1)[0]) for name, value in ask(question).items())
                    if value is not None}
        except NotImplementedError as error:
            return {"skip": str(error) or "not implemented"}
        except Exception as error:  # an error of the solver, which becomes part of the verdict
            names = isinstance(error, TypeError) and re.search("required .*argument|keyword argument", str(error))
            hint = "; check(…, arguments={name in the catalogue: its own name}) is for other names" if names else ""
            return {"error": f"{type(error).__name__}: {error}{hint}"}

    def _fields(self, *positional, **given):
        """The results by their names, in SI units."""
        found = self.function(*positional, **given)
        if hasattr(found, "_asdict"):
            found = found._asdict()
        elif not isinstance(found, dict):
            if found is None:
                raise NotImplementedError("it gives None, as a function without `return` does")
            names = self.results
            if len(names) == 1:
                found = {names[0]: found}
            elif all(hasattr(found, name) for name in names) and names:
                found = {name: getattr(found, name) for name in names}
            elif not isinstance(found, (tuple, list, numpy.ndarray)) or len(found) != len(names):
                raise TypeError(f"it gives {type(found).__name__}, in place of {', '.join(names) or 'a dict'}")
            else:
                found = dict(zip(names, found, strict=True))
        return {name: self.units[name].taken(numpy.asarray(value)) if name in self.units else value
                for name, value in found.items()}


def _column(value, count):
    """A result of `count` questions as a list; None where it is masked or not there."""
    if value is None:
        return [None] * count
    array = numpy.ma.asanyarray(value)
    if array.size == 1 and array.ndim <= 1:
        array = array.reshape(())
    elif array.shape != (count,):
        raise TypeError(f"a result has the shape {array.shape}, not ({count},)")
    column = [array.tolist()] * count if array.ndim == 0 else array.tolist()
    return [str(one) if isinstance(one, complex) else one for one in column]


def _json(request):
    """A request; it may have numbers of numpy and paths."""
    return json.dumps(request, default=lambda one: one.tolist() if hasattr(one, "tolist") else str(one))


def _refuse_unknown(functions, **renamed):
    """Raises an error for a name that no checked function has. A misspelt name would else be ignored without a message, and the
    function would be called in another way than the user meant."""
    known = dict.fromkeys(one["name"] for name in functions if name in catalogue
                          for one in [*catalogue[name]["parameters"], *catalogue[name]["results"]])
    for option, names in renamed.items():
        if names is not None and not isinstance(names, dict):
            raise TypeError(f"{option}: {names!r} is no dict like {{'speed': …}}")
        for name in names or {}:
            if name not in known:
                raise ValueError(f'{option}: "{name}" is no argument or result of {", ".join(functions)}; allowed: {", ".join(known) or "none"}')


def check(solver, function=None, tolerance="engineering", *, arguments=None, units=None, modulus="E*", ellipticity="k", sample=0,
          name=None):
    """Holds a function of yours to the certified values of a function of the catalogue.

        def test_film():
            tribocheck.check(my_film, "hamrock_dowson_central")

    The function is called with the arguments of the catalogue by name, in SI units: with arrays, or number by
    number where it takes none. It returns its result; where there are several, a tuple in the order of the
    catalogue, a dict, or an object with these attributes. Results that it leaves out, and questions for which it
    raises NotImplementedError, are not judged. A function for operating_point is called with one dict, which is a
    scene with one speed, and returns a dict.

    solver      the function, or a dict {name in the catalogue: function}: then the verdict also says where
                the errors of one function follow from another one
    function    its name in the catalogue; operating_point is one, too
    tolerance   "engineering" (1e-6), "strict" (the bound of the catalogue), or the path of a file
    arguments   other names that it takes, by those of the catalogue: {"speed": "u_mean"}
    units       other units of arguments and results, by the names of the catalogue: {"viscosity": "mPa s"}
    modulus     "E'" where it takes E' = 2E*, "bodies" where it takes the modulus and Poisson's ratio of each body
    ellipticity "radii" where a film takes radius_x and radius_y in place of the ellipticity
    sample      cases of each function at most; 0: all
    name        of the solver in the verdict

    Returns the verdict as a text. Raises AssertionError with the verdict, the worst case and the cause, as
    `tribocheck verify --subject` tells them, where something fails or nothing is answered.
    """
    if callable(solver):
        if function is None:
            raise TypeError("check() needs the name of the function in the catalogue")
        name = name or getattr(solver, "__name__", "the solver")
        solver = {function: solver}
    elif not isinstance(solver, dict) or not solver:
        raise TypeError(f"check(): {solver!r} is no function, and no dict {{name in the catalogue: function}} with one or more")
    elif function is not None:
        raise TypeError("check(): a dict has the names of its functions; leave out the second argument")
    _refuse_unknown(list(solver), arguments=arguments, units=units)
    request = {"tolerance": tolerance, "modulus": modulus, "ellipticity": ellipticity, "sample": sample}
    lines = []
    for one, its_function in solver.items():
        asked = [json.loads(line) for line in _library.cases(_json({**request, "functions": [one]})).splitlines()]
        mine = _Solver(one, its_function, arguments or {}, units or {})
        first = len({question["id"] for question in asked})  # those after them repeat earlier questions
        for part in (asked[:first], asked[first:]):
            lines += [json.dumps({**answer, "id": question["id"]}, default=str)
                      for question, answer in zip(part, mine.answers(part), strict=True)]
    request |= {"functions": list(solver), "subject": name or "the solver"}
    verdict = Verdict(list(solver), *_library.judge(_json(request), "\n".join(lines)))
    verdicts.append(verdict)
    if not verdict.holds:
        raise AssertionError(verdict.text)
    return verdict.text
