# SPDX-License-Identifier: Apache-2.0
"""Answers each question of `tribocheck verify` with the function of its name in a file: answering.py FILE.

A function gets the arguments by their names, and returns a number, a dict of results, or None for a case that it does
not have. FIELD_SOURCE names the folder of a solver from elsewhere; load() runs a file of that folder.
"""

import json
import os
import runpy
import sys
from types import SimpleNamespace


def load(path):
    return SimpleNamespace(**runpy.run_path(os.path.join(os.environ["FIELD_SOURCE"], path)))


def serve(functions):
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a solver prints goes to stderr: it is no answer
    for line in sys.stdin:
        question = json.loads(line)
        identity, name = question.pop("id"), question.pop("function", "operating_point")
        try:
            result = functions[name](**question) if name in functions else None
            if not isinstance(result, dict):
                result = {"skip": f"{name} is not offered here"} if result is None else {"value": result}
            text = json.dumps({"id": identity, **result}, default=float)
        except Exception as error:
            text = json.dumps({"id": identity, "error": f"{type(error).__name__}: {error}"})
        print(text, file=answers, flush=True)


if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(sys.argv[1]))
    serve(runpy.run_path(sys.argv[1]))
