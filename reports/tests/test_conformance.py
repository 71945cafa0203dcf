# SPDX-License-Identifier: Apache-2.0
"""verify --subject and --plugin: right solvers hold, wrong ones are named; tolerances, formats, baselines."""

import json
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import BUILT, PYTHON, subject, verify
from program import PROGRAM, Folder, run


class RightSolvers(unittest.TestCase):
    def test_our_own_model_is_complete_by_each_of_the_three_ways(self):
        verdicts = []
        for way in (["--subject", f"{PROGRAM} stream"], ["--subject", str(BUILT / "own_model")],
                    ["--plugin", str(BUILT / "own_model_plugin.so")]):
            result = verify(*way, "--tolerance", "strict")
            self.assertEqual((result.code, result.err), (0, ""), way)
            verdict = result.json()
            # The header of plug-ins has no words for other contacts than the usual circle.
            left = {one["quantity"] for one in verdict["quantities"] if one["status"] != "held"}
            self.assertEqual(verdict["starts"], 1, way)
            self.assertEqual(verdict["overall"], "partial" if left else "complete", way)
            verdicts.append([one for one in verdict["quantities"] if one["quantity"] not in left])
            self.assertEqual({name.split(".")[0] for name in left},
                             {"operating_point_of_ellipse", "operating_point_of_line",
                              "operating_point_of_other_film"} if way[0] == "--plugin" else set(), way)
        self.assertGreater(len(verdicts[0]), 80)
        self.assertEqual(verdicts[0], verdicts[1])
        usual = [one for one in verdicts[0] if not one["quantity"].startswith("operating_point_of")]
        self.assertEqual(usual, verdicts[2])

    def test_pythons_standard_library_is_enough_for_a_complete_one(self):
        result = verify("--subject", subject("python_stdlib/subject.py"))
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(result.json()["overall"], "complete")
        self.assertEqual(result.json()["diagnoses"], [])

    def test_what_is_skipped_makes_it_partial(self):
        result = verify("--plugin", str(BUILT / "c_plugin.so"))
        self.assertEqual(result.code, 0, result.out)
        verdict = result.json()
        self.assertEqual(verdict["overall"], "partial")
        status = {one["quantity"]: one["status"] for one in verdict["quantities"]}
        self.assertEqual(status["hertz_point.radius"], "held")
        self.assertEqual(status["operating_point.film"], "not offered")
        self.assertTrue(verdict["summary"].startswith("PARTIAL: "), verdict["summary"])
        required = verify("--plugin", str(BUILT / "c_plugin.so"), "--require", "operating_point.film")
        self.assertEqual(required.code, 1)
        self.assertIn("required, but not offered: operating_point.film", required.err)
        self.assertEqual(required.json()["overall"], "failed")
        self.assertRegex(required.json()["summary"],
                         "^FAILED: .*; required, but not held: operating_point.film [(]")

    def test_a_sample_is_a_part_of_the_cases(self):
        quantities = verify("--subject", f"{PROGRAM} stream", "--sample", "7").json()["quantities"]
        self.assertEqual({one["asked"] for one in quantities if "operating_point" not in one["quantity"]}, {7})


