# SPDX-License-Identifier: Apache-2.0
"""bench as a gate: a stand-in for tribocheck_bench gives the rows, so that each limit can be tested exactly."""
import json
import shlex
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

from plugins import plugin
from program import ENVIRONMENT, PROGRAM, TIMEOUT, Result, folder_until, run

CONTROL = "moment_5_2/control/std::exp"
MINE = "moment_5_2/plugin/mine"
OTHER = "moment_2/plugin/mine"
OURS = "moment_5_2/tribocheck/scalar"

# This program prints the rows that `rows.json` has for the first or the second run, in Google Benchmark's format. It
# writes the filters that it gets into the file `asked`.
STAND_IN = r"""#!/usr/bin/env python3
import json, os, pathlib, re, sys, time
here = pathlib.Path(__file__).parent
options = dict(word.lstrip("-").split("=", 1) for word in sys.argv[1:])
name = options.get("benchmark_filter", "").replace("all", "")
with open(here / "asked", "a") as file:
    print(name, file=file)
runs = json.loads((here / "rows.json").read_text())
rows = runs[min(len((here / "asked").read_text().splitlines()), len(runs)) - 1]
if not isinstance(rows, dict):
    exec(rows)
    sys.exit()
pattern = name[1:] if name.startswith("-") else name
made = []
for number, (row, values) in enumerate(rows.items()):
    if (re.search(pattern, row) is not None) == (name.startswith("-") and name != ""):
        continue
    run = {"run_name": row, "family_index": number, "points": values.pop("points", 1)}
    if "error" in values:
        made.append({**run, "error_occurred": True, "error_message": values["error"]})
        continue
    counters = {key: value for key, value in values.items() if key not in ("least", "median")}
    for kind, time in ({"run_type": "iteration"}, "least"), ({"run_type": "aggregate", "aggregate_name": "median"}, "median"):
        made.append({**run, **kind, "cpu_time": values[time], **counters})
print(json.dumps({"context": {}, "benchmarks": made}))
"""


def row(median=100.0, least=None, **counters):
    return {"median": median, "least": median if least is None else least, "judged": 100, "failures": 2,
            "max_ulp": 2.0, "evaluations": 7.5, **counters}


