# SPDX-License-Identifier: Apache-2.0
"""Tests gate.py and measure.py on the command line, with a made-up program and a made-up valgrind. Also tests the real program's output."""
import datetime
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
# The made-up program answers from NAME.json, which lies beside it. At each call for times it adds a line to the file `asked`.
PROGRAM = """#!/usr/bin/python3
import json, os, pathlib, sys
here = pathlib.Path(__file__)
state = json.loads(here.with_suffix(".json").read_text())
words = sys.argv[1:]
scalar = "no FMA" if os.environ.get("GLIBC_TUNABLES") == "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA" else "FMA"
def say(*row):
    print(*row, sep="\\t")
if state.get("fails"):
    sys.exit(state["fails"])
if words == ["--environment"]:
    for row in [["compiler", state["compiler"]], ["libc", "c 1"], ["scalar", scalar], *(["vector", name] for name in state["sets"])]:
        say(*row)
elif words == ["--counters"]:
    for key, counts in state["counters"].items():
        for name, count in counts.items():
            say(*(("curve", scalar) if key == "curve" else key.split(" ")), name, count)
elif words == ["--time", "5", "--set", state["sets"][0]]:
    log = here.parent / "asked"
    turn = log.read_text().split().count(here.stem) if log.exists() else 0
    log.open("a").write(here.stem + "\\n")
    for k in range(5):
        after = 1.2e-5 if turn < state["quiet_from"] else 1e-5
        for name in ("root", "curve"):
            say(name, state["sets"][0] if name == "root" else scalar, state["seconds"][name] * (1 + k / 100), 1e-5 * state["control"], after * state["control"])
elif words == ["--run", "1", "--set", "AVX2"]:
    for name in state["instructions"]:
        say(name, "AVX2" if name == "root" else scalar, 1)
else:
    sys.exit(f"not a mode: {words}")
"""
VALGRIND = """#!/usr/bin/python3
import json, pathlib, subprocess, sys
if sys.argv[1:] == ["--version"]:
    sys.exit(print("valgrind-9"))
options = [word for word in sys.argv[1:] if word.startswith("-")][:5]
program = sys.argv[len(options) + 1:]
assert {"-q", "--tool=callgrind", "--toggle-collect=tribocheck_gate_pass", "--dump-after=tribocheck_gate_pass"} < set(options), options
out = options[4].split("=", 1)[1]
for i, count in enumerate(json.loads(pathlib.Path(program[0]).with_suffix(".json").read_text())["instructions"].values(), 1):
    pathlib.Path(f"{out}.{i}").write_text(f"events: Ir\\ntotals: {count}\\n")
sys.exit(subprocess.run(program).returncode)
"""
STATE = {"compiler": "g++ 12", "sets": ["AVX9", "AVX2"], "quiet_from": 0, "control": 1, "seconds": {"root": 2e-5, "curve": 0.5e-5},
         "counters": {"root AVX9": {"steps": 100, "newton": 0}, "curve": {"evaluations": 7}},
         "instructions": {"root": 100000, "curve": 20000}}


