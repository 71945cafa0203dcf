#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that the gates are red when they should be. A program compared with itself has to pass each gate. If more
work is planted in a kernel (planted_work.toml), the gates that the plant names have to be red.

The work is planted in a scratch copy of the tree, where only tribocheck_gate_kernels is built. The base is a
build of the unchanged tree. The text that a patch replaces has to stand exactly once in its file.

  benchmarks/gates/prove.py build/release/tribocheck_gate_kernels --out reference/baselines/gates.json

Exit code 0: proved; 1: a gate's verdict is not the expected one; 2: not measured.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

import gate
import measure

PLANTS = pathlib.Path(__file__).with_name("planted_work.toml")
TARGET = "tribocheck_gate_kernels"


def run(command, folder):
    done = subprocess.run(list(map(str, command)), cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise measure.Unmeasured(f"{' '.join(map(str, command))}: {done.stdout[-1000:]}")
    return done.stdout


class Scratch:
    """A copy of the tree with a build of its own."""

    def __init__(self, folder):
        self.tree = folder / "tree"
        self.build = folder / "build"
        listed = run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], measure.ROOT)
        for name in filter(None, listed.split("\0")):
            if (measure.ROOT / name).is_file():
                (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(measure.ROOT / name, self.tree / name)
        run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DCMAKE_CXX_COMPILER=g++",
             "-DCMAKE_BUILD_TYPE=Release", "-DTRIBOCHECK_BUILD_BENCHMARKS=ON"], folder)

    def planted(self, plant):
        """Builds the program with this plant, restores the tree, and returns the path of the program."""
        whole = {}
        try:
            for patch in plant["patch"]:
                path = self.tree / patch["file"]
                text = path.read_text()
                whole.setdefault(path, text)
                if text.count(patch["find"]) != 1:
                    raise measure.Unmeasured(
                        f"{plant['id']}: its text stands {text.count(patch['find'])} times in {patch['file']}")
                path.write_text(text.replace(patch["find"], patch["replace"]))
            run(["cmake", "--build", self.build, "--target", TARGET, "-j2"], self.tree)
        finally:
            for path, text in whole.items():
                path.write_text(text)
        program = self.build / f"{TARGET}-{plant['id']}"
        shutil.copy2(self.build / TARGET, program)
        return program


def row(expected, verdict):
    """The ledger's row for a gate's verdict. `proved` says whether the verdict is the expected one."""
    proved = verdict.name == expected
    return {"gate": verdict.gate, "expected": expected, "verdict": verdict.name, "proved": proved,
            "workloads": verdict.compared, "greatest_ratio": verdict.worst and float(f"{verdict.worst:.5g}"),
            "red": verdict.red} | ({"why": verdict.why_not} if verdict.why_not else {})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="a build of this tree, with CMake's Release flags")
    parser.add_argument("--out", type=pathlib.Path, metavar="FILE", help="write the ledger there as JSON")
    parser.add_argument("--only", metavar="ID", help="this plant alone")
    arguments = parser.parse_args()
    started = time.monotonic()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="tribocheck-gates-"))
    try:
        plants = [plant for plant in tomllib.loads(PLANTS.read_text())["plant"]
                  if arguments.only in (None, plant["id"])]
        if not plants:
            raise measure.Unmeasured(f"--only: {arguments.only} is no plant of {PLANTS.name}")
        print("the same program")
        same = [row("passed", verdict) for verdict in
                gate.hold(gate.GATES, arguments.program, arguments.program, {}).values()]
        scratch = Scratch(folder)
        planted = []
        for plant in plants:
            print(f"\n{plant['id']}: {plant['work']}", flush=True)
            program = scratch.planted(plant)
            verdicts = gate.hold(plant["gates"], program, arguments.program, {})
            planted.append({"id": plant["id"], "work": plant["work"],
                            "files": [patch["file"] for patch in plant["patch"]],
                            "gates": [row("red", verdict) for verdict in verdicts.values()]})
    except (OSError, ValueError, measure.Unmeasured) as error:
        print(f"prove.py: {error}", file=sys.stderr)
        return 2
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    rows = [("same program", one) for one in same]
    rows += [(plant["id"], one) for plant in planted for one in plant["gates"]]
    print()
    for name, one in rows:
        print(f"{'proved' if one['proved'] else 'NOT PROVED':11} {name:16} {one['gate']:13} {one['verdict']:9}"
              f" greatest ratio {one['greatest_ratio']}")
    if arguments.out:
        ledger = {"commit": measure.commit(), "date": measure.today(),
                  "environment": measure.environment(arguments.program) | {"cores": os.cpu_count()},
                  "seconds": round(time.monotonic() - started), "same_program": same, "planted": planted}
        arguments.out.write_text(json.dumps(ledger, indent=1, ensure_ascii=False) + "\n")
    return 0 if all(one["proved"] for _, one in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
