# SPDX-License-Identifier: Apache-2.0
"""The functions of the catalogue, made from what the library says of them."""
import collections
import json

from . import _help, _library

catalogue = {one["name"]: one for one in json.loads(_library.describe())["functions"]}


def _docstring(entry):
    example = ", ".join(f"{name}={value!r}" for name, value in entry["example"].items() if name != "function")
    return "\n".join(_help.lines(
        entry, "an array of texts",
        ["An argument that is NaN, infinite or not allowed raises ValueError with its index. With masked=True", "the results are masked arrays, and masked there."],
        "by name", f">>> tribocheck.{entry['name']}({example})"))


kinds = {}  # the types of results, by their names


def _made(entry):
    """The function of an entry, with the type of its results where it has several."""
    name, parameters = entry["name"], [one["name"] for one in entry["parameters"]]
    library = _library.Function(name, parameters, [one.get("words", []) for one in entry["parameters"]], len(entry["results"]))
    call = f"_call(({', '.join(parameters)},), masked)"
    scope = {"_call": library.call}
    if len(entry["results"]) > 1:
        kind = collections.namedtuple("".join(map(str.capitalize, name.split("_"))), [one["name"] for one in entry["results"]],
                                      module="tribocheck")
        kind.__doc__ = f"The results of tribocheck.{name}()."
        for one in entry["results"]:
            getattr(kind, one["name"]).__doc__ = f"{one['meaning']}, {one['unit'] or '-'}"
        scope["_make"] = kind._make
        kinds[kind.__name__] = kind
        call = f"_make({call})"
    given = [one["name"] + (f"={one['default']!r}" if "default" in one else "") for one in entry["parameters"]]
    # An argument without a default may follow one with a default. Then all from the first default on are given by name.
    first = next((i for i, one in enumerate(given) if "=" in one), len(given))
    given.insert(first if any("=" not in one for one in given[first:]) else len(given), "*")
    exec(f"def {name}({', '.join(given)}, masked=False):\n    return {call}\n", scope)  # as collections.namedtuple does
    function = scope[name]
    function.__doc__ = _docstring(entry)
    function.__module__ = "tribocheck"
    return function


functions = {name: _made(entry) for name, entry in catalogue.items()}
