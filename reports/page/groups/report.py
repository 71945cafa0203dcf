#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the report's data: report.json with its schema, and data/*.tsv. It needs no package of Python.

`tribocheck report` calls this with a request on stdin: which sections are asked for, and what only the program itself makes
of scenes. Prints what was written and the verdict in short as JSON; or `failed`, why a file cannot be
written; or `refused`, what is wrong with the request.
"""
import argparse
import concurrent.futures
import contextlib
import dataclasses
import json
import math
import os
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
import line_films  # noqa: E402
import onset_uncertainty  # noqa: E402
import paper  # noqa: E402
import speed  # noqa: E402
import terminal  # noqa: E402
import verification  # noqa: E402
import work_precision  # noqa: E402
from group import Group, Missing, finding  # noqa: E402
from program import Program  # noqa: E402
from section_table import SECTIONS  # noqa: E402

class Maker(typing.NamedTuple):
    make: typing.Callable
    how_to: str = ""  # Markdown: the command that gives the group where it is missing
    step: str = ""  # for the progress line; empty: it takes no time


def solved_by_program(name, section=None):
    """A group that the program has made, with the section that tells its measured numbers."""
    def make(asked):
        facts = asked.facts_of(name)
        found = [finding(name, section, "software", "measured")] if section else []
        return Group(facts["data"], found, files=list(facts["files"].items()))
    return make


# In the order of report.json.
GROUPS = {
    "paper": Maker(paper.paper, "", "solving the published scenes"),
    "ledger": Maker(ledger.ledger, "`tribocheck reproduce`", "judging the paper's claims under every reading"),
    "onset_uncertainty": Maker(onset_uncertainty.onset_uncertainty, "`tribocheck sweep` of `reference/published/sweeps`",
                               "drawing onsets within the precision of Table 1"),
    "contacts": Maker(contacts.contacts, "The checkout's folder `reference/scenes`", "solving the contacts of machines"),
    "line_films": Maker(line_films.line_films, "The checkout's folders `reference/ehl` and `reference/scenes`",
                        "solving films of line contacts"),
    "certified": Maker(verification.certified, "The checkout's folder `reference/exact`, or `make references`,",
                       "holding the model to the certified tables"),
    "stress": Maker(verification.stress, "`make stress`"),
    "mutants": Maker(verification.mutants, "`make mutants`"),
    "planted_faults": Maker(verification.planted_faults, "`make faults`"),
    "diagnosis": Maker(verification.diagnosis, "`make diagnosis`"),
    "work_precision": Maker(work_precision.work_precision, "`make work-precision`"),
    "ellipse_fits": Maker(solved_by_program("ellipse_fits"), "The file `reference/mistakes.toml`"),
    "skipped_work": Maker(solved_by_program("skipped_work", "skipped-work")),
    "gates": Maker(speed.gates, "`make gate-proof`"),
    "sweep_speed": Maker(speed.sweep_speed, "`make bench-sweep`"),
    "environment": Maker(environment.environment),
}


class Places(typing.NamedTuple):
    out: pathlib.Path
    scenes: pathlib.Path  # the published ones
    reference: pathlib.Path  # the folder of exact/, baselines/ and scenes/
    root: pathlib.Path  # the project's folder; "." where there is none

    def shown(self, file):
        """A file as provenance names it: relative to the project's root if it lies below."""
        return str(file.relative_to(self.root) if file.is_relative_to(self.root) else file)


@dataclasses.dataclass(frozen=True)
class Asked:
    """The request, and the data that groups share."""
    places: Places
    program: Program
    version: str
    commit: str  # empty: not known
    compiler: str
    processor: str
    instruction_set: str
    tables: curves.Tables
    facts: dict  # what the program makes of scenes, by the names of groups
    ledger: concurrent.futures.Future | None  # takes some seconds; two groups read it

    def facts_of(self, group):
        facts = self.facts[group]
        if "missing" in facts:
            raise Missing(facts["missing"])
        return facts


class OutputFailed(Exception):
    pass


class Refused(Exception):
    pass


def sections_of(names):
    """The sections that are asked for, in the order of the page; all if none is named."""
    for name in names:
        if name not in SECTIONS:
            raise Refused(f"--section: {name} is not one of {', '.join(SECTIONS)}")
    return [name for name in SECTIONS if not names or name in names]


def section_of(group):
    """The section of a group: rather one in which the group comes first."""
    return next(name for place in (0, 1) for name, section in SECTIONS.items() if section.groups[place:place + 1] == (group,))


def group_of(name, asked):
    """A group, or why it is missing."""
    maker = GROUPS[name]
    try:
        return maker.make(asked)
    except Missing as missing:
        why = str(missing)
        absent = finding(name, section_of(name), "software", "absent", why)
        return Group({"missing": {"why": why, "how_to": maker.how_to}}, [absent])


def without_nan(value):
    """The value as JSON can hold it: NaN and infinity become None."""
    if isinstance(value, dict):
        return {name: without_nan(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def legible(text):
    """The text, in which a replacement sign stands for each byte of file names that is no UTF-8."""
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


@contextlib.contextmanager
def writing(target):
    try:
        yield
    except OSError as error:
        raise OutputFailed(f"cannot write {target}: {error.strerror}") from error


def make_folder(folder):
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)


def write(out, path, text):
    """Writes a file, in place of the one that is there, or to which a link there leads."""
    make_folder((out / path).parent)
    with writing(out / path):
        drawing.write_text(pathlib.Path(os.path.realpath(out / path)), legible(text))


def make(request, places, program, beside):
    """Makes the report. `beside` runs work beside the rest."""
    sections = sections_of(request["sections"])
    needed = {group for name in sections for group in SECTIONS[name].groups}
    for folder in ("data", "figures"):
        make_folder(places.out / folder)
    judged = beside.submit(ledger.reproduced, program, places) if "ledger" in needed else None
    asked = Asked(places, program, *(request[name] for name in ("version", "commit", "compiler", "processor", "instruction_set")),
                  curves.Tables(request["version"], request["outputs"]), request["facts"], judged)
    report = {"tribocheck": asked.version, "sections": sections, "findings": [], "not_run": [], "files": []}
    for name in GROUPS:
        if name not in needed:
            continue
        if GROUPS[name].step:
            drawing.show_step(GROUPS[name].step)
        group = group_of(name, asked)
        report[name] = group.data
        report["findings"] += [found for found in group.findings if found["section"] in sections]
        report["not_run"] += group.not_run
        for path, text in group.files:
            if text is not None:  # None: it is there already
                write(places.out, path, text)
            report["files"].append(path)
    drawing.show_step("")
    write(places.out, "report.schema.json", (HERE / "report.schema.json").read_text(encoding="utf-8"))
    write(places.out, "report.json", json.dumps(without_nan(report), indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return {"written": [*report["files"], "report.schema.json", "report.json"], "verdict": terminal.verdict(report)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="that makes the request")
    for name in Places._fields:
        parser.add_argument(name, type=pathlib.Path, help="a folder")
    told = vars(parser.parse_args())
    try:
        with Program(told.pop("program")) as program, concurrent.futures.ThreadPoolExecutor(1) as beside:
            answer = make(json.load(sys.stdin.buffer), Places(**told), program, beside)
    except OutputFailed as failed:
        answer = {"failed": legible(str(failed))}
    except Refused as refused:
        answer = {"refused": str(refused)}
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
