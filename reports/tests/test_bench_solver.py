# SPDX-License-Identifier: Apache-2.0
"""tribocheck bench of somebody's solvers: their rows, the gate by a baseline and by a second solver, and what cannot be timed."""
import json
import os
import pathlib
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import jsonschema

from conformance import junit_suite
from plugins import hertz, lines, moment, plugin
from program import ENVIRONMENT, PROGRAM, TIMEOUT, ProgramTest, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
# A solver that tells its times itself, so that each limit can be tested. HERTZ is the time of an answer in units of 100 µs; 0: no answer.
SUBJECT = """import json, os, sys
for line in sys.stdin:
    q = json.loads(line)
    answer = {"skip": "no"}
    if q.get("function") == "hertz_point" and HERTZ:
        answer = {"radius": 1.0, "seconds": 1e-4 * HERTZ}
    if q.get("function") == "hertz_line":
        answer = {"half_width": 1.0, "seconds": 1e-4}
    MORE
    print(json.dumps({"id": q["id"], **answer}), flush=True)
"""
ROW = "hertz_point/subject/python3 solver.py"
LINE = "hertz_line/subject/python3 solver.py"


def schema(name):
    return json.loads((ROOT / f"reference/schemas/{name}.schema.json").read_text(encoding="utf-8"))


def never_slower(baseline, *rows):
    """The rows of a baseline. The times of `rows` are five times longer, so that no run is slower, however long its control takes."""
    found = json.loads(pathlib.Path(baseline).read_text(encoding="utf-8"))["rows"]
    for row in rows:
        for member in ("least_over_control", "median_over_control"):
            found[row][member] *= 5
    return found


class OfSolvers(ProgramTest):
    def subject(self, hertz_time=1.0, more="pass", name="solver.py"):
        """The command of a subject, whose name in rows is the same in every folder."""
        text = SUBJECT.replace("HERTZ", str(hertz_time)).replace("MORE", more)
        return f"python3 {self.folder.write(name, text)}"

    def bench(self, *arguments, code=0):
        done = run("bench", "--quick", *arguments, cwd=ROOT)
        self.assertEqual(done.code, code, done.err)
        return done

    def document(self, *arguments, code=0):
        chosen = [] if "--filter" in arguments else ["--filter", "^(hertz|gaussian)"]
        found = self.bench("--format", "json", *chosen, *arguments, code=code).json()
        jsonschema.validate(found, schema("bench"), jsonschema.Draft202012Validator)
        return found


