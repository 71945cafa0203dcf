# SPDX-License-Identifier: Apache-2.0
"""Reads the measurements of tribocheck_gate_kernels, and valgrind's counts of that program."""
import datetime
import os
import pathlib
import platform
import re
import shutil
import subprocess
import tempfile

import rules

ROOT = pathlib.Path(__file__).resolve().parents[2]
VALGRIND_SET = "AVX2"  # valgrind 3.19 has no AVX-512
# Tells the C library not to use these instruction sets. The model then does not use them either.
WITHOUT_FMA = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA"}
PASS = "tribocheck_gate_pass"
ROUNDS = (4, 16)       # least and most rounds of times; in each round all programs run in turn
REPETITIONS = 5        # of each program in a round


class Unmeasured(Exception):
    """The program did not run, or its output is not as expected."""


def said_by(command, environment=None):
    try:
        done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              env=os.environ | (environment or {}))
    except OSError as error:
        raise Unmeasured(f"{command[0]}: {error.strerror}") from None
    if done.returncode != 0:
        raise Unmeasured(f"{' '.join(map(str, command))}: exit code {done.returncode}: {done.stderr.strip()[-300:]}")
    return done.stdout


def rows(command, environment=None):
    return [line.split("\t") for line in said_by(command, environment).splitlines()]


def environment(program):
    """Describes this machine and the build of the program."""
    found = {"cpu": platform.machine(), "valgrind": valgrind_version()}
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            found["cpu"] = line.split(":", 1)[1].strip()
            break
    sets = []
    for name, value in rows([program, "--environment"]):
        if name in ("scalar", "vector"):
            sets.append(value)
        else:
            found[name] = value
    return found | {"instruction_sets": sets}


def commit():
    return said_by(["git", "-C", ROOT, "describe", "--always", "--dirty", "--abbrev=40", "--exclude", "*"]).strip()


def today():
    return datetime.datetime.now(datetime.timezone.utc).date().isoformat()


def counters(program):
    """A dict: key → counter → count. Scalar workloads are counted with FMA, if the machine has it, and without FMA."""
    found = {}
    for environment in ({}, WITHOUT_FMA):
        for workload, instruction_set, name, count in rows([program, "--counters"], environment):
            found.setdefault(f"{workload} {instruction_set}", {})[name] = int(count)
    return found


def valgrind_version():
    """The version of valgrind; None if it is not installed."""
    if shutil.which("valgrind") is None:
        return None
    return said_by(["valgrind", "--version"]).strip()


def has_instruction_set(program, name):
    return ["vector", name] in rows([program, "--environment"])


def instructions(program):
    """A dict: key → instructions of a pass. Callgrind counts them in one run of the program, with a dump after each pass."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        keys = [f"{workload} {instruction_set}" for workload, instruction_set, _ in rows(
            ["valgrind", "-q", "--tool=callgrind", f"--toggle-collect={PASS}", f"--dump-after={PASS}",
             f"--callgrind-out-file={out}", program, "--run", "1", "--set", VALGRIND_SET])]
        found = {}
        for i, key in enumerate(keys, 1):
            dump = out.with_name(f"{out.name}.{i}").read_text()
            found[key] = int(re.search(r"^totals: (\d+)$", dump, re.MULTILINE).group(1))
    if len(keys) < 2 or min(found.values()) == 0:
        raise Unmeasured("callgrind saw no pass")
    return found


class Times:
    """The quiet repetitions of each program, their least number, and the control kernel's best time."""

    def __init__(self, runs):
        self.control = rules.best_control(runs)
        self.quiet = [{key: rules.quiet(repetitions, self.control) for key, repetitions in run.items()}
                      for run in runs]
        self.fewest = min(len(repetitions) for run in self.quiet for repetitions in run.values())

    def intervals(self):
        return [{key: rules.interval(repetitions) for key, repetitions in run.items()} for run in self.quiet]


def times(programs):
    """Runs the programs in turn, on the best instruction set, until each workload has enough quiet
    repetitions or the greatest number of rounds is reached. Returns the Times of all rounds."""
    runs = [{} for _ in programs]
    best = [next(value for name, value in rows([program, "--environment"]) if name == "vector")
            for program in programs]
    for turn in range(ROUNDS[1]):
        order = range(len(programs)) if turn % 2 == 0 else reversed(range(len(programs)))
        for i in order:
            for workload, instruction_set, *seconds in rows(
                    [programs[i], "--time", REPETITIONS, "--set", best[i]]):
                runs[i].setdefault(f"{workload} {instruction_set}", []).append(
                    rules.Repetition(*map(float, seconds)))
        found = Times(runs)
        if turn + 1 >= ROUNDS[0] and found.fewest >= rules.REPETITIONS:
            break
    return found
