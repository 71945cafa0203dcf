# SPDX-License-Identifier: Apache-2.0
"""verify --subject and --plugin: right solvers hold, wrong ones are named; tolerances, formats, baselines."""

import json
import pathlib
import re
import shlex
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import BUILT, PYTHON, altered, junit_suite, subject, verify
from program import PROGRAM, Folder, ProgramTest, run


def texts(result, kind):
    """The sentences of the changes against the baseline that are "better", "worse", "new" or "gone"."""
    return [one["text"] for one in result.json()["changes"][kind]]


class RightSolvers(unittest.TestCase):
    def test_our_own_model_is_complete_by_each_of_the_three_ways(self):
        verdicts = []
        for way in (["--subject", f"{PROGRAM} stream"], ["--subject", str(BUILT / "own_model")],
                    ["--plugin", str(BUILT / "own_model_plugin.so")]):
            verdict = verify(*way, "--tolerance", "strict").ended(0, "").json()
            # Plug-ins can only be asked about the usual circle: their header has no other contacts.
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
        result = verify("--subject", subject("python_stdlib/subject.py")).ended(0, "")
        self.assertEqual(result.json()["overall"], "complete")
        self.assertEqual(result.json()["diagnoses"], [])

    def test_what_is_skipped_makes_it_partial(self):
        verdict = verify("--plugin", str(BUILT / "c_plugin.so")).ended(0).json()
        self.assertEqual(verdict["overall"], "partial")
        status = {one["quantity"]: one["status"] for one in verdict["quantities"]}
        self.assertEqual(status["hertz_point.radius"], "held")
        self.assertEqual(status["operating_point.film"], "not offered")
        self.assertTrue(verdict["summary"].startswith("PARTIAL: "), verdict["summary"])
        required = verify("--plugin", str(BUILT / "c_plugin.so"), "--require", "operating_point.film").ended(1)
        self.assertIn("required, but not offered: operating_point.film", required.err)
        self.assertEqual(required.json()["overall"], "failed")
        self.assertRegex(required.json()["summary"],
                         "^FAILED: .*; required, but not held: operating_point.film [(]")

    def test_what_is_required_is_held_in_every_case(self):
        # Ways in which a required quantity is not held. With the first change it is held.
        for change, held, status in (("pass", True, "held"),
                                     ("if case == 'e0003': answer = {'id': case, 'skip': 'no'}", False, "held in part"),
                                     ("if name == 'effective_modulus': answer = {'id': case, 'skip': 'no'}", False,
                                      "not offered"),
                                     ("if case == 'e0003': answer['value'] *= 1.1", False, "FAILED")):
            with self.subTest(status=status):
                folder = Folder()
                self.addCleanup(folder.cleanup)
                command = altered(folder, change.replace("e0003", self.modulus_case()))
                result = verify("--subject", command, "--sample", "9", "--require", "effective_modulus",
                                "--require", "hertz_point")
                self.assertEqual(result.code, 0 if held else 1, result.err)
                told = f"required, but {status}: effective_modulus"
                self.assertEqual(told in result.err, not held, result.err)
                self.assertNotIn("hertz_point", result.err)

    def modulus_case(self):
        """The last case of the sample, so that other cases of its quantity hold."""
        lines = run("verify", "--save-cases", "-", "--sample", "9").json_lines()
        return [one["id"] for one in lines if one.get("function") == "effective_modulus"][-1]

    def test_a_sample_is_a_part_of_the_cases(self):
        quantities = verify("--subject", f"{PROGRAM} stream", "--sample", "7").json()["quantities"]
        self.assertEqual({one["asked"] for one in quantities if "operating_point" not in one["quantity"]}, {7})