class Rows(OfSolvers):
    def test_a_subject_has_a_row_for_each_function_that_it_offers(self):
        found = self.document("--subject", self.subject())
        self.assertEqual([(row["job"], row["family"], row["name"], row["cases"], row["measured"]) for row in found["rows"]],
                         [(job, "subject", "python3 solver.py", cases, "reported over texts/1")
                          for job, cases in (("hertz_point", 32), ("hertz_line", 32))])
        for row in found["rows"]:
            self.assertAlmostEqual(row["ns"], 1e5)
            self.assertLessEqual(row["over_control_low"], row["over_control"])
            self.assertLessEqual(row["over_control"], row["over_control_high"])
            self.assertGreater(row["wall_ns"], 0)
            self.assertIsNone(row["over_base"])
        self.assertEqual((found["left_out"], found["comparison"]), ([], None))

    def test_the_cases_that_have_an_answer_are_timed_alone(self):
        some = "answer = {'error': 'no'} if q.get('load', 0) > 50 else answer"
        found = self.document("--subject", self.subject(more=some), "--filter", "hertz_point")
        row, = found["rows"]
        self.assertTrue(0 < row["cases"] < 32, row)
        self.assertAlmostEqual(row["ns"], 1e5)

    def test_cpu_time_of_all_processes_of_a_subject_counts_where_it_tells_no_times(self):
        untold = "answer.pop('seconds', None); sum(range(2000))"
        command = self.subject(more=untold)
        alone, = self.document("--subject", command, "--filter", "hertz_point")["rows"]
        self.assertEqual(alone["measured"], "process over texts/1")
        behind = f"cat | {command} | cat"
        below, = self.document("--subject", behind, "--filter", "hertz_point")["rows"]
        self.assertGreater(below["ns"], 0.2 * alone["ns"])  # the two `cat` alone would take a twentieth
        self.assertGreater(alone["ns"], 1e3)

    def test_a_plugin_alone_and_two_beside_each_other(self):
        row, *rest = self.document("--alone", "--plugin", plugin("c_plugin"))["rows"]
        self.assertEqual((row["job"], row["family"], row["name"], row["measured"]),
                         ("gaussian_moment", "plugin", "c_plugin", "calls over exponentials/1"))
        self.assertEqual([one["job"] for one in rest], ["hertz_point"])
        found = self.document("--plugin", plugin("c_plugin"), "--plugin", plugin("own_model_plugin"), code=1)
        families = {(row["family"], row["name"]) for row in found["rows"]}
        self.assertEqual(families, {("plugin", "c_plugin"), ("base", "own_model_plugin")})
        gone = {note["row"] for note in found["comparison"]["gone"]}
        self.assertIn("hertz_line/base/own_model_plugin", gone)
        self.assertEqual(found["comparison"]["overall"], "worse")

    def test_a_solver_that_keeps_answers_is_told(self):
        keeps = """kept = globals().setdefault("kept", {{}})
    key = json.dumps([value for name, value in q.items() if name != "id"])
    new = key not in kept
    kept[key] = 1
    answer["seconds"] = 1e-4 * ({time} if new else 1)"""
        report = self.folder.path("speed.xml")
        for time, is_told in ((1.9, False), (2.1, True), (30, True)):
            done = self.bench("--subject", self.subject(more=keeps.format(time=time)), "--filter", "^hertz_point", "--format", "json",
                              "--junit", report)
            said = [f"{ROW}: answers are kept: a new case takes {time} times as long as one that was asked before, and the time told "
                    "is that of kept answers"] if is_told else []
            self.assertEqual(done.json()["kept"], said)
            self.assertEqual(done.err, "".join(f"tribocheck: {one}\n" for one in said))
            self.assertEqual(said, str(junit_suite(report).findtext("system-out") or "").splitlines())

    def test_columns_stand_below_their_names_for_long_names_too(self):
        command = self.subject(name="a_solver_with_a_name_of_more_than_26_signs.py")
        head, units, *rows = self.bench("--subject", command, "--filter", "^hertz").out.splitlines()
        for line in (head, *rows):
            self.assertEqual(len(line), len(rows[0]), line)

    def test_it_needs_no_tribocheck_bench(self):
        alone = self.folder.path("tribocheck")
        shutil.copy(PROGRAM, alone)
        def said(*words):
            return subprocess.run([alone, "bench", "--quick", *words], capture_output=True, text=True, cwd=ROOT, env=ENVIRONMENT,
                                  timeout=TIMEOUT)
        self.assertEqual(said("--subject", self.subject()).returncode, 0)
        self.assertEqual(said("--plugin", plugin("c_plugin"), "--alone", "--filter", "hertz_point").returncode, 0)
        refused = said("--plugin", plugin("c_plugin"))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--alone times the plug-in without it", refused.stderr)


