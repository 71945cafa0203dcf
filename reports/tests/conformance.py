# SPDX-License-Identifier: Apache-2.0
"""Helpers of the tests that ask subjects: their command lines, altered answers, and checks of JUnit files."""

import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from program import PROGRAM, run

SUBJECTS = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/subjects"
BUILT = pathlib.Path(PROGRAM).parent / "verification/conformance/subjects"
PYTHON = sys.executable


def subject(script, *words):
    return " ".join([PYTHON, "-B", str(SUBJECTS / script), *words])


# A program that answers like a right solver, but changes each answer, and runs other code at its end.
ALTERED = """
import json, math, os, signal, sys
sys.path.insert(0, {folder!r})
import subject
for text in sys.stdin:
    question, answer = json.loads(text), json.loads(subject.answer_text(text))
    name, case = question.get("function"), question["id"]
    {change}
    print(json.dumps(answer), flush=True)
{end}
"""


def altered(folder, change, end="pass", name="altered.py"):
    """The command of an altered solver, whose file stands in the folder."""
    path = folder.write(name, ALTERED.format(folder=str(SUBJECTS / "python_stdlib"), change=change, end=end))
    return f"{PYTHON} -B {path}"


def verify(*arguments):
    return run("verify", *arguments, "--format", "json")


# The elements of JUnit and their attributes in junit-10.xsd of Jenkins' xUnit plug-in; those in capitals are required.
JUNIT = {"testsuite": "NAME TESTS FAILURES ERRORS skipped time", "properties": "", "property": "NAME VALUE",
         "testcase": "NAME classname time", "failure": "message type", "error": "message type", "skipped": "message type", "system-out": "",
         "system-err": ""}


def junit_suite(path):
    """The suite of a JUnit file. Asserts that JUNIT has all its elements and attributes, and that its counts are right."""
    suite = ElementTree.parse(path).getroot()
    for element in suite.iter():
        words = JUNIT[element.tag].split()
        assert set(element.keys()) <= {word.lower() for word in words}, ElementTree.tostring(element)
        assert {word.lower() for word in words if word.isupper()} <= set(element.keys()), ElementTree.tostring(element)
    for attribute, found in (("tests", "testcase"), ("failures", ".//failure"), ("skipped", ".//skipped"), ("errors", ".//error")):
        assert int(suite.get(attribute, 0)) == len(suite.findall(found)), attribute
    return suite


def listed(script):
    done = run_python(SUBJECTS / script, "--list")
    return [line.split("\t")[0] for line in done.splitlines()]


def run_python(*words):
    return subprocess.run([PYTHON, "-B", *map(str, words)], capture_output=True, text=True, check=True,
                          timeout=60).stdout