class Outputs(ProgramTest):
    def test_markdown_and_junit_tell_the_same(self):
        path = self.folder.path("junit.xml")
        result = run("verify", "--subject", subject("small_python/my_solver.py"), "--format", "markdown",
                     "--junit", path).ended(1)
        self.assertIn("| `hamrock_dowson_central` | **FAILED** |", result.out)
        self.assertIn("**Diagnosis.**", result.out)
        self.assertTrue(result.out.startswith("### tribocheck: FAILED: 4 of 99 quantities held"), result.out)
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

    def test_a_subject_that_never_answers_is_told_in_the_files_that_a_ci_reads(self):
        script = self.folder.write("dies.py", "import sys\nprint('no | module', file=sys.stderr)\nsys.exit(3)\n")
        words = self.folder.write("words.py", "while True:\n    input()\n    print('what?', flush=True)\n")
        for way, why in ((["--subject", "no_such_program x"], "no program no_such_program is on PATH"),
                         (["--subject", "cd / && no-such-program"], "cannot be started: /bin/sh: 1: no-such-program"),
                         (["--subject", f"{PYTHON} {script}"], "never answered: it exits with code 3"),
                         (["--subject", f"{PYTHON} {words}", "--start-timeout", "2", "--case-timeout", "1"], "never answered: "),
                         (["--plugin", str(BUILT / "wrong_version.so")], "this program knows version 3")):
            with self.subTest(why=why):
                path = pathlib.Path(self.folder.path("junit.xml"))
                path.unlink(missing_ok=True)
                result = run("verify", *way, "--format", "markdown", "--junit", path).ended(2)
                self.assertIn(why, result.error_lines[0])
                suite = junit_suite(path)
                self.assertEqual((suite.get("tests"), suite.get("errors"), suite.get("failures")), ("1", "1", "0"))
                error = suite.find("testcase[@name='subject']/error").get("message")
                self.assertEqual(f"tribocheck: {error}", result.error_lines[0])
                head, *rest = result.out.splitlines()
                self.assertTrue(head.startswith("### tribocheck verify: NOTHING WAS JUDGED: "), head)
                self.assertIn(why, head.replace("\\", ""))
                if "exits" in why:
                    self.assertEqual(suite.find("system-err").text, "no | module")
                    self.assertIn("  no | module", rest)

    def test_tolerance_of_ones_own(self):
        good = self.folder.write("tolerance.txt", "default 1e-3  # wide\nhamrock_dowson_central 0.5\n")
        verify("--subject", subject("small_python/my_solver.py"), "--tolerance", good).ended(0)
        for text, words in (("film 1e-3\n", "tolerance.txt:1: film is no quantity"),
                            ("default\n", "default needs one number"),
                            ("default 2\n", "above 0 and below 1")):
            path = self.folder.write("tolerance.txt", text)
            self.assertIn(words, verify("--subject", subject("small_python/my_solver.py"), "--tolerance", path).ended(2).err)

    def test_bad_usage(self):
        for arguments, words in (
                (["--subject", ""], "--subject: nothing is given"),
                (["--plugin", ""], "--plugin: nothing is given"),
                (["--subject", "a", "--plugin", "b"], "--subject excludes --plugin"),
                (["--subject", f"{PROGRAM} stream", "--require", "film"], "film is no quantity"),
                (["--subject", f"{PROGRAM} stream", "--tolerance", "loose"], 'tolerance: "loose" is no file that can be read; allowed: engineering, strict, or'),
                (["--subject", f"{PROGRAM} stream", "--baseline", self.folder.path("none.json")],
                 "there is no such baseline"),
                (["--subject", f"{PROGRAM} stream", "--sample", "0"], "--sample"),
                (["--update-baseline", "--subject", "a"], "--update-baseline requires --baseline")):
            self.assertIn(words, run("verify", *arguments).ended(2).err)


SAMPLE = "20"  # cases a function


