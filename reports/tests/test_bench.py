# SPDX-License-Identifier: Apache-2.0
"""tribocheck bench: its rows in every format, and the message when it cannot run."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from program import PROGRAM, TIMEOUT, ProgramTest, folder_until, run

CLOSED_FORM = "^moment_2/(closed form|tribocheck)/"
OF_SOLVERS = ["over_control", "over_control_low", "over_control_high", "over_base", "over_base_low", "over_base_high",
              "wall_ns", "cases", "measured"]
COLUMNS = ["job", "family", "name", "ns", "ratio", "max_ulp", "p99_ulp", "mean_ulp", "evaluations", "failures", "judged",
           *OF_SOLVERS]


def bench(*arguments):
    return run("bench", "--quick", *arguments)


class Rows(unittest.TestCase):
    def test_json_has_a_row_for_each_contender_with_all_columns(self):
        rows = bench("--filter", CLOSED_FORM, "--format", "json").ended(0, "").json()["rows"]
        self.assertEqual({row["family"] for row in rows}, {"closed form", "tribocheck"})
        for row in rows:
            self.assertEqual(list(row), COLUMNS)
            self.assertEqual(row["job"], "moment_2")
            self.assertGreater(row["ns"], 0)
            self.assertGreater(row["judged"], 50)
            self.assertEqual(row["failures"], 0)
            self.assertEqual({row[name] for name in OF_SOLVERS}, {None})
        ours = [row for row in rows if row["family"] == "tribocheck"]
        self.assertEqual(min(row["ratio"] for row in ours), 1)
        self.assertTrue(all(row["max_ulp"] <= 2 for row in ours))

    def test_tsv_reads_back(self):
        done = bench("--filter", CLOSED_FORM, "--format", "tsv").ended(0)
        head, *rows = [line.split("\t") for line in done.out.splitlines()]
        self.assertEqual(head, COLUMNS)
        self.assertGreaterEqual(len(rows), 3)
        for row in rows:
            self.assertEqual(len(row), len(head))
            self.assertGreater(float(row[head.index("ns")]), 0)

    def test_table_names_the_job_and_its_contenders(self):
        done = bench("--filter", CLOSED_FORM).ended(0)
        lines = done.out.splitlines()
        self.assertEqual(lines[0], "F_2(d), d in (0, 6)")
        self.assertIn("closed form   erfc", done.out)
        self.assertNotIn("DEBUG", done.out + done.err)

    def test_without_ours_there_is_no_ratio(self):
        rows = bench("--filter", "^moment_2/closed form/", "--format", "json").json()["rows"]
        self.assertEqual([row["ratio"] for row in rows], [None])

    def test_integrals_count_their_integrand(self):
        rows = bench("--filter", "moment_5_2/GSL/QAGIU 1e-08 sqrt", "--format", "json").json()["rows"]
        self.assertEqual(len(rows), 1)
        self.assertGreater(rows[0]["evaluations"], 15)

    def test_scipy_is_measured_or_said_to_be_left_out(self):
        done = bench("--filter", "moment_5_2/(SciPy/|control)", "--format", "json").ended(0)
        measured = any(row["family"] == "SciPy" for row in done.json()["rows"])
        self.assertEqual(measured, "left out: moment_5_2/SciPy/quad" not in done.err)

    def test_the_reader_may_go_away(self):
        line = f"'{PROGRAM}' bench --quick --filter '{CLOSED_FORM}' | head -1; echo ${{PIPESTATUS[0]}}"
        done = subprocess.run(["bash", "-c", line], capture_output=True, timeout=TIMEOUT, check=True)
        self.assertEqual(done.stdout.splitlines()[-1], b"0")
        self.assertEqual(done.stderr, b"")


class Baselines(unittest.TestCase):
    FILTER = "^moment_5_2/tribocheck/scalar|^root_one_surface/tribocheck/scalar"

    def setUp(self):
        self.path = folder_until(self.addCleanup) / "bench.json"
        done = self.gate("--update-baseline")
        self.assertEqual((done.code, done.err), (0, f"tribocheck: baseline written: {self.path}\n"))
        self.baseline = json.loads(self.path.read_text())

    def gate(self, *more):
        return bench("--filter", self.FILTER, "--baseline", self.path, *more)

    def change(self, row, **fields):
        self.baseline["rows"][row].update(fields)
        self.path.write_text(json.dumps(self.baseline))

    def test_more_work_and_more_error_are_red(self):
        row = "root_one_surface/tribocheck/scalar"
        evaluations = self.baseline["rows"][row]["evaluations"]
        self.change(row, evaluations=evaluations - 1, max_ulp=0.001)
        done = self.gate().ended(1)
        self.assertIn(f"worse than the baseline: {row}: evaluations were", done.err)
        self.assertIn(f"worse than the baseline: {row}: the greatest error was 0.001 ulp", done.err)

    def test_a_time_is_red_when_a_second_run_says_so_too(self):
        row = "moment_5_2/tribocheck/scalar"
        before = self.baseline["rows"][row]
        self.change(row, least_over_control=before["least_over_control"] / 3,
                    median_over_control=before["median_over_control"] / 3)
        done = self.gate().ended(1)
        self.assertIn("measuring once more", done.err)
        self.assertIn(f"slower than the baseline: {row}: ", done.err)

    def test_times_of_another_processor_are_not_compared(self):
        self.baseline["environment"]["processor"] = "another"
        self.change("moment_5_2/tribocheck/scalar", least_over_control=1e-3, median_over_control=1e-3)
        self.assertIn("times are not comparable", self.gate().ended(0).err)

    def test_a_file_that_is_no_baseline(self):
        for text in ("{}", "no"):
            self.path.write_text(text)
            self.assertEqual(self.gate().code, 2)
        self.path.unlink()
        self.assertIn("there is no such baseline", self.gate().ended(2).err)


class Refusals(ProgramTest):
    def test_a_filter_that_is_no_expression(self):
        self.assert_refused(bench("--filter", "("), "--filter", "regular expression")

    def test_a_filter_that_matches_nothing(self):
        self.assert_refused(bench("--filter=-."), "-.", "no contender")  # after a leading - the pattern leaves out what it matches
        self.assert_refused(bench("--filter", "no such contender"), "no such contender",
                            "the jobs are moment_5_2, ", "points_1e6, hertz_ellipse; the families are GSL, ", "tribocheck")

    def test_an_unknown_format(self):
        self.assert_refused(bench("--format", "xml"), "--format")

    def test_a_program_that_is_not_built(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = pathlib.Path(folder) / "bin" / "tribocheck"
            alone.parent.mkdir()
            shutil.copy(PROGRAM, alone)
            done = subprocess.run([alone, "bench"], capture_output=True, timeout=TIMEOUT)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
            self.assertIn(b"make bench", done.stderr)

    def test_a_program_where_installations_put_helpers(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = pathlib.Path(folder) / "bin" / "tribocheck"
            helpers = pathlib.Path(folder) / "libexec" / "tribocheck"
            alone.parent.mkdir()
            helpers.mkdir(parents=True)
            shutil.copy(PROGRAM, alone)
            os.symlink(pathlib.Path(PROGRAM).parent / "tribocheck_bench", helpers / "tribocheck_bench")
            done = subprocess.run([alone, "bench", "--quick", "--filter", CLOSED_FORM],
                                  capture_output=True, timeout=TIMEOUT)
            self.assertEqual((done.returncode, done.stderr), (0, b""))


if __name__ == "__main__":
    unittest.main()
