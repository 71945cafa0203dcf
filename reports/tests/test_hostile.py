# SPDX-License-Identifier: Apache-2.0
"""verify --subject: hostile and broken subjects."""

import concurrent.futures
import re
import time
import unittest

from conformance import BUILT, PYTHON, SUBJECTS, listed, subject, verify


SILENT = {"exits_at_once", "exits_with_error", "closes_stdin", "closes_stdout"}


class Hostile(unittest.TestCase):
    """Whatever a subject does, each case gets one result, in time, and the rest still runs."""

    def test_each_is_survived(self):
        def asked(behaviour):
            start = time.monotonic()
            result = verify("--subject", subject("hostile/hostile.py", behaviour, "--after", "5"),
                            "--sample", "12", "--case-timeout", "0.7", "--start-timeout", "6", "--timeout", "15")
            return result, time.monotonic() - start
        behaviours = listed("hostile/hostile.py")
        self.assertGreater(len(behaviours), 30)
        with concurrent.futures.ThreadPoolExecutor(8) as pool:  # most of them sleep
            results = dict(zip(behaviours, pool.map(asked, behaviours)))
        for behaviour, (result, seconds) in results.items():
            with self.subTest(behaviour):
                self.assertLess(seconds, 60)
                if behaviour in SILENT:
                    self.assertEqual((result.code, result.out), (2, ""))
                    self.assertIn("--after 5 never answered: it ", result.error_lines[0])
                    continue
                self.assertIn(result.code, (0, 1), result.err)
                verdict = result.json()
                for one in verdict["quantities"]:
                    self.assertEqual(one["asked"], one["held"] + one["failed"] + one["skipped"], one)
                if result.code == 0:  # only behaviour that does the protocol no harm
                    self.assertIn(verdict["overall"], ("complete", "partial"), behaviour)
                    self.assertTrue(re.search("stderr|slow|SIGTERM|sigterm", behaviour), behaviour)

    def test_one_that_cannot_be_started_is_one_line_and_exit_code_2(self):
        hostile = SUBJECTS / "hostile"
        for way, command, words in (
                ("--subject", f"{hostile}/not_executable", "not_executable may not be executed"),
                ("--subject", f"'{hostile}'", "is a folder"),
                ("--subject", "/no/such/program", "there is no file /no/such/program"),
                ("--subject", "no-such-program x.py", "no program no-such-program is on PATH; install it"),
                ("--subject", "A='1 2' exec 'no-such-program' x", "no program no-such-program is on PATH"),
                ("--subject", "cd / && no-such-program", "cannot be started: /bin/sh: 1: no-such-program"),
                ("--subject", "env no-such-program", "cannot be started: env: "),
                ("--plugin", "/no/such.so", "there is no file /no/such.so"),
                ("--plugin", f"{hostile}/not_executable", "not_executable: cannot be loaded")):
            with self.subTest(command):
                result = verify(way, command)
                self.assertEqual((result.code, result.out), (2, ""))
                line, = result.error_lines
                self.assertIn(f"tribocheck: {way}: ", line)
                self.assertIn(words, line)

    def test_what_the_shell_alone_can_read_is_left_to_it(self):
        for command in (f"P={PYTHON}; $P -B {SUBJECTS}/small_python/my_solver.py",
                        f"if true; then {PYTHON} -B {SUBJECTS}/small_python/my_solver.py; fi",
                        f"(\"{PYTHON}\" -B {SUBJECTS}/small_python/my_solver.py)"):
            self.assertIn("R/2 in place of R", verify("--subject", command, "--sample", "5").ended(1, "").out)

    def test_a_plugin_that_crashes_does_not_take_the_run_with_it(self):
        crashing = sorted(BUILT.glob("*crash*.so"))
        self.assertTrue(crashing)
        result = verify("--plugin", str(crashing[0]), "--sample", "20").ended(1)
        of = {one["quantity"]: one for one in result.json()["quantities"]}
        self.assertIn("signal", of["gaussian_moment"]["reason"])
        radius = of["hertz_point.radius"]
        self.assertEqual(radius["skipped"], 0)
        self.assertNotIn("signal", radius["reason"])  # the other functions are asked nevertheless


if __name__ == "__main__":
    unittest.main()