class Gate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = folder_until(cls.addClassCleanup)
        cls.program = cls.folder / "tribocheck"
        shutil.copy(PROGRAM, cls.program)
        (cls.folder / "tribocheck_bench").write_text(STAND_IN)
        (cls.folder / "tribocheck_bench").chmod(0o755)

    def setUp(self):
        self.path = self.folder / "bench.json"
        self.path.unlink(missing_ok=True)
        self.rows = {CONTROL: {"median": 10.0, "least": 10.0}, MINE: row(), OTHER: row(), OURS: row()}
        self.written = self.gate(self.rows, "--update-baseline")
        self.assertEqual(self.written.code, 0, self.written.err)

    def bench(self, *arguments):
        done = subprocess.run([self.program, "bench", *map(str, arguments)], capture_output=True, text=True,
                              timeout=TIMEOUT, env=ENVIRONMENT)
        return Result(done.returncode, done.stdout, done.stderr)

    def gate(self, *runs_and_options):
        """Judges the rows of the first run, and of the second one where there are two."""
        runs = [one for one in runs_and_options if isinstance(one, dict)]
        options = [one for one in runs_and_options if not isinstance(one, dict)]
        (self.folder / "asked").unlink(missing_ok=True)
        (self.folder / "rows.json").write_text(json.dumps(runs))
        form = [] if "--format" in options else ["--format", "json"]
        return self.bench(*form, "--baseline", self.path, *options)

    def with_row(self, name=MINE, **values):
        return {**self.rows, name: row(**values)}

    def baseline(self):
        return json.loads(self.path.read_text())

    def assert_passes(self, done, *words):
        self.assertEqual(done.code, 0, done.err)
        self.assertRegex(done.error_lines[-1], f"^tribocheck: PASSED, no worse than {self.path}: ")
        for word in words:
            self.assertIn(word, done.err)

    def assert_fails(self, done, *words):
        self.assertEqual(done.code, 1, done.err)
        self.assertRegex(done.error_lines[-1], f"^tribocheck: FAILED, worse than {self.path}: ")
        for word in words:
            self.assertIn(word, done.err)

    def test_a_run_that_passes_says_how_much_it_has_compared(self):
        self.assertEqual(self.written.err, f"tribocheck: baseline written: {self.path}\n")
        self.assert_passes(self.gate(self.rows), "3 of 4 rows compared, the times of 3")
        self.assert_passes(self.gate(self.rows, "--filter", "/plugin/"), "2 of 3 rows compared, the times of 2",
                           "rows of the baseline that the filter leaves out: 1")

    def test_the_control_runs_whatever_the_filter_says_and_without_a_baseline_it_does_not(self):
        slow = self.with_row(median=200.0)
        for pattern in ("/plugin/", "^moment_5_2/plugin|^moment_2", "-GSL", "mine", "all", "/(plugin|tribocheck)/"):
            self.assert_fails(self.gate(slow, "--filter", pattern), f"slower than the baseline: {MINE}: ")
        for pattern in ("-control", "-moment", "-."):
            done = self.gate(self.rows, "--filter", pattern)
            self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1))
            self.assertIn("leaves out moment_5_2/control/std::exp, which --baseline needs", done.err)
        self.bench("--filter", "/plugin/")
        self.assertEqual((self.folder / "asked").read_text(), "/plugin/\n")

    def test_without_the_control_nothing_passes(self):
        rows = dict(self.rows)
        rows[CONTROL] = {"error": "it broke"}
        self.assert_fails(self.gate(rows), "the control did not run, so that no times are compared",
                          f"{CONTROL}: is gone (it broke)")

    def test_a_time_is_slower_beyond_a_tenth_where_the_intervals_do_not_meet_twice(self):
        for median, least, code in ((110.0, 101.0, 0), (110.1, 101.0, 1), (150.0, 100.0, 0), (150.0, 100.1, 1),
                                    (150.0, 99.0, 0), (90.0, 90.0, 0)):
            done = self.gate(self.with_row(median=median, least=least))
            self.assertEqual(done.code, code, (median, least, done.err))
        slow = self.with_row(median=150.0)
        self.assert_passes(self.gate(slow, self.rows), "measuring once more")
        self.assert_fails(self.gate(slow, slow))
        self.assert_passes(self.gate(slow, self.with_row(OTHER, median=150.0)))  # another row is slow in the second run
        # All times are divided by the control's, so that the machine may be slower.
        rows = {name: {**one, "median": 3 * one["median"], "least": 3 * one["least"]} for name, one in self.rows.items()}
        self.assert_passes(self.gate(rows))

    def test_errors_are_held_to_four_times_and_counts_exactly(self):
        for before, limit in ((2.0, 8.0), (1.0, 4.0), (0.1, 4.0), (1e6, 4e6)):
            self.path.unlink()
            self.gate(self.with_row(max_ulp=before), "--update-baseline")
            self.assert_passes(self.gate(self.with_row(max_ulp=limit)))
            self.assert_fails(self.gate(self.with_row(max_ulp=limit * (1 + 1e-15))), f"{MINE}: the greatest error")
            for error, is_better in ((before / 4, False), (before / 4 * (1 - 1e-15), True)):
                done = self.gate(self.with_row(max_ulp=error), "--update-baseline")
                self.assertEqual(f"baseline improved: {MINE}: the greatest error" in done.err, is_better, done.err)
        self.path.unlink()
        self.gate(self.rows, "--update-baseline")
        for field, worse, better in (("evaluations", 7.500001, 7.4), ("failures", 3, 1), ("judged", 99, 101)):
            self.assert_fails(self.gate(self.with_row(**{field: worse})), f"worse than the baseline: {MINE}: ")
            self.assert_passes(self.gate(self.with_row(**{field: better})))

    def test_rows_have_the_median_a_point_over_our_least_and_all_counts(self):
        rows = {MINE: row(300.0, 100.0, points=4, failures=3, judged=50, p99_ulp=1.5, mean_ulp=0.5),
                OURS: row(200.0, 40.0, points=8), "moment_5_2/tribocheck/AVX2": row(120.0, 60.0, points=8)}
        (self.folder / "rows.json").write_text(json.dumps([rows]))
        (self.folder / "asked").unlink(missing_ok=True)
        found = {f"{one['job']}/{one['family']}/{one['name']}": one
                 for one in self.bench("--format", "json").json()["rows"]}
        self.assertEqual({name: (one["ns"], one["ratio"]) for name, one in found.items()},
                         {MINE: (75.0, 5.0), OURS: (25.0, 25 / 15), "moment_5_2/tribocheck/AVX2": (15.0, 1.0)})
        self.assertEqual([found[MINE][name] for name in ("judged", "failures", "max_ulp", "p99_ulp", "mean_ulp",
                                                         "evaluations")], [50, 3, 2.0, 1.5, 0.5, 7.5])

    def test_what_is_no_longer_told_is_worse(self):
        for field in ("evaluations", "failures", "judged", "max_ulp"):
            rows = {**self.rows, MINE: {key: value for key, value in row().items() if key != field}}
            if field == "judged":
                rows[MINE].pop("failures")
            self.assert_fails(self.gate(rows), f"worse than the baseline: {MINE}: ")

    def test_a_row_that_is_gone_is_red_unless_the_filter_leaves_it_out(self):
        rows = {name: one for name, one in self.rows.items() if name != OTHER}
        self.assert_fails(self.gate(rows), f"worse than the baseline: {OTHER}: is gone")
        self.assert_fails(self.gate({**rows, OTHER: {"error": "no SciPy"}}), f"{OTHER}: is gone (no SciPy)")
        self.assert_passes(self.gate(rows, "--filter", "moment_5_2"))
        renamed = {name.replace("plugin/mine", "plugin/yours"): one for name, one in self.rows.items()}
        self.assert_fails(self.gate(renamed), f"{MINE}: is gone", f"{OTHER}: is gone")

    def test_rows_of_instruction_sets_may_be_gone_on_another_processor_alone(self):
        rows = {name: one for name, one in self.rows.items() if name != OURS}
        self.assert_fails(self.gate(rows), f"{OURS}: is gone")
        baseline = self.baseline()
        baseline["environment"]["processor"] = "another"
        self.path.write_text(json.dumps(baseline))
        self.assert_passes(self.gate(rows), "times are not comparable", "2 of 3 rows compared, the times of 0")
        self.assert_fails(self.gate({**rows, MINE: {"error": "gone"}}), f"{MINE}: is gone")

    def test_a_gate_that_compares_nothing_is_red(self):
        baseline = self.baseline()
        self.path.write_text(json.dumps({**baseline, "rows": {}}))
        self.assert_fails(self.gate(self.rows), "nothing of this run is in the baseline", "0 of 4 rows compared")
        self.path.write_text(json.dumps(baseline))
        self.assert_fails(self.gate({**self.rows, "new/plugin/one": row()}, "--filter", "new"), "nothing of this run")

    def test_an_update_writes_what_is_better_and_says_so_of_that_alone(self):
        before = self.baseline()["rows"]
        rows = {**self.with_row(evaluations=5.0, max_ulp=3.0, median=105.0),    # better, and a little worse
                OTHER: row(evaluations=5.0, max_ulp=9.0),                       # better, and worse
                OURS: row(median=50.0), "new/plugin/mine": row()}
        done = self.gate(rows, "--update-baseline").ended(1)
        self.assertEqual({line for line in done.error_lines if "tribocheck: baseline" in line}, {
            f"tribocheck: baseline improved: {MINE}: evaluations were 7.5, are 5",
            f"tribocheck: baseline kept: {OTHER}: it got worse",
            f"tribocheck: baseline improved: {OURS}: 5 times the control, was 10",
            "tribocheck: baseline improved: new/plugin/mine: is new"})
        after = self.baseline()["rows"]
        self.assertEqual(after[MINE], {**before[MINE], "evaluations": 5.0})
        self.assertEqual(after[OTHER], before[OTHER])
        self.assertEqual(after[OURS]["median_over_control"], 5.0)
        self.assertEqual(after["new/plugin/mine"], before[MINE])
        self.assertEqual(set(after), {*before, "new/plugin/mine"})

    def test_force_writes_all_that_ran_and_keeps_what_the_filter_leaves_out(self):
        before = self.baseline()["rows"]
        worse = self.with_row(max_ulp=100.0)
        worse.pop(OTHER)
        self.gate(worse, "--filter", "moment_5_2", "--update-baseline", "--force").ended(0)
        after = self.baseline()["rows"]
        self.assertEqual(after[MINE]["max_ulp"], 100.0)
        self.assertEqual(after[OTHER], before[OTHER])
        self.gate(worse, "--update-baseline", "--force")
        self.assertNotIn(OTHER, self.baseline()["rows"])

    def test_on_another_machine_an_update_leaves_the_times(self):
        baseline = self.baseline()
        baseline["environment"]["processor"] = "another"
        self.path.write_text(json.dumps(baseline))
        done = self.gate({**self.with_row(evaluations=5.0, median=1.0), "new/plugin/mine": row()}, "--update-baseline").ended(0)
        self.assertIn("PASSED", done.err)
        after = self.baseline()
        self.assertEqual(after["environment"], baseline["environment"])
        self.assertEqual(after["rows"][MINE], {**baseline["rows"][MINE], "evaluations": 5.0})
        self.assertIsNone(after["rows"]["new/plugin/mine"]["median_over_control"])

    def test_a_file_that_is_no_baseline_is_told_before_anything_is_measured_with_what_renews_it(self):
        for text, words in (("{}", "no baseline of"), ("no", "no JSON"), ("[]", "no baseline of"),
                            (json.dumps({**self.baseline(), "schema": 1}), "schema 1, and this program has 3")):
            self.path.write_text(text)
            done = self.gate(self.rows, "--filter", "/plugin/", "--quick")
            self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1), done.err)
            self.assertIn(words, done.err)
            self.assertFalse((self.folder / "asked").exists())
            renewal = shlex.split(done.err.partition(" it anew: tribocheck bench ")[2])
            self.assertEqual(self.bench(*renewal).code, 0)
            self.assert_passes(self.gate(self.rows, "--filter", "/plugin/"))

    def test_a_baseline_of_schema_2_is_read(self):
        old = {name: one for name, one in self.baseline().items() if name in ("environment", "rows")}
        self.path.write_text(json.dumps({"schema": 2, **old}))
        self.assert_passes(self.gate(self.rows), "3 of 4 rows compared, the times of 3")
        self.assert_fails(self.gate(self.with_row(evaluations=8.0)), "evaluations were 7.5, are 8")
        self.gate(self.rows, "--update-baseline")
        self.assertEqual(self.baseline()["schema"], "bench-baseline/3")

    def test_all_formats_tell_what_differs(self):
        rows = {**self.with_row(evaluations=8.0, max_ulp=0.1), "new/plugin/one": row(), OURS: row(median=200.0)}
        rows.pop(OTHER)
        told = {MINE: "worse", OTHER: "gone", OURS: "slower", "new/plugin/one": "new"}
        found = self.gate(rows).json()["comparison"]
        self.assertEqual({note["row"]: name for name in ("new", "slower", "gone", "worse") for note in found[name]}, told)
        self.assertEqual([note["row"] for note in found["better"]], [MINE])
        report = self.folder / "speed.xml"
        for form in ("table", "markdown"):
            text = self.gate(rows, "--format", form, "--junit", report).out
            for word in ("WORSE", "SLOWER", "new"):
                self.assertRegex(text, rf"(?m)\b{word}( \|)?$", form)
            self.assertRegex(text, r"(?i)gone.*: moment\\?_2/plugin/mine", form)
        suite = xml.etree.ElementTree.parse(report).getroot()
        self.assertEqual({one.get("name") for one in suite if one.find("failure") is not None}, {MINE, OTHER, OURS})

    def test_a_row_that_is_no_row_is_one_line(self):
        baseline = self.baseline()
        for broken in (1, {}, {**baseline["rows"][MINE], "max_ulp": "x", "judged": []}):
            self.path.write_text(json.dumps({**baseline, "rows": {**baseline["rows"], MINE: broken}}))
            done = self.gate(self.rows)
            self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1), done.err)
            self.assertIn("it is no baseline of `tribocheck bench`", done.err)

    def test_a_run_that_ends_without_results_is_one_line(self):
        for end, words in (("sys.exit(0)", "exit code 0"), ("sys.exit(2)", "exit code 2"),
                           ("sys.exit(3)", "exit code 3"), ("print('{\"benchmarks\": ['); sys.exit(0)", "exit code 0"),
                           ("print('{}'); sys.exit(0)", "exit code 0"), ("os.kill(os.getpid(), 9)", "signal 9"),
                           ("time.sleep(60)", "had not ended within 1 s"),
                           ("os.close(1); time.sleep(60)", "had not ended within 1 s")):
            (self.folder / "rows.json").write_text(json.dumps([end]))
            done = self.bench("--timeout", "1")
            self.assertEqual((done.code, done.out, len(done.error_lines)), (1, "", 1), (end, done.err))
            self.assertIn(words, done.err)


