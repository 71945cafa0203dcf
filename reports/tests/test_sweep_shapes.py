# SPDX-License-Identifier: Apache-2.0
"""Sweeps of ellipses, lines, two bodies and spectral moments give the same numbers as `stream`, `solve` and `onset`. Inputs that
describe no contact are refused before the sweep starts."""

import json
import math
import os
import shutil
import tomllib
import unittest

from program import run
from sweeps import SweepTest, opened, sweep

CIRCLE = {"bodies.reduced_radius": "9.5e-3"}
ELLIPSE = {"bodies.reduced_radius": None, "bodies.radius_x": "9.5e-3", "bodies.radius_y": "19e-3"}
LINE = {"bodies.reduced_radius": None, "bodies.radius_x": "9.5e-3", "bodies.length": "5e-3",
        "closures.film": '"dowson_toyoda_central"', "load": "500"}
MODULI = {"bodies.effective_modulus": None, "bodies.first_modulus": "206e9", "bodies.first_poisson_ratio": "0.3",
          "bodies.second_modulus": "310e9", "bodies.second_poisson_ratio": "0.26"}
FACES = {"bodies.reduced_radius": None, "bodies.first_radius_x": "4.7625e-3", "bodies.second_radius_x": "-27.7625e-3",
         "bodies.first_radius_y": "4.7625e-3", "bodies.second_radius_y": "-5.04825e-3"}
FACES_OF_LINE = {"bodies.reduced_radius": None, "bodies.first_radius_x": "13.97e-3", "bodies.second_radius_x": "20.95e-3",
                 "bodies.length": "20e-3", "load": "2000", "closures.film": '"pan_hamrock_minimum"'}
MOMENTS = {"surface.summit_density": None, "surface.summit_radius": None, "surface.summit_height_sd": None,
           "surface.summit_plane_offset": None, "surface.m0": "2.5e-15", "surface.m2": "1e-4", "surface.m4": "4e7"}


def uniform(low, high):
    return f'{{ distribution = "uniform", from = {low}, to = {high} }}'


# Scenes, and the inputs that vary in them.
PLANS = {
    "radius across, a grid": (ELLIPSE, {"bodies.radius_y": "[9.5e-3, 19e-3, 60e-3]"}),
    "radius across, drawn": (ELLIPSE, {"bodies.radius_y": uniform(9.5e-3, 60e-3), "load": uniform(10, 90)}),
    "radius along and law of points": (ELLIPSE, {
        "bodies.radius_x": "[6e-3, 12e-3]", "closures.film": '["hamrock_dowson_central", "hamrock_dowson_minimum"]'}),
    "length": (LINE, {"bodies.length": "{ from = 1e-3, to = 2e-2, count = 5 }"}),
    "length, radius and load, drawn": (LINE, {
        "bodies.length": uniform(2e-3, 8e-3), "bodies.radius_x": uniform(8e-3, 12e-3), "load": uniform(300, 600)}),
    "laws of lines": (LINE, {"closures.film": '["dowson_higginson_minimum", "dowson_toyoda_central", '
                                              '"pan_hamrock_minimum", "pan_hamrock_central"]'}),
    "Poisson ratio, a grid": (CIRCLE | MODULI, {"bodies.first_poisson_ratio": "[0, 0.17, 0.3, 0.5]"}),
    "moduli, drawn": (ELLIPSE | MODULI, {"bodies.first_poisson_ratio": uniform(0.25, 0.35),
                                         "bodies.second_modulus": uniform(290e9, 330e9)}),
    "faces": (FACES | MODULI, {"bodies.second_radius_y": "[-6e-3, -5.04825e-3, -4.9e-3, 0.1]",
                               "bodies.second_radius_x": uniform(-30e-3, -25e-3)}),
    "a flat face": (FACES | MODULI, {"bodies.first_radius_y": "[4.7625e-3, 4.8e-3]",
                                     "bodies.second_radius_x": "[-0.1, -27.7625e-3, 0.1, inf]"}),
    "faces of a line": (FACES_OF_LINE, {"bodies.first_radius_x": uniform(12e-3, 15e-3),
                                        "bodies.second_radius_x": "[20.95e-3, inf]"}),
    "moments, a grid": (CIRCLE | MOMENTS, {"surface.m2": "[5e-5, 1e-4, 2e-4]", "closures.asperity":
                                           '["greenwood_tripp", "greenwood_williamson"]'}),
    "moments, drawn": (ELLIPSE | MOMENTS, {"surface.m0": uniform(2e-15, 3e-15), "surface.m2": uniform(8e-5, 1.2e-4),
                                           "surface.m4": uniform(3e7, 5e7)}),
    "moments of a line": (LINE | MOMENTS, {"surface.m4": uniform(3e7, 5e7), "bodies.length": "[4e-3, 5e-3]"}),
}
FEW = [0.01, 0.2, 2.0]
MANY = [0.001 * 1.5**i for i in range(20)]