class Gate(OfSolvers):
    """The time that a subject tells is exact, but that of the control is measured and may be off by half. Times therefore differ by a
    large factor here. The exact limits are tested where two subjects are side by side."""

    def setUp(self):
        super().setUp()
        self.path = pathlib.Path(self.folder.path("speed.json"))
        self.bench("--subject", self.subject(), "--baseline", self.path, "--filter", "^hertz", "--update-baseline")
        self.change(rows=never_slower(self.path, LINE))

    def gate(self, *more, code=0, **subject):
        """The comparison, and stderr."""
        done = self.bench("--subject", self.subject(**subject), "--baseline", self.path, "--filter", "^hertz", "--format", "json",
                          *more, code=code)
        verdict = "PASSED, no worse than" if code == 0 else "FAILED, worse than"
        self.assertIn(f"tribocheck: {verdict} {self.path}: ", done.err)
        found = done.json()
        jsonschema.validate(found, schema("bench"), jsonschema.Draft202012Validator)
        self.assertEqual(found["comparison"]["overall"], "no worse" if code == 0 else "worse")
        # "told" is left out: a control that is disturbed for a while is told, and is not red.
        rows = {name: [note["row"] for note in notes if note["row"] != LINE] for name, notes in found["comparison"].items()
                if name in ("worse", "gone", "slower", "better", "new")}
        return {name: keys for name, keys in rows.items() if keys}, done.err

    def change(self, **members):
        self.path.write_text(json.dumps(json.loads(self.path.read_text()) | members))

    def test_the_baseline_says_of_what_it_is(self):
        baseline = json.loads(self.path.read_text())
        jsonschema.validate(baseline, schema("bench-baseline"), jsonschema.Draft202012Validator)
        self.assertEqual(list(baseline), ["schema", "version", "commit", "date", "environment", "rows"])

    def test_what_is_slower_twice_is_red_and_what_is_not_slower_is_not(self):
        found, said = self.gate(hertz_time=5, code=1)
        self.assertEqual(found, {"slower": [ROW]})
        self.assertIn("slower; measuring once more", said)
        found, said = self.gate(hertz_time=0.2)
        self.assertEqual(found, {"better": [ROW]})
        self.assertNotIn("slower", said)

    def test_a_solver_is_slower_from_12_percent_on_and_told_from_5(self):
        before = self.subject(name="before.py")
        for time, code, name in ((1.049, 0, None), (1.051, 0, "told"), (1.119, 0, "told"), (1.121, 1, "slower"), (0.9, 0, "better")):
            done = self.bench("--subject", self.subject(time), "--subject", before, "--filter", "^hertz", "--format", "json", code=code)
            found = done.json()["comparison"]
            self.assertEqual({one for one in ("worse", "gone", "slower", "told", "better", "new") if found[one]}, {name} - {None}, time)
            self.assertEqual("a little slower, not red: hertz_point/subject/" in done.err, name == "told", done.err)

    def test_what_is_faster_is_told_and_written_where_that_is_asked_for(self):
        before = json.loads(self.path.read_text())["rows"]
        self.assertEqual(self.gate("--update-baseline", hertz_time=0.2)[0], {"better": [ROW]})
        after = json.loads(self.path.read_text())["rows"]
        self.assertLess(after[ROW]["median_over_control"], 0.6 * before[ROW]["median_over_control"])
        self.assertEqual(self.gate("--update-baseline", hertz_time=1, code=1)[0], {"slower": [ROW]})
        self.assertEqual(json.loads(self.path.read_text())["rows"][ROW], after[ROW])
        # Times of fewer cases, of another machine, are no times of these cases.
        after[ROW]["cases"] -= 1
        self.change(rows=after, environment={"processor": "another", "compiler": "another"})
        self.gate("--update-baseline", code=1)
        kept = json.loads(self.path.read_text())["rows"]
        self.assertEqual((kept[ROW]["cases"], kept[ROW]["median_over_control"], kept[LINE]), (32, None, after[LINE]))

    def test_a_function_or_cases_that_are_gone_are_red(self):
        self.assertEqual(self.gate(hertz_time=0, code=1)[0], {"gone": [ROW]})
        fewer = "answer = {'skip': 'no'} if q.get('load', 0) > 50 else answer"
        self.assertIn(ROW, self.gate(more=fewer, code=1)[0]["worse"])

    def test_a_time_that_is_known_in_another_way_is_red(self):
        found, said = self.gate(more="answer.pop('seconds', None)", code=1)
        self.assertIn(ROW, found["worse"])
        self.assertIn('measured as "reported over texts/1", is as "process over texts/1"', said)

    def test_a_gate_that_compared_no_time_is_red(self):
        self.change(environment={"processor": "another", "compiler": "another"})
        found, said = self.gate(code=1)
        self.assertEqual(found, {"worse": [""]})
        self.assertIn("times are not comparable: another processor or compiler", said)
        self.assertIn("worse than the baseline: no time was compared", said)

    def test_a_function_that_one_solver_alone_offers_and_a_baseline_beside(self):
        before = self.subject(name="before.py")
        report = self.folder.path("speed.xml")
        found = self.document("--subject", self.subject(0), "--subject", before, "--junit", report, code=1)["comparison"]
        gone = "hertz_point/base/python3 before.py"
        self.assertEqual([note["row"] for note in found["gone"]], [gone])
        names = [one.get("name") for one in junit_suite(report).iter("testcase")]
        self.assertEqual((names.count(gone), len(names)), (1, 3))
        self.assertEqual((found["base"], found["baseline"], found["timed"]), (before, None, 1))
        found = self.document("--subject", before, "--subject", self.subject(0))["comparison"]
        self.assertEqual([note["row"] for note in found["new"]], ["hertz_point/subject/python3 before.py"])
        found = self.document("--subject", self.subject(), "--subject", before, "--filter", "^hertz_point/subject/")["comparison"]
        self.assertEqual((found["timed"], found["new"]), (1, []))
        self.change(environment={"processor": "another", "compiler": "another"})
        found = self.document("--subject", self.subject(), "--subject", before, "--baseline", self.path)["comparison"]
        self.assertEqual((found["timed"], [note["row"] for note in found["worse"]]), (2, []))

    def test_junit_and_markdown_tell_the_same(self):
        report = self.folder.path("speed.xml")
        done = self.bench("--subject", self.subject(5), "--baseline", self.path, "--filter", "^hertz", "--format", "markdown",
                          "--junit", report, code=1)
        self.assertTrue(done.out.startswith("### tribocheck bench: FAILED, worse than "), done.out)
        self.assertIn("| SLOWER |\n", done.out)
        self.assertIn("- **Slower**: hertz\\_point/subject/", done.out)
        suite = xml.etree.ElementTree.parse(report).getroot()
        self.assertEqual((suite.get("name"), suite.get("tests"), suite.get("failures")), ("tribocheck bench", "2", "1"))
        failed, = [one for one in suite if one.find("failure") is not None]
        self.assertEqual(failed.get("name"), ROW)
        self.assertIn("times the control, was", failed.find("failure").get("message"))


