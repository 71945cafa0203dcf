#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the report's data, report.json, data/*.tsv and the schema of the first. It needs no package of Python.

`tribocheck report` calls this with a request on stdin: where things are, which sections the page has, and the groups of
report.json that they need, some of them made already, some with facts of their scenes. Prints what was written and the verdict in
short as JSON; or `failed`, why a file cannot be written.
"""
import dataclasses
import functools
import json
import math
import pathlib
import sys
import typing

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parent / "render"))
import drawing  # noqa: E402
import contacts  # noqa: E402
import curves  # noqa: E402
import environment  # noqa: E402
import ledger  # noqa: E402
import onset_uncertainty  # noqa: E402
import paper  # noqa: E402
import speed  # noqa: E402
import terminal  # noqa: E402
import verification  # noqa: E402
import work_precision  # noqa: E402
from group import Group, Missing, finding  # noqa: E402
from program import Program  # noqa: E402

GROUPS = {"paper": paper.paper, "ledger": ledger.ledger, "onset_uncertainty": onset_uncertainty.onset_uncertainty,
          "contacts": contacts.contacts,
          "certified": verification.certified, "stress": verification.stress, "planted_faults": verification.planted_faults,
          "diagnosis": verification.diagnosis, "work_precision": work_precision.work_precision, "gates": speed.gates,
          "sweep_speed": speed.sweep_speed, "environment": environment.environment}


class Places(typing.NamedTuple):
    out: pathlib.Path
    root: pathlib.Path | None  # the project's folder, where there is one
    scenes: pathlib.Path  # the published ones
    reference: pathlib.Path  # the folder of exact/, baselines/ and scenes/

    def shown(self, file):
        """A file as provenance names it: from the project's root if it lies below it."""
        inside = self.root is not None and file.is_relative_to(self.root)
        return str(file.relative_to(self.root) if inside else file)


@dataclasses.dataclass(frozen=True)
class Asked:
    """What the groups are made from."""
    places: Places
    program: Program
    version: str
    commit: str  # empty: not known
    compiler: str
    processor: str
    instruction_set: str
    tables: curves.Tables

    @functools.cached_property
    def reproduced(self):
        """The ledger, which two groups read."""
        return ledger.reproduced(self)


class OutputFailed(Exception):
    pass


def group_of(one, asked):
    """A group as asked for: the one that is made already, or made here, or why it is missing."""
    if "made" in one:
        return Group(**one["made"])
    try:
        return GROUPS[one["id"]](asked, one["facts"]) if "facts" in one else GROUPS[one["id"]](asked)
    except Missing as missing:
        why = str(missing)
        return Group({"missing": {"why": why, "how_to": one["how_to"]}},
                     [finding(one["id"], one["section"], "software", "absent", why)])


def without_nan(value):
    """JSON has no NaN and no infinity: they are null."""
    if isinstance(value, dict):
        return {name: without_nan(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write(out, path, text):
    target = out / path
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        drawing.write_text(target, text)
    except OSError as error:
        raise OutputFailed(f"cannot write {target}: {error.strerror}") from error


def make(request, program):
    places = Places(pathlib.Path(request["out"]), pathlib.Path(request["root"]) if request["root"] else None,
                    pathlib.Path(request["scenes"]), pathlib.Path(request["reference"]))
    asked = Asked(places, program, *(request[name] for name in ("version", "commit", "compiler", "processor", "instruction_set")),
                  curves.Tables(request["version"], request["outputs"]))
    report = {"tribocheck": asked.version, "sections": request["sections"], "findings": [], "not_run": [], "files": []}
    written = []
    for one in request["groups"]:
        if one["step"]:
            drawing.show_step(one["step"])
        group = group_of(one, asked)
        report[one["id"]] = group.data
        report["findings"] += [found for found in group.findings if found["section"] in request["sections"]]
        report["not_run"] += group.not_run
        for path, text in group.files:
            if text is not None:  # None: it is there already
                write(places.out, path, text)
            report["files"].append(path)
            written.append(path)
    write(places.out, "report.schema.json", (HERE / "report.schema.json").read_text(encoding="utf-8"))
    drawing.show_step("")
    write(places.out, "report.json", json.dumps(without_nan(report), indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return {"written": [*written, "report.schema.json", "report.json"], "verdict": terminal.verdict(report)}


def main():
    try:
        request = json.load(sys.stdin)
        with Program(request["program"]) as program:
            answer = make(request, program)
    except OutputFailed as failed:
        answer = {"failed": str(failed)}
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
