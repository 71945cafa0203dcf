# SPDX-License-Identifier: Apache-2.0
"""The report's section on how sure the onset speeds are. Needs gnuplot, as the program does."""

import csv
import io
import json
import pathlib
import re
import shutil
import tempfile

from program import run
from report_files import PUBLISHED, SWEEP_FIGURES, WrittenReport, report

NUMBER = r"-?[\d.]+"


def number(cell):
    return float(re.match(NUMBER, cell)[0])


class OnsetUncertainty(WrittenReport):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = json.loads((cls.out / "report.json").read_text())
        cls.section = next(s for s in cls.page["sections"] if s["id"] == "sweep")
        shown = run("sweep", "show", cls.out / "sweep/onset_uncertainty.h5", "--format", "csv")
        cls.swept = {(row["scene"], row["column"]): row
                     for row in csv.DictReader(io.StringIO(shown.out))}

    def column(self, row, name="speed"):
        return self.swept[row[0], f"onset.{row[1].strip('`')}.{name}"]

    def test_speeds_are_those_of_the_sweep_and_of_onset(self):
        rows = self.section["tables"][0]["rows"]
        self.assertEqual(len(rows), 9)
        for row in rows:
            column = self.column(row)
            for cell, level in zip(row[3:6], ("0.025", "0.5", "0.975")):
                self.assertLess(abs(number(cell) / float(column[f"quantile_{level}"]) - 1), 6e-3)
            done = run("onset", PUBLISHED / f"{row[0]}.toml", "--criterion", row[1].strip("`"),
                       "--format", "csv")
            speed = next(csv.DictReader(io.StringIO(done.out)))["speed"]
            self.assertLess(abs(number(row[2]) / float(speed) - 1), 6e-3)
            undefined = float(column["undefined"]) / 8192
            self.assertLess(abs(number(row[6]) / 100 - undefined), 0.05 * undefined + 1e-9)

    def test_reported_speeds_lie_where_the_quantiles_say(self):
        reported = {"rough": 0.5, "medium": 0.15, "smooth": 0.09}
        for row in self.section["tables"][0]["rows"]:
            column = self.column(row)
            self.assertEqual(number(row[7]), reported[row[0]])
            if row[8] == "below all":
                self.assertLess(reported[row[0]], float(column["least"]))
            elif row[8] == "above all":
                self.assertGreater(reported[row[0]], float(column["greatest"]))
            else:
                part = number(row[8]) / 100
                for level in (0.01, 0.05, 0.25, 0.75, 0.95, 0.99):
                    if abs(level - part) > 0.02:
                        self.assertEqual(part > level,
                                         reported[row[0]] > float(column[f"quantile_{level}"]))

    def test_totals_are_those_of_the_sweep(self):
        rows = self.section["tables"][1]["rows"]
        self.assertGreater(len(rows), 6)
        for criterion, variable, *cells in rows:
            for surface, cell in zip(("rough", "medium", "smooth"), cells, strict=True):
                column = self.swept[surface, f"onset.{criterion.strip('`')}.speed"]
                self.assertLessEqual(abs(number(cell) - float(column["total:" + variable.strip("`")])),
                                     0.0005001)

    def test_what_carries_most_is_named(self):
        text = " ".join(self.section["paragraphs"])
        for surface in ("rough", "medium", "smooth"):
            column = self.swept[surface, "onset.film_maximum.speed"]
            totals = {name[len("total:"):]: float(cell) for name, cell in column.items()
                      if name.startswith("total:")}
            self.assertRegex(text, f"{max(totals, key=totals.get)} with [\\d.]+ % on the {surface}")

    def test_both_ways_of_drawing_agree(self):
        self.assertIn("the two agree", " ".join(self.section["paragraphs"]))

    def test_figures(self):
        self.assertEqual([figure["id"] for figure in self.section["figures"]], SWEEP_FIGURES)

    def test_without_its_sweeps_it_excuses_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            scenes = pathlib.Path(folder) / "scenes"
            shutil.copytree(PUBLISHED, scenes)
            (scenes / "sweeps/onset_medium.toml").unlink()
            out = pathlib.Path(folder) / "out"
            done = report("--scenes", scenes, "--out", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            page = json.loads((out / "report.json").read_text())
            section = next(s for s in page["sections"] if s["id"] == "sweep")
            self.assertIn("onset_medium.toml", section["paragraphs"][0])
            self.assertEqual(section["tables"] + section["figures"], [])
            missing = page["sections"][-1]["tables"][0]["rows"]
            self.assertTrue(any("onset speeds" in row[0] for row in missing))


if __name__ == "__main__":
    import unittest
    unittest.main()
