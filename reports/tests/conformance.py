# SPDX-License-Identifier: Apache-2.0
"""Puts the example subjects to the tests."""

import os
import pathlib
import subprocess
import sys

from program import PROGRAM, run

SUBJECTS = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/subjects"
BUILT = pathlib.Path(PROGRAM).parent / "verification/conformance/subjects"
PYTHON = sys.executable


def subject(script, *words):
    return " ".join([PYTHON, "-B", str(SUBJECTS / script), *words])


def verify(*arguments):
    return run("verify", *arguments, "--format", "json")


def listed(script):
    done = run_python(SUBJECTS / script, "--list")
    return [line.split("\t")[0] for line in done.splitlines()]


def run_python(*words):
    return subprocess.run([PYTHON, "-B", *map(str, words)], capture_output=True, text=True, check=True,
                          timeout=60).stdout
