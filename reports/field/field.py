#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The field's matrix: verdicts on many solvers side by side.

`tribocheck field` starts this script. It reads a folder of verdicts: each is NAME.json, as `tribocheck verify --subject …
--format json` writes it, with NAME.toml beside it. It writes the matrix as a page. A folder of the page's name gets a page and
a badge for each solver, and the matrix as JSON. Exit code 1: a file cannot be written; 2: bad input.
"""
import argparse
import collections
import datetime
import html
import itertools
import json
import pathlib
import re
import shlex
import sys
import tomllib
import typing

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parent / "page/render"))

SCHEMA, VERDICT = "field/1", "verify-subject/1"
# The fields of the file beside a verdict, and whether each is needed.
FIELDS = {"name": True, "language": True, "date": True, "address": False, "commit": False, "licence": False,
          "conventions": False, "asked": False, "group": False}
# A verdict on a quantity, its sign in the matrix and its colour.
STATUSES = {"held": ("●", "holds"), "held in the physical range": ("◕", "holds"), "held in part": ("◑", "differs"),
            "FAILED": ("✗", "fails"), "not offered": ("·", ""), "not asked": (" ", "")}
HELD = ("held", "held in the physical range")
UNJUDGED = ("not offered", "not asked")
# The members of a verdict's lists that are read here, with their types.
NUMBER, OPTIONAL_NUMBER, ANY = int, (int, float, type(None)), object
MEMBERS = {"quantities": {"quantity": str, "status": str, "asked": NUMBER, "held": NUMBER, "failed": NUMBER, "skipped": NUMBER,
                          "worst_relative_error": OPTIONAL_NUMBER, "worst_case": str},
           "examples": {"quantity": str, "case": str, "request": dict, "expected": ANY, "got": ANY, "unit": str, "reason": str},
           "diagnoses": {"quantity": str, "functions": list, "text": str}}
TEXTS = ("subject", "version", "tolerance", "summary", "overall")
# The colour of each verdict on a whole solver, and the meaning of the names of tolerances.
OVERALL = {"complete": "holds", "partial": "holds", "held in the physical range": "holds", "no worse": "differs", "nothing": "absent"}
TOLERANCES = {"engineering": "engineering: 1e-6 of the value, times its condition", "strict": "strict: the certified contracts"}


class Refused(Exception):
    """One line about bad input."""


class Verdict(typing.NamedTuple):
    """The verdict on one version of a solver."""
    stem: str
    about: dict  # the fields of the .toml
    said: dict  # the .json

    @property
    def id(self):
        """The name of its pages and of its badge, which stays the same from one verdict to the next."""
        return re.sub(r"[\W_]+", "_", self.about["name"].lower()).strip("_") or self.stem

    @property
    def cells(self):
        return {one["quantity"]: one["status"] for one in self.said["quantities"]}

    @property
    def counts(self):
        return collections.Counter(self.cells.values())

    def repeat(self, case):
        """The command line that asks the solver this case again."""
        way = "--plugin" if self.said["subject"].endswith(".so") else "--subject"
        asked = self.about.get("asked") or f"tribocheck verify {way} {shlex.quote(self.said['subject'])}"
        tolerance = "" if "--tolerance" in asked else f" --tolerance {shlex.quote(self.said['tolerance'])}"
        return f"{asked}{tolerance if self.said['tolerance'] != 'engineering' else ''} --show {case}"


def read_about(path):
    try:
        about = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise Refused(f"{path}: {error}; allowed: lines such as name = \"My solver\" (texts in quotes) and date = 2026-11-28") from None
    for field, value in about.items():
        if field not in FIELDS:
            raise Refused(f"{path}: {field}: this field is not known; allowed: {', '.join(FIELDS)}")
        if field == "date" and isinstance(value, datetime.date):
            about[field] = value = value.isoformat()
        if not isinstance(value, str) or not value.strip():
            raise Refused(f"{path}: {field}: {value!r}; allowed: a text that is not empty")
    for field, is_needed in FIELDS.items():
        if is_needed and field not in about:
            raise Refused(f"{path}: {field}: it is missing; allowed: a text that is not empty")
    about["date"] = read_date(about["date"], f"{path}: date")
    if not re.match("https?://", about.get("address", "https://")):
        raise Refused(f"{path}: address: {about['address']!r}; allowed: an address that begins with https:// or http://")
    return about


def read_date(text, what):
    try:
        return datetime.date.fromisoformat(text).isoformat()
    except ValueError:
        raise Refused(f"{what}: {text!r}; allowed: a day such as 2026-11-28") from None


def read_verdict(path):
    about = path.with_suffix(".toml")
    if not about.exists():
        raise Refused(f"{path}: {about.name} is missing beside it; it says {', '.join(f for f in FIELDS if FIELDS[f])} of the solver")
    try:
        said = json.loads(path.read_text(encoding="utf-8"), parse_constant=lambda word: None)
        schema = said["schema"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise Refused(f"{path}: it is no JSON of a verdict ({error}); allowed: what tribocheck verify --subject … --format json writes") from None
    if schema != VERDICT:
        raise Refused(f"{path}: schema: {schema!r}; allowed: {VERDICT}, as tribocheck verify --subject … --format json writes it")
    rows = [("", {**dict.fromkeys(MEMBERS, list), **dict.fromkeys(TEXTS, str), "sample": (int, str)}, said)]
    rows += [(part, members, one) for part, members in MEMBERS.items() if isinstance(said.get(part), list) for one in said[part]]
    for part, members, one in rows:
        for member, kind in members.items():
            if not isinstance(one, dict) or member not in one or not isinstance(one[member], kind):
                raise Refused(f"{path}: {part and part + ': '}{member}: it is missing or of another type; allowed: a whole document {VERDICT}")
    for one in said["quantities"]:
        if one["status"] not in STATUSES:
            raise Refused(f"{path}: quantities: status: {one['status']!r}; allowed: {', '.join(STATUSES)}")
    return Verdict(path.stem, read_about(about), said)


def read_folder(folder):
    """The verdicts of each solver, the newest last, in the order of groups and names."""
    if not folder.is_dir():
        raise Refused(f"{folder}: it is not a folder; allowed: a folder with verdicts, NAME.json with NAME.toml beside it")
    solvers = collections.defaultdict(list)
    for path in sorted(folder.glob("*.json")):
        verdict = read_verdict(path)
        same = solvers[verdict.id]
        same.append(verdict)
        if same[0].about["name"] != verdict.about["name"]:
            raise Refused(f"{path.with_suffix('.toml')}: name: {verdict.about['name']!r} and {same[0].about['name']!r} of {same[0].stem}.toml "
                          f"would both be {verdict.id}.html; allowed: one way to write a solver's name")
    for path in folder.glob("*.toml"):
        if not path.with_suffix(".json").exists():
            raise Refused(f"{path}: {path.stem}.json is missing beside it, a verdict as tribocheck verify --subject … --format json writes it")
    if not solvers:
        raise Refused(f"{folder}: it has no verdict; allowed: a folder with NAME.json and NAME.toml")
    for verdicts in solvers.values():
        verdicts.sort(key=lambda one: one.about["date"])
        for one, next_one in zip(verdicts, verdicts[1:]):
            if one.about["date"] == next_one.about["date"]:
                raise Refused(f"{folder}: {one.stem}.toml and {next_one.stem}.toml: both are of {one.about['name']} on "
                              f"{one.about['date']}; allowed: one verdict a solver and day")
    return sorted(solvers.values(), key=lambda all: (all[-1].about.get("group", ""), all[-1].about["name"].lower()))


def changes(before, after):
    """The quantities whose verdict changed: (quantity, before, after)."""
    names = dict.fromkeys([*before.cells, *after.cells])
    return [(name, *both) for name in names
            if len(set(both := [one.cells.get(name, "not asked") for one in (before, after)])) > 1]


def differences(solvers, first, last):
    """The changes between two days, as rows of texts (solver, quantity, verdict then, verdict now), and the names of the solvers
    without a verdict on or before the first day."""
    rows, new = [], []
    for verdicts in solvers:
        then, now = ([one for one in verdicts if one.about["date"] <= day][-1:] for day in (first, last))
        if then:
            rows += [(verdicts[-1].about["name"], *map(str.lower, one)) for one in changes(then[0], now[0])]
        else:
            new.append(verdicts[-1].about["name"])
    return rows, new


def matrix(solvers, version):
    """The document field/1."""
    quantities = dict.fromkeys(name for verdicts in solvers for name in verdicts[-1].cells)
    rows = []
    for verdicts in solvers:
        last = verdicts[-1]
        rows.append({
            "id": last.id, **{field: last.about.get(field) for field in FIELDS}, "tribocheck": last.said["version"],
            "subject": last.said["subject"], "tolerance": last.said["tolerance"], "sample": last.said["sample"],
            "overall": last.said["overall"], "summary": last.said["summary"],
            "cells": {name: last.cells.get(name, "not asked") for name in quantities},
            "numbers": {one["quantity"]: {key: one[key] for key in ("asked", "held", "failed", "skipped", "worst_relative_error", "worst_case")}
                        for one in last.said["quantities"] if one["status"] not in UNJUDGED},
            "causes": [{key: one[key] for key in ("quantity", "functions", "text")} for one in last.said["diagnoses"]],
            "worst": [{**{key: one[key] for key in ("quantity", "case", "request", "expected", "got", "unit", "reason")},
                       "repeat": last.repeat(one["case"])} for one in last.said["examples"]],
            "history": [{"date": one.about["date"], "commit": one.about.get("commit"), "tribocheck": one.said["version"],
                         "overall": one.said["overall"], "counts": dict(one.counts),
                         "changes": [dict(zip(("quantity", "before", "after"), change))
                                     for change in (changes(earlier, one) if earlier else [])]}
                        for earlier, one in zip([None, *verdicts], verdicts)]})
    return {"schema": SCHEMA, "version": version, "quantities": list(quantities), "solvers": rows}


def as_json(document):
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def badge(solver):
    """The text of a badge, and its colour."""
    counts = solver["history"][-1]["counts"]
    held = sum(counts.get(word, 0) for word in HELD)
    offered = sum(counts.values()) - counts.get("not offered", 0)
    colour = "b3001b" if counts.get("FAILED") else "0b6b3a" if held == offered > 0 else "8a4b00"
    return {"schemaVersion": 1, "label": "tribocheck", "message": f"{held} of {offered} held", "color": colour}


def cause_of(solver, quantity):
    """The sentences of the causes of a quantity that failed."""
    return "" if solver["cells"][quantity] != "FAILED" else " ".join(one["text"] for one in solver["causes"] if quantity.split(".")[0] in one["functions"])


def pages(document, name):
    """The texts of all files, by their paths beside the page."""
    import markup
    import render
    import sections
    templates = render.environment(HERE / "templates", {
        "groups": [(group, len(list(those))) for group, those in itertools.groupby(one["group"] for one in document["solvers"])],
        "STATUSES": STATUSES, "HELD": HELD, "OVERALL": OVERALL, "TOLERANCES": TOLERANCES, "UNJUDGED": UNJUDGED, "offered": [
            one for one in document["quantities"] if any(solver["cells"][one] not in UNJUDGED for solver in document["solvers"])],
        "badge": badge, "cause_of": cause_of, "folder": name, **document})
    templates.filters["html"] = lambda text: markup.Markdown(html.escape(str(text)))
    templates.filters["json"] = lambda value: json.dumps(value, ensure_ascii=False)
    templates.filters["tally"] = lambda cells, words: sum(one in words for one in cells.values())

    def page(template, **names):
        text = markup.indices(str(templates.get_template(template).render(names)))
        first, *parts = re.split(r"(?m)^## (.*)\n", text)
        made = [sections.Made(re.sub(r"\W+", "-", title.lower()).strip("-"), title, part, False) for title, part in zip(parts[::2], parts[1::2])]
        return sections.html_of(first, made, more_style=(HERE / "matrix.css").read_text(encoding="utf-8"))
    files = {f"{name}.html": page("matrix.md"), f"{name}/matrix.json": as_json(document)}
    for solver in document["solvers"]:
        stem = f"{name}/{solver['id']}"
        files[f"{stem}.html"] = page("solver.md", solver=solver)
        files[f"{stem}.badge.json"] = json.dumps(badge(solver)) + "\n"
        files[f"{stem}.svg"] = templates.get_template("badge.svg").render(**badge(solver))
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("format", choices=("page", "json"))
    parser.add_argument("days", nargs="*", help="two days: what changed between them is written to stdout in place of the page")
    given = parser.parse_args()
    import drawing
    solvers = read_folder(given.folder)
    if given.days:
        first, last = (read_date(day, "--diff") for day in given.days)
        if first >= last:
            raise Refused(f"--diff: {first} {last}; allowed: two days, the earlier one first")
        rows, new = differences(solvers, first, last)
        for row in [("solver", "quantity", first, last), *rows]:
            print("\t".join(drawing.cleaned(list(row))))
        if new:
            print(f"tribocheck: {len(new)} solvers have no verdict on or before {first} and are left out: {', '.join(new)}", file=sys.stderr)
        return
    document = drawing.cleaned(matrix(solvers, given.version))
    if given.format == "json":
        print(as_json(document), end="")
        return
    if given.out.suffix != ".html":
        raise Refused(f"--out: {given.out}; allowed: a file whose name ends in .html")
    if given.out.with_suffix("").resolve() == given.folder.resolve():
        raise Refused(f"--out: {given.out}: its pages would be written into the folder of the verdicts, {given.folder}; allowed: another name")
    try:
        import cmarkgfm  # noqa: F401
        import jinja2  # noqa: F401
    except ImportError as error:
        sys.exit(print(f"tribocheck: Python's {error.name} is missing (Debian: apt-get install python3-jinja2 python3-cmarkgfm)",
                       file=sys.stderr) or 1)
    for path, text in pages(document, given.out.stem).items():
        path = given.out.parent / path
        path.parent.mkdir(parents=True, exist_ok=True)
        drawing.write_text(path, text)
    print(f"{len(solvers)} solvers side by side: {given.out}")


if __name__ == "__main__":
    try:
        main()
    except Refused as refused:
        sys.exit(print(f"tribocheck: {refused}", file=sys.stderr) or 2)
    except OSError as failed:
        sys.exit(print(f"tribocheck: cannot write {failed.filename}: {failed.strerror}", file=sys.stderr) or 1)
