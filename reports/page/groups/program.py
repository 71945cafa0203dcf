# SPDX-License-Identifier: Apache-2.0
"""The program's own commands, asked as any user asks them."""
import json
import subprocess

from group import Missing


def said(program, *arguments, cwd=None):
    """What a command says: its output, and the lines that it complains of. Raises Missing, with the first of these, where
    it has no output."""
    done = subprocess.run([program, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                          errors="replace", cwd=cwd)
    complaints = [line.removeprefix("tribocheck: ") for line in done.stderr.splitlines()]
    if not done.stdout or done.returncode not in (0, 1):
        errors = [line for line in complaints if not line.startswith("warning: ")]
        raise Missing(errors[0] if errors else f"{arguments[0]} ended with exit code {done.returncode}")
    return done.stdout, complaints


def answer(program, *arguments, cwd=None):
    """What a command answers as JSON."""
    return json.loads(said(program, *arguments, "--format", "json", cwd=cwd)[0])