class Refusals(OfSolvers):
    def test_what_cannot_be_asked_for(self):
        one, other = "--plugin", plugin("c_plugin")
        for words, said in ((["--alone"], "--alone would be ignored without --plugin"),
                            ([one, other, one, other, "--alone"], "--alone would be ignored beside a second --plugin"),
                            ([one, other, one, other, one, other], "--plugin: 3 are given; allowed: one, or two"),
                            ([one, other, "--subject", "true"], "--plugin"),
                            (["--subject", self.subject(), "--filter", "lost"], "the functions are effective_modulus, "),
                            (["--subject", "no_such_program"], "no program no_such_program is on PATH"),
                            (["--alone", one, "no_such.so"], "there is no file no_such.so"),
                            (["--alone", one, plugin("wrong_version")], "this program knows version 3")):
            self.assert_refused(run("bench", *words), said)

    def test_a_solver_that_cannot_be_timed_is_one_line(self):
        for more, said in (("sys.exit(3)", "exits with code 3 at "), ("raise ValueError('mine')", "ValueError: mine"),
                           ("os.kill(os.getpid(), 9)", "it is killed by signal 9 (SIGKILL, Killed)"),
                           ("q['id'] += '0'", "answers in another order than it was asked"),
                           ("import time; time.sleep(9)", "is stopped, as --timeout is over, at effective_modulus")):
            done = run("bench", "--quick", "--timeout", "2", "--subject", self.subject(more=more), cwd=ROOT)
            self.assert_refused(done, said, code=1)
        self.assert_refused(run("bench", "--subject", self.subject(), "--filter", "^load_sharing", cwd=ROOT),
                            "it offers no function that is asked for", code=1)
        self.assert_refused(run("bench", "--alone", "--plugin", plugin("crashing"), cwd=ROOT), "is killed by signal 6", code=1)


    def test_one_that_cannot_be_timed_is_told_in_the_files_that_a_ci_reads(self):
        speed = self.folder.write("speed.json", "{\n<<<<<<< HEAD\n")
        for words, said, code in (
                (["--subject", "no_such_program"], "no program no_such_program is on PATH", 2),
                (["--subject", self.subject(more="sys.exit(3)", name="ends.py")], "exits with code 3 at ", 1),
                (["--alone", "--plugin", plugin("wrong_version")], "this program knows version 3", 2),
                (["--subject", self.subject(), "--filter", "^load_sharing"], "it offers no function that is asked for", 1),
                (["--subject", self.subject(), "--baseline", speed],
                 f"{speed}: it is broken at line 2, and no JSON: `<<<<<<< HEAD` is a mark of a merge conflict; restore it, for "
                 f"example by git checkout -- {speed}, or write it anew: tribocheck bench --quick --subject ", 2)):
            with self.subTest(said):
                report = self.folder.path("speed.xml")
                done = self.bench(*words, "--format", "markdown", "--junit", report, code=code)
                suite = junit_suite(report)
                self.assertEqual((suite.get("name"), suite.get("tests"), suite.get("errors")), ("tribocheck bench", "1", "1"))
                error = suite.find("testcase[@name='subject']/error").get("message")
                self.assertIn(said, error)
                self.assertEqual(f"tribocheck: {error}\n", done.err)
                self.assertTrue(done.out.startswith("### tribocheck bench: NOTHING WAS JUDGED: "), done.out)

    def test_a_baseline_of_a_newer_version_is_told(self):
        path = pathlib.Path(self.folder.path("speed.json"))
        gate = ["--subject", self.subject(), "--baseline", path, "--filter", "^hertz", "--format", "json"]
        self.bench(*gate, "--update-baseline")
        file = json.loads(path.read_text()) | {"rows": never_slower(path, ROW, LINE)}
        for version in ("0.9.0", file["version"]):
            path.write_text(json.dumps(file | {"version": version}))
            remarks = self.bench(*gate).json()["comparison"]["remarks"]
            self.assertEqual(remarks, [] if version == file["version"] else [
                f"the baseline was written by tribocheck 0.9.0, which is newer than this {file['version']}: what it adds is not "
                "judged"])


