# SPDX-License-Identifier: Apache-2.0
"""The report's section on how sure the onset speeds are. Needs gnuplot, as the program does."""

import json
import pathlib
import re
import shutil
import tempfile

from page_tables import percent
from program import run
from report_files import PUBLISHED, SWEEP_DATA, SWEEP_FIGURES, WrittenReport, report

SURFACES = ("rough", "medium", "smooth")
REPORTED = {"rough": 0.5, "medium": 0.15, "smooth": 0.09}
CRITERIA = ("film_maximum", "film_departure", "asperity_minimum")


class Reported(WrittenReport):
    sections = ("uncertainty",)
    reported = REPORTED

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.group = cls.told["onset_uncertainty"]
        cls.speeds = {(one["surface"], speed["criterion"]): speed
                      for one in cls.group["surfaces"] for speed in one["speeds"]}
        shown = run("sweep", "show", cls.out / "sweep/onset_uncertainty.h5", "--format", "csv")
        cls.swept = {(row["scene"], row["column"]): row
                     for row in shown.rows()}

    def column(self, surface, criterion, name="speed"):
        return self.swept[surface, f"onset.{criterion}.{name}"]

    def check_that_reported_speeds_lie_where_the_quantiles_say(self):
        reported = {one["surface"]: one["reported"] for one in self.group["surfaces"]}
        self.assertEqual({surface: one["value"] for surface, one in reported.items()}, self.reported)
        for one in reported.values():
            self.assertLess(one["low"], one["value"])
            self.assertLess(one["value"], one["high"])
        for (surface, criterion), speed in self.speeds.items():
            column = self.column(surface, criterion)
            below = speed["cases_below_reported"]
            if self.reported[surface] < float(column["least"]):
                self.assertEqual((speed["reported_lies"], below), ("below all", 0))
            elif self.reported[surface] > float(column["greatest"]):
                self.assertEqual((speed["reported_lies"], below), ("above all", 1))
            else:
                self.assertEqual(speed["reported_lies"], "among them")
                for level in (0.01, 0.05, 0.25, 0.75, 0.95, 0.99):
                    if abs(level - below) > 0.02:
                        self.assertEqual(below > level, self.reported[surface] > float(column[f"quantile_{level}"]))
            self.assertEqual(speed["reported_is_within_95_percent"],
                             reported[surface]["high"] >= float(column["quantile_0.025"]) and
                             reported[surface]["low"] <= float(column["quantile_0.975"]))
        self.assertEqual({one["reported_lies"] for one in self.speeds.values()}, self.places)


class OnsetUncertainty(Reported):
    places = {"below all", "above all"}
    test_reported_speeds_lie_where_the_quantiles_say = Reported.check_that_reported_speeds_lie_where_the_quantiles_say

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
            self.assertEqual(speed["as_printed"], float(done.rows()[0]["speed"]))

    def test_what_carries_most_is_named(self):
        for surface in SURFACES:
            column = self.column(surface, "film_maximum")
            totals = {name[len("total:"):]: float(cell) for name, cell in column.items() if name.startswith("total:")}
            most = max(totals, key=totals.get)
            self.assertRegex(self.text, f"`{most}` on the {surface} surface \\({100 * totals[most]:.0f} %\\)")

    def test_both_ways_of_drawing_agree(self):
        finding, = (one for one in self.told["findings"] if one["id"] == "onset_speeds_drawn_twice")
        self.assertEqual(finding["standing"], "holds")
        agreement = self.group["agreement"]
        self.assertTrue(agreement["agree"])
        self.assertTrue(0 < agreement["in_deviations"] <= agreement["most_deviations"] == 3.5)
        self.assertLess(agreement["farthest"], 0.03)
        self.assertIn("**Onset speeds drawn twice:** two generators agree.", self.text)

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
            report("--scenes", scenes, "--out", out, "--section", "uncertainty").ended(0)
            written = json.loads((out / "report.json").read_text())
            self.assertIn("onset_medium.toml", written["onset_uncertainty"]["missing"]["why"])
            finding, = (one for one in written["findings"] if one["id"] == "onset_uncertainty")
            self.assertEqual((finding["standing"], finding["section"]), ("absent", "uncertainty"))
            page = (out / "report.md").read_text()
            self.assertRegex(page, r"This part of the page is missing: \S+onset_medium.toml".replace("_", r"\\?_"))
            self.assertNotIn("Sobol", page)


class OtherSpeeds(Reported):
    """Other reported speeds than those of the paper: two inside the 95 % interval, and one just above it."""
    reported = {"rough": 0.8205, "medium": 0.95, "smooth": 0.217}
    places = {"among them", "above all"}
    test_reported_speeds_lie_where_the_quantiles_say = Reported.check_that_reported_speeds_lie_where_the_quantiles_say

    @classmethod
    def written(cls):
        scenes, out = (pathlib.Path(cls.folder.name) / name for name in ("scenes", "out"))
        shutil.copytree(PUBLISHED, scenes)
        text = (scenes / "claims.tsv").read_text()
        for surface, speed in cls.reported.items():
            text = re.sub(rf"(?m)^(C1\.{surface}\t(?:[^\t]*\t){{5}})[^\t]*\t[^\t]*\t[^\t]*", rf"\g<1>{speed}\t{speed}\t0.001", text)
        (scenes / "claims.tsv").write_text(text)
        return out, report("--scenes", scenes, "--out", out, "--section", "uncertainty")

    def test_they_are_told_as_parts(self):
        within = {name: speed["reported_is_within_95_percent"] for (name, criterion), speed in self.speeds.items() if criterion == "film_maximum"}
        self.assertEqual(within, {"rough": True, "medium": True, "smooth": False})
        for surface in SURFACES:
            part = self.speeds[surface, "film_maximum"]["cases_below_reported"]
            self.assertIn(f"{surface} {self.reported[surface]:g} m/s: {percent(part, 2)}", self.text)


if __name__ == "__main__":
    import unittest
    unittest.main()
