# SPDX-License-Identifier: Apache-2.0
"""Compares the report's numbers of machine contacts with `solve`, `onset` and the functions of `stream`."""

import json
import pathlib
import re
import tomllib
import unittest

from program import folder_until, run
from report_files import CONTACT_DATA, CONTACT_FIGURES, CONTACTS, ROOT, WrittenReport, files_below, project_copy, report, table

SCENES = ROOT / "reference/scenes"
POINT = ("film", "film_parameter", "asperity_load_share", "friction")


def functions(*requests):
    """The answers of `tribocheck stream` to requests of functions, in their order."""
    done = run("stream", stdin="".join(json.dumps({"id": str(i), **one}) + "\n" for i, one in enumerate(requests)))
    answers = [json.loads(line) for line in done.out.splitlines()]
    assert len(answers) == len(requests) and not any("error" in one for one in answers), done
    return answers


class Contacts(WrittenReport):
    sections = ("contacts",)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.told = cls.told["contacts"]
        cls.trees = {name: tomllib.loads((SCENES / f"{name}.toml").read_text()) for name in CONTACTS}

    def assert_close(self, mine, other, tolerance=1e-13):
        self.assertLessEqual(abs(mine - other), tolerance * abs(other), f"{mine!r} {other!r}")

    def solved(self, name, speeds):
        """The CSV rows of `tribocheck solve` for the scene at these speeds."""
        path = pathlib.Path(self.folder.name) / "at_speeds.json"
        path.write_text(json.dumps(self.trees[name] | {"speed": speeds}))
        return run("solve", path, "--format", "csv").ended(0).rows()

    def test_files_are_those_promised(self):
        self.assertEqual(self.done.code, 0, self.done.err)
        pictures = [f"figures/{figure}.{kind}" for figure in CONTACT_FIGURES for kind in ("svg", "png")]
        self.assertLessEqual({*CONTACT_DATA, *pictures}, set(files_below(self.out)))
        for name in CONTACTS:
            self.assertEqual((self.out / f"data/scenes/{name}.toml").read_text(), (SCENES / f"{name}.toml").read_text())
        self.assertEqual(list(self.told["scenes"]), CONTACTS)

    def test_shapes_are_a_circle_an_ellipse_and_a_line(self):
        self.assertEqual([one["shape"] for one in self.told["scenes"].values()], ["circle", "ellipse", "line"])

    def test_hertz_numbers_are_those_of_the_functions(self):
        for name, one in self.told["scenes"].items():
            bodies = self.trees[name]["bodies"]
            modulus, = functions({"function": "effective_modulus", **{key: bodies[key] for key in (
                "first_modulus", "first_poisson_ratio", "second_modulus", "second_poisson_ratio")}})
            self.assert_close(one["effective_modulus"], modulus["value"])
            self.assertEqual(one["load"], self.trees[name]["load"])
        circle, ellipse, line = self.told["scenes"].values()
        common = {name: {"load": one["load"], "effective_modulus": one["effective_modulus"]}
                  for name, one in self.told["scenes"].items()}
        point, oval, strip = functions(
            {"function": "hertz_point", **common["ball_on_flat"], "reduced_radius": circle["radius_x"]},
            {"function": "hertz_ellipse", **common["bearing_outer_ring"], "radius_x": ellipse["radius_x"],
             "radius_y": ellipse["radius_y"]},
            {"function": "hertz_line", "effective_modulus": line["effective_modulus"],
             "load_per_length": line["load"] / line["length"], "reduced_radius": line["radius_x"]})
        self.assertEqual((circle["ellipticity"], circle["semi_axis_x"], circle["radius_x"]),
                         (1, circle["semi_axis_y"], self.trees["ball_on_flat"]["bodies"]["reduced_radius"]))
        self.assert_close(circle["semi_axis_x"], point["radius"])
        self.assert_close(line["semi_axis_x"], strip["half_width"])
        self.assertEqual([line[key] for key in ("semi_axis_y", "ellipticity", "approach", "radius_y")], [None] * 4)
        for one, other, keys in ((circle, point, ("mean_pressure", "peak_pressure", "approach")),
                                 (ellipse, oval, ("semi_axis_x", "semi_axis_y", "ellipticity", "mean_pressure",
                                                  "peak_pressure", "approach")),
                                 (line, strip, ("mean_pressure", "peak_pressure"))):
            for key in keys:
                with self.subTest(shape=one["shape"], key=key):
                    self.assert_close(one[key], other[key])

    def test_radii_follow_from_the_faces(self):
        for name, direction in (("bearing_outer_ring", "x"), ("bearing_outer_ring", "y"), ("gear_flank", "x")):
            first, second = (self.trees[name]["bodies"][f"{body}_radius_{direction}"] for body in ("first", "second"))
            self.assert_close(self.told["scenes"][name][f"radius_{direction}"], 1 / (1 / first + 1 / second), 1e-12)

    def test_points_and_curves_agree_with_solve(self):
        for name, one in self.told["scenes"].items():
            points = [one[key] for key in ("at_told_speed", "slowest", "fastest", "least_friction")]
            self.assertEqual(points[0]["speed"], self.told["told_speed"])
            rows = table(self.out / f"data/contact_{name}.tsv")
            self.assertGreater(len(rows), 600)
            curve = [{key: float(row[key]) for key in ("speed", *POINT)} for row in rows]
            self.assertEqual([curve[0], curve[-1]], points[1:3])
            speed = self.trees[name]["speed"]
            self.assert_close(curve[0]["speed"], speed["from"])
            self.assert_close(curve[-1]["speed"], speed["to"])
            told = points + curve
            for mine, other in zip(told, self.solved(name, [point["speed"] for point in told]), strict=True):
                for key in POINT:
                    self.assertLessEqual(abs(mine[key] - float(other[key])), 1e-12 * abs(float(other[key])), (name, key))

    def test_heating_at_the_least_friction_is_that_of_its_speed(self):
        """The inlet heats by η₀u²/k_f, where k_f = 0.14 W/(m·K). The gear heats by over 100 K, the film of the bearing by less than 10 K."""
        for name, one in self.told["scenes"].items():
            speed = one["least_friction"]["speed"]
            self.assert_close(one["heating_at_least_friction"]["inlet_heating"], one["viscosity"] * speed**2 / 0.14, 1e-12)
        gear = self.told["scenes"]["gear_flank"]["heating_at_least_friction"]
        self.assertGreater(min(gear.values()), 100)
        self.assertLess(self.told["scenes"]["bearing_outer_ring"]["heating_at_least_friction"]["film_heating"], 10)

    def test_limits_are_those_that_contact_tells_beyond(self):
        done = run("contact", *(SCENES / f"{name}.toml" for name in CONTACTS), "--format", "json")
        beyond = {limit["word"] for scene in json.loads(done.out)["scenes"] for limit in scene["validity"] if limit["holds"] in ("no", "accepted")}
        self.assertEqual({one["word"] for one in self.told["limits_passed"]}, beyond)
        self.assertIn("film_heating", beyond)

    def test_least_friction_is_that_of_onset(self):
        done = run("onset", *(SCENES / f"{name}.toml" for name in CONTACTS), "--format", "csv")
        speeds = {row["id"]: float(row["speed"]) for row in done.rows()
                  if row["criterion"] == "friction_minimum"}
        marks = {row["name"]: row for row in table(self.out / "data/contact_marks.tsv")}
        for name, one in self.told["scenes"].items():
            self.assertEqual(one["least_friction"]["speed"], speeds[name])
            self.assertEqual(float(marks[name]["friction"]), one["least_friction"]["friction"])