class Baselines(ProgramTest):
    def setUp(self):
        super().setUp()
        self.path = self.folder.path("baseline.json")

    def gate(self, script, *more):
        return verify("--subject", subject(*script), "--sample", SAMPLE, "--baseline", self.path, *more)

    def test_what_failed_before_may_fail_and_nothing_else(self):
        small = ("small_python/my_solver.py",)
        self.assertEqual(self.gate(small, "--update-baseline").code, 0)  # the new baseline allows what fails
        self.assertEqual(self.gate(small).code, 0)
        worse = self.gate(("fakes/fake.py", "--mistake", "hertz_peak_without_3_2")).ended(1)
        self.assertIn("hertz_point.peak_pressure: was held, is FAILED",
                      "\n".join(texts(worse, "worse")))
        better = self.gate(("python_stdlib/subject.py",)).ended(0)
        self.assertTrue(texts(better, "better"))

    def told(self, script):
        """The verdict of a gate in each format: exit code, last line, head, JSON, JUnit."""
        junit = self.folder.path("junit.xml")
        told = [run("verify", "--subject", subject(*script), "--sample", SAMPLE, "--baseline", self.path,
                    "--format", format, "--junit", junit) for format in ("table", "markdown", "json")]
        code, = {one.code for one in told}
        return (code, told[0].out.splitlines()[-1], told[1].out.splitlines()[0], told[2].json(),
                junit_suite(junit))

    def test_a_gate_that_passes_is_headed_so_in_every_format_and_names_what_failed_before(self):
        small = ("small_python/my_solver.py",)
        self.gate(small, "--update-baseline")
        code, table, markdown, told, junit = self.told(small)
        self.assertEqual(code, 0)
        self.assertTrue(table.startswith(f"PASSED, no worse than {self.path}: 4 of 99 quantities held"), table)
        self.assertIn("1 failed as before (hamrock_dowson_central)", table)
        self.assertTrue(markdown.startswith("### tribocheck: PASSED, no worse than "), markdown)
        self.assertEqual((told["overall"], told["summary"]), ("no worse", table))
        self.assertEqual(told["baseline"], {"file": self.path, "failed_already": ["hamrock_dowson_central"], "lost": []})
        self.assertEqual(told["changes"], {"better": [], "worse": [], "new": [], "gone": []})
        self.assertEqual((junit.get("failures"), junit.findall(".//failure")), ("0", []))
        skipped = junit.find(".//testcase[@name='hamrock_dowson_central']/skipped").get("message")
        self.assertIn("failed as before", skipped)

    def test_a_gate_that_fails_is_red_in_every_format_for_what_is_worse_alone(self):
        self.gate(("fakes/fake.py", "--mistake", "film_radius_in_mm"), "--update-baseline")
        code, table, markdown, told, junit = self.told(("small_python/my_solver.py",))
        self.assertEqual(code, 1)
        self.assertTrue(table.startswith(f"FAILED, worse than {self.path}: 4 of 99"), table)
        self.assertIn("1 failed as before (hamrock_dowson_central)", table)
        self.assertTrue(markdown.startswith("### tribocheck: FAILED, worse than "), markdown)
        self.assertEqual((told["overall"], told["summary"]), ("worse", table))
        red = [case.get("name") for case in junit if case.find("failure") is not None]
        self.assertEqual(red, [one["quantity"] for one in told["changes"]["worse"]])
        self.assertEqual(int(junit.get("failures")), len(red))
        self.assertIn("load_sharing", red)  # held in the baseline, not offered now
        self.assertNotIn("hamrock_dowson_central", red)

    def test_better_new_and_gone_are_told_in_every_format_and_are_not_red(self):
        self.gate(("fakes/fake.py", "--mistake", "film_minimum"), "--update-baseline")
        old = json.loads(pathlib.Path(self.path).read_text())
        del old["quantities"]["hertz_point.radius"]
        rows = {"hamrock_dowson_central": old["quantities"]["hamrock_dowson_central"],
                "hertz_point.approach": old["quantities"]["hertz_point.approach"],
                "hertz_cone": old["quantities"]["hertz_line.half_width"]}
        pathlib.Path(self.path).write_text(json.dumps({**old, "quantities": rows, "version": "0.0.1"}))
        for format in ("table", "markdown", "json"):
            junit = self.folder.path("junit.xml")
            result = run("verify", "--subject", subject("python_stdlib/subject.py"), "--sample", SAMPLE, "--baseline",
                         self.path, "--format", format, "--junit", junit).ended(0)
            out = ElementTree.parse(junit).getroot().find("system-out").text
            for said in (result.out.replace("\\", ""), out):  # Markdown escapes signs
                lists_each = format == "json" and said is not out
                for words in ("hamrock_dowson_central: was FAILED, is held", "effective_modulus: is new, held",
                              "hertz_point.radius: is new, held" if lists_each else "more like it: reduced_radius.radius_x, ",
                              "hertz_cone: is no longer asked by version "):
                    self.assertIn(words, said, format)
        better, = result.json()["changes"]["better"]
        self.assertEqual((better["quantity"], better["fact"], better["before"], better["after"], len(better["cases"])),
                         ("hamrock_dowson_central", "status", "FAILED", "held", int(SAMPLE)))
        self.assertEqual({one["after"] for one in better["cases"]}, {None})
        updated = self.gate(("python_stdlib/subject.py",), "--update-baseline")
        for words in ("baseline improved: hamrock_dowson_central: ", "baseline extended: hertz_point.radius: is new",
                      "baseline shortened: hertz_cone: is no longer asked"):
            self.assertIn(words, updated.err)
        self.assertEqual(texts(self.gate(("python_stdlib/subject.py",)), "new"), [])

    def test_update_takes_what_is_better_and_force_what_is_worse(self):
        right, wrong = ("python_stdlib/subject.py",), ("fakes/fake.py", "--mistake", "film_minimum")
        self.gate(right, "--update-baseline")
        before = pathlib.Path(self.path).read_text()
        self.assertIn("baseline kept: hamrock_dowson_central: was held, is FAILED", self.gate(wrong, "--update-baseline").ended(1).err)
        rows = json.loads(pathlib.Path(self.path).read_text())["quantities"]
        self.assertEqual(rows, json.loads(before)["quantities"])
        forced = self.gate(wrong, "--update-baseline", "--force")
        self.assertIn("baseline lowered: hamrock_dowson_central", forced.err)
        self.assertEqual(self.gate(wrong).code, 0)

    def test_an_update_that_improves_nothing_leaves_the_file_as_it_is(self):
        right, file = ("python_stdlib/subject.py",), pathlib.Path(self.path)
        self.gate(right, "--update-baseline")
        file.write_text(re.sub(r'"date": ".*"', '"date": "2020-02-02"', file.read_text()))
        before = file.read_bytes()
        for more in ([], ["--force"]):
            self.assertIn(f"baseline unchanged: {self.path}", self.gate(right, "--update-baseline", *more).err)
            self.assertEqual(file.read_bytes(), before)
        self.gate(("fakes/fake.py", "--mistake", "film_minimum"), "--update-baseline")
        self.assertEqual(file.read_bytes(), before)
        rows = json.loads(before)
        self.assertEqual(list(rows), ["schema", "version", "commit", "date", "subject", "tolerance", "sample", "losses",
                                      "quantities"])
        self.assertEqual(list(rows["quantities"]), sorted(rows["quantities"]))

    def test_a_file_of_schema_2_is_read_and_becomes_one_of_schema_3_when_it_is_improved(self):
        self.gate(("fakes/fake.py", "--mistake", "film_minimum"), "--update-baseline")
        old = json.loads(pathlib.Path(self.path).read_text())
        old = {"schema": 2, **{name: old[name] for name in ("tolerance", "sample", "subject", "quantities")}}
        pathlib.Path(self.path).write_text(json.dumps(old))
        self.assertEqual(self.gate(("fakes/fake.py", "--mistake", "film_minimum")).code, 0)
        self.assertEqual(self.gate(("fakes/fake.py", "--mistake", "hertz_peak_without_3_2")).code, 1)
        self.gate(("python_stdlib/subject.py",), "--update-baseline")
        self.assertEqual(json.loads(pathlib.Path(self.path).read_text())["schema"], "verify-baseline/3")

    def test_what_is_worse_within_the_tolerance_has_a_diagnosis(self):
        self.hold(altered(self.folder, "pass"), "--update-baseline")
        junit = self.folder.path("junit.xml")
        for change, words in (("answer['value'] *= 1 + 3e-9", "3e-07 % high everywhere. It is off by one factor, 1 + 3e-09, as a "),
                              ("answer['value'] = float(f\"{answer['value']:.8g}\")", "single precision"),
                              ("answer['value'] *= 1 + 1e-14 * (-1) ** int(case[1:].rstrip('d'))", "rounding, and no wrong formula")):
            result = self.hold(altered(self.folder, f'if name == "hamrock_dowson_central": {change}'), "--junit", junit)
            worse, = texts(result, "worse")
            self.assertIn("hamrock_dowson_central: the worst error was ", worse)
            text, = (one["text"] for one in result.json()["diagnoses"])
            self.assertIn("Worse than the baseline, still within the tolerance: hamrock_dowson_central is ", text)
            self.assertIn(words, text)
            self.assertIn(text, junit_suite(junit).find(".//failure").text)

    def test_changes_that_are_alike_are_told_once_with_their_quantities(self):
        self.hold(altered(self.folder, "pass"), "--update-baseline")
        gone = altered(self.folder, 'if name == "hertz_ellipse": answer = {"id": case, "skip": "no"}')
        told = run("verify", "--subject", gone, "--sample", SAMPLE, "--baseline", self.path).out
        self.assertEqual(told.count("was held, is not offered"), 1, told)
        self.assertRegex(told, "(?m)^Worse than the baseline: hertz_ellipse.semi_axis_x: was held, is not offered.*\n  and 5 more like "
                               "it: hertz_ellipse.semi_axis_y, .*, hertz_ellipse.approach$")
        self.assertEqual(len(texts(self.hold(gone), "worse")), 6)

    def test_a_mistake_of_a_helper_is_told_once_with_its_functions(self):
        twice = altered(self.folder, 'question["effective_modulus"] = 2 * question.get("effective_modulus", 0)\n'
                                     '    if name and question["effective_modulus"]: answer = json.loads(subject.answer_text('
                                     'json.dumps(question)))')
        told = [one for one in verify("--subject", twice, "--sample", SAMPLE).json()["diagnoses"]
                if "film-doubled-E'" in one["mistakes"] or one["quantity"] == "hamrock_dowson_central"]
        one, = told
        self.assertEqual(len(one["functions"]), 11, one)
        self.assertEqual(one["text"].count("in place of 2E*"), 1)
        self.assertIn("The same explains the answers of hamrock_dowson_minimum, hamrock_dowson_soft_central, ", one["text"])

    def test_an_answer_that_is_lost_is_named_with_its_reason(self):
        skips = 'if case in {}: answer = {{"id": case, "skip": "no root"}}'
        cases = [one["id"] for one in run("verify", "--save-cases", "-", "--sample", SAMPLE).json_lines()
                 if one.get("function") == "effective_modulus"]
        self.hold(altered(self.folder, "pass"), "--update-baseline")
        lost = altered(self.folder, skips.format([cases[3], cases[5]]))
        junit = self.folder.path("junit.xml")
        result = self.hold(lost, "--junit", junit)
        said = (f"effective_modulus: was held, is held in part; the first case without an answer is {cases[3]}: no root")
        self.assertEqual((result.code, texts(result, "worse")), (1, [said]))
        self.assertEqual(junit_suite(junit).find(".//failure").get("message"), said)
        for style in ("table", "markdown"):
            told = run("verify", "--subject", lost, "--sample", SAMPLE, "--baseline", self.path, "--format", style).out
            self.assertIn(said, told.replace("\\", ""), style)
        self.hold(lost, "--update-baseline", "--force")
        more = self.hold(altered(self.folder, skips.format([cases[2], cases[3], cases[5]])))
        self.assertEqual(texts(more, "worse"), [
            f"effective_modulus: {len(cases) - 2} cases held, {len(cases) - 3} hold; 2 cases had no answer, 3 have none; the first case without an answer is "
            f"{cases[2]}: no root"])

    def test_accuracy_has_a_ratchet(self):
        right = ("python_stdlib/subject.py",)
        self.gate(right, "--update-baseline")
        baseline = json.loads(pathlib.Path(self.path).read_text())
        quantity, row = max(baseline["quantities"].items(), key=lambda one: one[1]["worst_error"])
        worst = row["worst_error"]
        self.assertGreater(worst, 1e-14)
        for part, code in ((3.999, 0), (4.001, 1)):
            row["worst_error"] = worst / part
            pathlib.Path(self.path).write_text(json.dumps(baseline))
            result = self.gate(right)
            self.assertEqual(result.code, code, part)
        self.assertIn(f"{quantity}: the worst error was {worst / 4.001:.3g}",
                      "\n".join(texts(result, "worse")))

    def test_a_file_that_is_no_baseline(self):
        right = ("python_stdlib/subject.py",)
        for text, words in (("{}", "no baseline of"), ("null", "no baseline of"),
                            ('{"schema": 1, "quantities": {}, "tolerance": "engineering"}', "of schema 1"),
                            ('{"schema": "verify-baseline/4", "quantities": {}}', "of schema 4, and this program has 3"),
                            ('{"schema": "bench-baseline/3", "quantities": {}}', "no baseline of"),
                            (f'{{"schema": 2, "quantities": {{"gaussian_moment": 1}}, "sample": {SAMPLE}, '
                             '"tolerance": {"default": 1e-6}}', "type")):
            pathlib.Path(self.path).write_text(text)
            result = self.gate(right)
            self.assertEqual((result.code, result.out), (2, ""), text)
            line, = result.error_lines
            self.assertIn(words, line)
            renewal = line.partition("; this makes it anew: tribocheck ")[2]
            self.assertEqual(run(*shlex.split(renewal)).code, 0, line)
            self.assertEqual(self.gate(right).code, 0)

    def test_a_broken_file_is_to_be_restored(self):
        right = ("python_stdlib/subject.py",)
        self.gate(right, "--update-baseline")
        whole = pathlib.Path(self.path).read_text()
        lines = whole.splitlines(keepends=True)
        for text, words in (
                ("no", "at line 1, and no JSON: the line is `no`"),
                ("", "at line 1, and no JSON: it ends too early, after ``"),
                ("".join(lines[:20]), "at line 20, and no JSON: it ends too early, after `"),
                ("".join(lines[:7] + ["<<<<<<< HEAD\n"] + lines[7:]), "at line 8, and no JSON: `<<<<<<< HEAD` is a mark of a merge"),
                ("".join(lines[:7] + [">>>>>>> topic\n"] + lines[7:]), "at line 8, and no JSON: `>>>>>>> topic` is a mark of a merge"),
                (whole.replace('"skipped"', "skipped", 1), "at line 17, and no JSON: the line is `   skipped: 0,`")):
            pathlib.Path(self.path).write_text(text)
            for more in ([], ["--update-baseline"]):
                result = self.gate(right, *more)
                self.assertEqual((result.code, result.out, pathlib.Path(self.path).read_text()), (2, "", text))
                line, = result.error_lines
                self.assertIn(f"{self.path}: it is broken {words}", line)
                self.assertIn(f"; restore it, for example by git checkout -- {self.path}, or write it anew: tribocheck ", line)
        renewal = line.partition(", or write it anew: tribocheck ")[2]
        self.assertEqual(run(*shlex.split(renewal)).code, 0, line)
        self.assertEqual(self.gate(right).code, 0)

    def test_a_file_of_a_newer_version_is_told(self):
        right = ("python_stdlib/subject.py",)
        self.gate(right, "--update-baseline")
        old = json.loads(pathlib.Path(self.path).read_text())
        own = old["version"]
        rows = old["quantities"] | {"hertz_cone": old["quantities"]["hertz_line.half_width"]}
        for version, is_newer in (("0.9.0", True), ("0.10.0", True), ("1.0.0", True), (own, False), ("0.0.9", False), ("x", False)):
            pathlib.Path(self.path).write_text(json.dumps(old | {"version": version} | ({"quantities": rows} if is_newer else {})))
            junit = self.folder.path("junit.xml")
            result = self.gate(right, "--junit", junit)
            said = f"The baseline was written by tribocheck {version}, which is newer than this {own}: what it adds is not judged."
            self.assertEqual((result.code, result.json()["notes"]), (0, [said] if is_newer else []), version)
            self.assertEqual(said in str(junit_suite(junit).findtext("system-out")), is_newer)
            if is_newer:
                self.assertEqual(texts(result, "gone"),
                                 [f"hertz_cone: is not asked yet by version {own}; the baseline is of {version}"])
        pathlib.Path(self.path).write_text(json.dumps(old | {"version": "0.9.0", "schema": "verify-baseline/4"}))
        refused = self.gate(right).ended(2)
        self.assertIn(f"of schema 4, and this program has 3; tribocheck 0.9.0 wrote it, which is newer than this {own}; this makes",
                      refused.err)

    def test_it_is_tied_to_what_the_tolerances_say_and_not_to_their_file(self):
        right = ("python_stdlib/subject.py",)
        text = "gaussian_moment 1e-3\nhertz_point.radius 1e-6\n"
        spelt = self.folder.write("t.txt", text)
        self.gate(right, "--tolerance", spelt, "--update-baseline")
        other = self.folder.write("other.txt", "default 1e-6  # as it is\ngaussian_moment 0.001\n")
        for same in (spelt, self.folder.path("./t.txt"), other):
            self.assertEqual(self.gate(right, "--tolerance", same).code, 0, same)
        self.folder.write("t.txt", text.replace("1e-3", "2e-3"))
        for changed in (["--tolerance", spelt], ["--tolerance", "strict"], []):
            self.assertIn("it was made with the tolerance ", self.gate(right, *changed).ended(2).err)
        result = verify("--subject", subject(*right), "--tolerance", other, "--sample", "19", "--baseline", self.path)
        self.assertIn(f"it was made with the sample {SAMPLE}, and this is 19", result.err)

    def film_times(self, factor, only="True"):
        return altered(self.folder, f'if name == "hamrock_dowson_central" and ({only}): answer["value"] *= {factor}')

    def hold(self, command, *more):
        return verify("--subject", command, "--sample", SAMPLE, "--baseline", self.path, *more)

    def test_what_failed_may_become_four_times_as_wrong_and_no_more(self):
        self.hold(self.film_times(1.01), "--update-baseline")
        row = json.loads(pathlib.Path(self.path).read_text())["quantities"]["hamrock_dowson_central"]
        self.assertEqual((len(row["failed"]), row["held"]), (int(SAMPLE), 0))
        for error in row["failed"].values():
            self.assertAlmostEqual(error, 0.01, delta=1e-9)
        for factor in (1.01, 0.99, 1.0399, 0.9601, 1.0025):
            result = self.hold(self.film_times(factor))
            self.assertEqual((result.code, result.json()["overall"]), (0, "no worse"), factor)
        for factor in (1.0401, 0.9599, 1e6, 0, -1, "math.inf", "math.nan"):
            result = self.hold(self.film_times(factor))
            self.assertEqual((result.code, result.json()["overall"]), (1, "worse"), factor)
            self.assertIn(f"hamrock_dowson_central: {SAMPLE} cases failed before and are worse by more than 4 times",
                          result.out)

    def test_one_case_of_many_that_becomes_worse_or_fails_anew_is_red(self):
        self.hold(self.film_times(1.01, "case != 'f0000'"), "--update-baseline")
        failed = list(json.loads(pathlib.Path(self.path).read_text())["quantities"]["hamrock_dowson_central"]["failed"])
        for change, words in ((f"(0 if case == '{failed[3]}' else 1.01) if case != 'f0000' else 1",
                               f"the first is {failed[3]}, which was off by 0.01, is off by 1"),
                              ("1.01", "1 case failed that did not before; the first is f0000"),
                              (f"1.01 if case != '{failed[3]}' else 1", "1 case failed that did not")):
            self.assertIn(words, self.hold(self.film_times(change)).ended(1).out)

    def test_a_case_without_an_answer_stays_one_and_others_do_not_become_one(self):
        ways = {"off": 'answer["value"] *= 1.01', "wrong": 'answer["value"] = None',
                "silent": 'answer = {"id": case, "error": "no root"}'}
        commands = {way: f'if name == "hamrock_dowson_central": {change}' for way, change in ways.items()}
        for i, before in enumerate(ways):
            pathlib.Path(self.path).unlink(missing_ok=True)
            self.hold(altered(self.folder, commands[before]), "--update-baseline")
            for k, now in enumerate(ways):
                result = self.hold(altered(self.folder, commands[now]))
                self.assertEqual(result.code, 1 if k > i else 0, f"{before}, {now}: {result.out}")

    def test_a_gate_without_an_answer_is_red(self):
        nothing = altered(self.folder, 'answer = {"id": case, "skip": "no"}')
        self.hold(nothing, "--update-baseline")
        for command in (nothing, subject("python_stdlib/subject.py")):
            result = self.hold(command)
            self.assertEqual((result.code, result.json()["overall"]), (1, "worse"))
            self.assertRegex(result.out, "nothing is (tested|compared)")

    def test_a_baseline_is_looked_at_before_anybody_is_asked(self):
        for text, more in (("{}", []), ('{"schema": 1, "quantities": {}}', ["--update-baseline"])):
            pathlib.Path(self.path).write_text(text)
            self.hold(f"touch '{self.folder.path('asked')}'", *more).ended(2)
            self.assertFalse(pathlib.Path(self.folder.path("asked")).exists())


