#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the report's data: report.json with its schema, and data/*.tsv. It needs no package of Python.

`tribocheck report` starts this script. Its arguments are the path of tribocheck, the folders of Places, the fields of Built, and the
sections that are asked for; all sections if none is named. Prints the verdict in short and where the page is. Exit code 1: a
file cannot be written, or the page or a picture is missing; a line on stderr says why. Exit code 2: bad input.
"""
import concurrent.futures
import contextlib
import dataclasses
import json
import math
import os
import pathlib
import subprocess
import sys
import typing

HERE = pathlib.Path(__file__).resolve().parent
MISSING_PACKAGES = 3  # exit code of render.py
sys.path.insert(1, str(HERE.parent / "render"))
import drawing  # noqa: E402
import contacts  # noqa: E402
import curves  # noqa: E402
import ellipse_fits  # noqa: E402
import environment  # noqa: E402
import ledger  # noqa: E402
import line_films  # noqa: E402
import onset_uncertainty  # noqa: E402
import paper  # noqa: E402
import point_films  # noqa: E402
import published  # noqa: E402
import skipped_work  # noqa: E402
import speed  # noqa: E402
import terminal  # noqa: E402
import starved_films  # noqa: E402
import verification  # noqa: E402
import work_precision  # noqa: E402
from group import Group, Missing, Refused, finding, printable  # noqa: E402
from program import Program  # noqa: E402
from section_table import SECTIONS  # noqa: E402

class Maker(typing.NamedTuple):
    make: typing.Callable
    how_to: str = ""  # Markdown: the command that gives the group where it is missing
    step: str = ""  # for the progress line; empty: it takes no time


# In the order of report.json.
GROUPS = {
    "paper": Maker(paper.paper, "", "solving the published scenes"),
    "ledger": Maker(ledger.ledger, "`tribocheck reproduce`", "judging the paper's claims under every reading"),
    "onset_uncertainty": Maker(onset_uncertainty.onset_uncertainty, "`tribocheck sweep` of `reference/published/sweeps`",
                               "drawing onsets within the print precision of the inputs"),
    "contacts": Maker(contacts.contacts, "The checkout's folder `reference/scenes`", "solving the contacts of machines"),
    "line_films": Maker(line_films.line_films, "The checkout's folders `reference/ehl` and `reference/scenes`",
                        "solving films of line contacts"),
    "point_films": Maker(point_films.point_films, "The checkout's folders `reference/ehl` and `reference/scenes`",
                         "judging formulas of circles by solved films"),
    "starved_films": Maker(starved_films.starved_films, "`make paper-films`", "judging closures of starvation by solved films"),
    "certified": Maker(verification.certified, "The checkout's folder `reference/exact`, or `make references`,",
                       "holding the model to the certified tables"),
    "stress": Maker(verification.stress, "`make stress`"),
    "mutants": Maker(verification.mutants, "`make mutants`"),
    "planted_faults": Maker(verification.planted_faults, "`make faults`"),
    "diagnosis": Maker(verification.diagnosis, "`make diagnosis`"),
    "work_precision": Maker(work_precision.work_precision, "`make work-precision`"),
    "ellipse_fits": Maker(ellipse_fits.ellipse_fits, "The file `reference/mistakes.toml`"),
    "skipped_work": Maker(skipped_work.skipped_work, "", "counting work"),
    "gates": Maker(speed.gates, "`make gate-proof`"),
    "sweep_speed": Maker(speed.sweep_speed, "`make bench-sweep`"),
    "environment": Maker(environment.environment),
}


class Places(typing.NamedTuple):
    out: pathlib.Path
    scenes: pathlib.Path  # the published ones
    reference: pathlib.Path  # the folder of exact/, baselines/ and scenes/
    root: pathlib.Path  # the project's folder; "." where there is none
    render: pathlib.Path  # the folder of render.py

    def shown(self, file):
        """A file as provenance names it: relative to the project's root if it lies below."""
        return str(file.relative_to(self.root) if file.is_relative_to(self.root) else file)