class WithoutThem(unittest.TestCase):
    def setUp(self):
        self.project = project_copy(folder_until(self.addCleanup), "published", "scenes")

    def test_a_scene_that_is_missing_or_wrong_is_named_on_the_page(self):
        path = self.project / "reference/scenes/gear_flank.toml"
        text = path.read_text()
        for changed, why in ((None, "cannot be read"), (text.replace("length = 20e-3", "length = -1"), "bodies.length"),
                             (text.replace("boundary_coefficient = 0.12\n", ""), "friction"),
                             (re.sub(r"(?m)^speed = .*", "speed = [2, 3]", text), "1 m/s")):
            with self.subTest(why):
                path.unlink(missing_ok=True)
                if changed is not None:
                    self.assertNotEqual(changed, text)
                    path.write_text(changed)
                report("--section", "contacts", cwd=self.project).ended(0)
                told = json.loads((self.project / "reports/out/report.json").read_text())
                self.assertIn("gear_flank.toml", told["contacts"]["missing"]["why"])
                self.assertIn(why, told["contacts"]["missing"]["why"])
                self.assertEqual([(one["id"], one["standing"]) for one in told["findings"]], [("contacts", "absent")])
                self.assertIn("This part of the page is missing", (self.project / "reports/out/report.md").read_text())


if __name__ == "__main__":
    unittest.main()