class Shapes(SweepTest):
    def case_values(self, group, case):
        """The varied fields of a case, as TOML."""
        values = {}
        for path, data in group["inputs"].items():
            words = [word.decode() if isinstance(word, bytes) else word for word in data.attrs.get("words", [])]
            values[path] = f'"{words[int(data[case])]}"' if words else repr(float(data[case]))
        return values

    def case_text(self, scene, values, speeds):
        return sweep({**scene, **values, "speed": repr(speeds)}).replace("[sweep]\n", "")

    def points(self, text):
        """The points of a scene by `stream`. If a radius is infinite, which JSON cannot hold, they come from `solve`."""
        tree = tomllib.loads(text)
        if any(isinstance(value, float) and math.isinf(value) for value in tree["bodies"].values()):
            return run("solve", self.folder.write("case.toml", text), "--format", "json").json()["points"]
        asked = "".join(json.dumps(tree | {"id": str(speed), "speed": speed}) + "\n" for speed in tree["speed"])
        return run("stream", stdin=asked).json_lines()

    def test_points_are_those_of_stream(self):
        for what, (scene, varied) in PLANS.items():
            is_drawn = any("distribution" in value for value in varied.values())
            for speeds in (FEW, MANY):
                with self.subTest(what, speeds=len(speeds)):
                    self.swept(sweep({**scene, **varied, "speed": repr(speeds)}, **({"draws": 5} if is_drawn else {})),
                               "--force")
                    with opened(self.path("out.h5")) as file:
                        group = file["smooth"]
                        cases = group["outputs/film"].shape[0]
                        self.assertGreaterEqual(cases, 3)
                        films = set()
                        for case in range(cases):
                            text = self.case_text(scene, self.case_values(group, case), speeds)
                            points = self.points(text)
                            self.assertEqual(len(points), len(speeds), text)
                            for j, point in enumerate(points):
                                for name, data in group["outputs"].items():
                                    self.assert_same(data[case][j], point[name], name, data)
                            films.add((points[0]["film"], points[0]["asperity_load_share"]))
                        self.assertEqual(len(films), cases, "each case has results of its own")

    def test_onsets_are_those_of_onset(self):
        criteria = ["film_maximum", "film_departure", "friction_minimum"]
        for what, (scene, varied) in PLANS.items():
            is_drawn = any("distribution" in value for value in varied.values())
            with self.subTest(what):
                speed = "{ from = 1e-4, to = 30 }"
                self.swept(sweep({**scene, **varied, "speed": speed}, onset=json.dumps(criteria),
                                 **({"draws": 3} if is_drawn else {})), "--force")
                with opened(self.path("out.h5")) as file:
                    group = file["smooth"]
                    for case in range(group["outputs/onset/film_maximum/speed"].shape[0]):
                        text = sweep({**scene, **self.case_values(group, case), "speed": speed}).replace("[sweep]\n", "")
                        rows = run("onset", self.folder.write("case.toml", text), "--format", "json",
                                   *(part for one in criteria for part in ("--criterion", one))).json()["onsets"]
                        self.assertEqual([row["criterion"] for row in rows], criteria)
                        for row in rows:
                            for number in ("speed", "film", "film_parameter"):
                                data = group[f"outputs/onset/{row['criterion']}/{number}"]
                                tolerance = 1e-6 if row["criterion"] == "friction_minimum" else 1e-13
                                if row[number] is None:
                                    self.assertTrue(math.isnan(data[case]), (row, number))
                                else:
                                    self.assertLessEqual(abs(data[case] - row[number]), tolerance * row[number],
                                                         (row, number))

    def test_show_and_estimate_take_them(self):
        text = sweep({**FACES_OF_LINE, **PLANS["faces of a line"][1], "speed": "[0.1, 1.0]"}, draws=4)
        self.swept(text)
        self.assertEqual(run("sweep", self.path("sweep.toml"), "--estimate").code, 0)
        cases = run("sweep", "show", self.path("out.h5"), "--cases", "--format", "csv").ended(0, "")
        self.assertEqual(len(cases.out.splitlines()), 1 + 2 * 4 * 2)

    def test_a_flat_face_is_told_as_inf_and_left_out_of_a_map_of_films(self):
        speeds, outputs = "{ from = 1e-3, to = 1, count = 30 }", '["film"]'
        for radii, drawn in (("[0.05, 0.1, 0.2, inf]", True), ("[-inf, -0.2, -0.1, -0.05]", True),
                             ("[-0.1, 0.05, 0.1, 0.2]", False)):
            with self.subTest(radii):
                shutil.rmtree(self.path("drawn"), ignore_errors=True)
                self.swept(sweep({**FACES, "bodies.second_radius_x": radii, "speed": speeds, "outputs": outputs}),
                           "--force", "--pictures", self.path("drawn"))
                names = os.listdir(self.path("drawn")) if os.path.isdir(self.path("drawn")) else []
                self.assertEqual("film_map.svg" in names, drawn, names)
                if drawn:
                    with open(self.path("drawn/film_map.svg"), encoding="utf-8") as file:
                        self.assertIn("flat faces are left out", file.read())
                told = {form: run("sweep", "show", self.path("out.h5"), "--cases", "--format", form).out
                        for form in ("csv", "json")}
                rows = [json.loads(line)["bodies.second_radius_x"] for line in told["json"].splitlines()]
                self.assertEqual([float(one) for one in rows],
                                 [float(line.split(",")[2]) for line in told["csv"].splitlines()[1:]])
                self.assertEqual({one for one in rows if isinstance(one, str)}, {"inf", "-inf"} & set(rows))
                self.assertEqual(sorted({float(one) for one in rows}), sorted(map(float, radii.strip("[]").split(", "))))

    # Each row has a scene, the inputs that vary, and words of the error message, which is one line.
    REFUSED = [
        # One value of a grid gives a face that does not touch the other body's face.
        (FACES, {"bodies.second_radius_y": "[-4e-3, -5.04825e-3, 0.1]"},
         ["bodies.first_radius_y: where bodies.second_radius_y is -0.004: 0.0047625 is not allowed beside second_radius_y",
          "the faces do not meet at a point; allowed: 1/first_radius_y + 1/second_radius_y above 0"]),
        (FACES, {"bodies.first_radius_x": "[4.7625e-3, 20e-3, 40e-3]"},
         ["bodies.first_radius_x: a value of its grid: 0.04 is not allowed beside second_radius_x", "do not meet"]),
        # The radius nearest below 0 is neither the least nor the greatest of the grid.
        (FACES, {"bodies.second_radius_x": "[-30e-3, -4e-3, -27.7625e-3, 0.1, 1]"},
         ["where bodies.second_radius_x is -0.004: ", "do not meet"]),
        (FACES, {"bodies.second_radius_x": "[0, -27.7625e-3, 0.1]"}, ["bodies.second_radius_x: a value of its grid: 0 is"]),
        (FACES, {"bodies.second_radius_x": "{ from = -1, to = 1, count = 3, spacing = \"lin\" }"},
         ["bodies.second_radius_x: 0 is not allowed"]),
        # Every value of one grid is allowed with the middle value of the other grid, but one pair of outer values is not.
        (FACES, {"bodies.first_radius_x": "[4e-3, 5e-3, 25e-3]", "bodies.second_radius_x": "[-60e-3, -30e-3, -20e-3]"},
         ["bodies.first_radius_x: where bodies.first_radius_x is 0.025 and bodies.second_radius_x is -0.02: ",
          "do not meet"]),
        (FACES_OF_LINE, {"bodies.second_radius_x": "[-13.97e-3, 20.95e-3, 1]"},
         ["where bodies.second_radius_x is -0.01397: ", "do not meet"]),
        (FACES, {"bodies.second_radius_x": "[-30e-3, -4e-3, 0.1]"},
         ["bodies.first_radius_x: 0.0047625 is not allowed beside second_radius_x, which is -0.004: the faces do not meet"]),
        # Each radius is allowed alone, but double cannot hold the ellipse of the two.
        (ELLIPSE, {"bodies.radius_x": "[1e-250, 9.5e-3, 1]", "bodies.radius_y": "[1e-3, 19e-3, 1e250]"},
         ["bodies.radius_y: where bodies.radius_x is 1e-250 and bodies.radius_y is 1e+250: "]),
        # Distributions that reach a value that is refused.
        (FACES, {"bodies.second_radius_y": uniform(-6e-3, -4.5e-3)},
         ["bodies.first_radius_y: where bodies.second_radius_y reaches -0.0045: ", "do not meet"]),
        (FACES, {"bodies.second_radius_y": '{ distribution = "normal", mean = -5.1e-3, sd = 1e-4 }'},
         ["where bodies.second_radius_y reaches -0.004", "do not meet"]),
        (FACES, {"bodies.second_radius_x": '{ distribution = "normal", mean = 0.02, sd = 0.01 }'},
         ["bodies.second_radius_x: this normal distribution reaches 0; ", ": truncate it with `from`"]),
        (FACES, {"bodies.second_radius_x": uniform(-1, 1.5)},
         ["bodies.second_radius_x: this uniform distribution reaches 0; second_radius_x must be a number other than 0"]),
        (FACES, {"bodies.first_radius_y": uniform(4e-3, 6e-3)},
         ["bodies.first_radius_y: where bodies.first_radius_y reaches 0.006: ", "do not meet"]),
        (FACES, {"bodies.first_radius_y": uniform(4e-3, 5e-3), "bodies.second_radius_y": uniform(-6e-3, -4.8e-3)},
         ["where bodies.first_radius_y reaches 0.005 and bodies.second_radius_y reaches -0.0048: ", "do not meet"]),
        # A film law of the wrong kind, for points on a line or for lines on an ellipse, at any place of the list.
        (LINE, {"closures.film": '["dowson_higginson_minimum", "dowson_toyoda_central", "hamrock_dowson_central"]'},
         ["closures.film: a value of its grid: \"hamrock_dowson_central\" is not allowed: the contact is a line"]),
        (ELLIPSE, {"closures.film": '["pan_hamrock_central", "hamrock_dowson_central"]'},
         ["closures.film: a value of its grid: \"pan_hamrock_central\" is not allowed: the contact is no line"]),
        # Moments that no profile has.
        (CIRCLE | MOMENTS, {"surface.m2": "[1e-4, 2e-4, 4e-4]"},
         ["surface.m4: where surface.m2 is 4e-4: 4e+7 is not allowed: m0 · m4/m2² = "]),
        (CIRCLE | MOMENTS, {"surface.m2": "[1e-4, 1.5e-4, 2.5e-4]", "surface.m4": "[2e7, 4e7, 6e7]"},
         ["surface.m4: where surface.m2 is 0.00025 and surface.m4 is 2e+7: ", "m0 · m4/m2² = "]),
        (CIRCLE | MOMENTS, {"surface.m2": uniform(1e-4, 4e-4)}, ["surface.m4: where surface.m2 reaches 0.0004: "]),
        (CIRCLE | MOMENTS, {"surface.m4": uniform(3e6, 4e7)},
         ["surface.m4: where surface.m4 reaches 3e+06: 3000000", " is not allowed: m0 · m4/m2² = "]),
        # Roelands' law, where a varied word chooses it.
        (CIRCLE, {"lubricant.viscosity": "[5e-5, 1e-3, 1e-2]", "friction.viscosity": '["roelands", "barus"]'},
         ["lubricant.viscosity: where lubricant.viscosity is 5e-5 and friction.viscosity is roelands: "]),
        # A number outside its own range, and fields that do not belong to this scene.
        (ELLIPSE, {"bodies.radius_y": "[19e-3, -19e-3]"}, ["bodies.radius_y: -0.019 is not allowed"]),
        (LINE, {"bodies.length": uniform(-1e-3, 1e-2)},
         ["bodies.length: this uniform distribution reaches −0.001; length must be a number above 0"]),
        (CIRCLE | MODULI, {"bodies.first_poisson_ratio": "[0.3, 0.6]"}, ["bodies.first_poisson_ratio: 0.6 is not allowed"]),
        (CIRCLE, {"bodies.radius_y": "[9.5e-3, 19e-3]"}, ["bodies.radius_y: given beside bodies.reduced_radius"]),
    ]

    def test_what_no_contact_is_made_of_is_refused_in_one_line(self):
        for scene, varied, words in self.REFUSED:
            with self.subTest(varied=varied):
                done = self.sweep(sweep({**scene, **varied, "speed": "[0.1, 1.0]"}))
                errors = [line for line in done.error_lines if " warning: " not in line]
                self.assertEqual((done.code, done.out, len(errors)), (2, "", 1), done.err)
                for word in words:
                    self.assertIn(word, errors[0])
                self.assertNotIn("out.h5", self.names())

    def test_faces_at_the_rim_of_meeting_are_taken(self):
        """All pairs of faces touch. The pair of 19.9e-3 and -20e-3 is only just allowed."""
        self.swept(sweep({**FACES, "bodies.first_radius_x": "[4e-3, 5e-3, 19.9e-3]",
                          "bodies.second_radius_x": "[-60e-3, -30e-3, -20e-3, 0.5]", "speed": "0.1"}))
        with opened(self.path("out.h5")) as file:
            films = file["smooth/outputs/film_flooded"][()]
            self.assertEqual(films.shape, (12,))
            self.assertTrue((films > 0).all())


if __name__ == "__main__":
    unittest.main()