@dataclasses.dataclass(frozen=True)
class Asked:
    """The request, and the data that groups share."""
    places: Places
    program: Program
    built: environment.Built
    tables: curves.Tables
    published: list  # the paper's scenes
    ledger: concurrent.futures.Future | None  # takes some seconds; two groups read it


class OutputFailed(Exception):
    pass


def sections_of(names):
    """The sections that are asked for, in the order of the page; all if none is named."""
    for name in names:
        if name not in SECTIONS:
            raise Refused(f"--section: {name} is not one of {', '.join(SECTIONS)}")
    return [name for name in SECTIONS if not names or name in names]


def folder_of(out, sections):
    """The folder to write to. It is `out`, or a folder below it that is named by the sections, if `out` has a report of more
    sections: that report is left alone."""
    asked = sections_of(sections)
    try:
        there = json.loads((out / "report.json").read_text(encoding="utf-8"))["sections"]
        return out / "-".join(asked) if len(there) > len(asked) else out
    except (OSError, ValueError, KeyError, TypeError):
        return out  # no report, or none that can be read


def section_of(group):
    """The section of a group. Of several, it is the one whose first group this is."""
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
    """Writes a file in place of the present one. If that is a link, the file that it leads to is replaced."""
    make_folder((out / path).parent)
    with writing(out / path):
        drawing.write_text(pathlib.Path(os.path.realpath(out / path)), legible(text))


def make(sections, places, built, program, beside):
    """Writes the data. Returns the files, the verdict, and warnings of the scenes. `beside` runs work on another thread."""
    scenes, warnings = published.read(program, places)
    sections = sections_of(sections)
    needed = {group for name in sections for group in SECTIONS[name].groups}
    if "paper" in needed:
        ledger.claims_of(places)
    for folder in ("data", "figures"):
        make_folder(places.out / folder)
    judged = beside.submit(ledger.reproduced, program, places) if "ledger" in needed else None
    outputs = [{"name": name} | one for name, one in scenes[0].about.outputs.items()]
    asked = Asked(places, program, built, curves.Tables(built.version, outputs), scenes, judged)
    report = {"schema": "report/1", "version": built.version, "sections": sections, "findings": [], "not_run": [], "files": []}
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
    return [*report["files"], "report.schema.json", "report.json"], terminal.verdict(report), warnings


def draw(places):
    """Draws the page and its pictures. Returns the files, or None if there is no page; and lines that say why something is missing."""
    done = subprocess.run([sys.executable, "-B", places.render / "render.py", places.out], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, encoding="utf-8", errors="replace")
    if done.returncode == MISSING_PACKAGES:
        return None, [done.stdout.partition("\n")[0] + ": neither page nor pictures can be made"]
    if done.returncode:
        return None, ["render.py failed: see above"]
    told = json.loads(done.stdout)
    return told["written"], told["undrawn"]


def complain(line):
    """Writes a line to stderr. A stderr that is closed or full is no reason to fail."""
    with contextlib.suppress(OSError):
        os.write(2, f"tribocheck: {printable(legible(line))}\n".encode())


def main():
    path, *words = sys.argv[1:]
    places, built, sections = Places(*map(pathlib.Path, words[:5])), environment.Built(*words[5:9]), words[9:]
    try:
        places = places._replace(out=folder_of(places.out, sections))
        with Program(path) as program, concurrent.futures.ThreadPoolExecutor(1) as beside:
            written, verdict, warnings = make(sections, places, built, program, beside)
    except (OutputFailed, Refused) as stopped:
        for line in stopped.args:
            complain(line)
        return 2 if isinstance(stopped, Refused) else 1
    drawn, undrawn = draw(places)
    for line in [*(f"warning: {one}" for one in warnings), *undrawn]:
        complain(line)
    what, page = ("The data", "report.json") if drawn is None else ("The page", "index.html")
    count = len(written) + len(drawn or [])
    page_line = printable(legible(f"{what}: {places.out}/{page} ({count} files in all, data and pictures among them)"))
    sys.stdout.buffer.write(f"{verdict}{page_line}\n".encode())
    return 1 if undrawn else 0


if __name__ == "__main__":
    sys.exit(main())