class Ends(ProgramTest):
    """How a subject ends after its last answer."""

    def test_one_that_ends_badly_has_failed(self):
        for end, words in (("sys.exit(77)", "exits with code 77"), ("sys.exit(1)", "exits with code 1"),
                           ("raise ValueError", "exits with code 1"), ("os._exit(255)", "exits with code 255"),
                           ("os.kill(os.getpid(), signal.SIGKILL)", "137|signal 9")):
            command = altered(self.folder, "pass", end)
            for more in ([], ["--show", "h0000"]):
                result = run("verify", "--subject", command, *(more or ["--sample", "3"])).ended(1)
                self.assertRegex(result.out, f"the protocol was broken: it .*({words}).* after its last answer")

    def test_one_that_ends_well_or_late_has_not(self):
        for end in ("pass", "sys.exit(0)", "import time; time.sleep(0.5)"):
            result = verify("--subject", altered(self.folder, "pass", end), "--sample", "3")
            self.assertEqual((result.code, result.json()["notes"]), (0, []), end)
        result = verify("--subject", altered(self.folder, "pass", "import time; time.sleep(60)"), "--sample", "3",
                        "--case-timeout", "1")
        self.assertEqual((result.code, result.json()["notes"]),
                         (0, ["It did not end when its input had ended, and was killed."]))

    def test_a_baseline_does_not_allow_it(self):
        command, path = altered(self.folder, "pass", "sys.exit(77)"), self.folder.path("baseline.json")
        for more in (["--update-baseline"], []):
            result = verify("--subject", command, "--sample", "3", "--baseline", path, *more).ended(1)
        self.assertIn("exits with code 77 after its last answer", "".join(texts(result, "worse")))


if __name__ == "__main__":
    unittest.main()
