# SPDX-License-Identifier: Apache-2.0
"""closures.film = "solved": points with a film, points without one and why, ellipses, onsets, streams and sweeps."""

import itertools
import json
import math
import unittest

from program import ProgramTest, run, scene
from report_files import ROOT
from sweeps import SweepTest, opened

REASON = ("Moes' M or L is outside the tables of solved films, so that \"solved\" in closures has no film "
          "there")


def solved(**changes):
    tree = scene(**changes)
    tree["closures"] = {**tree.get("closures", {}), "film": "solved"}
    return tree


class FilmsBetween(ProgramTest):
    def answer(self, command, tree, *arguments, code=0):
        result = run(command, self.folder.write("scene.toml", tree), *arguments)
        self.assertEqual(result.code, code, result.err)
        return result

    def test_a_point_outside_of_the_table_is_undefined_with_the_reason(self):
        tree = solved(speed=[1e-4, 0.3, 50], outputs=["film", "regime", "minimum_film", "peak_pressure"])
        points = self.answer("solve", tree, "--format", "json").json()["points"]
        self.assertEqual([point["film"] is None for point in points], [True, False, True])
        for point in points:
            self.assertGreater(point["peak_pressure"], 1e8)
            if point["film"] is None:
                self.assertEqual(point["undefined"],
                                 {name: REASON for name in ("film", "regime", "minimum_film")})
            else:
                self.assertNotIn("undefined", point)
                self.assertTrue(0.2 * point["film"] < point["minimum_film"] < 0.9 * point["film"])

    def test_it_is_near_the_law_of_all_regimes(self):
        films = []
        for law in ("solved", "nijenbanning_venner_moes"):
            tree = solved(speed=0.3, outputs=["film"])
            tree["closures"]["film"] = law
            films.append(self.answer("solve", tree, "--format", "json").json()["points"][0]["film"])
        self.assertAlmostEqual(films[0] / films[1], 1, delta=0.05)
        self.assertNotEqual(films[0], films[1])

    def test_an_ellipse_is_refused(self):
        tree = solved(speed=0.3)
        tree["bodies"] = {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "radius_y": 2e-2}
        result = run("solve", self.folder.write("scene.toml", tree)).ended(2)
        self.assertIn("the contact is an ellipse, and films of circles and of lines alone are solved", result.err)

    def test_stream_and_onset_give_what_solve_gives(self):
        tree = solved(speed=[0.3], outputs=["film", "friction"])
        point = self.answer("solve", tree, "--format", "json").json()["points"][0]
        line = json.loads(run("stream", stdin=json.dumps({**tree, "speed": 0.3}) + "\n").out)
        self.assertEqual((line["film"], line["friction"]), (point["film"], point["friction"]))
        tree = solved(speed={"from": 0.05, "to": 3, "count": 3})
        onsets = self.answer("onset", tree, "--format", "json").json()["onsets"]
        top = [one for one in onsets if one["criterion"] == "film_maximum"][0]
        self.assertTrue(0.05 < top["speed"] < 3)

    def test_starved_films_are_solved_beside_flooded_ones_alone(self):
        starved = {"supply": {"inlet_film": "500 nm"}, "closures": {"film": "solved", "starvation": "solved"}}
        for changes, reason in ((
                {"closures": {"film": "nijenbanning_venner_moes", "starvation": "solved"}},
                "closures.starvation: \"solved\" is not allowed with closures.film = \"nijenbanning_venner_moes\": starved films "
                "were solved beside flooded ones"),
                ({"bodies": {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 5e-3}},
                 "the contact is no circle, and starved films of circles alone are a table")):
            tree = scene(**{**starved, "speed": 1, **changes})
            self.assertIn(reason, run("solve", self.folder.write("scene.toml", tree)).ended(2).err)

    def test_starved_films_between_solved_ones(self):
        tree = solved(speed=[0.001, 0.8, 50], outputs=["film", "film_flooded", "inlet"], supply={"inlet_film": "400 nm"})
        tree["closures"]["starvation"] = "solved"
        points = self.answer("solve", tree, "--format", "json").json()["points"]
        self.assertEqual([point["film"] is None for point in points], [True, False, True])
        self.assertEqual(points[0]["undefined"]["film"], REASON)
        film = points[1]["film"]
        self.assertTrue(0.5*min(points[1]["film_flooded"], 4e-7) < film < min(points[1]["film_flooded"], 4e-7))
        line = json.loads(run("stream", stdin=json.dumps({**tree, "speed": 0.8}) + "\n").out)
        self.assertEqual(line["film"], film)
        found = {one["criterion"]: one for one in
                 self.answer("onset", tree, "--format", "json").json()["onsets"]}
        self.assertIn("no maximum within", found["film_maximum"]["undefined"]["speed"])
        tree["speed"] = found["film_departure"]["speed"]
        at = self.answer("solve", tree, "--format", "json").json()["points"][0]
        self.assertAlmostEqual(at["film"]/at["film_flooded"], 0.95, delta=1e-9)

    def test_they_have_the_ratios_of_the_films_solved_for_the_paper(self):
        solved_films = json.loads((ROOT / "reference/baselines/paper_films.json").read_text())["surfaces"]
        tree, held = solved(outputs=["film", "film_flooded"]), 0
        tree["closures"]["starvation"] = "solved"
        tree["load"] = 50
        tree["lubricant"] |= {"viscosity": 0.0202, "pressure_viscosity": 2e-8}
        tree["bodies"] = {"effective_modulus": 107.9e9, "reduced_radius": 9.5e-3}
        del tree["surface"]
        for film in itertools.chain.from_iterable(solved_films.values()):
            tree |= {"speed": film["speed"], "supply": {"inlet_film": film["inlet_film"]}}
            point = self.answer("solve", tree, "--format", "json").json()["points"][0]
            self.assertEqual(point["film"] is not None, 20 <= film["load_number"] <= 2000, film)
            if point["film"] is not None:
                ratio = film["film_ratio"]
                self.assertAlmostEqual(point["film"]/point["film_flooded"], ratio["value"], delta=ratio["error"] + 4e-3)
                held += 1
        self.assertGreater(held, 20)


SWEEP = """id = "between"
load = [50, 60]
speed = [1e-4, 0.3]
outputs = ["film", "regime", "inlet"]
[surface]
summit_density = 5e10
summit_radius = 1e-5
summit_height_sd = 1e-7
[bodies]
effective_modulus = 107.9e9
reduced_radius = 9.5e-3
[lubricant]
viscosity = 0.0202
pressure_viscosity = 2e-8
[closures]
film = "solved"
"""


class Sweeps(SweepTest):
    def test_words_of_points_without_a_film_are_undefined(self):
        self.sweep(SWEEP, out="once.h5")
        with opened(self.path("once.h5")) as file:
            outputs = file["between/outputs"]
            films = outputs["film"][:]
            self.assertEqual([[math.isnan(film) for film in row] for row in films], [[True, False]] * 2)
            for name in ("regime", "inlet"):
                words = [word.decode() if isinstance(word, bytes) else word for word in outputs[name].attrs["words"]]
                for row in outputs[name][:]:
                    self.assertEqual([words[int(code)] == "undefined" for code in row], [True, False], name)


if __name__ == "__main__":
    unittest.main()
