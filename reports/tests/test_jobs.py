# SPDX-License-Identifier: Apache-2.0
"""verify --jobs: several processes of a subject give the same bytes as one process; durations are told in JSON and JUnit."""

import json
import os
import re
import signal
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import altered, subject
from program import ProgramTest, run, start
from test_processes import SOON, is_running, wait_until

OUTPUTS = ("table", "json", "markdown")
DIES = 'if case in {cases}: print("no " + case, file=sys.stderr, flush=True); os._exit(3)'


class SameBytes(ProgramTest):
    def outputs(self, command, jobs, *options, styles=OUTPUTS):
        """Exit code, stderr and all outputs, without durations and forecasts of durations."""
        junit = self.folder.path("junit.xml")
        told = []
        for style in styles:
            result = run("verify", "--subject", command, "--format", style, "--junit", junit, "--jobs", jobs, *options)
            text = result.out
            if style == "json":
                verdict = json.loads(text)
                del verdict["seconds"]
                text = json.dumps(verdict, indent=1)
            told += [result.code, re.sub(".* cases will take some .*\n", "", result.err), text]
        with open(junit) as file:
            return [*told, re.sub(' time="[^"]*"', "", file.read())]

    def assert_same(self, change, *options, end="pass", styles=OUTPUTS):
        command = altered(self.folder, change, end)
        alone = self.outputs(command, 1, *options, styles=styles)
        for jobs in (2, 7):
            for one, other in zip(alone, self.outputs(command, jobs, *options, styles=styles), strict=True):
                self.assertEqual(one, other, f"{change}; --jobs {jobs}")
        return alone

    def test_of_a_right_solver_and_of_a_wrong_one(self):
        self.assertEqual(self.assert_same("pass", styles=("json",))[0], 0)
        self.assertEqual(self.assert_same('if name == "hertz_point": answer["radius"] *= 1.01', "--sample", "30")[0], 1)

    def test_of_one_that_dies_now_and_then_or_in_a_whole_function(self):
        told = self.assert_same(DIES.format(cases=("e0003", "m0100", "m0101", "h0007", "h0008", "p0000")), "--sample", "200", styles=("table",))
        self.assertRegex(told[2], "The last it wrote to stderr:\n  no [a-z]")
        self.assertRegex(told[2], "It was started [3-7] times")
        whole = self.assert_same('if name == "hertz_point": os._exit(3)', "--sample", "30", styles=("json",))
        self.assertIn('"starts": 4,', whole[2])
        often = self.assert_same('if case[-1] == "7": os._exit(3)', "--sample", "60", styles=("json",))
        self.assertIn('"starts": 25,', often[2])

    def test_of_one_that_hangs(self):
        told = self.assert_same('import time; time.sleep(60 if case in ("e0003", "e0011", "e0020") else 0)', "--sample", "20",
                                "--case-timeout", "2", "--start-timeout", "30", styles=("json",))
        self.assertIn("no answer within 2 s", told[2])

    def test_of_one_that_breaks_the_protocol(self):
        self.assert_same('print("hello " + case)', "--sample", "20", styles=("json",))
        self.assert_same("print(json.dumps(answer))", "--sample", "20", styles=("table",))
        told = self.assert_same("pass", "--sample", "20", end="sys.exit(77)", styles=("table",))
        self.assertIn("exits with code 77 after its last answer", told[2])

    def test_of_one_that_never_answers(self):
        for jobs in (1, 7):
            result = run("verify", "--subject", "exit 3", "--jobs", jobs)
            self.assertEqual((result.code, result.err), (2, "tribocheck: exit 3 never answered: it exits with code 3\n"))