class Outputs(unittest.TestCase):
    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.cleanup)

    def test_markdown_and_junit_tell_the_same(self):
        path = self.folder.path("junit.xml")
        result = run("verify", "--subject", subject("small_python/my_solver.py"), "--format", "markdown",
                     "--junit", path)
        self.assertEqual(result.code, 1)
        self.assertIn("| `hamrock_dowson_central` | **FAILED** |", result.out)
        self.assertIn("**Diagnosis.**", result.out)
        self.assertTrue(result.out.startswith("### tribocheck: FAILED: 4 of 86 quantities held"), result.out)
        suite = ElementTree.parse(path).getroot()
        failed = [case.get("name") for case in suite if case.find("failure") is not None]
        self.assertEqual(failed, ["hamrock_dowson_central"])
        self.assertEqual(int(suite.get("failures")), 1)
        self.assertGreater(int(suite.get("skipped")), 5)

    def test_where_nothing_is_offered_junit_is_red_as_the_exit_code_is(self):
        path = self.folder.path("junit.xml")
        run("init", "subject", "--language", "python", "--out", self.folder.path("mine.py"))
        result = verify("--subject", f"{PYTHON} {self.folder.path('mine.py')}", "--junit", path)
        self.assertEqual((result.code, result.json()["overall"]), (1, "nothing"))
        suite = ElementTree.parse(path).getroot()
        self.assertEqual([case.get("name") for case in suite if case.find("failure") is not None], ["anything"])

    def test_tolerance_of_ones_own(self):
        good = self.folder.write("tolerance.txt", "default 1e-3  # wide\nhamrock_dowson_central 0.5\n")
        result = verify("--subject", subject("small_python/my_solver.py"), "--tolerance", good)
        self.assertEqual(result.code, 0, result.out)
        for text, words in (("film 1e-3\n", "tolerance.txt:1: film is no quantity"),
                            ("default\n", "default needs one number"),
                            ("default 2\n", "above 0 and below 1")):
            path = self.folder.write("tolerance.txt", text)
            result = verify("--subject", subject("small_python/my_solver.py"), "--tolerance", path)
            self.assertEqual(result.code, 2)
            self.assertIn(words, result.err)

    def test_bad_usage(self):
        for arguments, words in (
                (["--subject", ""], "--subject: nothing is given"),
                (["--plugin", ""], "--plugin: nothing is given"),
                (["--subject", "a", "--plugin", "b"], "--subject excludes --plugin"),
                (["--subject", f"{PROGRAM} stream", "--require", "film"], "film is no quantity"),
                (["--subject", f"{PROGRAM} stream", "--tolerance", "loose"], "loose: cannot be read"),
                (["--subject", f"{PROGRAM} stream", "--baseline", self.folder.path("none.json")],
                 "there is no such baseline"),
                (["--subject", f"{PROGRAM} stream", "--sample", "0"], "--sample"),
                (["--update-baseline", "--subject", "a"], "--update-baseline requires --baseline")):
            result = run("verify", *arguments)
            self.assertEqual(result.code, 2, arguments)
            self.assertIn(words, result.err)