class OnAProgram(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name in ("tools", "without"):
            (self.folder / name).mkdir()
            (self.folder / name / "git").symlink_to("/usr/bin/git")
        (self.folder / "tools/python3").symlink_to("/usr/bin/python3")
        self.write("tools/valgrind", VALGRIND)
        self.now = self.program("now")
        self.baseline = self.folder / "baseline.json"

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        path.chmod(0o755)
        return path

    def program(self, name, **changes):
        (self.folder / f"{name}.json").write_text(json.dumps({**STATE, **changes}))
        return self.write(name, PROGRAM)

    def gate(self, *words, tools="tools"):
        """Runs gate.py and returns its exit code, its lines without times, and its stderr. `tools` is the folder of commands;
        the folder `without` has no valgrind."""
        # GLIBC_TUNABLES is left out, because the made-up program derives its instruction set from it, and all tests may run with it.
        environment = {name: value for name, value in os.environ.items() if name != "GLIBC_TUNABLES"} | {"PATH": str(self.folder / tools)}
        done = subprocess.run([sys.executable, "-B", HERE / "gate.py", *map(str, words)], capture_output=True, text=True, env=environment)
        return done.returncode, re.sub(r"; \d+\.\d s$", "", done.stdout, flags=re.MULTILINE).splitlines(), done.stderr

    def made(self):
        """Writes the baseline of the made-up program and returns its content."""
        self.assertEqual(self.gate(self.now, "--baseline", self.baseline, "--update")[0], 0)
        return json.loads(self.baseline.read_text())

    def held(self, *words, **changes):
        if changes:
            self.program("now", **changes)
        return self.gate(self.now, "--baseline", self.baseline, *words)


class Updates(OnAProgram):
    def test_write_all_that_was_measured(self):
        before = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
        code, lines, errors = self.gate(self.now, "--baseline", self.baseline, "--update")
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(lines, [f"{self.baseline}: 3 rows of counters, 2 rows of instructions, 2 rows of time"])
        found = json.loads(self.baseline.read_text())
        head = subprocess.run(["git", "-C", HERE, "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
        self.assertIn(found.pop("commit"), (head, f"{head}-dirty"))
        self.assertIn(found.pop("date"), (before, datetime.datetime.now(datetime.timezone.utc).date().isoformat()))
        cpu = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
        if cpu:
            self.assertEqual(found["environment"].pop("cpu"), cpu.group(1).strip())
        self.assertEqual(found, {
            "environment": {"valgrind": "valgrind-9", "compiler": "g++ 12", "libc": "c 1", "instruction_sets": ["FMA", "AVX9", "AVX2"]},
            "control_seconds": 1e-5,
            "counters": {"root AVX9": {"steps": 100, "newton": 0}, "curve FMA": {"evaluations": 7}, "curve no FMA": {"evaluations": 7}},
            "instructions": {"root AVX2": 100000, "curve FMA": 20000},
            "time": {"root AVX9": [2, 2.04], "curve FMA": [0.5, 0.51]}})
        begun = [re.match(r'"([^"]*)": ', line) for line in self.baseline.read_text().splitlines()]
        self.assertEqual([one.group(1) for one in begun if one], [
            "commit", "date", "environment", "control_seconds", "counters", "root AVX9", "curve FMA", "curve no FMA", "instructions",
            "root AVX2", "curve FMA", "time", "root AVX9", "curve FMA"])

    def test_have_four_digits(self):
        self.program("now", seconds={"root": 1.234567e-5, "curve": 1e-5})
        self.assertEqual(self.made()["time"]["root AVX9"], [1.235, 1.259])

    def test_count_no_instructions_where_there_is_no_valgrind(self):
        self.assertEqual(self.gate(self.now, "--baseline", self.baseline, "--update", tools="without")[0], 0)
        found = json.loads(self.baseline.read_text())
        self.assertEqual((found["instructions"], found["environment"]["valgrind"]), ({}, None))


class Holds(OnAProgram):
    def setUp(self):
        super().setUp()
        self.made()

    def test_what_did_not_change(self):
        code, lines, errors = self.held()
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(lines, [
            "counters",
            "  passed: 2 workloads",
            "instructions",
            "                                      base         now    change",
            "  root AVX2                         100000      100000    +0.00 %",
            "  curve FMA                          20000       20000    +0.00 %",
            "  passed: 2 workloads",
            "time",
            "  first run                                 base               now    change",
            "  root AVX9                       2.000    2.040    2.000    2.040     +0.0 %",
            "  curve FMA                       0.500    0.510    0.500    0.510     +0.0 %",
            "  passed: 2 workloads",
            "Ran 6 cases"])

    def test_one_more_step_of_work_is_red(self):
        counters = {**STATE["counters"], "root AVX9": {"steps": 101, "newton": 0}}
        code, lines, _ = self.held("--gates", "counters", counters=counters)
        self.assertEqual((code, lines), (1, ["counters", "  RED root AVX9: steps 101, not 100", "  red: 2 workloads", "Ran 2 cases"]))

    def test_more_instructions_are_red_and_fewer_are_told(self):
        code, lines, _ = self.held("--gates", "instructions", instructions={"root": 101001, "curve": 19799})
        self.assertEqual((code, lines), (1, [
            "instructions",
            "                                      base         now    change",
            "  root AVX2                         100000      101001    +1.00 %  RED",
            "  curve FMA                          20000       19799    -1.01 %  fewer: make gate-baseline keeps that",
            "  RED root AVX2: +1.00 % instructions",
            "  red: 2 workloads",
            "Ran 2 cases"]))

    def test_a_time_that_is_longer_twice_is_red(self):
        code, lines, _ = self.held("--gates", "time", seconds={"root": 2.4e-5, "curve": 0.5e-5})
        rows = ["                 base               now    change", "  root AVX9                       2.000    2.040    2.400    2.448    +20.0 %  slower",
                "  curve FMA                       0.500    0.510    0.500    0.510     +0.0 %"]
        self.assertEqual((code, lines), (1, [
            "time", "  first run                " + rows[0], *rows[1:], "  second run               " + rows[0], *rows[1:],
            "  RED root AVX9: slower, twice", "  red: 2 workloads", "Ran 2 cases"]))

    def test_another_compiler_is_not_compared_but_for_counters(self):
        code, lines, _ = self.held(compiler="g++ 13")
        why = "  not held: not comparable: compiler g++ 13, the baseline's g++ 12"
        self.assertEqual((code, lines), (0, ["counters", "  passed: 2 workloads", "instructions", why, "time", why, "Ran 2 cases"]))

    def test_a_control_kernel_of_another_speed_is_not_compared(self):
        code, lines, _ = self.held("--gates", "time", control=1.5, seconds={"root": 3e-5, "curve": 0.75e-5})
        self.assertEqual((code, lines), (0, [
            "time", "  not held: not comparable: the control kernel takes 15.0 µs, 10.0 when the baseline was made: the processor is another one "
            "of the same name, or other programs share it", "Ran 0 cases"]))

    def test_a_machine_without_the_instruction_set_or_a_baseline_says_so(self):
        self.assertEqual(self.held("--gates", "instructions", sets=["AVX9"])[:2],
                         (0, ["instructions", "  not held: this machine has no AVX2", "Ran 0 cases"]))
        self.baseline.write_text("{}")
        self.assertEqual(self.held("--gates", "time")[1][1], "  not held: the baseline has no such rows: make gate-baseline")

    def test_without_valgrind_it_says_so(self):
        code, lines, _ = self.gate(self.now, "--baseline", self.baseline, "--gates", "instructions", tools="without")
        self.assertEqual((code, lines[1]), (0, "  not held: valgrind is not installed"))

    def test_a_program_that_fails_or_is_not_there_is_told_with_code_2(self):
        self.assertEqual(self.gate(self.folder / "lost", "--gates", "counters", "--base", self.now)[2], f"gate.py: {self.folder / 'lost'}: No such file or directory\n")
        self.assertEqual(self.held(fails=3), (2, ["counters"], f"gate.py: {self.now} --environment: exit code 3: \n"))
        self.assertEqual(self.held(fails="no memory")[2], f"gate.py: {self.now} --environment: exit code 1: no memory\n")

    def test_a_base_that_is_another_program_or_a_library_is_told_in_one_line(self):
        library = self.folder / "libmine.so"
        library.write_text("#!/bin/sh\nkill -SEGV $$\n")
        library.chmod(0o755)
        for base, why in ((library, "exit code -11"), ("/bin/true", "it does not tell its compiler"), (self.folder / "lost", "No such file")):
            code, lines, said = self.gate(self.now, "--base", base)
            self.assertEqual((code, lines, said.count("\n")), (2, [], 1), said)
            self.assertIn(f"gate.py: --base: {base} is no tribocheck_gate_kernels", said)
            self.assertIn(why, said)
            self.assertIn("tribocheck bench --plugin YOURS --plugin BEFORE", said)

    def test_a_pass_that_callgrind_did_not_see_is_told(self):
        for counts in ({"root": 100000, "curve": 0}, {"root": 100000}):
            self.assertEqual(self.held("--gates", "instructions", instructions=counts),
                             (2, ["instructions"], "gate.py: callgrind saw no pass\n"))


class Rounds(OnAProgram):
    """Programs run in turn until each workload has enough quiet repetitions."""

    def asked(self, *words):
        self.assertIn(self.gate(self.now, "--gates", "time", *words)[0], (0, 1))
        return (self.folder / "asked").read_text().split()

    def test_are_four_where_all_is_quiet_and_the_first_one_alternates(self):
        self.assertEqual(self.asked("--base", self.program("base")), ["base", "now", "now", "base"] * 2)

    def test_are_as_many_as_are_needed(self):
        self.program("now", quiet_from=7)
        self.assertEqual(self.asked("--base", self.program("base")).count("now"), 9)

    def test_are_sixteen_at_most_and_then_the_machine_is_busy(self):
        self.program("now", quiet_from=99)
        code, lines, _ = self.gate(self.now, "--gates", "time", "--base", self.program("base"))
        self.assertEqual((code, lines[1]), (0, "  not held: not comparable: the machine is busy: 0 quiet repetitions, 9 are needed"))
        self.assertEqual((self.folder / "asked").read_text().split().count("now"), 16)

    def test_another_program_is_the_base_where_it_is_given(self):
        base = self.program("base", counters={**STATE["counters"], "curve": {"evaluations": 8}},
                            instructions={"root": 50000, "curve": 20000}, seconds={"root": 1e-5, "curve": 0.5e-5})
        code, lines, _ = self.gate(self.now, "--base", base, "--baseline", self.folder / "none.json")
        self.assertEqual(code, 1)
        self.assertEqual([line for line in lines if line.startswith("  RED")], [
            "  RED curve FMA: evaluations 7, not 8", "  RED curve no FMA: evaluations 7, not 8", "  RED root AVX2: +100.00 % instructions",
            "  RED root AVX9: slower, twice"])


class Kernels(unittest.TestCase):
    """Tests the real program. Its modes run the same workloads, or a part of them, on the instruction sets of the machine."""
    PROGRAM = os.environ.get("TRIBOCHECK_GATE_KERNELS", "")

    def rows(self, *words):
        done = subprocess.run([self.PROGRAM, *words], capture_output=True, text=True, check=True)
        return [line.split("\t") for line in done.stdout.splitlines()]

    def setUp(self):
        self.scalar = next(value for name, value in self.rows("--environment") if name == "scalar")
        self.sets = [value for name, value in self.rows("--environment") if name == "vector"]

    def test_a_workload_of_batches_runs_on_each_set_and_another_one_once(self):
        found = {}
        for name, where, passes in self.rows("--run", "3"):
            self.assertEqual(passes, "3")
            found.setdefault(name, []).append(where)
        self.assertGreater(len(found), 10)
        for name, where in found.items():
            self.assertIn(where, ([self.scalar], self.sets), name)
        self.assertEqual(found["root_wide"], [self.scalar])
        self.assertEqual(found["root_wide_batch"], self.sets)

    def test_what_is_counted_is_a_part_of_what_runs_and_the_same_each_time(self):
        counted = self.rows("--counters")
        self.assertEqual(counted, self.rows("--counters"))
        self.assertLessEqual({tuple(row[:2]) for row in counted}, {tuple(row[:2]) for row in self.rows("--run", "1")})

    def test_one_workload_and_one_set_can_be_chosen(self):
        last = self.sets[-1]
        self.assertEqual(self.rows("--run", "1", "--workload", "root_wide_batch", "--set", last), [["root_wide_batch", last, "1"]])
        self.assertEqual(self.rows("--run", "1", "--set", last),
                         [row for row in self.rows("--run", "1") if row[1] in (self.scalar, last)])

    def test_times_are_between_two_of_the_control_and_less_than_the_process_took(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        rows = self.rows("--time", "2", "--set", self.sets[0])
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        took = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        keys = [row[:2] for row in self.rows("--run", "1", "--set", self.sets[0])]
        self.assertEqual([row[:2] for row in rows], 2 * keys)
        times = [list(map(float, row[2:])) for row in rows]
        self.assertGreater(min(map(min, times)), 0)
        # Each number is the time of one pass. The process took longer than their sum, because it made many passes.
        self.assertLess(sum(seconds + control for seconds, control, _ in times), took)
        for k in range(len(rows) - 1):
            if k + 1 != len(keys):
                self.assertEqual(rows[k][4], rows[k + 1][3], "the control after one workload is that before the next")

    def test_what_is_not_there_is_told_with_code_2(self):
        for words, said in ((["--workload", "lost"], "no workload lost on any instruction set"),
                            (["--workload", "root_wide_batch", "--set", "lost"], "no workload root_wide_batch on lost")):
            done = subprocess.run([self.PROGRAM, "--counters", *words], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (2, f"tribocheck_gate_kernels: {said}; --counters lists them\n"))
        done = subprocess.run([self.PROGRAM, "--counters", "--lost"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--lost", done.stderr)


if __name__ == "__main__":
    unittest.main()
