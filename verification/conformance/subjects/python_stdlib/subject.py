#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Answers JSON lines: one question a line on stdin, one answer a line on stdout, in order."""

import json
import math
import sys

import fields
import films
import inlet
import liquids
import moments
import point
import solver
import surfaces

BEYOND = "outside the range of double precision"


def effective_modulus(given):
    return {"value": solver.effective_modulus(*given.values())}


def reduced_radius(given):
    return solver.reduced_radius(*given.values())


def gaussian_moment(given):
    return {"value": moments.gaussian_moment(given["order"], given["argument"])}


def hertz_point(given):
    return solver.hertz_point(given["load"], given["effective_modulus"], given["reduced_radius"])


def hertz_ellipse(given):
    return solver.hertz_ellipse(*given.values())


def hertz_line(given):
    return solver.hertz_line(*given.values())


def hamrock_dowson_central(given):
    return {"value": solver.hamrock_dowson_central(*given.values())}


def starvation_ratio(given):
    return {"value": inlet.starvation_ratio(*given.values())}


def load_sharing(given):
    return {"value": solver.load_sharing(*given.values())}


FUNCTIONS = {function.__name__: function for function in (
    effective_modulus, reduced_radius, gaussian_moment, hertz_point, hertz_ellipse, hertz_line,
    hamrock_dowson_central, starvation_ratio, load_sharing)}


def value_of(module, name, *first):
    """A function that looks `name` up in the module at each call, so that a function that was replaced takes effect."""
    return lambda given: {"value": getattr(module, name)(*first, *given.values())}


FUNCTIONS |= {name: value_of(films, "point_film" if law[2] else "soft_film", name) for name, law in films.POINTS.items()}
FUNCTIONS |= {name: value_of(films, "line_film", name) for name in films.LINES}
FUNCTIONS |= {name: value_of(module, function) for name, module, function in (
    ("moes_line", films, "moes_line"), ("nijenbanning_venner_moes", films, "nijenbanning_venner_moes"),
    ("regime_film", films, "regime_film"),
    ("gupta_thermal_reduction", films, "thermal_reduction"), ("dowson_higginson_density", liquids, "density"),
    ("barus_viscosity", liquids, "barus"), ("roelands_viscosity", liquids, "roelands"),
    ("astm_d341_viscosity", liquids, "astm_d341"), ("viscosity_index", liquids, "viscosity_index"),
    ("carreau_yasuda_viscosity", liquids, "carreau_yasuda"),
    ("murch_wilson_thermal_reduction", films, "rolling_reduction"),
    *((name, surfaces, name) for name in ("subsurface_shear", "jkr_radius", "pull_off_force", "plasticity_index",
                                          "kogut_etsion_load", "persson_contact_area", "patir_cheng_pressure_flow")))}
FUNCTIONS["lambda_ratio"] = lambda given: surfaces.lambda_ratio(*given.values())
FUNCTIONS["summits_from_spectral_moments"] = lambda given: liquids.summits(*given.values())


def call(line):
    name = line["function"]
    if not isinstance(name, str) or name not in FUNCTIONS:
        return {"skip": f"no function {name}"}, {}
    given = {key: value for key, value in line.items() if key not in ("id", "function")}
    arguments = fields.read_arguments(name, given)
    try:
        return FUNCTIONS[name](arguments), {}
    except (OverflowError, ZeroDivisionError):
        return {"value": math.inf}, {}


def operating_point(line):
    scene = fields.read_scene(line)
    outputs = fields.read_outputs(line, scene)
    try:
        return point.solve(scene, outputs)
    except (OverflowError, ZeroDivisionError):
        return dict.fromkeys(outputs, math.inf), {}


def answer(line):
    """The members of an answer, without the id."""
    values, undefined = call(line) if "function" in line else operating_point(line)
    for name, value in values.items():
        if isinstance(value, float) and not math.isfinite(value):
            values[name], undefined[name] = None, BEYOND
    return {**values, "undefined": undefined} if undefined else values


def answer_text(text):
    identity = None
    try:
        line = json.loads(text)
        if not isinstance(line, dict):
            raise ValueError("a line has to be an object")
        identity = line.get("id")
        members = answer(line)
    except fields.InputError as problem:
        members = {"error": dict(zip(("field", "message"), problem.args))}
    except ValueError as problem:
        members = {"error": {"field": "", "message": str(problem)}}
    return json.dumps({"id": identity, **members}, allow_nan=False)


def main():
    for text in sys.stdin:
        if text.strip():
            print(answer_text(text), flush=True)


if __name__ == "__main__":
    main()
