# SPDX-License-Identifier: Apache-2.0
"""The time, commit and machine of the page, and the age of the results that it shows."""
import datetime
import os
import pathlib
import re
import subprocess
import typing

from baselines import BASELINES, MEASURED, from_baseline
from group import Group, Missing

UNKNOWN = "unknown"


class Built(typing.NamedTuple):
    """The program that makes the report."""
    version: str
    commit: str  # empty: not known
    compiler: str
    instruction_set: str


def processor():
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        text = ""
    found = re.search(r"^model name.*?: (.*)$", text, re.MULTILINE)
    return found[1] if found else UNKNOWN


def today():
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "")
    now = datetime.datetime.now(datetime.timezone.utc)
    if re.fullmatch(r"-?\d{1,10}", seconds):
        now = datetime.datetime.fromtimestamp(int(seconds), datetime.timezone.utc)
    return now.date()


def day_of(date):
    """Reads "2026-11-21"; None where it is no date."""
    found = re.fullmatch(r"(\d{4})-(\d{1,2})-(\d{1,2})", date)
    try:
        return datetime.date(*map(int, found.groups())) if found else None
    except ValueError:
        return None


def text_of(of, key):
    value = of.get(key) if isinstance(of, dict) else None
    return value if isinstance(value, str) else UNKNOWN


def commits_since(root, commit, paths):
    """How many commits have changed these files since; None if git does not know the commit, or if it is not just a full hash."""
    if not re.fullmatch(r"[0-9a-f]{40}", commit) or not (root / ".git").exists():
        return None
    try:
        done = subprocess.run(["git", "-C", root, "rev-list", "--count", f"{commit}..HEAD", "--", *paths], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=20)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return int(done.stdout) if done.returncode == 0 and done.stdout.strip().isdigit() else None


def baseline_of(places, file, now):
    """A row on the baseline of a slow target with its age in days, or with the reason why its file cannot be read."""
    target, what = BASELINES[file]
    row = {"file": file, "what": what, "target": target}
    try:
        baseline = from_baseline(places, file, dict)
    except Missing as missing:
        return row | {"missing": str(missing)}
    date, machine = text_of(baseline, "date"), baseline.get("environment")
    day = day_of(date)
    return row | {"commit": text_of(baseline, "commit"), "date": date, "age_in_days": (now - day).days if day else None,
                  "measures": list(MEASURED[file]), "commits_since": commits_since(places.root, text_of(baseline, "commit"), MEASURED[file]),
                  "processor": text_of(machine, "cpu"), "compiler": text_of(machine, "compiler")}


def environment(asked):
    now, kernel = today(), os.uname()
    built = asked.built
    return Group({
        "version": built.version, "commit": built.commit or None, "compiler": built.compiler, "processor": processor(),
        "instruction_set": built.instruction_set, "kernel": f"{kernel.sysname} {kernel.release} {kernel.machine}",
        "date": now.isoformat(), "baselines": [baseline_of(asked.places, file, now) for file in BASELINES]})
