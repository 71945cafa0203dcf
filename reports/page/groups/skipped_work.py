# SPDX-License-Identifier: Apache-2.0
"""Evaluations that scenes with fewer outputs save."""
import scenes
from group import Group, finding

SPEEDS = 10000  # of each scene, log-spaced over its range
REQUESTS = ([], ["film"], ["fluid_load_share", "regime"], ["real_area_ratio"])  # outputs; none named: all


def asking(scene, speeds, outputs):
    """The scene with other outputs at that many speeds."""
    asked = {name: one for name, one in scene.items() if name != "outputs"} | ({"outputs": outputs} if outputs else {})
    return asked | {"speed": {"from": speeds[0], "to": speeds[1], "count": SPEEDS}}


def rows_of(stem, flooded, works):
    """The work that each request of a scene saves. `full` is the work of all outputs, in evaluations of F_n: the steps of the roots,
    one step for a root that is λ₀ or λ_b without any, and for each point one share and two moments."""
    full = sum(flooded[name] for name in ("root_steps", "roots_skipped_at_film", "roots_skipped_at_floor")) + 3 * SPEEDS
    for outputs, work in zip(REQUESTS, works):
        done = work["root_steps"] + work["shares"] + work["moments"]
        yield {"scene": stem, "asked": outputs, "root_steps": work["root_steps"], "roots_that_are_film": work["roots_skipped_at_film"],
               "roots_that_are_floor": work["roots_skipped_at_floor"],
               "shares_skipped": work["shares_skipped_not_asked"] + work["shares_skipped_as_nothing"],
               "starvation_skipped": SPEEDS - work["starvation_ratios"], "saved": (full - min(full, done)) / full}


def skipped_work(asked):
    trees = []
    for one in asked.published:
        scene = scenes.read(asked.places.scenes / f"{one.stem}.toml")
        trees += [asking(scene, one.about.speeds, outputs) for outputs in (["film_flooded"], *REQUESTS)]
    with scenes.files_of(trees) as paths:
        works = [{name: one["value"] for name, one in about.work.items()}
                 for about in scenes.abouts(asked.program.said("solve", *paths, "--about", "--format", "json")[0])]
    count = 1 + len(REQUESTS)
    rows = [row for i, one in enumerate(asked.published)
            for row in rows_of(one.stem, works[i * count], works[i * count + 1:(i + 1) * count])]
    saved = [row["saved"] for row in rows]
    return Group({"speeds": SPEEDS, "rows": rows, "least_saved": min(1.0, *saved), "greatest_saved": max(0.0, *saved)},
                 [finding("skipped_work", "skipped-work", "software", "measured")])
