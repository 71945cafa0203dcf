#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The inventory gate: the checks that ran are those that the manifest lists, each on no fewer cases than listed.

It reads gates/manifest.tsv and the JUnit file of `ctest --output-junit`, which `make test` writes. It is red
if a listed check did not run or was skipped, if a check ran on no case or on fewer than listed, or if a
check ran that is not listed. It is also red if the greatest error/bound of a check fell below a quarter of
the listed one: then a bound was widened, or the code became better and the bound has to be tightened. A
check is a TEST of a C++ program, a Python file or a command. The cases of a TEST are its comparisons, those
of a Python file are its tests, and a command is one case.

  python3 verification/gates/inventory.py build/release/ctest.xml            hold
  python3 verification/gates/inventory.py build/release/ctest.xml --write    make the manifest anew
"""
import argparse
import pathlib
import re
import sys
import typing
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
MANIFEST = HERE / "manifest.tsv"
RAN_LINE = re.compile(r"^Ran (\d+) (?:cases|tests?)\b(?:, the nearest at (\S+) of its bound)?", re.MULTILINE)


# GoogleTest's lines on one test: where it begins, and how it ended.
TEST_LINE = re.compile(r"^\[ RUN      \] (\S+)$(.*?)(?:^\[ +(OK|SKIPPED|FAILED) +\] \1|\Z)", re.MULTILINE | re.DOTALL)

TYPE_LINE = re.compile(r"^\[-+\] \d+ tests? from ((\S+)/\d+), where TypeParam = (.+)$", re.MULTILINE)


class Ran(typing.NamedTuple):
    cases: int
    part_of_bound: float  # the greatest error/bound; 0 where nothing is held to a bound


def ran_on(output):
    """The cases that a check says it ran on; one case where it does not say."""
    counts = RAN_LINE.findall(output)
    if not counts:
        return Ran(1, 0)
    return Ran(sum(int(cases) for cases, _ in counts), max(float(part or 0) for _, part in counts))


def endings(junit):
    """The name of each check, what it printed, and how it ended: OK, FAILED or SKIPPED. A program of
    GoogleTest, which CTest calls concern.program, has the checks concern.Suite.Test."""
    for test in ElementTree.parse(junit).iter("testcase"):
        name = test.get("name").split("  #")[0]
        output = test.findtext("system-out") or ""
        status = {"run": "OK", "fail": "FAILED"}.get(test.get("status"), "SKIPPED")
        tests = TEST_LINE.findall(output) if status != "SKIPPED" else []
        types = {match[1]: match for match in TYPE_LINE.finditer(output)}
        for suite_and_test, printed, ended in tests:
            suite, one = suite_and_test.split(".")
            if suite in types:  # the name that CTest has for it
                _, suite, kind = types[suite].groups()
                one += f"<{kind}>"
            yield f"{name.split('.')[0]}.{suite}.{one}", printed, ended or "FAILED"  # a TEST that crashed has no last line
        if not tests:
            yield name, output, status


def checks_that_ran(junit):
    """Name → Ran of each check. A check that was skipped or not run has no cases."""
    # A failed check ran, too. CTest reports its failure.
    return {name: Ran(0, 0) if ended == "SKIPPED" else ran_on(output) for name, output, ended in endings(junit)}


def read_manifest(path):
    listed = {}
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            name, cases, part = line.split("\t")
            listed[name] = Ran(int(cases), float(part))
    return listed


def write_manifest(path, ran):
    rows = "".join(f"{name}\t{row.cases}\t{row.part_of_bound:.3g}\n" for name, row in sorted(ran.items()))
    path.write_text("# check, the fewest cases it may run on, greatest error/bound among them; "
                    "made by inventory.py --write\n" + rows)


def findings(listed, ran):
    for name, row in sorted(listed.items()):
        if name not in ran:
            yield f"{name}: listed, but it did not run"
        elif ran[name].cases == 0:
            yield f"{name}: skipped, or ran on no case"
        elif ran[name].cases < row.cases:
            yield f"{name}: ran on {ran[name].cases} cases, {row.cases} are listed"
        elif ran[name].part_of_bound < row.part_of_bound / 4:
            yield (f"{name}: the greatest error is {ran[name].part_of_bound:.3g} of its bound, "
                   f"{row.part_of_bound:.3g} is listed: a bound is too wide now")
    for name in sorted(ran.keys() - listed.keys()):
        yield f"{name}: not on the manifest (inventory.py --write puts it there)"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("junit", type=pathlib.Path, help="what ctest --output-junit wrote")
    parser.add_argument("--only", metavar="REGEX", type=re.compile, help="hold these checks alone")
    parser.add_argument("--part", action="store_true", help="only a part of the checks was to run: hold those that did")
    parser.add_argument("--manifest", type=pathlib.Path, default=MANIFEST)
    parser.add_argument("--write", action="store_true", help="make the manifest anew from this run")
    arguments = parser.parse_args()
    try:
        ran = checks_that_ran(arguments.junit)
        if arguments.write:
            empty = [name for name, row in ran.items() if row.cases == 0]
            if empty:
                sys.exit("not written, these ran on no case: " + ", ".join(sorted(empty)))
            write_manifest(arguments.manifest, ran)
        listed = read_manifest(arguments.manifest)
        if arguments.only:
            ran = {name: row for name, row in ran.items() if arguments.only.search(name)}
            listed = {name: row for name, row in listed.items() if arguments.only.search(name)}
    except (OSError, ValueError, ElementTree.ParseError) as error:
        print(f"inventory: {error}", file=sys.stderr)
        return 2
    if arguments.part:
        listed = {name: row for name, row in listed.items() if name in ran}
    if not ran and not listed:
        print("inventory: no check ran")
        return 1
    found = list(findings(listed, ran))
    for line in found:
        print(f"inventory: {line}")
    print(f"inventory: {len(listed)} checks listed, {len(ran)} ran, {sum(row.cases for row in ran.values())} cases")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