class Baselines(unittest.TestCase):
    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.cleanup)
        self.path = self.folder.path("baseline.json")

    def gate(self, script, *more):
        return verify("--subject", subject(*script), "--sample", "60", "--baseline", self.path, *more)

    def test_what_failed_before_may_fail_and_nothing_else(self):
        small = ("small_python/my_solver.py",)
        self.assertEqual(self.gate(small, "--update-baseline").code, 1)  # it fails, and is written
        self.assertEqual(self.gate(small).code, 0)
        worse = self.gate(("fakes/fake.py", "--mistake", "hertz_peak_without_3_2"))
        self.assertEqual(worse.code, 1)
        self.assertIn("hertz_point.peak_pressure: was held, is FAILED",
                      "\n".join(worse.json()["baseline"]["worse"]))
        better = self.gate(("python_stdlib/subject.py",))
        self.assertEqual(better.code, 0)
        self.assertTrue(better.json()["baseline"]["better"])

    def told(self, script):
        """What each format says of a gate: exit code, last line, head, JSON, JUnit."""
        junit = self.folder.path("junit.xml")
        told = [run("verify", "--subject", subject(*script), "--sample", "60", "--baseline", self.path,
                    "--format", format, "--junit", junit) for format in ("table", "markdown", "json")]
        code, = {one.code for one in told}
        return (code, told[0].out.splitlines()[-1], told[1].out.splitlines()[0], told[2].json(),
                ElementTree.parse(junit).getroot())

    def test_a_gate_that_passes_is_headed_so_in_every_format_and_names_what_failed_before(self):
        small = ("small_python/my_solver.py",)
        self.gate(small, "--update-baseline")
        code, table, markdown, told, junit = self.told(small)
        self.assertEqual(code, 0)
        self.assertTrue(table.startswith(f"PASSED, no worse than {self.path}: 4 of 86 quantities held"), table)
        self.assertIn("1 failed as before (hamrock_dowson_central)", table)
        self.assertTrue(markdown.startswith("### tribocheck: PASSED, no worse than "), markdown)
        self.assertEqual((told["overall"], told["summary"]), ("no worse", table))
        self.assertEqual(told["baseline"], {"file": self.path, "worse": [], "better": [],
                                            "failed_already": ["hamrock_dowson_central"]})
        self.assertEqual((junit.get("failures"), junit.findall(".//failure")), ("0", []))
        self.assertEqual(int(junit.get("skipped")), len(junit.findall(".//skipped")))
        self.assertEqual(int(junit.get("tests")), len(junit))
        skipped = junit.find(".//testcase[@name='hamrock_dowson_central']/skipped").get("message")
        self.assertIn("failed as before", skipped)

    def test_a_gate_that_fails_is_red_in_every_format_for_what_is_worse_alone(self):
        self.gate(("fakes/fake.py", "--mistake", "film_minimum"), "--update-baseline")
        code, table, markdown, told, junit = self.told(("small_python/my_solver.py",))
        self.assertEqual(code, 1)
        self.assertTrue(table.startswith(f"FAILED, worse than {self.path}: 4 of 86"), table)
        self.assertIn("1 failed as before (hamrock_dowson_central)", table)
        self.assertTrue(markdown.startswith("### tribocheck: FAILED, worse than "), markdown)
        self.assertEqual((told["overall"], told["summary"]), ("worse", table))
        red = [case.get("name") for case in junit if case.find("failure") is not None]
        self.assertEqual(red, [line.split(":")[0] for line in told["baseline"]["worse"]])
        self.assertEqual(int(junit.get("failures")), len(red))
        self.assertIn("load_sharing", red)  # held then, not offered now
        self.assertNotIn("hamrock_dowson_central", red)

    def test_update_takes_what_is_better_and_force_what_is_worse(self):
        right, wrong = ("python_stdlib/subject.py",), ("fakes/fake.py", "--mistake", "film_minimum")
        self.gate(right, "--update-baseline")
        before = pathlib.Path(self.path).read_text()
        kept = self.gate(wrong, "--update-baseline")
        self.assertEqual(kept.code, 1)
        self.assertIn("baseline kept: hamrock_dowson_central: was held, is FAILED", kept.err)
        rows = json.loads(pathlib.Path(self.path).read_text())["quantities"]
        self.assertEqual(rows, json.loads(before)["quantities"])
        forced = self.gate(wrong, "--update-baseline", "--force")
        self.assertIn("baseline lowered: hamrock_dowson_central", forced.err)
        self.assertEqual(self.gate(wrong).code, 0)

    def test_accuracy_has_a_ratchet(self):
        right = ("python_stdlib/subject.py",)
        self.gate(right, "--update-baseline")
        baseline = json.loads(pathlib.Path(self.path).read_text())
        baseline["quantities"]["hamrock_dowson_central"]["worst_relative_error"] = 1e-16
        pathlib.Path(self.path).write_text(json.dumps(baseline))
        result = self.gate(right)
        self.assertEqual(result.code, 1)
        self.assertIn("hamrock_dowson_central: the worst error was 1e-16",
                      "\n".join(result.json()["baseline"]["worse"]))

    def test_a_file_that_is_no_baseline(self):
        for text in ("{}", "no", '{"schema": 1, "quantities": {"x": 1}, "tolerance": "strict"}'):
            pathlib.Path(self.path).write_text(text)
            result = self.gate(("python_stdlib/subject.py",))
            self.assertEqual(result.code, 2, text)
            self.assertIn("baseline.json", result.err)


if __name__ == "__main__":
    unittest.main()