class AtOnce(ProgramTest):
    ALONE = """if "first" not in globals():
        first = 1
        import fcntl
        lock = open({lock!r}, "a")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os._exit(5)
    import time
    time.sleep(0.001)"""
    TOGETHER = """if "first" not in globals():
        first = 1
        import time
        open({folder!r} + f"/ran{{os.getpid()}}", "w").close()
    while case == "e0039" and sum(one.startswith("ran") for one in os.listdir({folder!r})) < 4:
        time.sleep(0.01)"""

    def runs(self):
        """The processes of the subject that have told that they run."""
        return [int(name[3:]) for name in os.listdir(self.folder.name) if name.startswith("ran")]

    def test_as_many_run_as_are_wanted(self):
        # The first process waits in its last case of a function until four processes have run; alone it would wait for ever.
        command = altered(self.folder, self.TOGETHER.format(folder=self.folder.name))
        for jobs, code in (("4", 0), ("3", 1)):
            result = run("verify", "--subject", command, "--sample", "60", "--jobs", jobs, "--case-timeout", "3")
            self.assertEqual(result.code, code, result.out)
            for one in self.runs():
                os.unlink(self.folder.path(f"ran{one}"))

    def test_all_end_by_ctrl_c(self):
        command = altered(self.folder, f"""import time
    open({self.folder.name!r} + f"/ran{{os.getpid()}}", "w").close()
    time.sleep(0.05)""")
        with start("verify", "--subject", command, "--jobs", "3", stdout=subprocess.DEVNULL) as process:
            self.assertTrue(wait_until(lambda: len(self.runs()) == 3, 60))
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(SOON), -signal.SIGINT)
        self.assertTrue(wait_until(lambda: not any(map(is_running, self.runs())), SOON))

    def test_all_lines_of_each_are_counted_to_its_end(self):
        # Each process has ended before all of its lines are read.
        command = altered(self.folder, "pass", end='print(*["the end"] * 3000, sep=chr(10), flush=True); os._exit(0)')
        for jobs in (1, 2):
            result = run("verify", "--subject", command, "--sample", "20", "--jobs", jobs)
            self.assertIn(f"{3000 * jobs} lines", result.out)

    def test_what_runs_only_once_at_a_time_is_asked_nevertheless(self):
        command = altered(self.folder, self.ALONE.format(lock=self.folder.path("lock")))
        told = [run("verify", "--subject", command, "--sample", "20", "--jobs", jobs).out for jobs in ("1", "3")]
        self.assertIn("COMPLETE", told[0])
        self.assertEqual(*told)

    def test_bad_numbers_are_one_line(self):
        for number in ("0", "65", "-1", "two", "1.5"):
            self.assert_refused(run("verify", "--subject", "true", "--jobs", number), "--jobs")

    def test_it_is_refused_where_nobody_is_asked_or_one_case(self):
        for words in ([], ["--show", "h0000"], ["--subject", "true", "--show", "h0000"], ["--save-cases", "-"]):
            self.assert_refused(run("verify", "--jobs", "2", *words), "--jobs would be ignored")


class Durations(ProgramTest):
    def test_json_and_junit_tell_them_and_the_table_does_not(self):
        junit = self.folder.path("junit.xml")
        slow = altered(self.folder, 'if name == "hertz_point":\n        import time\n        time.sleep(0.02)')
        result = run("verify", "--subject", slow, "--sample", "20", "--format", "json", "--junit", junit)
        seconds = result.json()["seconds"]
        of = {one["function"]: one["seconds"] for one in seconds["functions"]}
        self.assertGreater(of["hertz_point"], 0.3)
        self.assertEqual(max(of, key=of.get), "hertz_point")
        self.assertGreater(seconds["run"], sum(of.values()))
        self.assertGreater(seconds["cpu"], 0.01)
        suite = ElementTree.parse(junit).getroot()
        self.assertGreater(float(suite.get("time")), 0.3)
        times = {one.get("name"): float(one.get("time", 0)) for one in suite.iter("testcase")}
        parts = [value for name, value in times.items() if name.startswith("hertz_point.")]
        self.assertEqual(len(set(parts)), 1)
        self.assertAlmostEqual(sum(parts), float(of["hertz_point"]), delta=0.01)
        self.assertNotIn("second", run("verify", "--subject", subject("python_stdlib/subject.py"), "--sample", "3").out)


if __name__ == "__main__":
    unittest.main()
