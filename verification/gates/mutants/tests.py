# SPDX-License-Identifier: Apache-2.0
"""The tests of a built copy in small parts, and one run of a part with a mutant or without."""
import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import uuid

import schemata
from plant import scratch

LEAST_SECONDS = 15  # the least time limit of a test, because of other work on the machine
RUNNING = set()  # marks of tests that run
CLASSES = """
import sys, unittest
def flat(one):
    for part in one:
        yield from flat(part) if isinstance(part, unittest.TestSuite) else [part]
suite = unittest.defaultTestLoader.loadTestsFromName(sys.argv[1])
print(*dict.fromkeys(type(one).__name__ for one in flat(suite)))
"""


def all_units(copy, tree, left_out=None):
    """CTest's tests in parts: TESTs of GoogleTest, classes of Python files, other tests whole. Tests that match `left_out` need no built program."""
    said = subprocess.run(["ctest", "--test-dir", copy.build, "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    units = []
    for test in json.loads(said)["tests"]:
        properties = {one["name"]: one["value"] for one in test.get("properties", [])}
        if left_out and re.search(left_out, test["name"]):
            continue
        if "command" not in test or "FIXTURES_SETUP" in properties:  # tests make by themselves what a fixture makes before them
            continue
        unit = {"name": test["name"], "test": test["name"], "command": test["command"], "folder": properties.get("WORKING_DIRECTORY", str(copy.build)),
                "environment": dict(one.split("=", 1) for one in properties.get("ENVIRONMENT", []) if "WRITTEN_REPORT" not in one),
                "fails": properties.get("FAIL_REGULAR_EXPRESSION", []), "skips": properties.get("SKIP_REGULAR_EXPRESSION", []),
                "timeout": properties.get("TIMEOUT", 600)}
        if len(test["command"]) == 1 and test["command"][0].endswith("_test"):
            units += [{**unit, "name": f"{test['name']}:{case}", "case": case} for case in cases_of(test["command"][0])]
        elif test["command"][1:4] == ["-B", "-m", "unittest"]:
            done = subprocess.run([test["command"][0], "-B", "-c", CLASSES, test["command"][4]], cwd=tree.moved(unit["folder"]),
                                  env={**os.environ, **tree.environment(unit)}, capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{test['name']}: {done.stderr}")
            module = test["command"][4]
            units += [{**unit, "name": f"{test['name']}:{name}", "command": [*test["command"][:4], "-f", f"{module}.{name}"]}
                      for name in done.stdout.split()]
        else:
            units.append(unit)
    return units


def cases_of(program):
    said = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    suite = ""
    for line in said.splitlines():
        name = line.split("#")[0].strip()
        if line.startswith("  "):
            if "DISABLED_" not in suite + name:
                yield suite + name
        elif name.endswith("."):
            suite = name


def together(units):
    """The parts, with all TESTs of one program joined to one part, the quickest first."""
    joined = {}
    for unit in units:
        if "case" not in unit:
            joined[unit["name"]] = {**unit}
            continue
        whole = joined.setdefault(unit["test"], {**unit, "name": unit["test"], "seconds": 0, "cases": []})
        whole["cases"].append(unit["case"])
        whole["seconds"] += unit["seconds"]
    return sorted(joined.values(), key=lambda unit: unit["seconds"])


def check_named(test, case):
    """The manifest's name of the check, which is a TEST of a program of GoogleTest or the whole test."""
    return f"{test.split('.')[0]}.{case}" if case else test


def check_of(unit, said):
    """The manifest's name of the check at which the part ended."""
    if "cases" not in unit:
        return unit["test"]
    # After a TEST that failed, the next ones are listed as begun and skipped.
    first = re.findall(r"^\[  FAILED  \] ([^\s,]+)", said, re.MULTILINE) or re.findall(r"^\[ RUN      \] (\S+)$", said, re.MULTILINE)[-1:]
    return check_named(unit["test"], first[0] if first else None)


def narrowed(unit, said):
    """The part cut down to the test at which it ended, or None if the output does not tell this test."""
    if "cases" in unit or "case" in unit:
        last = re.findall(r"^\[  FAILED  \] ([^\s,]+)", said, re.MULTILINE)
        return {**unit, "cases": last[:1]} if last else None
    last = re.findall(r"^(?:FAIL|ERROR): (test\w*) \(([\w.]+)\)", said, re.MULTILINE)
    if unit["command"][1:4] != ["-B", "-m", "unittest"] or not last or not last[0][1].endswith(f".{last[0][0]}"):
        return None
    return {**unit, "command": [*unit["command"][:4], "-f", last[0][1]]}


class Tree:
    """A copy of the tree without switches, beside the built copy, for the tests that read files of the tree."""

    def __init__(self, root, copy, folder):
        self.root, self.copy, self.folder = root, copy, folder
        is_new = not folder.is_dir()
        scratch.copy_tree(root, folder)  # again, because a run that was stopped may have left a mutant planted
        if is_new:
            schemata.with_history(root, folder)
        build = folder / "build/release"
        shutil.rmtree(build, ignore_errors=True)
        build.mkdir(parents=True)
        for program in copy.build.iterdir():
            if program.is_file() and os.access(program, os.X_OK):
                os.link(program, build / program.name)
            elif program.is_dir():
                (build / program.name).symlink_to(program)

    def moved(self, text):
        """A path of the built copy as a path of this tree. Libraries and test programs stay where they were built."""
        path = pathlib.Path(text)
        if path.is_absolute() and path.is_relative_to(self.copy.build):
            here = self.folder / "build/release" / path.name
            return str(here if path.parent == self.copy.build and here.is_file() else path)
        return str(self.folder / path.relative_to(self.copy.tree) if path.is_absolute() and path.is_relative_to(self.copy.tree) else text)

    def environment(self, unit):
        return {name: self.moved(value) for name, value in unit["environment"].items()}

    @contextlib.contextmanager
    def planted(self, mutants):
        """Writes those mutants that have no switch into this tree."""
        texts = {one["file"]: (self.root / one["file"]).read_bytes() for one in mutants if not one["switched"]}
        for file, text in texts.items():
            for one in sorted((one for one in mutants if one["file"] == file), key=lambda one: one["begin"], reverse=True):
                text = text[:one["begin"]] + one["replacement"].encode() + text[one["end"]:]
            (self.folder / file).write_bytes(text)
        try:
            yield
        finally:
            for file, text in texts.items():
                (self.folder / file).write_bytes(text)

    def start(self, unit, more, seconds):
        """Runs a part. Returns green, red or hung, and the end of its output. No process that the part started is left."""
        # When memory runs out, the system ends the mutant before any other process.
        command = ["choom", "-n", "1000", "--", *(self.moved(word) for word in unit["command"])]
        cases = unit.get("cases") or ([unit["case"]] if "case" in unit else [])
        if cases:
            command += ["--gtest_filter=" + ":".join(cases), "--gtest_fail_fast"]
        mark = uuid.uuid4().hex
        RUNNING.add(mark)
        with tempfile.TemporaryDirectory(prefix="tribocheck-mutant-", ignore_cleanup_errors=True) as folder:
            os.chmod(folder, 0o755)  # some tests run the program as another user
            environment = {**os.environ, **self.environment(unit), **more, "TMPDIR": folder, "TRIBOCHECK_MUTANT_RUN": mark}
            with open(pathlib.Path(folder) / "said", "w+b") as said:
                process = subprocess.Popen(command, cwd=self.moved(unit["folder"]), env=environment, stdin=subprocess.DEVNULL,
                                           stdout=said, stderr=subprocess.STDOUT, start_new_session=True)
                try:
                    code = process.wait(seconds)
                except subprocess.TimeoutExpired:
                    code = None
                finally:
                    with contextlib.suppress(ProcessLookupError):
                        os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                    if code != 0:
                        end_marked(mark)
                    RUNNING.discard(mark)
                said.seek(0)
                text = said.read().decode(errors="replace")
        if code is None:
            return "hung", text[-20000:]
        skipped = any(re.search(one, text) for one in unit["skips"])
        wrong = code != 0 or any(re.search(one, text) for one in unit["fails"])
        if cases and f"[  PASSED  ] {len(cases)} test" not in text and "SKIPPED" not in text:
            wrong = True  # the program ended early
        return "red" if wrong and not skipped else "green", text[-20000:]

    def run(self, unit, numbers):
        more = {"TRIBOCHECK_MUTANT": ",".join(map(str, numbers))} if numbers else {}
        end, said = self.start(unit, more, min(max(10 * unit["seconds"], LEAST_SECONDS), max(unit["timeout"], 300)))
        return end, check_of(unit, said), narrowed(unit, said) if end == "red" else None

    def cover(self, unit, size, files):
        """Runs a part without a mutant. Returns its time and end, the mutants that it reaches, and the files of this tree that it reads."""
        for file in files:
            path = self.folder / file
            os.utime(path, ns=(0, path.stat().st_mtime_ns))
        with tempfile.NamedTemporaryFile(prefix="tribocheck-reached-") as reached:
            reached.truncate(size)
            start = time.monotonic()
            end, output = self.start(unit, {"TRIBOCHECK_MUTANTS_REACHED": reached.name}, 3 * unit["timeout"])
            seconds = time.monotonic() - start
            found = pathlib.Path(reached.name).read_bytes()
        return {"seconds": round(seconds, 2), "red": end != "green", "output": output,
                "reached": [n for n, how in enumerate(found) if how == 1], "differs": [n for n, how in enumerate(found) if how == 2],
                "read": [file for file in files if (self.folder / file).stat().st_atime_ns != 0]}


def stop(*_):
    """Ends the run and its tests at once. The ledger has all that was found."""
    for mark in list(RUNNING):
        end_marked(mark)
    os._exit(130)


def end_marked(mark):
    """Ends, by their ids, the processes with this mark in their environment. A test may have started them in other sessions."""
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if mark.encode() in (folder / "environ").read_bytes():
                os.kill(int(folder.name), signal.SIGKILL)
