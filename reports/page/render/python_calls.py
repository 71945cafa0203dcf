#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints what cProfile measured of a solver, as JSON: its functions, their kind (own, library or apart) and their callers.

`tribocheck profile` calls this. STATS is the file that cProfile wrote; MODULE is the module that was run, if any.
"""
import argparse
import json
import os
import pstats
import sysconfig

# Built-in functions that read questions, write answers or load code, by parts of the names that cProfile gives them.
APART = ("'_io.", "builtins.print", "builtins.input", "_json.", "builtins.__import__", "marshal.", "posix.", "_imp.")
LIBRARIES = tuple(os.path.join(os.path.realpath(sysconfig.get_path(kind)), "")
                  for kind in ("stdlib", "platstdlib", "purelib", "platlib")) + ("/usr/lib/python", "/usr/local/lib/python")


def kind_of(file, name, module):
    if file == "~":
        return "apart" if any(part in name for part in APART) else "library"
    if file.startswith("<"):
        return "apart" if "importlib" in file else "library"
    path = os.path.realpath(file)
    if module and (f"/{module}/" in path or path.endswith(f"/{module}.py")):
        return "own"
    if path.startswith(LIBRARIES) or "/site-packages/" in path or "/dist-packages/" in path:
        return "apart" if "/json/" in path or path.endswith(("/codecs.py", "/cProfile.py", "/runpy.py")) else "library"
    return "own"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stats", metavar="STATS")
    parser.add_argument("module", metavar="MODULE", nargs="?", default="")
    arguments = parser.parse_args()
    stats = pstats.Stats(arguments.stats).stats
    places = {key: place for place, key in enumerate(stats)}
    functions = []
    for (file, line, name), (_, calls, own, _, callers) in stats.items():
        functions.append({"file": "" if file == "~" else file, "line": line, "name": name,
                          "kind": kind_of(file, name, arguments.module.split(".")[0]), "calls": calls, "seconds": own,
                          "callers": [[places[caller], cost[3]] for caller, cost in callers.items() if caller in places]})
    print(json.dumps({"functions": functions}))


if __name__ == "__main__":
    main()
