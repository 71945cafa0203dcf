#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Adds one thing of each kind to a scratch copy of the tree, checks that each is offered where it should be, and says how
many files each takes by hand.

additions.toml has the kinds, their changes and the checks on the built copy. One copy takes all changes and is built once, in
some three minutes on two cores. The exit code is 1 if a change does not apply, the copy does not build, a check fails, or a
kind takes more files by hand than its limit.

  verification/gates/additions/prove.py
  verification/gates/additions/prove.py --count    say the counts, and whether each change still applies; build nothing
  verification/gates/additions/prove.py --only closure --keep
"""
import argparse
import dataclasses
import difflib
import functools
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "verification/gates"))
import scratch  # noqa: E402
ADDITIONS = pathlib.Path(__file__).with_name("additions.toml")
PLACES = ("before", "after", "replace")
FIELDS = {"adds": str, "wanted": int, "limit": int, "hand": list, "texts": list, "made": list, "checks": list}
ASKED = {"contains", "value", "equal", "between"}
CHECK_FIELDS = {"says", "run", "of", "input", "files", "solver", "code", "read", *ASKED}
SCHEMA = "reference/scene.schema.json"
VERIFY = ["verify", "--format", "json"]
NOT_WRITTEN = {"python": "return None", "c": "return TRIBOCHECK_NOT_OFFERED;"}  # what `init` writes in place of a result
ENDINGS = {"python": "py", "c": "c"}


class Red(Exception):
    """Why a change does not apply, or a check fails."""


@dataclasses.dataclass
class Kind:
    name: str
    adds: str
    wanted: int
    limit: int
    hand: list
    texts: list = dataclasses.field(default_factory=list)
    made: list = dataclasses.field(default_factory=list)
    checks: list = dataclasses.field(default_factory=list)

    @property
    def files(self):
        return sorted({change["file"] for change in self.hand})

    @property
    def counted_apart(self):
        return sorted({change["file"] for change in self.texts} | set(self.made))


def read_additions(text):
    """The kinds. Raises ValueError if the text breaks a rule that the head of additions.toml states."""
    kinds = []
    for name, table in tomllib.loads(text).items():
        wrong = [key for key in table if not isinstance(table[key], FIELDS.get(key, ()))]
        missing = {"adds", "wanted", "limit", "hand", "checks"} - set(table)
        if wrong or missing:
            raise ValueError(f"{name}: {', '.join(wrong or sorted(missing))}: {'not a field of a kind' if wrong else 'missing'}")
        kind = Kind(name, **table)
        for change in kind.hand + kind.texts:
            keys = set(change) - {"file"}
            if keys != {"new"} and not (len(keys) == 2 and "find" in keys and keys & set(PLACES)):
                raise ValueError(f"{name}: {change.get('file')}: a change has `new`, or `find` and one of {', '.join(PLACES)}")
        both = set(kind.files) & set(kind.counted_apart)
        if both:
            raise ValueError(f"{name}: {min(both)} is counted by hand and apart")
        for check in kind.checks:
            if not {"says", "run"} <= set(check) <= CHECK_FIELDS or not ASKED & set(check):
                raise ValueError(f"{name}: {check.get('says')}: a check has `says`, `run` and what it asks: {', '.join(sorted(ASKED))}")
        kinds.append(kind)
    return kinds


class Tree:
    """The texts of a tree with changes. They are written to files only by write()."""

    def __init__(self, root):
        self.root = root
        self.texts = {}

    def text(self, file):
        if file not in self.texts and (self.root / file).is_file():
            self.texts[file] = (self.root / file).read_text(encoding="utf-8")
        return self.texts.get(file)

    def apply(self, change):
        file, old = change["file"], self.text(change["file"])
        if "new" in change:
            if old is not None:
                raise Red(f"{file} is there already")
            self.texts[file] = change["new"]
            return
        if old is None:
            raise Red(f"{file} is not there")
        found = change["find"]
        if old.count(found) != 1:
            raise Red(f"{file}: additions.toml puts its change beside a text that stands here {old.count(found)} times, not once; where your "
                      f"own change of this file is right, give additions.toml the new text: {found.strip().splitlines()[0]}")
        self.texts[file] = old.replace(found, change.get("replace", change.get("before", "") + found + change.get("after", "")))

    def write(self, to):
        for file, text in self.texts.items():
            (to / file).parent.mkdir(parents=True, exist_ok=True)
            (to / file).write_text(text, encoding="utf-8")


def added_lines(root, kind):
    """The number of lines that the kind alone adds or changes in its files by hand. Raises Red if a change does not apply."""
    tree, before = Tree(root), Tree(root)
    for change in kind.hand + kind.texts:
        tree.apply(change)
    count = 0
    for file in kind.files:
        old, new = ((one.text(file) or "").splitlines() for one in (before, tree))
        count += sum(line.startswith("+") for line in difflib.ndiff(old, new))
    return count


def problems_of(root, kinds):
    """Why a kind does not apply to the tree, alone or with the others, or takes more files than its limit."""
    together = Tree(root)
    for kind in kinds:
        try:
            added_lines(root, kind)
            for change in kind.hand + kind.texts:
                together.apply(change)
        except Red as red:
            yield f"{kind.name}: {red}"
        if len(kind.files) > kind.limit:
            yield f"{kind.name}: {len(kind.files)} files by hand, at most {kind.limit} are allowed: {', '.join(kind.files)}"


def table_of(root, kinds):
    """The lines of the table: a head, and one line per kind."""
    yield f"{'kind':10}  by hand  limit  wanted  lines  texts and tables"
    for kind in kinds:
        try:
            lines = added_lines(root, kind)
        except Red:
            lines = "-"
        yield (f"{kind.name:10}  {len(kind.files):7}  {kind.limit:5}  {kind.wanted:6}  {lines:5}  {len(kind.counted_apart):16}")


def run(command, code=0, **options):
    """The command's output: (stdout, stdout and stderr). Raises Red if it ends with another exit code than `code`."""
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, errors="replace", **options)
    if done.returncode != code:
        said = done.stdout + done.stderr
        errors = [line for line in said[:-3000].splitlines() if "error" in line][:5]  # they may stand before the end of a build's output
        raise Red("\n".join((f"exit code {done.returncode}, not {code}: {shlex.join(map(str, command))}", *errors, said[-3000:])))
    return done.stdout, done.stdout + done.stderr


