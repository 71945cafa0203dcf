# SPDX-License-Identifier: Apache-2.0
"""The fields of a line: their names, allowed values and defaults."""

import math

import films
import inlet
import point
import solver

REQUIRED = object()

RADII = ("first_radius_x", "second_radius_x", "first_radius_y", "second_radius_y")
FUNCTIONS = {
    "effective_modulus": {"first_modulus": ("above 0", REQUIRED), "first_poisson_ratio": ("Poisson", REQUIRED),
                          "second_modulus": ("above 0", REQUIRED), "second_poisson_ratio": ("Poisson", REQUIRED)},
    "reduced_radius": {name: ("not 0", REQUIRED) for name in RADII},
    "gaussian_moment": {"order": ("order", REQUIRED), "argument": ("any", REQUIRED)},
    "hertz_point": {name: ("above 0", REQUIRED)
                    for name in ("load", "effective_modulus", "reduced_radius")},
    "hertz_ellipse": {name: ("above 0", REQUIRED)
                      for name in ("load", "effective_modulus", "radius_x", "radius_y")},
    "hertz_line": {name: ("above 0", REQUIRED)
                   for name in ("load_per_length", "effective_modulus", "reduced_radius")},
    "hamrock_dowson_central": {
        "speed": ("above 0", REQUIRED), "viscosity": ("above 0", REQUIRED),
        "pressure_viscosity": ("above 0", REQUIRED), "load": ("above 0", REQUIRED),
        "effective_modulus": ("above 0", REQUIRED), "reduced_radius": ("above 0", REQUIRED),
        "ellipticity": ("above 0", 1.0)},
    "starvation_ratio": {"closure": (inlet.CLOSURES, REQUIRED),
                         "flooded_over_inlet": ("above 0", REQUIRED), "damiens_exponent": ("above 0", 3.0)},
    "load_sharing": {"asperity": (("greenwood_tripp", "greenwood_williamson"), REQUIRED),
                     "flooded_film_parameter": ("above 0", REQUIRED), "stiffness": ("from 0", REQUIRED),
                     "offset": ("from 0", REQUIRED)},
}

FILM = ("speed", "viscosity", "pressure_viscosity", "load", "effective_modulus", "radius_x", "ellipticity")
REGIMES = ("isoviscous_rigid", "viscous_rigid_barus", "viscous_rigid_roelands", "isoviscous_elastic",
           "viscous_elastic")


def above_zero(*names, **defaults):
    return {name: ("above 0", defaults.get(name, REQUIRED)) for name in names}


FUNCTIONS |= {name: above_zero(*(one for one in FILM if law[2] or one != "pressure_viscosity"), ellipticity=1.0)
              for name, law in films.POINTS.items()}
FUNCTIONS |= {name: above_zero(*FILM[:3], "load_per_length", "effective_modulus", "reduced_radius")
              for name in (*films.LINES, "moes_line")}
FUNCTIONS["nijenbanning_venner_moes"] = {
    **above_zero(*FILM[:5], "radius_x", "radius_y"), "exponent": (("ei_over_ri", "ei_over_ep"), "ei_over_ri"),
    "bracket": (("three_halves", "three_halves_of_s"), "three_halves")}
FUNCTIONS |= {
    "regime_film": {"regime": (REGIMES, REQUIRED), **above_zero(
        "viscosity_parameter", "elasticity_parameter", "radius_ratio", "ellipticity", radius_ratio=1.0, ellipticity=1.0)},
    "gupta_thermal_reduction": {
        **above_zero("peak_pressure", "effective_modulus"), "slide_roll_ratio": ("from 0", REQUIRED),
        **above_zero("temperature_viscosity", "viscosity", "speed", "thermal_conductivity")},
    "dowson_higginson_density": {"pressure": ("from 0", REQUIRED)},
    "barus_viscosity": {**above_zero("viscosity", "pressure_viscosity"), "pressure": ("from 0", REQUIRED)},
    "astm_d341_viscosity": above_zero("first_temperature", "first_viscosity", "second_temperature",
                                      "second_viscosity", "temperature"),
    "viscosity_index": above_zero("kinematic_viscosity_40", "kinematic_viscosity_100"),
    "summits_from_spectral_moments": above_zero("m0", "m2", "m4"),
}
FUNCTIONS |= {
    "subsurface_shear": {**above_zero("peak_pressure", "radius"), "depth": ("from 0", REQUIRED),
                         "poisson_ratio": ("Poisson", REQUIRED)},
    "jkr_radius": {"load": ("any", REQUIRED), **above_zero("work_of_adhesion", "effective_modulus", "reduced_radius")},
    "pull_off_force": {"adhesion": (("jkr", "dmt"), REQUIRED), **above_zero("work_of_adhesion", "reduced_radius")},
    "murch_wilson_thermal_reduction": above_zero("temperature_viscosity", "viscosity", "speed", "thermal_conductivity"),
    "carreau_yasuda_viscosity": {
        **above_zero("viscosity"), "high_shear_viscosity": ("from 0", REQUIRED), **above_zero("relaxation_time"),
        "shear_rate": ("from 0", REQUIRED), **above_zero("transition_exponent", "power_law_index")},
    "plasticity_index": above_zero("effective_modulus", "hardness", "summit_height_sd", "summit_radius"),
    "kogut_etsion_load": above_zero("interference_ratio"),
    "persson_contact_area": {"pressure": ("from 0", REQUIRED), **above_zero("effective_modulus", "rms_gradient")},
    "patir_cheng_pressure_flow": above_zero("film_ratio"),
    "lambda_ratio": above_zero("minimum_film", "first_roughness", "second_roughness"),
}
FUNCTIONS["roelands_viscosity"] = FUNCTIONS["barus_viscosity"]

