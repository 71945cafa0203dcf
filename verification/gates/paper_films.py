#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Solves the starved films of the paper's three surfaces over their speeds, for the report.

`tribocheck film` solves the flooded and the starved film of smooth faces at each speed. In place of the scene's closure of
starvation, `tribocheck solve` then takes Damiens' closure with the exponent that gives the solved ratio of the two films. With
the film law that is nearest to the solved flooded films, it gives the load shares and the friction. One contact takes ten
seconds to a minute, all of them a quarter of an hour on one core. Finished contacts stay in build/paper_films/<the program's
digest>, so that a stopped run goes on where it was. Then the script writes the results with commit and environment. The
exit code is 1 if a contact was not solved.

  verification/gates/paper_films.py build/release/tribocheck --out reference/baselines/paper_films.json
"""
import argparse
import datetime
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/gates/faults"))
import plant  # noqa: E402
SURFACES = ("smooth", "medium", "rough")
FASTEST, STEPS, RATIO = 3.0, 16, 1.3  # the greatest speed in m/s, the number of speeds, and the ratio of neighbouring ones
THICKEST = 2.6  # greatest ratio of oil layer to flooded film: there the film is within a few per cent of the flooded one
TOLERANCE = 1e-2
FILM_LAW = "nijenbanning_venner_moes"
TAKEN = ("speed", "load_number", "material_number", "inlet_film", "central_film", "minimum_film", "flooded_central_film",
         "film_ratio", "damiens_exponent")
SHARES = ("film_parameter", "asperity_load_share", "friction")


def speeds(fastest):
    """The speeds from the fastest down, as far as the oil layer is below THICKEST times the flooded film, which grows as u^0.67."""
    all_of_them = [float(f"{FASTEST / RATIO ** step:.4g}") for step in range(STEPS)]
    return [u for u in all_of_them if fastest["inlet_film"] < THICKEST * fastest["flooded_central_film"]["value"] * (u / FASTEST) ** 0.67]


def told(program, command, scene, *more):
    return subprocess.run([program, command, "-", "--format", "json", *more], input=scene, text=True,
                          stdout=subprocess.PIPE, check=False)


def at_speed(scene, speed):
    return re.sub(r"(?m)^speed = .*$", f"speed = {speed}", scene)


def solved(program, scene, speed, folder):
    """The row of one contact: the films that `tribocheck film` gives, and the load shares and the friction that follow."""
    kept = folder / f"{hashlib.sha256(f'{scene}{speed} {TOLERANCE}'.encode()).hexdigest()[:16]}.json"
    if not kept.exists():
        done = told(program, "film", at_speed(scene, speed), "--tolerance", str(TOLERANCE))
        if not done.stdout:
            raise SystemExit(f"`tribocheck film` gave no result at the speed {speed} m/s")
        kept.with_suffix(".part").write_text(done.stdout)
        kept.with_suffix(".part").rename(kept)
    film = json.loads(kept.read_text())["films"][0]
    row = {name: film.get(name) for name in TAKEN}
    if row["film_ratio"] is None:
        return row | {"reason": film.get("undefined", {}).get("film_ratio")}
    row["closures"] = {one["name"]: one["film_ratio"] for one in film["closures"]}
    exponent = row["damiens_exponent"]
    closure = "" if exponent is None else f'starvation = "damiens"\ndamiens_exponent = {exponent}\n'
    mixed = re.sub(r"(?m)^starvation = .*\n?", f'{closure}film = "{FILM_LAW}"\n', at_speed(scene, speed))
    if exponent is None:  # within its error the ratio is 1 or that of the oil layer, and no exponent gives it
        return row
    point = json.loads(told(program, "solve", mixed).stdout)["points"][0]
    return row | {name: point[name] for name in SHARES}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    folder = ROOT / "build/paper_films" / hashlib.sha256(arguments.program.read_bytes()).hexdigest()[:16]
    folder.mkdir(parents=True, exist_ok=True)
    surfaces, unsolved = {}, 0
    for surface in SURFACES:
        scene = (ROOT / f"reference/published/{surface}.toml").read_text()
        rows = []
        for speed in speeds(solved(arguments.program, scene, FASTEST, folder)):
            rows.append(solved(arguments.program, scene, speed, folder))
            print(f"{surface}, {speed} m/s: ratio {rows[-1]['film_ratio']}", file=sys.stderr)
        unsolved += sum(row["film_ratio"] is None for row in rows)
        surfaces[surface] = sorted(rows, key=lambda row: row["speed"])
    made = {"what": "starved films of the paper's three surfaces, solved", "commit": plant.commit(),
            "date": datetime.date.today().isoformat(), "environment": plant.environment(), "tolerance": TOLERANCE,
            "film_law": FILM_LAW, "surfaces": surfaces}
    text = json.dumps(made, indent=1) + "\n"
    (arguments.out.write_text if arguments.out else sys.stdout.write)(text)
    return 1 if unsolved else 0


if __name__ == "__main__":
    sys.exit(main())