class Rates(unittest.TestCase):
    def test_the_counted_ones_are_what_is_promised_and_the_page_tells_them(self):
        rates = json.loads((ROOT / "reference/baselines/bench_rates.json").read_text(encoding="utf-8"))["rates"]
        page = (ROOT / "verification/conformance/README.md").read_text(encoding="utf-8")
        self.assertGreaterEqual(len(rates), 12)
        for one in rates:
            red = one["red"] / one["runs"]
            if one["solver"] == "unchanged":
                self.assertLessEqual(red, 0.01, one)
            elif one["solver"] == "slower_25":
                self.assertGreaterEqual(red, 0.95, one)
            else:
                self.assertGreaterEqual(red + one["told"] / one["runs"], 0.95, one)
            self.assertIn(f"| {one['red']} of {one['runs']} ", page)


class PluginHost(ProgramTest):
    def test_a_block_of_questions_is_answered_by_its_time(self):
        asked = [moment(0.5), moment(1.5), "", hertz(), moment(0), "", "no question", "", ""]
        times, mixed, broken, empty = run("plugin-host", "--time", plugin("c_plugin"), stdin=lines(asked)).ended(0).json_lines()
        self.assertEqual((times["answered"], empty), (2, {"answered": 0}))
        self.assertTrue(0 < times["seconds"] < 1e-3 and 0 < times["control"] < 1e-6 and times["wall"] > 0, times)
        self.assertEqual(mixed, {"error": "a block has questions of one function"})
        self.assertIn("error", broken)


if __name__ == "__main__":
    unittest.main()