def at(value, path):
    """The value at a path of a JSON value, such as 0/film or name=b/film. Raises Red if there is none."""
    for part in path.split("/"):
        key, is_choice, wanted = part.partition("=")
        try:
            if is_choice:
                value = next(one for one in value if one[key] == wanted)
            else:
                value = value[int(part) if isinstance(value, list) else part]
        except (LookupError, TypeError, ValueError, StopIteration):
            raise Red(f"{path}: there is no {part}") from None
    return value


def is_same(one, other):
    if any(isinstance(each, bool) or not isinstance(each, (int, float)) for each in (one, other)):
        return type(one) is type(other) and one == other
    return math.isclose(one, other, rel_tol=1e-9)


def json_in(text):
    """The JSON value of the text, or the list of the values of its lines. Raises Red if the text is neither."""
    try:
        value = json.loads(text)
        return value if isinstance(value, list) or "\n" in text.strip() else [value]  # a single line is a list of one value
    except ValueError:
        pass
    try:
        return [json.loads(line) for line in text.splitlines()]
    except ValueError:
        raise Red(f"this is no JSON: {text[:300]}") from None


def judge(check, text, said):
    """Raises Red if a program's output is not what the check asks. `text` is its stdout; `said` has its stderr, too, for `contains`."""
    place = 0
    for wanted in check.get("contains", ()):
        place = said.find(wanted, place)
        if place < 0:
            raise Red(f"\"{wanted}\" does not stand there, or not behind the others, in\n{said[-3000:]}")
        place += len(wanted)
    if not {"value", "equal", "between"} & set(check):
        return
    told = json_in(text)
    for path, wanted in check.get("value", {}).items():
        if not is_same(at(told, path), wanted):
            raise Red(f"{path} is {at(told, path)}, not {wanted}")
    for path, other in check.get("equal", {}).items():
        if not is_same(at(told, path), at(told, other)):
            raise Red(f"{path} is {at(told, path)}, and {other} {at(told, other)}")
    for path, (least, greatest) in check.get("between", {}).items():
        if not least <= at(told, path) <= greatest:
            raise Red(f"{path} is {at(told, path)}, not from {least} to {greatest}")


