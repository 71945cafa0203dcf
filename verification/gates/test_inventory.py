# SPDX-License-Identifier: Apache-2.0
"""Tests the inventory gate: how it reads CTest's file, and each fault that turns it red."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import inventory
from inventory import Ran


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.junit = pathlib.Path(folder.name) / "ctest.xml"
        self.manifest = pathlib.Path(folder.name) / "manifest.tsv"

    def write_junit(self, *cases):
        rows = "".join(f'<testcase name="{name}" status="{status}"><system-out>{output}</system-out></testcase>'
                       for name, status, output in cases)
        self.junit.write_text(f"<testsuite>{rows}</testsuite>")

    def gate(self, *arguments):
        """The exit code and the output."""
        said = io.StringIO()
        with mock.patch.object(sys, "argv", ["inventory.py", str(self.junit), "--manifest", str(self.manifest),
                                             *arguments]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            try:
                return inventory.main(), said.getvalue()
            except SystemExit as end:
                return end.code, said.getvalue()


class WhatRan(Folder):
    def test_cases_are_what_the_check_says_and_one_where_it_says_nothing(self):
        self.write_junit(("a", "run", "Ran 12 cases, the nearest at 0.25 of its bound\n"),
                         ("b", "run", "Ran 5 tests in 0.1s\n"), ("c", "run", "done\n"),
                         ("d", "run", "Ran 2 cases, the nearest at 0.5 of its bound\nRan 3 cases\n"),
                         ("e", "fail", "Ran 7 cases\n"), ("f", "run", "Ran 0 cases\n"))
        self.assertEqual(inventory.checks_that_ran(self.junit),
                         {"a": Ran(12, 0.25), "b": Ran(5, 0), "c": Ran(1, 0), "d": Ran(5, 0.5), "e": Ran(7, 0),
                          "f": Ran(0, 0)})

    def test_a_program_of_googletest_has_a_check_for_each_of_its_tests(self):
        output = ("[ RUN      ] Film.IsRight\nRan 3 cases, the nearest at 0.5 of its bound\n"
                  "[       OK ] Film.IsRight (1 ms)\n"
                  "[----------] 1 test from Sum/1, where TypeParam = float\n"
                  "[ RUN      ] Sum/1.IsRight\nRan 4 cases\n[       OK ] Sum/1.IsRight (0 ms)\n"
                  "[ RUN      ] Each/Film.IsThin/one\n[  FAILED  ] Each/Film.IsThin/one, where GetParam() = 1 (0 ms)\n"
                  "[ RUN      ] Film.IsSkipped\n[  SKIPPED ] Film.IsSkipped (0 ms)\n"
                  "[ RUN      ] Film.Crashes\nRan 2 cases\nSegmentation fault\n")
        self.write_junit(("analytic.film_test", "fail", output), ("analytic.other_test", "notrun", ""))
        self.assertEqual(inventory.checks_that_ran(self.junit),
                         {"analytic.Film.IsRight": Ran(3, 0.5), "analytic.Sum.IsRight<float>": Ran(4, 0),
                          "analytic.Each/Film.IsThin/one": Ran(1, 0),
                          "analytic.Film.IsSkipped": Ran(0, 0), "analytic.Film.Crashes": Ran(2, 0),
                          "analytic.other_test": Ran(0, 0)})
        self.assertEqual({name for name, _, ended in inventory.endings(self.junit) if ended == "OK"},
                         {"analytic.Film.IsRight", "analytic.Sum.IsRight<float>"})

    def test_what_was_skipped_or_not_run_has_no_cases(self):
        self.write_junit(("a", "notrun", "Ran 12 cases\n"), ("b", "disabled", ""), ("c", "skipped", ""))
        self.assertEqual(set(inventory.checks_that_ran(self.junit).values()), {Ran(0, 0)})


class Findings(unittest.TestCase):
    LISTED = {"a": Ran(10, 0.4), "b": Ran(1, 0)}

    def found(self, **changed):
        return list(inventory.findings(self.LISTED, {**self.LISTED, **changed}))

    def test_the_same_or_more_is_green(self):
        self.assertEqual(self.found(), [])
        self.assertEqual(self.found(a=Ran(11, 0.9)), [])

    def test_one_case_fewer_is_red(self):
        self.assertEqual(self.found(a=Ran(9, 0.4)), ["a: ran on 9 cases, 10 are listed"])

    def test_no_case_is_red(self):
        self.assertEqual(self.found(b=Ran(0, 0)), ["b: skipped, or ran on no case"])

    def test_a_bound_is_too_wide_where_errors_take_less_than_a_quarter_of_what_they_took(self):
        self.assertEqual(self.found(a=Ran(10, 0.101)), [])
        self.assertEqual(len(self.found(a=Ran(10, 0.099))), 1)

    def test_what_did_not_run_and_what_is_not_listed_is_red(self):
        self.assertEqual(list(inventory.findings(self.LISTED, {"b": Ran(1, 0), "c": Ran(1, 0)})),
                         ["a: listed, but it did not run",
                          "c: not on the manifest (inventory.py --write puts it there)"])


class Gate(Folder):
    def test_what_is_written_is_green_and_the_exit_code_follows(self):
        self.write_junit(("a", "run", "Ran 12 cases, the nearest at 0.25 of its bound\n"), ("b", "run", ""))
        self.assertEqual(self.gate("--write")[0], 0)
        self.assertEqual(inventory.read_manifest(self.manifest), {"a": Ran(12, 0.25), "b": Ran(1, 0)})
        self.write_junit(("a", "run", "Ran 11 cases, the nearest at 0.25 of its bound\n"), ("b", "run", ""))
        code, said = self.gate()
        self.assertEqual(code, 1)
        self.assertIn("a: ran on 11 cases, 12 are listed", said)
        self.assertEqual(self.gate("--only", "^b$")[0], 0)
        self.assertEqual(self.gate("--only", "^typo$"), (1, "inventory: no check ran\n"))

    def test_of_a_part_what_ran_is_held_alone(self):
        self.write_junit(("a", "run", "Ran 12 cases\n"), ("b", "run", ""))
        self.gate("--write")
        self.write_junit(("a", "run", "Ran 12 cases\n"))
        self.assertEqual((self.gate()[0], self.gate("--part")[0]), (1, 0))
        self.write_junit(("a", "run", "Ran 11 cases\n"))
        self.assertEqual(self.gate("--part")[0], 1)
        self.write_junit(("c", "run", "Ran 1 cases\n"))
        self.assertIn("c: not on the manifest", self.gate("--part")[1])
        self.write_junit()
        self.assertEqual(self.gate("--part"), (1, "inventory: no check ran\n"))

    def test_no_manifest_is_written_of_a_check_that_ran_on_nothing(self):
        self.write_junit(("a", "run", "Ran 12 cases\n"), ("b", "notrun", ""))
        self.assertIn("these ran on no case: b", self.gate("--write")[0])
        self.assertFalse(self.manifest.exists())

    def test_a_file_that_is_not_there_is_one_line_and_exit_code_2(self):
        code, said = self.gate()
        self.assertEqual((code, len(said.splitlines())), (2, 1))


if __name__ == "__main__":
    unittest.main()
