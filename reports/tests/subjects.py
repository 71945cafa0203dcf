# SPDX-License-Identifier: Apache-2.0
"""Runs the example solvers, and compares their answers with those of `tribocheck stream`."""

import json
import math
import os
import pathlib
import select
import subprocess
import sys

from program import TIMEOUT, run, scene, strict_json

SUBJECTS = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/subjects"
ORDERS = [0, 0.5, 1, 1.5, 2, 2.5]
ARGUMENTS = [-40, -9.5, -8.5, -3, -1.146, -1e-3, 0, 0.25, 1, 3.5, 9, 20, 38]
MODELS = ["greenwood_tripp", "greenwood_williamson"]
CLOSURES = ["flooded_inlet", "starved_inlet", "printed_exponents", "damiens"]
SUPPLIES = [None, {"inlet_film_ratio": 4}, {"inlet_film": 1e-7}, {"inlet_flow": 1e-8}]
FILM = {"viscosity": 0.04, "pressure_viscosity": 2e-8, "effective_modulus": 1.1e11}


def call(function, **arguments):
    return {"function": function, **arguments}


def moments():
    return [call("gaussian_moment", order=order, argument=d) for order in ORDERS for d in ARGUMENTS]


def effective_moduli():
    return [call("effective_modulus", first_modulus=first, first_poisson_ratio=nu1, second_modulus=second,
                 second_poisson_ratio=nu2)
            for first, nu1, second, nu2 in [(206e9, 0.3, 72e9, 0.22), (3e6, 0.5, 110e9, 0), (1e12, -0.9, 1e5, 0.4)]]


def reduced_radii():
    return [call("reduced_radius", first_radius_x=R1x, second_radius_x=R2x, first_radius_y=R1y,
                 second_radius_y=R2y)
            for R1x, R2x, R1y, R2y in [(9.5e-3, 1e30, 9.5e-3, 1e30), (5e-3, 22.5e-3, 5e-3, -5.2e-3),
                                       (-32.5e-3, 5e-3, -5.3e-3, 5e-3), (12e-3, 1e30, 1e30, 20e-3)]]


def hertz_points():
    return [call("hertz_point", load=load, effective_modulus=modulus, reduced_radius=radius)
            for load, modulus, radius in [(50, 107.9e9, 9.5e-3), (1e-6, 1e6, 10), (1e6, 1e12, 1e-6)]]


def hertz_ellipses():
    return [call("hertz_ellipse", load=load, effective_modulus=modulus, radius_x=Rx, radius_y=Ry)
            for load, modulus, Rx, Ry in [(50, 107.9e9, 9.5e-3, 19e-3), (1e3, 113e9, 5.91e-3, 88e-3),
                                          (30, 5e10, 20e-3, 12.7e-3), (1e-3, 1e5, 1, 1), (1e6, 1e12, 1e-4, 1)]]


def hertz_lines():
    return [call("hertz_line", load_per_length=load, effective_modulus=modulus, reduced_radius=radius)
            for load, modulus, radius in [(1e5, 107.9e9, 9.5e-3), (1e-3, 1e5, 10), (1e8, 1e12, 1e-6)]]


def films():
    return [call("hamrock_dowson_central", speed=u, load=load, reduced_radius=radius, ellipticity=k, **FILM)
            for u, load, radius, k in [(1, 20, 0.01, 1), (1e-4, 0.1, 1e-3, 3), (30, 1e4, 0.3, 8)]]


def starvation_ratios():
    return [call("starvation_ratio", closure=closure, flooded_over_inlet=r, damiens_exponent=2.5)
            for closure in CLOSURES for r in [1e-12, 0.01, 0.6, 0.999, 1, 1.5, 100, 1e12]]


def load_sharings():
    return [call("load_sharing", asperity=asperity, flooded_film_parameter=flooded, stiffness=stiffness,
                 offset=offset)
            for asperity in MODELS for flooded in [1e-4, 0.3, 2, 50] for stiffness in [0, 1e-6, 0.3, 10, 1e6]
            for offset in [0, 1.146]]