class Plugins(unittest.TestCase):
    def bench(self, library, ending, *arguments):
        done = run("bench", "--quick", "--plugin", plugin(library), *arguments, environment={"TRIBOCHECK_ENDING": ending})
        self.assertEqual((done.out, done.said.count("\n")), ("", 1), done.said)
        return done.code, done.said

    def test_one_that_ends_the_process_or_hangs_is_one_line(self):
        for code in ("0", "1", "2", "3", "77"):
            exit_code, said = self.bench("ending", code)
            self.assertEqual(exit_code, 1)
            self.assertIn(f"ended without results, with exit code {code}, with the plug-in {plugin('ending')} loaded; "
                          "a plug-in must not call exit()", said)
        exit_code, said = self.bench("ending", "never", "--timeout", "1.5")
        self.assertEqual(exit_code, 1)
        self.assertIn("had not ended within 1.5 s, with the plug-in ", said)

    def test_one_that_takes_part_in_nothing_is_refused(self):
        exit_code, said = self.bench("throwing", "0")
        self.assertEqual(exit_code, 2)
        self.assertIn("throwing.so: it offers none of the jobs", said)
        exit_code, said = self.bench("c_plugin", "0", "--filter", "tribocheck/scalar")
        self.assertEqual(exit_code, 2)
        self.assertIn("the filter leaves it out", said)


if __name__ == "__main__":
    unittest.main()
