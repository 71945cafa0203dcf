# SPDX-License-Identifier: Apache-2.0
"""Checks tribocheck_work_precision on one small job: its tables and its JSON have the same rows. Times are not judged, and
neither are numbers that depend on the instruction set."""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOB = "^moment_2$"
COLUMNS = ["job", "family", "series", "name", "ns", "evaluations", "max_ulp", "p99_ulp", "mean_ulp", "failures", "no_numbers", "judged"]


def read(line, row, nothing):
    """The cells of a line with the types that the JSON of its row has, so that numbers are compared by value."""
    return [None if cell == nothing else cell if isinstance(value, str) else float(cell)
            for cell, value in zip(line.split("\t"), row.values(), strict=True)]


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name) / "out"
        self.baseline = pathlib.Path(folder.name) / "baseline.json"

    def run_with(self, *options):
        return subprocess.run([os.environ["TRIBOCHECK_WORK_PRECISION"], "--quick", "--out", self.out, *options], capture_output=True,
                              text=True)

    def measured(self, *options):
        done = self.run_with("--jobs", JOB, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.out / "work_precision.json").read_text())

    def plugin(self, name):
        return "--plugin", pathlib.Path(os.environ["TRIBOCHECK_SUBJECTS"]) / f"{name}.so"

    def test_the_tables_have_the_cells_of_the_json(self):
        found = self.measured("--commit", "one", "--date", "a day", *self.plugin("own_model_plugin"))
        self.assertEqual({key: found[key] for key in ("commit", "date")}, {"commit": "one", "date": "a day"})
        self.assertEqual(list(found), ["commit", "date", "environment", "error_against_work"])
        rows = found["error_against_work"]
        self.assertEqual([list(row) for row in rows], [COLUMNS] * len(rows))
        head, *lines = (self.out / "work_precision.tsv").read_text().splitlines()
        self.assertEqual(head, "\t".join(COLUMNS))
        for line, row in zip(lines, rows, strict=True):
            self.assertEqual(read(line, row, ""), list(row.values()))
        blocks = [block.splitlines() for block in (self.out / "moment_2.blocks.tsv").read_text().split("\n\n\n")]
        self.assertEqual([block[0] for block in blocks], [f'"{series}"' for series in dict.fromkeys(row["series"] for row in rows)])
        for block in blocks:
            for line, row in zip(block[1:], [row for row in rows if f'"{row["series"]}"' == block[0]], strict=True):
                self.assertEqual(read(line, row, "NaN"), list(row.values()))
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["moment_2.blocks.tsv", "work_precision.json", "work_precision.tsv"])
        # The plug-in has the same errors as our scalar way, and the best instruction set has a row.
        by_name = {(row["family"], row["name"]): row for row in rows}
        self.assertEqual(len(by_name), len(rows))
        ours, theirs = by_name["tribocheck", "scalar"], by_name["plugin", "own model"]
        same = ["job", *COLUMNS[5:]]
        self.assertEqual([theirs[column] for column in same], [ours[column] for column in same])
        self.assertIn(("tribocheck", f"batch {found['environment']['instruction_set']}"), by_name)
        for row in rows:
            self.assertEqual(row["job"], "moment_2")
            self.assertGreater(row["ns"], 0)
            self.assertLessEqual(row["no_numbers"], row["failures"])
            self.assertLessEqual(row["failures"], row["judged"])
            if row["max_ulp"] is not None:
                self.assertLessEqual(row["mean_ulp"], row["max_ulp"])
                self.assertLessEqual(row["p99_ulp"], row["max_ulp"])

    def test_failures_are_counted_on_the_certified_rows(self):
        rows = self.measured(*self.plugin("talkative"))["error_against_work"]  # it answers 1
        got = next(row for row in rows if row["family"] == "plugin")
        with open(ROOT / "reference/exact/gaussian_moment.csv") as file:
            exact = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))
                     if float.fromhex(row["order"]) == 2 and 0 < float.fromhex(row["argument"]) < 6]
        high = [float.fromhex(row["high"]) for row in exact]
        off = [abs(1 - one) for one in high]
        failed = [one > 1e-6 * max(1, float(row["condition"])) * value for one, row, value in zip(off, exact, high)]
        self.assertEqual((got["judged"], got["failures"], got["no_numbers"]), (len(exact), sum(failed), 0))
        ulps = [one / math.ulp(value) for one, value in zip(off, high)]
        self.assertEqual(got["max_ulp"], float(f"{max(ulps):.4g}"))
        self.assertAlmostEqual(got["mean_ulp"] / (sum(ulps) / len(ulps)), 1, delta=1e-3)

    def test_a_part_of_the_jobs_leaves_the_baseline_alone(self):
        before = {"commit": "before", "error_against_work": [{"job": "another"}], "line_film": []}
        self.baseline.write_text(json.dumps(before))
        self.measured("--baseline", self.baseline)
        self.assertEqual(json.loads(self.baseline.read_text()), before)

    def test_wrong_arguments_are_refused_before_anything_is_measured(self):
        self.baseline.write_text("no")
        for options, said in ((("--jobs", "("), '--jobs: "(" is no'), (("--jobs", "no such job"), "moment_2, root_wide"),
                              (("--jobs", JOB, "--baseline", self.baseline), "this is no baseline"),
                              (("--jobs", JOB, "--baseline", self.out / "missing.json"), "this is no baseline"),
                              (("--plugin", self.out / "missing.so"), "missing.so"), (self.plugin("no_version"), "no_version")):
            done = self.run_with(*options)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (2, "", 1), done.stderr)
            self.assertIn(said, done.stderr)
            self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