def examples():
    """The example of each function without a list above, and of the ellipse and the line: with each word, and with larger numbers."""
    asked = {line["function"] for line in (moments() + effective_moduli() + reduced_radii() + hertz_points()
                                           + films() + starvation_ratios() + load_sharings())}
    lines = []
    for entry in run("functions", "--format", "json").json()["functions"]:
        if entry["name"] in asked:
            continue
        one = {name: value for name, value in entry["example"].items() if name != "id"}
        variants = [{**one, parameter["name"]: word} for parameter in entry["parameters"]
                    for word in parameter.get("words", ())] or [one]
        lines += variants + [{name: value if isinstance(value, str) else 1.5 * value for name, value in line.items()}
                             for line in variants]
    return lines


def operating_points():
    friction = [{"boundary_coefficient": 0.13},
                {"boundary_coefficient": 0.1, "slide_roll_ratio": 0.2, "viscosity": "roelands"},
                {"boundary_coefficient": 0.1, "fluid": "limiting", "viscosity": "ambient"},
                {"boundary_coefficient": 0, "slide_roll_ratio": 0}]
    points = []
    for surface in ["rough", "smooth"]:
        for asperity in MODELS:
            for closure in CLOSURES:
                for i, supply in enumerate(SUPPLIES):
                    for speed in [1e-4, 0.01, 0.1, 3]:
                        points.append(scene(surface, speed=speed, supply=supply, friction=friction[i],
                                            closures={"asperity": asperity, "starvation": closure}))
    # Other shapes and film laws. Each has three speeds, so that tests that ask every third line ask each of them.
    for radius in [{"radius_y": 30e-3}, {"radius_y": 4e-3}, {"length": 2e-3}]:
        bodies = {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, **radius}
        closures = {"film": "dowson_toyoda_central"} if "length" in radius else {}
        points += [scene("smooth", speed=speed, bodies=bodies, closures=closures) for speed in [0.01, 0.03, 0.1]]
    return points


def all_lines():
    return numbered(moments() + effective_moduli() + reduced_radii() + hertz_points() + hertz_ellipses()
                    + hertz_lines() + films() + starvation_ratios() + load_sharings() + examples()
                    + operating_points())


def numbered(lines):
    return [{**line, "id": f"c{i}"} for i, line in enumerate(lines)]


def text_of(lines):
    return "".join(json.dumps(line) + "\n" for line in lines)


def answers_of(command, lines):
    done = subprocess.run(list(map(str, command)), input=text_of(lines).encode(), capture_output=True,
                          timeout=TIMEOUT)
    assert (done.returncode, done.stderr) == (0, b""), (done.returncode, done.stderr.decode()[-500:])
    return [strict_json(line) for line in done.stdout.decode().splitlines()]


def reference_answers(lines):
    result = run("stream", stdin=text_of(lines))
    assert result.code == 0, result.err
    return result.json_lines()


def python(name, *arguments):
    """The command of a Python subject."""
    return [sys.executable, "-B", SUBJECTS / name, *arguments]


def is_close(found, expected, relative):
    if isinstance(expected, (int, float)) and isinstance(found, (int, float)):
        return math.isclose(found, expected, rel_tol=relative, abs_tol=1e-300)
    return found == expected


def assert_agree(test, command, lines, relative):
    """Asserts that every answer is a skip or agrees with ours. Returns each line that was not skipped, with its answer."""
    answered = []
    found = answers_of(command, lines)
    for line, mine, theirs in zip(lines, reference_answers(lines), found, strict=True):
        test.assertEqual(theirs["id"], line["id"])
        if "skip" in theirs:
            test.assertEqual(list(theirs), ["id", "skip"])
            continue
        test.assertNotIn("error", theirs, line)
        for name, value in theirs.items():
            if name != "undefined":
                test.assertTrue(is_close(value, mine[name], relative), (line, name, value, mine[name]))
        answered.append((line, theirs))
    return answered


def assert_lockstep(test, command):
    """Asserts that each answer comes before the next question."""
    with subprocess.Popen(list(map(str, command)), stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        try:
            for line in numbered(hertz_points() + operating_points()[:3]):
                process.stdin.write(text_of([line]).encode())
                process.stdin.flush()
                test.assertTrue(select.select([process.stdout], [], [], TIMEOUT)[0], "no answer")
                test.assertEqual(json.loads(process.stdout.readline())["id"], line["id"])
            process.stdin.close()
            test.assertEqual(process.wait(TIMEOUT), 0)
        finally:
            process.kill()


def functions_of(answered):
    return {line.get("function", "operating_point") for line, _ in answered}
