# SPDX-License-Identifier: Apache-2.0
"""onset: the four criteria, and the reasons where there is no onset."""

import re
import unittest

from program import ProgramTest, run, scene, without_field

CRITERIA = ["film_maximum", "film_departure", "friction_minimum", "asperity_minimum"]
VALUES = ["speed", "film", "film_parameter"]


class OnsetTest(ProgramTest):
    def found(self, tree, *arguments):
        result = run("onset", self.folder.write("scene.toml", tree), *arguments, "--format", "json").ended(0, "")
        return {onset["criterion"]: onset for onset in result.json()["onsets"]}

    def test_film_maximum_of_table_1(self):
        for surface in ["rough", "medium", "smooth"]:
            found = self.found(scene(surface))
            self.assertEqual(list(found), CRITERIA)
            for criterion in ["film_maximum", "asperity_minimum"]:
                self.assertAlmostEqual(found[criterion]["film_parameter"], 1.43166235170080,
                                       delta=1e-13)

    def test_it_is_the_maximum_that_solve_finds(self):
        onset = self.found(scene("medium"))["film_maximum"]
        speeds = [onset["speed"] * factor for factor in [0.99, 1, 1.01]]
        path = self.folder.write("at.json", scene("medium", speed=speeds))
        before, at, after = [p["film"] for p in run("solve", path, "--format", "json").json()["points"]]
        self.assertAlmostEqual(at / onset["film"], 1, delta=1e-12)
        self.assertLess(before, at)
        self.assertLess(after, at)

    def test_departure(self):
        for departure in [0.05, 0.5]:
            onset = self.found(scene(), "--departure", departure)["film_departure"]
            path = self.folder.write("at.json", scene(speed=onset["speed"]))
            point = run("solve", path, "--format", "json").json()["points"][0]
            self.assertAlmostEqual(point["film"] / point["film_flooded"], 1 - departure, delta=1e-12)

    def test_the_default_departure_is_one_twentieth(self):
        self.assertEqual(self.found(scene()), self.found(scene(), "--departure", "0.05"))
        self.assertEqual(self.found(scene()), self.found(scene(), "--departure", "5 %"))

    def test_the_law_of_the_inlet_is_named(self):
        for law in ("flooded_inlet", "damiens"):
            tree = {**scene(), "closures": {"starvation": law}}
            self.assertEqual({one["starvation"] for one in self.found(tree).values()}, {law})
            table = run("onset", self.folder.write("law.toml", tree)).out
            self.assertIn(f": onset of starvation, starvation = {law}\n", table)
            others = {"flooded_inlet", "starved_inlet", "damiens"} - {law}
            for criterion in ("film_departure", "film_maximum"):
                told = dict(map(reversed, re.findall(r"([\d.e+-]+) m/s by (\w+)", "".join(re.findall(rf"(?m)^  - {criterion}: .*", table)))))
                expected = {other: self.found({**scene(), "closures": {"starvation": other}})[criterion]["speed"] for other in others}
                self.assertEqual(told, {other: f"{speed:.5g}" for other, speed in expected.items() if speed is not None})
                self.assertTrue(told or criterion == "film_maximum")
        self.assertNotIn("another law", run("onset", self.folder.write("wet.toml", scene(supply=None))).out)

    def test_only_the_criteria_that_are_asked_for(self):
        found = self.found(scene(), "--criterion", "friction_minimum", "--criterion", "film_maximum")
        self.assertEqual(sorted(found), ["film_maximum", "friction_minimum"])

    def test_a_scene_may_follow_a_criterion(self):
        path = self.folder.write("scene.toml", scene())
        run("onset", "--criterion", "film_maximum", path).ended(0, "")

    def test_where_there_is_none_it_says_why(self):
        for name, onset in self.found(scene(supply=None)).items():
            with self.subTest(criterion=name):
                self.assertEqual([onset[value] for value in VALUES], [None] * 3)
                for value in VALUES:
                    self.assertTrue(onset["undefined"][value])

    def why(self, tree, criterion):
        return self.found(tree)[criterion].get("undefined", {}).get("speed")

    def test_faces_known_by_rq_alone_have_no_onset_of_what_their_summits_do(self):
        faces = {"supply": {"inlet_film": 1e-7}, "surface": {"rms_roughness": 1e-8}}
        for criterion in CRITERIA:
            why = self.why(scene() | faces, criterion)
            if criterion in ("friction_minimum", "asperity_minimum"):
                self.assertIn("Rq alone does not say what the summits carry", why)
            else:
                self.assertIsNone(why)
        smooth = {key: value for key, value in (scene() | faces).items() if key != "surface"}
        self.assertNotIn("Rq", self.why(smooth, "friction_minimum"))
        self.assertIn("the bodies are smooth", self.why(smooth, "asperity_minimum"))

    def test_friction_names_the_input_that_it_lacks(self):
        for missing, named in ((["lubricant.eyring_stress"], "friction needs lubricant.eyring_stress"),
                               (["friction.boundary_coefficient"], "friction needs friction.boundary_coefficient"),
                               (["lubricant.eyring_stress", "friction.boundary_coefficient"],
                                "friction needs lubricant.eyring_stress and friction.boundary_coefficient")):
            tree = scene()
            for path in missing:
                tree = without_field(tree, path)
            self.assertEqual(self.why(tree, "friction_minimum"), named)
        self.assertIsNone(self.why(scene(), "friction_minimum"))

    def test_an_onset_beyond_the_range_of_double_is_none(self):
        tree = scene()
        tree["lubricant"]["viscosity"] = 1e-320
        path = self.folder.write("thin.toml", tree)
        found = run("onset", path, "--criterion", "film_maximum", "--format", "json").json()["onsets"][0]
        self.assertEqual([found[value] for value in VALUES], [None] * 3)
        row = run("onset", path, "--criterion", "film_maximum", "--format", "csv").rows()[0]
        self.assertEqual([row[value] for value in VALUES], [""] * 3)
        self.assertEqual(row["reason"], found["undefined"]["speed"])

    def test_speed_may_be_absent(self):
        found = self.found(scene(speed=None))
        self.assertIsNone(found["friction_minimum"]["speed"])
        self.assertIsNotNone(found["film_maximum"]["speed"])

    def test_formats_agree(self):
        for supply in [{"inlet_film_ratio": 4}, None]:
            tree = scene(supply=supply)
            path = self.folder.write("scene.toml", tree)
            found = self.found(tree)
            rows = run("onset", path, "--format", "csv").rows()
            table = [line for line in run("onset", path).out.splitlines()[5:] if not line.startswith("  - ")]
            for row, line in zip(rows, table, strict=True):
                self.assert_agree(found[row["criterion"]], row, line)

    def assert_agree(self, onset, row, line):
        self.assertEqual(row["id"], onset["id"])
        reason = onset.get("undefined", {}).get("speed", "")
        self.assertEqual(row["reason"], reason)
        if reason:
            self.assertEqual([row[value] for value in VALUES], [""] * 3)
            self.assertEqual(line.strip(), f"{row['criterion']}  none: {reason}")
        else:
            self.assertEqual([float(row[value]) for value in VALUES], [onset[v] for v in VALUES])
            self.assertEqual(line.split(), [row["criterion"]] + [f"{onset[v]:.5g}" for v in VALUES])


if __name__ == "__main__":
    unittest.main()
