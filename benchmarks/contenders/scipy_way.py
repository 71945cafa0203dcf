# SPDX-License-Identifier: Apache-2.0
"""Computes moments and film parameters, like the contenders in C++, with SciPy's quad and fsolve. Each question is a line of JSON, and so is
each answer. An answer has the CPU time of the computation alone."""
import json
import math
import sys
import time

from scipy.integrate import quad
from scipy.optimize import fsolve

evaluations = 0


def moment(d):
    global evaluations
    evaluations += 1
    value, _ = quad(lambda s: (s - d) ** 2.5 * math.exp(-s * s / 2), d, math.inf)
    return value / math.sqrt(2 * math.pi)


def film_parameter(stiffness, offset, flooded):
    def balance(film):
        share = math.sqrt(stiffness * moment(film[0] - offset))
        return share + (flooded / film[0]) ** (1 / 0.14) - 1
    root, _, found, _ = fsolve(balance, flooded, full_output=True)
    return root[0] if found == 1 else math.nan


def attempt(function, arguments):
    try:
        value = float(function(*arguments))
    except (ArithmeticError, ValueError, TypeError):
        return None  # an iterate became negative, which makes a power complex, or a number overflowed
    return value if math.isfinite(value) else None


def main():
    global evaluations
    import warnings
    warnings.simplefilter("ignore")
    print(json.dumps({"ready": True}), flush=True)
    for line in sys.stdin:
        ask = json.loads(line)
        function = {"moment": moment, "film_parameter": film_parameter}[ask["function"]]
        evaluations = 0
        start = time.process_time()
        values = [attempt(function, arguments) for arguments in zip(*ask["arguments"])]
        seconds = time.process_time() - start
        print(json.dumps({"seconds": seconds, "evaluations": evaluations, "values": values}),
              flush=True)


main()
