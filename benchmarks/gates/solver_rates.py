#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts how often `tribocheck bench` is right about a solver that is unchanged, 10 % slower, or 25 % slower.

A solver in Python is timed as a subject, and one in C as a plug-in, both against a baseline that is made at the start.
The plug-in is also timed in a pair with its unchanged version, without a baseline. Each kind runs on the machine as it
is, and beside two busy loops. Writes how many runs of each kind were red, and how many said that the solver is slower.
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SUBJECT = """import json, math, sys
def moment(d, steps):
    low, high = max(0.0, -d - 9), 9 + max(0.0, -d)
    width = (high - low) / steps
    total = 0.0
    for i in range(steps):
        t = low + width * (i + 0.5)
        total += t * t * math.sqrt(t) * math.exp(-(t + d) ** 2 / 2)
    return width * total / math.sqrt(2 * math.pi)
for line in sys.stdin:
    q = json.loads(line)
    answer = {"skip": "not in this solver"}
    if q.get("function") == "gaussian_moment":
        answer = {"value": moment(q["argument"], STEPS)}
    elif q.get("function") == "hertz_point":
        answer = {"radius": (0.75 * q["load"] * q["reduced_radius"] / q["effective_modulus"]) ** (1 / 3)}
    print(json.dumps({"id": q["id"], **answer}), flush=True)
"""

PLUGIN = """#include <math.h>
#include <string.h>
#include "tribocheck_plugin.h"
int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
static double moment(double d) {
  const double low = d < -9 ? -d - 9 : 0, high = d < 0 ? 9 - d : 9, width = (high - low) / STEPS;
  double total = 0;
  for (int i = 0; i < STEPS; ++i) {
    const double t = low + width * (i + 0.5);
    total += t * t * sqrt(t) * exp(-(t + d) * (t + d) / 2);
  }
  return total * width / sqrt(2 * acos(-1));
}
int tribocheck_function(const char* name, size_t count, const double* const* argument, double* const* result,
                        int* status) {
  if (strcmp(name, "gaussian_moment") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    result[0][i] = moment(argument[1][i]);
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
"""

STEPS = {"unchanged": 400, "slower_10": 440, "slower_25": 500}


class Solvers:
    """Writes the solvers of all speeds to a folder, and runs `tribocheck bench` on them."""

    def __init__(self, program, include, folder):
        self.program, self.folder = program, folder
        for change, steps in STEPS.items():
            where = folder / change
            where.mkdir()
            (where / "solver.py").write_text(SUBJECT.replace("STEPS", str(4 * steps)))
            (where / "solver.c").write_text(PLUGIN)
            subprocess.run(["cc", "-O2", "-shared", "-fPIC", f"-DSTEPS={steps}", "-I", include, where / "solver.c", "-o",
                            where / "libsolver.so", "-lm"], check=True)

    def options(self, way, change):
        here = self.folder / change
        if way == "subject":
            return ["--subject", f"python3 {here / 'solver.py'}"]
        if way == "plugin":
            return ["--alone", "--plugin", here / "libsolver.so"]
        return ["--plugin", here / "libsolver.so", "--plugin", self.folder / "unchanged/libsolver.so"]

    def bench(self, way, change, *more):
        baseline = [] if way == "pair" else ["--baseline", self.folder / f"{way}.json"]
        words = [self.program, "bench", "--filter", "^(gaussian_moment|hertz_point)/", *self.options(way, change), *baseline,
                 *more]
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)


def outcome(done):
    """Returns "red", "told" (a little slower) or "silent". Ends this script at any other outcome."""
    if done.returncode not in (0, 1) or "ED, " not in done.stderr:
        sys.exit(f"solver_rates.py: {done.stderr}")
    if done.returncode == 1:
        return "red"
    return "told" if "a little slower" in done.stderr else "silent"


def rate(solvers, way, change, runs):
    """The counts of one kind of runs, and the load average of the machine over the last 5 minutes at their end."""
    runs = max(1, runs // 5) if change == "slower_10" else runs
    counts = collections.Counter(outcome(solvers.bench(way, change)) for _ in range(runs))
    return {"solver": change, "runs": runs, "red": counts["red"], "told": counts["told"], "load": round(os.getloadavg()[1], 1)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="build/release/tribocheck")
    parser.add_argument("--runs", type=int, default=100, help="of each kind; a fifth of it of 10 %% (default: 100)")
    parser.add_argument("--ways", default="subject,plugin,pair", help="some of these (the default), with commas")
    parser.add_argument("--out", type=pathlib.Path, help="the file for the result")
    given = parser.parse_args()
    include = pathlib.Path(__file__).resolve().parents[2] / "verification/conformance"
    version = subprocess.run([given.program, "--version"], capture_output=True, text=True, check=True).stdout
    cpu = next((line.partition(": ")[2].strip() for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
                if line.startswith("model name")), "unknown")
    result = {"commit": version.partition("commit ")[2].partition(",")[0], "date": datetime.date.today().isoformat(),
              "environment": {"cpu": cpu, "cores": os.cpu_count()}, "rates": []}
    with tempfile.TemporaryDirectory() as folder:
        solvers = Solvers(given.program.resolve(), include, pathlib.Path(folder))
        for way in given.ways.split(","):
            if way != "pair":
                solvers.bench(way, "unchanged", "--update-baseline")
            for state in ("quiet", "loaded"):
                busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"])
                        for _ in range(2 if state == "loaded" else 0)]
                try:
                    for change in STEPS:
                        result["rates"].append({"way": way, "state": state, **rate(solvers, way, change, given.runs)})
                        print(result["rates"][-1], flush=True)
                        if given.out:  # written after each kind, so that a stopped run keeps its results
                            given.out.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
                finally:
                    for one in busy:
                        one.kill()
                        one.wait()


if __name__ == "__main__":
    main()
