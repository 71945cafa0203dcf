# SPDX-License-Identifier: Apache-2.0
"""The paper's six scenes as the program reads them: three surfaces, each with two models of its asperities."""
import typing

import ledger
import scenes
from group import Refused, printable

MODELS = {"GT": "greenwood_tripp", "GW": "greenwood_williamson"}


class Published(typing.NamedTuple):
    """One of the six scenes: a surface with the contact of Greenwood and Tripp (GT), or Greenwood and Williamson (GW)."""
    surface: str
    model: str
    file: str  # as provenance names it
    about: scenes.About

    @property
    def stem(self):
        return stem_of(self.surface, self.model)  # "smooth_gw": of the scene and of its data


def stem_of(surface, model):
    return surface if model == "GT" else f"{surface}_{model.lower()}"


def unfit(about, model):
    """Why the report cannot take a scene that is otherwise good; empty if the report can."""
    low, high = about.input("speed.from"), about.input("speed.to")
    if about.input("closures.asperity") != MODELS[model]:
        return f"closures.asperity: the report needs {MODELS[model]} here"
    if not about.has_friction_inputs:
        return "the report needs lubricant.eyring_stress and friction.boundary_coefficient"
    is_range = low is not None and high is not None and low < high
    return "" if is_range else "speed: the report needs a range of speeds"


def read(program, places):
    """The scenes, and warnings of the limits of validity that they pass. Raises Refused with every problem of every scene."""
    paths = {(surface, model): places.scenes / f"{stem_of(surface, model)}.toml" for model in MODELS for surface in ledger.SURFACES}
    code, told, complaints = program.run("solve", *paths.values(), "--about", "--format", "json")
    abouts = iter(scenes.abouts(told) if told else ())
    found, problems = [], []
    warnings = [line.removeprefix("warning: ") for line in complaints if line.startswith("warning: ")]
    for (surface, model), path in paths.items():
        start = f"{printable(str(path))}:"
        errors = [line for line in complaints if line.startswith(start)]
        if not errors:  # it has an answer
            about = next(abouts, None)
            if about is None:
                raise Refused(f"solve --about ended with exit code {code}")
            why = unfit(about, model)
            errors = [f"{path}: {why}"] if why else []
            found.append(Published(surface, model, places.shown(path), about))
        problems += errors
    if problems:
        raise Refused(*problems)
    return found, warnings
