# SPDX-License-Identifier: Apache-2.0
"""Results of the slow targets of make, from reference/baselines, with commit, date and machine."""
import json
import math
import re

from group import Missing, not_run

# File: the target of make that writes it, and its content.
BASELINES = {
    "accuracy.json": ("baseline", "accuracy that later versions have to keep"),
    "stress.json": ("stress", "random points against long double"),
    "mutants.json": ("mutants", "random changes, and how many the tests notice"),
    "diagnosis.json": ("diagnosis", "wrong solvers, and whose mistakes are named"),
    "paper_films.json": ("paper-films", "starved films of the paper's surfaces"),
    "planted_faults.json": ("faults", "planted faults and what caught them"),
    "work_precision.json": ("work-precision", "error against work"),
    "performance.json": ("gate-baseline", "work and time that the gates compare with"),
    "gates.json": ("gate-proof", "proof that the gates turn red"),
    "sweep.json": ("bench-sweep", "speed, memory and scaling of sweeps"),
}
# The code that each of them measures, below the project's folder.
MEASURED = {
    "accuracy.json": ("model/include", "model/src"), "stress.json": ("model/include", "model/src"),
    "mutants.json": ("model", "verification", "reports", "benchmarks"), "diagnosis.json": ("verification/conformance", "reference/mistakes.toml"),
    "planted_faults.json": ("model", "verification", "reports", "benchmarks"), "work_precision.json": ("model/include", "model/src", "model/ehl"),
    "paper_films.json": ("model/ehl",), "performance.json": ("model/include", "model/src"), "gates.json": ("benchmarks/gates", "benchmarks/kernels"),
    "sweep.json": ("model/include", "model/src", "model/sweep"),
}
MOST_NESTED = 16  # lists and tables within each other, as in scenes


def nests_too_deep(text):
    """Whether a text is nested too deep. Ask this before a parser, which may take a level of its own stack for each level."""
    depth = 0
    for sign in re.findall(r'"(?:[^"\\]|\\.)*"|[\[{\]}]', text, re.DOTALL):
        depth += sign in "[{"
        depth -= sign in "]}"
        if depth > MOST_NESTED:
            return True
    return False


def finite(text):
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text} is no number of JSON")
    return value


def read_baseline(places, file):
    """The content of a baseline. Raises Missing where the file is not there or not JSON."""
    path = places.reference / "baselines" / file
    shown = places.shown(path)
    try:
        text = path.read_text(encoding="utf-8-sig")
        if nests_too_deep(text):
            raise Missing(f"`{shown}`: lists and tables are nested more than {MOST_NESTED} deep")
        content = json.loads(text, parse_float=finite, parse_constant=finite)
        json.dumps(content, ensure_ascii=False).encode("utf-8")  # raises UnicodeEncodeError for half of a surrogate pair
        return content
    except OSError as error:
        raise Missing(f"`{shown}` is not there") from error
    except ValueError as error:
        raise Missing(f"`{shown}` is not JSON") from error


def from_baseline(places, file, make):
    """The result of make(baseline). Raises Missing where the file is not there, not JSON, or of a shape that `make` cannot read."""
    baseline = read_baseline(places, file)
    try:
        return make(baseline)
    except (LookupError, TypeError, AttributeError, ValueError, ArithmeticError) as error:
        why = f"it lacks {error}" if isinstance(error, KeyError) else error
        raise Missing(f"`{places.shown(places.reference / 'baselines' / file)}` has another shape: {why}") from error


def part(places, file, what, make):
    """The result of make(baseline), or why it is missing, for a part that its group can do without; and the list of what did not run."""
    try:
        return from_baseline(places, file, make), []
    except Missing as missing:
        why = str(missing)
        return {"missing": why}, [not_run(what, why, f"`make {BASELINES[file][0]}`")]


# Each of these functions returns a value of one type, and raises TypeError for another value.
def text(value):
    if not isinstance(value, str):
        raise TypeError("another value where a text belongs")
    return value


def flag(value):
    if not isinstance(value, bool):
        raise TypeError("another value where true or false belongs")
    return value


def count(value):
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError("another value where a whole number belongs")
    return value


def number(value):
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise TypeError("another value where a number belongs")
    return float(value)


def number_or_none(value):
    """A number; None for null, which stands for infinity and for a number that was not measured."""
    return None if value is None else number(value)


def texts(value):
    if not isinstance(value, list):
        raise TypeError("another value where a list of texts belongs")
    return [text(one) for one in value]


def copied(row, kind, *names):
    return {name: kind(row[name]) for name in names}


def run_of(baseline):
    """When, at which commit and on which machine a baseline was measured."""
    run = copied(baseline, text, "commit", "date")
    if "seconds" in baseline:
        run |= copied(baseline, number, "seconds")
    return run | {"environment": copied(baseline["environment"], text, "cpu", "compiler")}
