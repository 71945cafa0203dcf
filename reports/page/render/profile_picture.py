#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The picture of a profile: a bar for each of the lines on which a solver's time goes.

`tribocheck profile --picture` calls this. DATA is what `tribocheck profile --format json` prints. Prints what was
drawn, as JSON.
"""
import pathlib

import drawing

MOST = 20  # lines that are drawn
LONGEST = 40  # signs of a name


def name_of(line):
    place = pathlib.PurePath(line["file"]).name + (f":{line['line']}" if line["line"] else "")
    name = f"{place} {line['function']}"
    return name if len(name) <= LONGEST else name[:LONGEST - 1] + "…"


def blocks(profile):
    """Tab-separated blocks, as profile.gp reads them; the first line is on top."""
    lines = profile["lines"][:MOST]
    words = "share of the solver's " + ("instructions (%)" if profile["unit"] == "instructions" else "time (%)")
    rows = "".join(f"{len(lines) - i}\t{100*one['share']:.3f}\t{name_of(one)}\t{100*one['share']:.1f} %\n"
                   for i, one in enumerate(lines))
    return f"{len(lines) + 0.6}\t{words}\n\n\n{rows}"


def drawn(profile, folder):
    subject = profile["subject"] if len(profile["subject"]) <= 60 else profile["subject"][:59] + "…"
    return {"script": "profile.gp", "data": folder, "name": "profile", "height": 190 + 26*len(profile["lines"][:MOST]),
            "title": drawing.enhanced(f"{subject}: where the time goes"),
            "subtitle": drawing.enhanced(f"{profile['tool']}, {profile['answers']} answers")}


if __name__ == "__main__":
    drawing.draw_one(__doc__, "profile", blocks, drawn)
