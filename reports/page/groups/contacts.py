# SPDX-License-Identifier: Apache-2.0
"""Contacts as machines have them: the scenes of reference/scenes, a circle, an ellipse and a line, solved."""
import curves
import scenes
from group import Group, Missing

STEMS = ("ball_on_flat", "bearing_outer_ring", "gear_flank")
TOLD_SPEED = 1.0  # m/s; the page tells films at this speed
TOLD = ("speed", "film", "film_parameter", "asperity_load_share", "friction")


def told(point):
    return point and {name: point[name] for name in TOLD}


def before_solved(file, about):
    """The dry contact of a scene, and inputs that the page tells. Raises Missing if the page would lack a number."""
    low, high = about.speeds
    if not about.has_friction_inputs:
        raise Missing(f"{file} has not all inputs of friction")
    if not low <= TOLD_SPEED <= high:
        raise Missing(f"the speeds of {file} leave {TOLD_SPEED:g} m/s out")
    dry = {name: one["value"] for name, one in about.contact.items() if name not in ("share_without_film", "speed_power")}
    return {"file": file, "shape": dry.pop("shape"), "load": about.input("load")} | dry | {
        "summit_density": about.input("surface.summit_density"), "summit_radius": about.input("surface.summit_radius"),
        "plane_offset": about.input("surface.offset_planes") * about.input("surface.summit_plane_offset"),
        "viscosity": about.input("lubricant.viscosity"), "pressure_viscosity": about.input("lubricant.pressure_viscosity"),
        "boundary_coefficient": about.input("friction.boundary_coefficient"),
        "slide_roll_ratio": about.input("friction.slide_roll_ratio"), "film_law": about.input("closures.film")}


def heating(program, path, speed):
    """The heating of the oil in the inlet and in the film at a speed (K), from the limits of validity; None without a speed."""
    if speed is None:
        return None
    scene, = program.answer("contact", path, "--speed", repr(speed))["scenes"]
    return {limit["word"]: limit["value"] for limit in scene["validity"] if limit["word"] in ("inlet_heating", "film_heating")}


def contacts(asked):
    paths = {stem: asked.places.reference / f"scenes/{stem}.toml" for stem in STEMS}
    abouts = dict(zip(STEMS, scenes.abouts(asked.program.said("solve", *paths.values(), "--about", "--format", "json")[0])))
    facts = {stem: before_solved(asked.places.shown(paths[stem]), about) for stem, about in abouts.items()}
    found = curves.solved([curves.Contact(asked.program, scenes.read(paths[stem]), *about.speeds)
                           for stem, about in abouts.items()], ["friction_minimum"])
    tables, made, files, marks = asked.tables, {}, [], []
    for (stem, fact), one in zip(facts.items(), found):
        least = one.onsets["friction_minimum"]["speed"]
        at_least = None if least is None else one.contact.at(least)
        made[stem] = fact | {
            "at_told_speed": told(one.contact.at(TOLD_SPEED)), "slowest": told(one.curve[0]), "fastest": told(one.curve[-1]),
            "least_friction": told(at_least), "heating_at_least_friction": heating(asked.program, paths[stem], least)}
        files += [(f"data/contact_{stem}.tsv", tables.curve("Stribeck curve", fact["file"], one.curve)),
                  (f"data/scenes/{stem}.toml", scenes.file_text(paths[stem]))]
        marks.append((stem, at_least))
    files.append(("data/contact_marks.tsv", tables.named("Points to mark: the least friction (friction_minimum)",
                                                         "the scenes of the curves contact_*.tsv", marks)))
    return Group({"told_speed": TOLD_SPEED, "scenes": made, "limits_passed": scenes.limits_passed(asked.program, paths)}, files=files)