class Copy:
    """A copy of the tree with the additions, and its programs."""

    def __init__(self, folder):
        self.folder = folder
        self.tree, self.build = folder / "tree", folder / "build"

    def make(self, kinds):
        """Writes the additions and builds. Then programs of the build write the files anew that are generated."""
        # All kinds stand in one copy: if one of them makes `verify` red, `verify` is red for all.
        self.verify_code = max((check.get("code", 0) for kind in kinds for check in kind.checks if check["run"] == VERIFY), default=0)
        scratch.copy_tree(ROOT, self.tree)
        changed = Tree(self.tree)
        for kind in kinds:
            for change in kind.hand + kind.texts:
                changed.apply(change)
        changed.write(self.tree)
        # The engine is compiled only for AVX2, SSE4 and the plain processor, as for planted faults.
        run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DTRIBOCHECK_TARGETS_LEFT_OUT=HWY_SSSE3|HWY_AVX3|HWY_AVX3_DL",
             "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DTRIBOCHECK_BUILD_REFERENCES=ON",
             "-DTRIBOCHECK_BUILD_TESTS=ON"])
        run(["cmake", "--build", self.build, "-j", str(len(os.sched_getaffinity(0))), "--target", "tribocheck",
             "generate_references", "json_schema_test", "own_model", "own_model_plugin", "tribocheck_python", "tribocheck_octave"])
        made = {file for kind in kinds for file in kind.made}
        if SCHEMA in made:
            run([self.program("json_schema_test")], env={**os.environ, "TRIBOCHECK_UPDATE_SCHEMA": "1"})
        for table in sorted(made - {SCHEMA}):
            run([self.program("generate_references"), self.tree / "reference/exact", "--only", pathlib.Path(table).name])

    def program(self, name):
        places = {"tribocheck": "", "generate_references": "reference/generators", "json_schema_test": "verification/tests",
                  "own_model": "verification/conformance/subjects"}
        return self.build / places.get(name, "") / name  # a path stays as it is

    @functools.cached_property
    def verified(self):
        """The output of `tribocheck verify`, which several kinds ask for."""
        return run([self.program("tribocheck"), *VERIFY], self.verify_code, cwd=self.tree)

    def solver(self, asked, folder):
        """The file of a solver from `init` whose asked function has got a body; in C the library made of it."""
        language, function = asked["language"], asked["function"]
        source = folder / f"solver.{ENDINGS[language]}"
        run([self.program("tribocheck"), "init", "subject", "--language", language, "--out", source], cwd=self.tree)
        text = source.read_text()
        begins = re.search(rf"^(?:def|static int) {function}\(", text, re.MULTILINE)
        if begins is None:
            raise Red(f"`init` does not write a function {function}")
        place = begins.end()
        source.write_text(text[:place] + text[place:].replace(NOT_WRITTEN[language], asked["body"], 1))
        if language == "python":
            return source
        library = folder / "libsolver.so"
        run(["cc", "-O2", "-shared", "-fPIC", "-I", self.tree / "verification/conformance", source, "-o", library])
        return library

    def hold(self, check):
        """Raises Red if the check fails."""
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            folder = pathlib.Path(name)
            for file, text in check.get("files", {}).items():
                (folder / file).write_text(text)
            names = {"{folder}": folder, "{build}": self.build}
            if "solver" in check:
                names["{solver}"] = self.solver(check["solver"], folder)
            words = [functools.reduce(lambda word, one: word.replace(one, str(names[one])), names, word) for word in check["run"]]
            if words == VERIFY:
                text, said = self.verified
            else:
                text, said = run([self.program(check.get("of", "tribocheck")), *words], check.get("code", 0), cwd=self.tree,
                                 input=check.get("input", ""))
            if "read" in check:
                text = said = (folder / check["read"]).read_text(encoding="utf-8")
            judge(check, text, said)


def prove(kinds, folder):
    """Builds a copy, runs all checks, and prints a line for each. Returns whether all are held."""
    copy = Copy(folder)
    copy.make(kinds)
    are_held = True
    for kind in kinds:
        print(f"{kind.name}: {kind.adds}", flush=True)
        for check in kind.checks:
            try:
                copy.hold(check)
                print(f"  held    {check['says']}", flush=True)
            except Red as red:
                are_held = False
                print(f"  FAILED  {check['says']}: {red}", flush=True)
    return are_held


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", action="store_true", help="build nothing")
    parser.add_argument("--only", metavar="KIND", action="append", help="this kind; may be given again")
    parser.add_argument("--keep", action="store_true", help="leave the scratch copy, and say where")
    arguments = parser.parse_args()
    kinds = read_additions(ADDITIONS.read_text(encoding="utf-8"))
    unknown = set(arguments.only or ()) - {kind.name for kind in kinds}
    if unknown:
        parser.error(f"--only: {min(unknown)} is not one of {', '.join(kind.name for kind in kinds)}")
    kinds = [kind for kind in kinds if not arguments.only or kind.name in arguments.only]
    problems = list(problems_of(ROOT, kinds))
    are_held = True
    if not arguments.count and not problems:
        folder = pathlib.Path(tempfile.mkdtemp(prefix="tribocheck-additions-"))
        try:
            are_held = prove(kinds, folder)
        except Red as red:
            problems.append(str(red))
        finally:
            if arguments.keep:
                print(f"scratch copy: {folder}")
            else:
                shutil.rmtree(folder, ignore_errors=True)
    for line in table_of(ROOT, kinds):
        print(line)
    for problem in problems:
        print(f"RED  {problem}")
    if arguments.count:
        print(f"Ran {len(kinds)} cases")  # the inventory reads this
    return 0 if are_held and not problems else 1


if __name__ == "__main__":
    sys.exit(main())
