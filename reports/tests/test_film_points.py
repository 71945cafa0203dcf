# SPDX-License-Identifier: Apache-2.0
"""film: circles and ellipses, flooded and starved, their fields and pictures."""

import csv
import math
import os
import re
import unittest

import h5py
import svg_plots
from program import run
from report_files import ROOT
from test_film import MODULUS, RADIUS, VISCOSITY, FilmTest, film_number, line, shear_stress

CHITTENDEN = ("chittenden_central_431", "chittenden_central_430", "chittenden_minimum_368")
NIJENBANNING = ("nijenbanning_three_halves_of_s", "nijenbanning_ei_over_ep", "nijenbanning_ei_over_ep_of_s")


class Points(FilmTest):
    def point(self, load_number, material_number, radius_ratio=1):
        tree = line(10, material_number)
        tree["load"] = load_number*2*MODULUS*RADIUS**2*(VISCOSITY/(MODULUS*RADIUS))**0.75
        tree["bodies"] = {"effective_modulus": MODULUS, "radius_x": RADIUS, "radius_y": radius_ratio*RADIUS}
        return tree

    def test_a_circle_is_solved_beside_the_laws_of_points(self):
        found = self.film(self.point(20, 10), "--tolerance", "1e-2")
        self.assertAlmostEqual(found["load_number"], 20, delta=1e-9)
        self.assertAlmostEqual(found["ellipticity"], 1, delta=1e-12)
        # Film numbers computed by this solver on four grids. The least film is beside the middle.
        for quantity, known in [("central_film", 4.8588), ("minimum_film", 3.0201), ("film_at_greatest_pressure", 4.8587)]:
            solved = found[quantity]
            self.assertAlmostEqual(film_number(solved["value"]), known, delta=film_number(solved["error"]) + 1e-3)
            self.assertLess(solved["error"], 1e-2*solved["value"])
        self.assertIsNone(found["spike_pressure"])
        self.assertIn("circles and ellipses", found["undefined"]["spike_pressure"])
        self.assertEqual([one["name"] for one in found["formulas"]],
                         [*(f"hamrock_dowson_{kind}{film}" for kind in ("", "soft_") for film in ("central", "minimum")),
                          "nijenbanning_venner_moes", *CHITTENDEN, *NIJENBANNING])
        for one in found["formulas"]:
            self.assertIsNone(one["deviation_percent"])
            self.assertAlmostEqual(one["this_liquid_deviation_percent"],
                                   100*(one["film"]/found[one["stands_for"]]["value"] - 1), delta=1e-10)
        self.assertEqual(found["tolerance"], 1e-2)
        self.assertGreater(found["cells_across"], 0)

    def test_chittendens_film_is_that_of_the_radii_in_the_cited_form(self):
        found = self.film(self.point(20, 10, 2.5), "--tolerance", "1e-2")
        films = {one["name"]: film_number(one["film"]) for one in found["formulas"]}
        # U^0.68 G^0.49 W^-0.073 of the contact as a film number (h/R)(2U)^(-1/2).
        twice = VISCOSITY/(MODULUS*RADIUS)
        powers = (twice/2)**0.68*(10*twice**-0.25)**0.49*(20*twice**0.75)**-0.073*twice**-0.5
        side = 2.5**(2/3)
        self.assertAlmostEqual(films["chittenden_central_431"], 4.31*powers*(1 - math.exp(-1.23*side)), delta=1e-9)
        self.assertAlmostEqual(films["chittenden_minimum_368"], 3.68*powers*(1 - math.exp(-0.67*side)), delta=1e-9)
        self.assertAlmostEqual(films["chittenden_central_430"], 4.30*powers*(1 - math.exp(-1.28*found["ellipticity"])), delta=1e-9)

    def test_a_ball_by_its_radius_is_the_circle_by_two(self):
        two = self.point(20, 5)
        ball = two | {"bodies": {"effective_modulus": MODULUS, "reduced_radius": RADIUS}}
        self.assertEqual(self.film(ball, "--tolerance", "1e-2"), self.film(two, "--tolerance", "1e-2"))

    def test_an_ellipse_across_the_motion_carries_a_thicker_film(self):
        films = [self.film(self.point(20, 5, ratio), "--tolerance", "1e-2") for ratio in (0.5, 1, 2)]
        self.assertEqual(sorted(one["ellipticity"] for one in films), [one["ellipticity"] for one in films])
        for quantity in ("central_film", "minimum_film"):
            values = [one[quantity]["value"] for one in films]
            self.assertEqual(sorted(values), values)

    def test_a_constant_viscosity_has_films_of_soft_bodies_and_of_all_regimes(self):
        found = self.film(self.point(50, 0), "--tolerance", "1e-2")
        self.assertEqual([one["name"] for one in found["formulas"] if one["film"] is not None],
                         ["hamrock_dowson_soft_central", "hamrock_dowson_soft_minimum", "nijenbanning_venner_moes", *NIJENBANNING])

    def test_the_shipped_ball_is_as_the_readme_says(self):
        ball = ROOT / "reference/scenes/ball_on_flat.toml"
        found, = run("film", str(ball), "--speed", "1", "--tolerance", "1e-2", "--format", "json").ended(0, "").json()["films"]
        readme = (ROOT / "reports/program/README.md").read_text(encoding="utf-8")
        self.assertIn(f"a least film beside the middle of {1e9*found['minimum_film']['value']:.1f} nm", readme)
        formula, = (one["film"] for one in found["formulas"] if one["name"] == "hamrock_dowson_minimum")
        self.assertIn(f"formula says {1e9*formula:.1f} nm", readme)

    def starved(self, layer, **supply):
        """The circle at M = 20, L = 10, behind a layer of `layer` times its flooded central film (4.8587 as a film number), or with `supply`."""
        ball = self.point(20, 10)
        return ball | {"supply": supply or {"inlet_film": layer*4.8587/film_number(1)}}

    def test_a_layer_of_oil_starves_a_circle(self):
        flooded = self.film(self.point(20, 10), "--tolerance", "1e-2")
        self.assertNotIn("film_ratio", flooded)
        found = self.film(self.starved(1), "--tolerance", "1e-2")
        self.assertEqual((flooded["assumptions"]["inlet"], found["assumptions"]["inlet"]), ("flooded", "starved"))
        self.assertEqual(found["flooded_central_film"], flooded["central_film"])
        self.assertEqual(found["formulas"], flooded["formulas"])
        # The ratio 0.7702 was computed by this solver on four grids.
        ratio, layer = found["film_ratio"], found["inlet_film"]/flooded["central_film"]["value"]
        self.assertAlmostEqual(ratio["value"], 0.7702, delta=ratio["error"] + 1e-3)
        self.assertAlmostEqual(ratio["value"], found["central_film"]["value"]/flooded["central_film"]["value"], delta=1e-12)
        self.assertAlmostEqual(layer, 1, delta=1e-3)
        gamma = found["damiens_exponent"]
        self.assertAlmostEqual(layer/(1 + layer**gamma)**(1/gamma), ratio["value"], delta=1e-9)
        closures = {one["name"]: one for one in found["closures"]}
        self.assertEqual(list(closures), ["flooded_inlet", "starved_inlet", "printed_exponents", "damiens"])
        self.assertAlmostEqual(closures["damiens"]["film_ratio"], layer/(1 + layer**3)**(1/3), delta=1e-12)
        for one in closures.values():
            self.assertAlmostEqual(one["deviation_percent"], 100*(one["film_ratio"]/ratio["value"] - 1), delta=1e-9)
        self.assertEqual(self.film(self.starved(1), "--flooded", "--tolerance", "1e-2"), flooded)
        self.assert_film_refused("no scene here has one", self.write(self.point(20, 10)), "--flooded")

    def test_supplies_of_one_layer_are_one_film(self):
        one = self.film(self.starved(0.6), "--tolerance", "1e-2")
        layer = one["inlet_film"]
        flow = self.film(self.starved(0, inlet_flow=layer*one["speed"]), "--tolerance", "1e-2")
        self.assertAlmostEqual(flow["central_film"]["value"], one["central_film"]["value"], delta=1e-9*layer)
        refused = self.write(self.starved(0, inlet_film_ratio=4))
        self.assert_film_refused("supply.inlet_film_ratio: it is a ratio to σ_s", refused)

    def test_a_layer_that_floods_the_contact_is_not_solved(self):
        result = run("film", self.write(self.starved(50)), "--tolerance", "1e-2").ended(1)
        self.assertIn("a thicker one all but floods the contact", result.err)
        self.assertIn("not solved", result.out)

    def test_rows_of_both_kinds_stand_in_one_csv(self):
        paths = [self.write(line(10, 5), "line.toml"), self.write(self.point(20, 5), "ball.toml")]
        rows = list(csv.DictReader(run("film", *paths, "--tolerance", "1e-2", "--format", "csv").out.splitlines()))
        self.assertEqual([bool(row["ellipticity"]) for row in rows], [False, True])
        self.assertEqual([bool(row["moes_line"]) for row in rows], [True, False])
        self.assertEqual([bool(row["hamrock_dowson_central"]) for row in rows], [False, True])
        self.assertEqual([row["tolerance"] for row in rows], ["0.01", "0.01"])

    def test_a_load_too_small_is_told(self):
        found, = self.films(self.point(0.9, 0), code=1)
        self.assertIn("M = 0.9 is below 1: the load is too small to flatten the bodies", found["reason"])

    def test_the_picture_shows_both_fields_the_middle_and_the_nearest_laws(self):
        path, picture = self.write(self.point(20, 8)), self.folder.path("ball.svg")
        run("film", path, "--tolerance", "1e-2", "--picture", picture).ended(0)
        with open(picture, encoding="utf-8") as file:
            text = file.read()
        self.assertEqual(list(svg_plots.looks(picture)), [])
        self.assertRegex(text, r"point contact at 1 m/s; least film [0-9.]+ nm<")
        for words in ("film thickness h (nm), × where least", "pressure p (GPa)", "at y = 0"):
            self.assertIn(words, text)
        self.assertEqual(text.count("<image"), 2)
        for name in ("Chittenden et al.", "Nijenbanning et al."):  # a law of the least film and one of the central film
            self.assertEqual(text.count(name), 1, name)
        self.assertNotIn(", soft", text)

    def fields(self, tree, name):
        """Returns the fields that --fields wrote, as {(x, y): (p, h)}, and the film of the JSON text."""
        target = self.folder.path(name)
        result = run("film", self.write(tree), "--tolerance", "1e-2", "--fields", target, "--format", "json", "--profile")
        self.assertEqual((result.code, result.err), (0, f"tribocheck: wrote {target}\n"))
        found, = result.json()["films"]
        if name.endswith(".csv"):
            with open(target, encoding="utf-8") as file:
                self.assertEqual(file.readline(), "x [m],y [m],pressure [Pa],film [m]\n")
                rows = [tuple(map(float, line.split(","))) for line in file]
            return {row[:2]: row[2:] for row in rows}, found
        with h5py.File(target) as file:
            self.assertEqual({one: file[one].attrs["unit"] for one in file}, {"x": "m", "y": "m", "pressure": "Pa", "film": "m"})
            for number in ("speed", "load_number", "material_number", "half_width", "ellipticity", "peak_pressure"):
                self.assertEqual(file.attrs[number], found[number])
            return {(x, y): (p, h) for y, *rows in zip(file["y"], file["pressure"], file["film"])
                    for x, p, h in zip(file["x"], *rows)}, found

    def test_friction_is_the_shear_stress_of_all_places_over_the_load(self):
        for fluid, viscosity in (("eyring", "barus"), ("limiting", "roelands")):
            tree = self.point(20, 5)
            tree["lubricant"]["eyring_stress"] = 5e6
            tree["friction"] = {"fluid": fluid, "viscosity": viscosity, "slide_roll_ratio": 0.2}
            fields, found = self.fields(tree, "ball.csv")
            places = sorted({x for x, _ in fields}), sorted({y for _, y in fields})
            cell = math.prod((one[-1] - one[0])/(len(one) - 1) for one in places)
            expected = cell*sum(shear_stress(tree, *at) for at in fields.values() if at[0] > 0)/tree["load"]
            friction = found["friction"]
            # The fields are of the finest grid. The value is extrapolated from all grids, and differs little.
            self.assertAlmostEqual(friction["value"], expected, delta=3*friction["error"])
            self.assertLess(friction["error"], 0.1*expected)
        del tree["lubricant"]["eyring_stress"]
        found = self.film(tree, "--tolerance", "1e-2")
        self.assertIsNone(found["friction"])
        self.assertIn("eyring_stress", found["undefined"]["friction"])

    def test_fields_are_those_of_the_whole_contact_and_the_same_in_both_formats(self):
        tree = self.point(20, 5, 2)
        fields, found = self.fields(tree, "ball.csv")
        self.assertEqual(fields, self.fields(tree, "ball.h5")[0])
        self.assertEqual(len(fields), (found["cells"] + 1)*(found["cells_across"] + 1))
        middle = found["profile"]
        self.assertEqual([fields[x, 0] for x in middle["x"]], list(zip(middle["pressure"], middle["film"])))
        for (x, y), values in fields.items():
            self.assertEqual(values, fields[x, -y])
        xs, ys = (sorted({place[i] for place in fields}) for i in (0, 1))
        carried = sum(p for p, _ in fields.values())*(xs[1] - xs[0])*(ys[1] - ys[0])
        self.assertTrue(0.9*tree["load"] < carried < tree["load"], carried/tree["load"])  # a part of the load is outside the grid
        self.assertAlmostEqual(min(h for _, h in fields.values())/found["minimum_film"]["value"], 1, delta=2e-2)

    def test_fields_are_refused_before_the_film_is_solved(self):
        ball, csv_file = self.write(self.point(20, 5)), self.folder.path("a.csv")
        self.assert_film_refused("is a line contact; allowed: --profile", self.write(line(10, 5), "line.toml"), "--fields", csv_file)
        self.assert_film_refused("--fields writes one contact, and this would be 2", ball, ball, "--fields", csv_file)
        self.assert_film_refused("allowed: a name that ends in .h5 or .csv", ball, "--fields", self.folder.path("a.txt"))
        lost = run("film", ball, "--fields", self.folder.path("none/a.h5"))
        self.assertEqual((lost.code, lost.out, len(lost.error_lines)), (1, "", 1))
        self.assertIn("cannot write", lost.err)
        os.mkdir(csv_file)
        self.assert_film_refused("is a directory", ball, "--fields", csv_file)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["a.csv", "line.toml", "scene.toml"])

    def test_an_estimate_holds_the_grid_that_is_solved_and_solves_nothing(self):
        path = self.write(self.point(20, 5))
        head, *lines = run("film", path, "--tolerance", "1e-2", "--estimate").ended(0, "").out.splitlines()
        grids = re.fullmatch(r"line at 1 m/s: M = 20, L = 5, barus, incompressible, to 0\.01: (\d) to (\d) grids, the finest of (\d+) to (\d+) nodes", head)
        self.assertRegex("\n".join(lines), r"^contacts 1\ntime   \S+ s to \S+ s on 1 thread, roughly\nmemory \S+ MB to \S+ [MG]B$")
        found = self.film(self.point(20, 5), "--tolerance", "1e-2")
        self.assertEqual(int(grids[1]), found["grids"])
        self.assertEqual(int(grids[3]), (found["cells"] + 1)*(found["cells_across"]//2 + 1))
        self.assertGreater(int(grids[4]), int(grids[3]))
        self.assertIn("M = 0.9 is below 1", run("film", self.write(self.point(0.9, 5), "light.toml"), "--estimate").out)
        several = run("film", self.write(line(10, 5, speed=[0.5, 1]), "line.toml"), path, "--estimate").out
        self.assertIn("\ncontacts 3\n", several)

    def test_an_estimate_tells_refused_speeds_by_their_range(self):
        # M ∝ u^(−3/4): the first three are too heavy for the grids, the last two too light; the one between is solved.
        told = run("film", self.write(self.point(20, 5) | {"speed": [1e-7, 2e-7, 3e-7, 1, 1e3, 2e3]}), "--estimate").out.splitlines()
        self.assertRegex(told[0], r"^line at 1e-07 to 3e-07 m/s \(3 speeds\): M = \S+ to \S+, L = \S+ to \S+, barus, incompressible, to 0.001: refused, "
                                  r"the first because: an error needs three grids")
        self.assertRegex(told[1], r"^line at 1 m/s: M = 20, L = 5, .* grids, the finest of")
        self.assertRegex(told[2], r"^line at 1000 to 2000 m/s \(2 speeds\): .*: refused, the first because: M = 0\.\d+ is below 1")
        for refused, speeds in ((told[0], (1e-7, 3e-7)), (told[2], (1e3, 2e3))):
            numbers = re.search(r"M = (\S+) to (\S+), L = (\S+) to (\S+), ", refused).groups()
            for number, expected in zip(numbers, [20*u**-0.75 for u in speeds] + [5*u**0.25 for u in speeds]):
                self.assertAlmostEqual(float(number)/expected, 1, delta=1e-4, msg=refused)
        self.assertEqual(told[3], "contacts 1")
        twice = [self.write(self.point(0.9, 5) | {"id": name}, name) for name in ("a", "b")]
        self.assertEqual([one.partition(" at ")[0] for one in run("film", *twice, "--estimate").out.splitlines()[:2]], ["a", "b"])


if __name__ == "__main__":
    unittest.main()