SCENE = {
    "load": ("above 0", REQUIRED), "speed": ("above 0", REQUIRED),
    "surface.summit_density": ("above 0", REQUIRED), "surface.summit_radius": ("above 0", REQUIRED),
    "surface.summit_height_sd": ("above 0", REQUIRED), "surface.summit_plane_offset": ("from 0", 0.0),
    "surface.offset_planes": ((0, 1, 2), 1),
    "bodies.effective_modulus": ("above 0", REQUIRED), "bodies.reduced_radius": ("above 0", None),
    "bodies.ellipticity": ("above 0", 1.0),
    "bodies.radius_x": ("above 0", None), "bodies.radius_y": ("above 0", None), "bodies.length": ("above 0", None),
    "lubricant.viscosity": ("above 0", REQUIRED), "lubricant.pressure_viscosity": ("above 0", REQUIRED),
    "lubricant.eyring_stress": ("above 0", None),
    "supply.inlet_film": ("above 0", None), "supply.inlet_film_ratio": ("above 0", None),
    "supply.inlet_flow": ("above 0", None),
    "friction.boundary_coefficient": ("from 0", None), "friction.slide_roll_ratio": ("from 0", 1.0),
    "friction.fluid": (("eyring", "limiting"), "eyring"),
    "friction.viscosity": (("barus", "ambient", "roelands"), "barus"),
    "closures.asperity": (("greenwood_tripp", "greenwood_williamson"), "greenwood_tripp"),
    "closures.starvation": (inlet.CLOSURES, "flooded_inlet"), "closures.damiens_exponent": ("above 0", 3.0),
    "closures.film": (("hamrock_dowson_central", *films.POINTS, *films.LINES), "hamrock_dowson_central"),
}
SHAPES = ({"reduced_radius"}, {"radius_x", "radius_y"}, {"radius_x", "length"})
OF_FRICTION = ("lubricant.eyring_stress", "friction.boundary_coefficient")
ORDERS = (0, 0.5, 1, 1.5, 2, 2.5)


class InputError(Exception):
    """Has two arguments: the name of the field, and the message."""


def number(name, value, allowed):
    try:
        value = math.nan if isinstance(value, bool) or not isinstance(value, (int, float)) else float(value)
    except OverflowError:  # a whole number with more digits than a double reaches
        value = math.inf
    if not math.isfinite(value):
        raise InputError(name, "this is no finite number")
    if not {"above 0": value > 0, "from 0": value >= 0, "not 0": value != 0,
            "Poisson": -1 < value <= 0.5, "any": True}[allowed]:
        raise InputError(name, f"{value} is not allowed; allowed: {allowed}")
    return value


def checked(name, value, allowed):
    words = ORDERS if allowed == "order" else allowed
    if isinstance(words, str):
        return number(name, value, words)
    if isinstance(value, bool) or value not in words:
        raise InputError(name, f"not known; allowed: {', '.join(map(str, words))}")
    return value


def read(given, allowed_fields):
    """All fields by name, with defaults for absent ones. Raises InputError for an unknown, missing or wrong field."""
    for name in given:
        if name not in allowed_fields:
            raise InputError(name, "unknown field")
    result = {}
    for name, (allowed, default) in allowed_fields.items():
        if name in given:
            result[name] = checked(name, given[name], allowed)
        elif default is REQUIRED:
            raise InputError(name, "missing")
        else:
            result[name] = default
    return result


def read_arguments(name, given):
    """The arguments of a function."""
    arguments = read(given, FUNCTIONS[name])
    if name == "reduced_radius":
        for first, second in (RADII[:2], RADII[2:]):
            if not solver.has_point(arguments[first], arguments[second]):
                raise InputError(first, f"no point of contact: 1/{first} + 1/{second} has to be above 0")
    return arguments


def flattened(line):
    """Makes {"bodies.reduced_radius": 1} from {"bodies": {"reduced_radius": 1}}, and leaves out id and outputs."""
    flat = {}
    for name, value in line.items():
        if isinstance(value, dict):
            flat.update({f"{name}.{key}": inner for key, inner in value.items()})
        elif name not in ("id", "outputs"):
            flat[name] = value
    return flat


def read_outputs(line, scene):
    """The asked outputs. Without a list in the line these are all outputs, but friction only if its fields are given."""
    asked = line.get("outputs")
    missing = [name for name in OF_FRICTION if scene[name] is None]
    if asked is None:
        return [name for name in point.OUTPUTS if name != "friction" or not missing]
    if not isinstance(asked, list) or not asked:
        raise InputError("outputs", "this is no list of outputs")
    for name in asked:
        if name not in point.OUTPUTS:
            raise InputError("outputs", f"not known; allowed: {', '.join(point.OUTPUTS)}")
    if "friction" in asked and missing:
        raise InputError(missing[0], "missing: friction needs it")
    return asked


def read_scene(line):
    scene = read(flattened(line), SCENE)
    if "supply" in line and sum(scene[f"supply.{kind}"] is not None for kind in
                                ("inlet_film", "inlet_film_ratio", "inlet_flow")) != 1:
        raise InputError("supply", "one of inlet_film, inlet_film_ratio, inlet_flow is needed")
    given = {name for name in ("reduced_radius", "radius_x", "radius_y", "length") if scene[f"bodies.{name}"] is not None}
    if given not in SHAPES:
        raise InputError("bodies", "one of reduced_radius; radius_x and radius_y; radius_x and length is needed")
    if (scene["closures.film"] in films.LINES) != ("length" in given):
        raise InputError("closures.film", "a line needs a law of lines, and a point one of points")
    if scene["friction.viscosity"] == "roelands" and math.log(scene["lubricant.viscosity"]) <= -9.67:
        raise InputError("lubricant.viscosity", "too thin for Roelands' law")
    return scene
