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
from report_files import PUBLISHED, SWEEP_DATA, SWEEP_FIGURES, WrittenReport, report

SURFACES = ("rough", "medium", "smooth")
REPORTED = {"rough": 0.5, "medium": 0.15, "smooth": 0.09}
CRITERIA = ("film_maximum", "film_departure", "asperity_minimum")


def table_after(text, caption):
    """Rows of a Markdown table under their headings."""
    lines = text.partition(f"**{caption}**")[2].strip().split("\n\n")[0].splitlines()
    head, _, *rows = [[cell.strip().strip("`") for cell in line.strip("|").split("|")] for line in lines]
    return [dict(zip(head, row, strict=True)) for row in rows]


class OnsetUncertainty(WrittenReport):
    sections = ("uncertainty",)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.report = json.loads((cls.out / "report.json").read_text())
        cls.group = cls.report["onset_uncertainty"]
        cls.page = (cls.out / "report.md").read_text()
        cls.speeds = {(one["surface"], speed["criterion"]): speed
                      for one in cls.group["surfaces"] for speed in one["speeds"]}
        shown = run("sweep", "show", cls.out / "sweep/onset_uncertainty.h5", "--format", "csv")
        cls.swept = {(row["scene"], row["column"]): row
                     for row in csv.DictReader(io.StringIO(shown.out))}

    def column(self, surface, criterion, name="speed"):
        return self.swept[surface, f"onset.{criterion}.{name}"]

    def test_numbers_are_those_of_the_sweep_and_of_onset(self):
        self.assertEqual(set(self.speeds), {(surface, criterion) for surface in SURFACES for criterion in CRITERIA})
        told = {(scene["id"], column["name"]): column["values"][0]
                for scene in self.group["sweep"]["scenes"] for column in scene["columns"]}
        self.assertEqual(len(told), 9)
        for (surface, criterion), speed in self.speeds.items():
            column, value = self.column(surface, criterion), told[surface, speed["column"]]
            for one in value["quantiles"]:
                self.assertEqual(one["value"], float(column[f"quantile_{one['level']:g}"]))
            self.assertEqual((value["count"], value["undefined"]), (int(column["count"]), int(column["undefined"])))
            done = run("onset", PUBLISHED / f"{surface}.toml", "--criterion", criterion, "--format", "csv")
            self.assertEqual(speed["as_printed"], float(next(csv.DictReader(io.StringIO(done.out)))["speed"]))

    def test_reported_speeds_lie_where_the_quantiles_say(self):
        reported = {one["surface"]: one["reported"] for one in self.group["surfaces"]}
        self.assertEqual({surface: one["value"] for surface, one in reported.items()}, REPORTED)
        for one in reported.values():
            self.assertLess(one["low"], one["value"])
            self.assertLess(one["value"], one["high"])
        for (surface, criterion), speed in self.speeds.items():
            column = self.column(surface, criterion)
            below = speed["cases_below_reported"]
            if REPORTED[surface] < float(column["least"]):
                self.assertEqual((speed["reported_lies"], below), ("below all", 0))
            elif REPORTED[surface] > float(column["greatest"]):
                self.assertEqual((speed["reported_lies"], below), ("above all", 1))
            else:
                self.assertEqual(speed["reported_lies"], "among them")
                for level in (0.01, 0.05, 0.25, 0.75, 0.95, 0.99):
                    if abs(level - below) > 0.02:
                        self.assertEqual(below > level, REPORTED[surface] > float(column[f"quantile_{level}"]))
            self.assertEqual(speed["reported_is_within_95_percent"],
                             reported[surface]["high"] >= float(column["quantile_0.025"]) and
                             reported[surface]["low"] <= float(column["quantile_0.975"]))
        self.assertEqual({one["reported_lies"] for one in self.speeds.values()}, {"below all", "above all"})

    def test_the_table_of_speeds_is_the_data(self):
        rows = table_after(self.page, "Onset speeds within the precision of Table 1, m/s")
        self.assertEqual([(row["surface"], row["criterion"]) for row in rows], list(self.speeds))
        for row in rows:
            speed, column = self.speeds[row["surface"], row["criterion"]], self.column(row["surface"], row["criterion"])
            expected = [speed["as_printed"], *(float(column[f"quantile_{level}"]) for level in ("0.025", "0.5", "0.975"))]
            for name, value in zip(("as printed", "2.5 %", "median", "97.5 %"), expected):
                self.assertLess(abs(float(row[name]) / value - 1), 6e-3)
            undefined = 100 * int(column["undefined"]) / 8192
            self.assertLess(abs(float(row["no onset in"].split()[0]) - undefined), 0.05 * undefined + 1e-9)
            self.assertEqual(float(row["reported"]), REPORTED[row["surface"]])
            self.assertEqual(row["cases below the reported speed"], speed["reported_lies"])

    def test_totals_are_those_of_the_sweep(self):
        rows = table_after(self.page, "What carries the uncertainty: total Sobol indices of the onset speed")
        self.assertGreater(len(rows), 6)
        for row in rows:
            for surface in SURFACES:
                total = float(self.column(surface, row["criterion"])["total:" + row["input"]])
                self.assertLessEqual(abs(float(row[surface].split(" ± ")[0].replace("−", "-")) - total), 0.0005001)

    def test_what_carries_most_is_named(self):
        for surface in SURFACES:
            column = self.column(surface, "film_maximum")
            totals = {name[len("total:"):]: float(cell) for name, cell in column.items() if name.startswith("total:")}
            most = max(totals, key=totals.get)
            self.assertRegex(self.page, f"`{most}` on the {surface} surface \\({100 * totals[most]:.0f} %\\)")

    def test_both_ways_of_drawing_agree(self):
        finding, = (one for one in self.report["findings"] if one["id"] == "onset_speeds_drawn_twice")
        self.assertEqual(finding["standing"], "holds")
        agreement = self.group["agreement"]
        self.assertTrue(agreement["agree"])
        self.assertTrue(0 < agreement["in_deviations"] <= agreement["most_deviations"] == 3.5)
        self.assertLess(agreement["farthest"], 0.03)
        self.assertIn("**Onset speeds drawn twice:** two generators agree.", self.page)

    def test_figures(self):
        html = (self.out / "index.html").read_text()
        self.assertEqual(re.findall(r'<figure id="(\w+)"', html)[-2:], SWEEP_FIGURES)
        for path in SWEEP_DATA:
            self.assertTrue((self.out / path).is_file())
            self.assertIn(f'href="{path}"', html)

    def test_without_its_sweeps_it_excuses_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            scenes = pathlib.Path(folder) / "scenes"
            shutil.copytree(PUBLISHED, scenes)
            (scenes / "sweeps/onset_medium.toml").unlink()
            out = pathlib.Path(folder) / "out"
            done = report("--scenes", scenes, "--out", out, "--section", "uncertainty")
            self.assertEqual(done.returncode, 0, done.stderr)
            written = json.loads((out / "report.json").read_text())
            self.assertIn("onset_medium.toml", written["onset_uncertainty"]["missing"]["why"])
            finding, = (one for one in written["findings"] if one["id"] == "onset_uncertainty")
            self.assertEqual((finding["standing"], finding["section"]), ("absent", "uncertainty"))
            page = (out / "report.md").read_text()
            self.assertRegex(page, r"This part of the page is missing: \S+onset_medium.toml".replace("_", r"\\?_"))
            self.assertNotIn("Sobol", page)


if __name__ == "__main__":
    import unittest
    unittest.main()
