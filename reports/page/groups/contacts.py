# SPDX-License-Identifier: Apache-2.0
"""Contacts as machines have them: the scenes of reference/scenes, a circle, an ellipse and a line, solved."""
import curves
import scenes
from group import Group

TOLD_SPEED = 1.0  # m/s; the page tells films at this speed
TOLD = ("speed", "film", "film_parameter", "asperity_load_share", "friction")


def told(point):
    return point and {name: point[name] for name in TOLD}


def contacts(asked):
    facts = asked.facts_of("contacts")  # facts of the dry contacts, with the speeds of the scenes
    paths = {stem: asked.places.reference / f"scenes/{stem}.toml" for stem in facts}
    found = curves.solved([curves.Contact(asked.program, scenes.read(paths[stem]), *fact["speeds"])
                           for stem, fact in facts.items()], ["friction_minimum"])
    tables, made, files, marks = asked.tables, {}, [], []
    for (stem, fact), one in zip(facts.items(), found):
        least = one.onsets["friction_minimum"]["speed"]
        at_least = None if least is None else one.contact.at(least)
        made[stem] = {name: value for name, value in fact.items() if name != "speeds"} | {
            "at_told_speed": told(one.contact.at(TOLD_SPEED)), "slowest": told(one.curve[0]), "fastest": told(one.curve[-1]),
            "least_friction": told(at_least)}
        files += [(f"data/contact_{stem}.tsv", tables.curve("Stribeck curve", fact["file"], one.curve)),
                  (f"data/scenes/{stem}.toml", scenes.file_text(paths[stem]))]
        marks.append((stem, at_least))
    files.append(("data/contact_marks.tsv", tables.named("Points to mark: the least friction (friction_minimum)",
                                                         "the scenes of the curves contact_*.tsv", marks)))
    return Group({"told_speed": TOLD_SPEED, "scenes": made}, files=files)
