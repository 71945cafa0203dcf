# SPDX-License-Identifier: Apache-2.0
"""Asks the page's live part under Node, without a page, and makes random scenes for it."""
import json
import math
import pathlib
import random
import shutil
import subprocess

from program import ENVIRONMENT, TIMEOUT, toml

HERE = pathlib.Path(__file__).resolve().parent


def ask(questions):
    """The answers of live_model.js to questions; each question is [what, argument, …]."""
    done = subprocess.run([shutil.which("node"), HERE / "live_model.js"], input="".join(json.dumps(one) + "\n" for one in questions),
                          capture_output=True, text=True, timeout=TIMEOUT, env=ENVIRONMENT)
    if done.returncode or done.stderr:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


# The dotted path of each number of a random scene, and the range in which its logarithm is drawn uniformly.
NUMBERS = {"load": (0.1, 1e4), "speed": (1e-5, 30), "bodies.effective_modulus": (1e9, 3e11), "lubricant.viscosity": (1e-3, 1),
           "lubricant.pressure_viscosity": (5e-9, 3e-8), "lubricant.eyring_stress": (1e6, 2e7), "surface.summit_density": (1e9, 1e13),
           "surface.summit_radius": (1e-6, 1e-3), "surface.summit_height_sd": (1e-8, 1e-6), "surface.rms_roughness": (1e-8, 1e-6),
           "surface.summit_plane_offset": (0.1, 3), "friction.boundary_coefficient": (0.03, 0.3), "friction.slide_roll_ratio": (1e-3, 2)}
SHAPES = {"circle": {"bodies.reduced_radius": (1e-4, 0.1), "bodies.ellipticity": (1, 5)},
          "ellipse": {"bodies.radius_x": (1e-4, 0.1), "bodies.radius_y": (1e-4, 0.1)},
          "line": {"bodies.radius_x": (1e-4, 0.1), "bodies.length": (1e-3, 0.1)}}
SUPPLIES = {"flooded": {}, "inlet_film": {"supply.inlet_film": (1e-8, 1e-5)}, "inlet_film_ratio": {"supply.inlet_film_ratio": (0.1, 100)},
            "inlet_flow": {"supply.inlet_flow": (1e-12, 1e-5)}}
POINT_FILMS = ["hamrock_dowson_central", "hamrock_dowson_minimum", "hamrock_dowson_soft_central", "hamrock_dowson_soft_minimum",
               "nijenbanning_venner_moes"]
LINE_FILMS = ["dowson_higginson_minimum", "dowson_toyoda_central", "pan_hamrock_minimum", "pan_hamrock_central", "ertel_grubin", "moes_line"]


def random_scene(seed):
    """A scene as paths and values, and the paths of its numbers."""
    draw = random.Random(seed)
    shape, supply = draw.choice(list(SHAPES)), draw.choice(list(SUPPLIES))
    ranges = NUMBERS | SHAPES[shape] | SUPPLIES[supply]
    scene = {path: math.exp(draw.uniform(math.log(low), math.log(high))) for path, (low, high) in ranges.items()}
    numbers = list(scene)
    scene |= {"surface.offset_planes": draw.choice([0, 1, 2]), "friction.fluid": draw.choice(["eyring", "limiting"]),
              "friction.viscosity": draw.choice(["barus", "ambient", "roelands"]),
              "closures.asperity": draw.choice(["greenwood_tripp", "greenwood_williamson"]),
              "closures.film": draw.choice(LINE_FILMS if shape == "line" else POINT_FILMS)}
    if scene["closures.film"] == "nijenbanning_venner_moes" and shape == "circle":
        scene["bodies.ellipticity"] = 1.0  # this law takes two radii in place of another ellipticity
        numbers.remove("bodies.ellipticity")
    if supply != "flooded":
        scene["closures.starvation"] = draw.choice(["flooded_inlet", "starved_inlet", "damiens"])
        if scene["closures.starvation"] == "damiens":
            scene["closures.damiens_exponent"] = draw.uniform(2, 5)
            numbers.append("closures.damiens_exponent")
    return scene, numbers


def tree(scene):
    made = {}
    for path, value in scene.items():
        section, _, key = path.rpartition(".")
        (made.setdefault(section, {}) if section else made)[key] = value
    return made


def text(scene):
    return toml(tree(scene))
