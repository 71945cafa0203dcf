# SPDX-License-Identifier: Apache-2.0
"""Writes the type stubs of the package, made from the catalogue of its library: make_stubs.py PACKAGE."""
import inspect
import pathlib
import sys

PACKAGE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(PACKAGE.parent))
import tribocheck  # noqa: E402
from tribocheck._functions import catalogue  # noqa: E402

HEAD = """from typing import Any, Callable, Generic, Literal, NamedTuple, TypeVar, overload

import numpy
from numpy.typing import ArrayLike, NDArray

_T = TypeVar("_T")
_Array = NDArray[numpy.float64]

catalogue: dict[str, Any]
functions: dict[str, Callable[..., Any]]
"""


def stubs_of(entry):
    """The type of the results if there are several, then the function with numbers alone and with arrays."""
    name, results = entry["name"], entry["results"]
    kind = "".join(map(str.capitalize, name.split("_")))  # as _functions has it
    if len(results) > 1:
        yield f"class {kind}(NamedTuple, Generic[_T]):\n" + "".join(f"    {one['name']}: _T\n" for one in results)
    words = {one["name"]: f"Literal[{', '.join(map(repr, one['words']))}]" for one in entry["parameters"] if "words" in one}
    for number, result in (("float", "float"), ("ArrayLike", "_Array")):
        kinds = {one: text + (" | list[str] | NDArray[numpy.str_]" if number == "ArrayLike" else "") for one, text in words.items()}
        kinds["masked"] = "bool" if number == "ArrayLike" else "Literal[False]"
        given, by_name = [], False
        for one in inspect.signature(tribocheck.functions[name]).parameters.values():
            if one.kind is one.KEYWORD_ONLY and not by_name:
                given.append("*")
                by_name = True
            given.append(f"{one.name}: {kinds.get(one.name, number)}" + ("" if one.default is one.empty else " = ..."))
        yield f"@overload\ndef {name}({', '.join(given)}) -> {f'{kind}[{result}]' if len(results) > 1 else result}: ...\n"


(PACKAGE / "_functions.pyi").write_text("\n".join([HEAD, *(text for entry in catalogue.values() for text in stubs_of(entry))]))
names = sorted(name for name in vars(tribocheck) if not name.startswith("_"))
homes = {name: getattr(getattr(tribocheck, name), "__module__", "").removeprefix("tribocheck") or "._functions" for name in names}
(PACKAGE / "__init__.pyi").write_text("".join(f"from {home} import {name} as {name}\n" for name, home in homes.items()) + "\n__version__: str\n")
(PACKAGE / "py.typed").touch()
