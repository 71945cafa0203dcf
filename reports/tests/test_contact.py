# SPDX-License-Identifier: Apache-2.0
"""contact, and the outputs of the smooth contact: each number is computed in a second way."""

import json
import math
import os
import pathlib
import re
import unittest

from program import ProgramTest, quiet_scene, run, scene, with_field, without_field
from sweeps import sweep

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
SMOOTH = ["peak_pressure", "mean_pressure", "minimum_film", "lambda_ratio"]
LINE = {"closures": {"film": "dowson_toyoda_central"},
        "bodies": {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 1e-2}}


def values(facts):
    return {fact["name"]: fact["value"] for fact in facts}


class ContactTest(ProgramTest):
    def told(self, tree, code=0):
        result = run("contact", self.folder.write("scene.json", tree), "--format", "json")
        self.assertEqual((result.code, result.err), (code, ""))
        told, = result.json()["scenes"]
        return told

    def at(self, tree, speed):
        at, = self.told(tree | {"speed": speed})["speeds"]
        return at

    def assert_near(self, value, expected, relative=1e-12):
        if expected == 0:
            return self.assertEqual(value, 0)
        self.assertLess(abs(value / expected - 1), relative, (value, expected))


class Numbers(ContactTest):
    def test_of_a_circle_the_hertz_contact_is_that_of_its_formulas(self):
        told = values(self.told(quiet_scene())["contact"])
        load, modulus, radius = 50, 107.9e9, 9.5e-3
        axis = math.cbrt(3 * load * radius / (4 * modulus))
        self.assert_near(told["semi_axis_x"], axis)
        self.assert_near(told["mean_pressure"], load / (math.pi * axis ** 2))
        self.assert_near(told["peak_pressure"], 1.5 * load / (math.pi * axis ** 2))
        self.assert_near(told["approach"], axis ** 2 / radius)
        self.assertEqual((told["shape"], told["ellipticity"]), ("circle", 1))

    def test_an_ellipse_of_two_equal_radii_is_told_as_a_circle(self):
        for radius, words in ((5e-3, "a circle, as both radii are alike"), (6e-3, None)):
            tree = quiet_scene(bodies={"effective_modulus": 107.9e9, "radius_x": 5e-3, "radius_y": radius})
            table = run("contact", self.folder.write("scene.toml", tree)).out
            self.assertRegex(table, r"\n  shape of the contact +ellipse" + (": " + words if words else "") + r"\n")

    def test_of_an_ellipse_the_pressure_bends_the_faces_by_their_radii(self):
        tree = quiet_scene(bodies={"effective_modulus": 107.9e9, "radius_x": 5e-3, "radius_y": 4e-2})
        told = values(self.told(tree)["contact"])
        area = math.pi * told["semi_axis_x"] * told["semi_axis_y"]
        self.assert_near(told["peak_pressure"], 1.5 * 50 / area)
        self.assert_near(told["mean_pressure"], 50 / area)
        self.assert_near(told["ellipticity"], told["semi_axis_y"] / told["semi_axis_x"])
        a, b = told["semi_axis_x"], told["semi_axis_y"]
        for first, other, radius in ((a, b, 5e-3), (b, a, 4e-2)):
            curvature = told["peak_pressure"] / 107.9e9 * first * other * self.integral(first, other)
            self.assert_near(curvature, 1 / radius, 1e-9)

    @staticmethod
    def integral(a, b):
        """∫ dw/((a² + w) √((a² + w)(b² + w)w)) from 0 to ∞, with w = ab tan²t by Simpson's rule in t. 1/R along a is p₀ab/E* times
        this integral (K. L. Johnson: Contact Mechanics, section 3.3)."""
        steps, total = 4000, 0.0
        for i in range(steps + 1):
            sine, cosine = math.sin(math.pi / 2 * i / steps), math.cos(math.pi / 2 * i / steps)
            p, q = (a * cosine) ** 2 + a * b * sine ** 2, (b * cosine) ** 2 + a * b * sine ** 2
            weight = 1 if i in (0, steps) else 4 if i % 2 else 2
            total += weight * 2 * math.sqrt(a * b) * cosine ** 2 / (p * math.sqrt(p * q))
        return total * math.pi / 2 / steps / 3

    def test_of_a_line_the_command_that_solves_its_film_is_named(self):
        roller = (ROOT / "reference/scenes/roller.toml").read_text(encoding="utf-8")
        hint = "`tribocheck film` solves the line"
        self.assertEqual(run("contact", ROOT / "reference/scenes/roller.toml", "--speed", "1").out.count(hint), 1)
        self.assertNotIn(hint, run("contact", ROOT / "reference/scenes/ball_on_flat.toml", "--speed", "1").out)
        path = self.folder.path("roller.toml")
        pathlib.Path(path).write_text(roller.replace('film = "dowson_toyoda_central"', ""), encoding="utf-8")
        self.assertIn("`tribocheck film` tells how far off each is", run("contact", path).err)

    def test_of_a_line_they_are_those_of_film(self):
        roller = str(ROOT / "reference/scenes/roller.toml")
        film, = run("film", roller, "--speed", "0.586", "--tolerance", "1e-2", "--format", "json").json()["films"]
        told, = run("contact", roller, "--format", "json").json()["scenes"]
        contact, numbers = values(told["contact"]), values(told["speeds"][0]["numbers"])
        self.assertEqual(told["speeds"][0]["speed"], 0.586)
        self.assert_near(contact["semi_axis_x"], film["half_width"])
        self.assert_near(contact["peak_pressure"], film["peak_pressure"])
        self.assert_near(numbers["moes_load_number"], film["load_number"])
        self.assert_near(numbers["moes_material_number"], film["material_number"])
        self.assertEqual(numbers["ehl_regime"], "piezoviscous_elastic")
        self.assertNotIn("regime", numbers)  # the output of this name tells what carries the load

    def test_numbers_of_a_point_are_those_of_their_formulas(self):
        told = values(self.at(quiet_scene(), 0.1)["numbers"])
        modulus = 2 * 107.9e9
        u, g, w = 0.0202 * 0.1 / (modulus * 9.5e-3), 2e-8 * modulus, 50 / (modulus * 9.5e-3 ** 2)
        for name, expected in (("speed_number", u), ("material_number", g), ("load_number", w),
                               ("moes_load_number", w * (2 * u) ** -0.75),
                               ("moes_material_number", g * (2 * u) ** 0.25),
                               ("viscosity_parameter", g * w ** 3 / u ** 2),
                               ("elasticity_parameter", w ** (8 / 3) / u ** 2)):
            self.assert_near(told[name], expected)

    def test_films_are_those_of_the_functions_of_their_names(self):
        point = {"speed": 0.1, "viscosity": 0.0202, "pressure_viscosity": 2e-8, "load": 50, "effective_modulus": 107.9e9,
                 "reduced_radius": 9.5e-3, "radius_x": 9.5e-3, "radius_y": 9.5e-3, "ellipticity": 1, "load_per_length": 5000}
        taken = {one["name"]: [parameter["name"] for parameter in one["parameters"]]
                 for one in run("functions", "--format", "json").json()["functions"]}
        for tree, count in ((quiet_scene(), 5), (quiet_scene(**LINE), 6)):
            films = self.at(tree, 0.1)["films"]
            self.assertEqual(len(films), count)
            asked = [{"id": film["law"], "function": film["law"]} | {name: point[name] for name in taken[film["law"]] if name in point}
                     for film in films]
            answers = run("stream", stdin="".join(json.dumps(one) + "\n" for one in asked)).json_lines()
            for film, answer in zip(films, answers):
                self.assert_near(film["film"], answer["value"])
                self.assertEqual(film["kind"] == "minimum", film["law"].endswith("minimum"), film["law"])

    def test_lambda_and_capital_lambda_are_apart(self):
        tree = with_field(quiet_scene(), "surface.rms_roughness", [3e-8, 4e-8])
        at = self.at(tree, 0.1)
        ratios, films = values(at["ratios"]), {film["law"]: film["film"] for film in at["films"]}
        point, = run("solve", self.folder.write("one.json", tree | {"speed": 0.1}), "--format", "json").json()["points"]
        self.assertEqual(ratios["film"], point["film"])
        self.assertEqual(ratios["film_parameter"], point["film_parameter"])
        least = point["film"] * films["hamrock_dowson_minimum"] / films["hamrock_dowson_central"]
        self.assert_near(ratios["minimum_film"], least)
        self.assert_near(ratios["lambda_ratio"], least / 5e-8)
        without, = [fact for fact in self.at(quiet_scene(), 0.1)["ratios"] if fact["name"] == "lambda_ratio"]
        self.assertIsNone(without["value"])
        self.assertIn("surface.rms_roughness", without["undefined"])

    def test_the_table_has_each_reason_once_below_its_few_words(self):
        for tree, brief, what, sentence, lines in (
                (quiet_scene(), "no Rq is given", "roughness of both faces together",
                 "the scene has none of surface.rms_roughness", 3),
                (quiet_scene(**LINE), "a line has none", "approach of the bodies", "of a line it depends on the whole bodies", 1)):
            told = run("contact", self.folder.write("one.json", tree)).out
            self.assertEqual(told.count(f"undefined: {brief}\n"), lines, told)
            self.assertEqual(told.count(f"\n  - {what}: {sentence}"), 1, told)
            self.assertEqual(told.count(sentence), 1, told)

    def test_the_least_film_has_all_that_moves_the_film(self):
        flooded = with_field(without_field(quiet_scene("smooth"), "supply"), "surface.rms_roughness", 5e-8)
        flooded |= {"outputs": ["film", "minimum_film", "lambda_ratio"], "speed": [0.5, 1]}
        heated = flooded["lubricant"] | {"thermal": "gupta", "conductivity": 0.14, "temperature_coefficient": 0.04}
        ways = {"flooded": {}, "heated": {"lubricant": heated, "friction": flooded["friction"] | {"slide_roll_ratio": 1}},
                "starved": {"supply": {"inlet_flow": 1e-8}, "closures": {"starvation": "damiens"}},
                "collapsed": {"supply": {"inlet_flow": 1e-8}}}
        films, parts = {}, set()
        for way, change in ways.items():
            path = self.folder.write("scene.json", flooded | change)
            for command in ("solve", "curve"):
                point = run(command, path, "--format", "json").json()["points"][-1]
                films[way] = point["film"]
                if way == "collapsed":
                    self.assertEqual((point["film"], point["minimum_film"], point["lambda_ratio"]), (0, 0, 0))
                    continue
                parts.add(round(point["minimum_film"] / point["film"], 9))
                self.assert_near(point["lambda_ratio"], point["minimum_film"] / 5e-8)
            ratios = values(self.at(flooded | change, 1)["ratios"])
            self.assert_near(ratios["film"], point["film"])
            self.assert_near(ratios["minimum_film"], point["minimum_film"])
        self.assertEqual(len(parts), 1)
        self.assertLess(films["heated"], films["flooded"])
        self.assertLess(films["starved"], films["flooded"] / 2)
        least = with_field(flooded, "closures.film", "hamrock_dowson_minimum")
        for point in run("solve", self.folder.write("least.json", least), "--format", "json").json()["points"]:
            self.assertEqual(point["minimum_film"], point["film"])

    def test_summits_are_those_of_the_formulas(self):
        tree = quiet_scene("smooth")
        told = self.told(tree)
        surfaces, contact = values(told["surfaces"]), values(told["contact"])
        density, radius, sd = 2e11, 1e-5, 2.5e-8
        stiffness = 16 * math.sqrt(2) * math.pi / 15 * (density * radius * sd) ** 2 * math.sqrt(sd / radius) \
            * 107.9e9 / contact["mean_pressure"]
        self.assert_near(surfaces["stiffness"], stiffness)
        self.assert_near(surfaces["offset"], 0.919)
        self.assertEqual(surfaces["floor"], 0)
        # Stiff summits have a floor, which the film reaches at the slowest speeds.
        stiff = with_field(without_field(tree, "supply"), "surface.summit_density", 2e12) | {"speed": 1e-9}
        told, = run("contact", self.folder.write("stiff.json", stiff), "--format", "json").json()["scenes"]
        point, = run("solve", self.folder.path("stiff.json"), "--format", "json").json()["points"]
        self.assertGreater(point["separation"], 0)
        self.assert_near(point["separation"], values(told["surfaces"])["floor"], 1e-3)


class Ranges(ContactTest):
    def beyond(self, tree, speed):
        return {film["law"]: film["beyond"] for film in self.at(tree, speed)["films"]}

    def test_a_law_says_whether_the_contact_is_in_its_range(self):
        steel = self.beyond(quiet_scene(), 0.1)
        self.assertEqual(steel["hamrock_dowson_central"], "")
        self.assertIn("isoviscous_elastic", steel["hamrock_dowson_soft_central"])
        rubber = self.beyond(quiet_scene(bodies={"effective_modulus": 1e7, "reduced_radius": 9.5e-3}), 0.1)
        self.assertEqual(rubber["hamrock_dowson_soft_minimum"], "")
        self.assertIn("piezoviscous_elastic", rubber["hamrock_dowson_minimum"])
        narrow = run("contact", self.folder.write("narrow.json", quiet_scene(
            bodies={"effective_modulus": 107.9e9, "radius_x": 4e-2, "radius_y": 5e-3})), "--format", "json")
        film = narrow.json()["scenes"][0]["speeds"][0]["films"][0]
        self.assertFalse(film["is_inside_range"])
        self.assertIn("fitted to 1 to 8", film["beyond"])

    def test_where_no_text_tells_the_range_of_a_law_it_is_not_known(self):
        def films(radius_x, radius_y, modulus=1e7):
            bodies = {"effective_modulus": modulus, "radius_x": radius_x, "radius_y": radius_y}
            told = self.told(quiet_scene(bodies=bodies, closures={"film": "hamrock_dowson_soft_central"}) | {"speed": 0.1})
            holds = {one["word"]: one["holds"] for one in told["validity"]}
            return {film["law"]: film for film in told["speeds"][0]["films"]}, holds["film_law_ellipticity"]
        narrow, holds = films(4e-2, 2e-3)
        soft = narrow["hamrock_dowson_soft_central"]
        self.assertEqual((soft["is_inside_range"], holds), (None, "not known"))
        self.assertRegex(soft["beyond"], r"k is 0\.1\d*, and the range that it was fitted to is not known")
        self.assertIs(narrow["hamrock_dowson_central"]["is_inside_range"], False)
        self.assertIs(films(1e-2, 4e-2)[0]["hamrock_dowson_soft_central"]["is_inside_range"], None)
        self.assertIs(films(1e-2, 4e-2, 107.9e9)[0]["hamrock_dowson_soft_central"]["is_inside_range"], False)  # it is made for another regime
        circle, holds = films(1e-2, 1e-2)
        self.assertEqual((circle["hamrock_dowson_soft_central"]["is_inside_range"], holds), (True, "yes"))

    def test_the_speeds_are_up_to_four_of_the_scene_or_its_slowest_and_fastest(self):
        for speed, expected in (([0.5, 0.1, 2], [0.1, 0.5, 2]), ([1, 2, 3, 4, 1], [1, 4]), ([2, 2], [2]),
                                ({"from": 0.1, "to": 3, "count": 5}, [0.1, 3]), (0.1, [0.1])):
            told = self.told(quiet_scene(speed=speed))
            self.assertEqual([at["speed"] for at in told["speeds"]], expected)
        self.assertEqual(self.told(without_field(quiet_scene(), "speed"))["speeds"], [])
        path = self.folder.write("scene.json", quiet_scene(speed=[1, 2, 3]))
        told, = run("contact", path, "--speed", "0.5", "--format", "json").json()["scenes"]
        self.assertEqual([at["speed"] for at in told["speeds"]], [0.5])
        self.assert_refused(run("contact", path, "--speed", "0"), "--speed", "a number above 0")
        for text, speed in (("50 cm/s", 0.5), ("500 mm/s", 0.5), ("3.6 km/h", 1)):
            told, = run("contact", path, "--speed", text, "--format", "json").json()["scenes"]
            self.assertEqual([one["speed"] for one in told["speeds"]], [speed])
        self.assert_refused(run("contact", path, "--speed", "50 cm"), "--speed", "50 cm is not allowed", "or with its unit: mm/s, m/s or km/h")

    def test_an_oil_whose_viscosity_does_not_rise_has_the_films_of_its_laws(self):
        still = with_field(quiet_scene(bodies={"effective_modulus": 1e7, "reduced_radius": 9.5e-3}), "lubricant.pressure_viscosity", 0)
        self.assert_refused(run("contact", self.folder.write("hard.json", still)), "lubricant.pressure_viscosity",
                            "whose film would be 0", "hamrock_dowson_soft_central")
        soft = with_field(still, "closures.film", "hamrock_dowson_soft_central")
        at = self.at(soft, 0.1)
        films = {film["law"]: film["film"] for film in at["films"]}
        self.assertIsNone(films["hamrock_dowson_central"])
        rising = {film["law"]: film["film"] for film in self.at(with_field(soft, "lubricant.pressure_viscosity", 1e-10), 0.1)["films"]}
        self.assertEqual(films["hamrock_dowson_soft_central"], rising["hamrock_dowson_soft_central"])
        self.assertEqual(values(at["numbers"])["ehl_regime"], "isoviscous_elastic")
        points = [run("solve", self.folder.write("soft.json", with_field(soft, "lubricant.pressure_viscosity", alpha) | {"outputs": ["film"]}),
                      "--format", "json").json()["points"][0]["film"] for alpha in (0, 1e-10)]
        self.assertEqual(points[0], points[1])

    def test_the_oil_is_told_at_its_temperature(self):
        oil = {"kinematic_viscosity": [["40 °C", "68 mm²/s"], ["100 °C", "8.6 mm²/s"]], "density": 870, "temperature": "40 °C",
               "pressure_viscosity": 2e-8, "eyring_stress": 2.5e6}
        told = self.told(quiet_scene(lubricant=oil))
        facts = values(told["lubricant"])
        self.assert_near(facts["kinematic_viscosity"], 68e-6, 1e-9)
        self.assert_near(facts["viscosity"], 870 * 68e-6, 1e-9)
        self.assertEqual(facts["temperature"], 313.15)
        text = run("contact", self.folder.write("oil.json", quiet_scene(lubricant=oil))).out
        for part in ("68 mm²/s", "59.16 mPa·s", "40 °C", "20 1/GPa"):
            self.assertIn(part, text)

    def test_words_say_what_lambda_and_a_low_share_mean(self):
        for roughness, word in ((1e-6, "boundary or mixed lubrication"), (1e-8, "mixed lubrication"), (1e-9, "full film")):
            ratios = {one["name"]: one for one in self.at(with_field(quiet_scene("smooth"), "surface.rms_roughness", roughness), 0.1)["ratios"]}
            self.assertEqual(ratios["lambda_ratio"]["note"], word, ratios["lambda_ratio"]["value"])
        share, = [one for one in self.told(quiet_scene())["surfaces"] if one["name"] == "share_without_film"]
        self.assertLess(share["value"], 1)
        self.assertIn(f"at most {100*share['value']:.0f} % of the load", share["note"])

    def test_a_default_that_matters_is_told_as_one(self):
        def notes(tree):
            told = self.told(tree)
            return {one["name"]: one["note"] for one in told["surfaces"] + told["lubricant"]}
        told = notes(quiet_scene(speed=0.1))
        self.assertEqual(told["slide_roll_ratio"], "the default, as much sliding as rolling")
        self.assertEqual(told["starvation"], "the default")
        self.assertEqual(told["offset_planes"], "the default, of one face; where both faces are rough alike, both bring it")
        chosen = quiet_scene(speed=0.1, closures={"starvation": "damiens", "asperity": "greenwood_williamson"})
        chosen = with_field(with_field(chosen, "friction.slide_roll_ratio", 0.02), "surface.offset_planes", 2)
        told = notes(chosen)
        self.assertEqual([told[name] for name in ("slide_roll_ratio", "starvation", "offset_planes")], ["", "", ""])
        # A value that the scene gives is not told as the default, even where it equals the default.
        same = quiet_scene(speed=0.1, closures={"starvation": "flooded_inlet"})
        told = notes(with_field(with_field(same, "friction.slide_roll_ratio", 1), "surface.offset_planes", 1))
        self.assertEqual([told[name] for name in ("slide_roll_ratio", "starvation", "offset_planes")], ["", "", ""])
        still = notes(without_field(with_field(chosen, "surface.summit_plane_offset", 0), "supply") | {"outputs": ["film"]})
        self.assertEqual({"slide_roll_ratio", "starvation", "offset_planes"} & set(still), set())

    def test_a_film_that_has_collapsed_is_told_and_has_no_word_of_lambda(self):
        tree = with_field(with_field(quiet_scene(), "surface.rms_roughness", 1e-7), "supply", {"inlet_film": 1e-8})
        for closure, note, word in (("flooded_inlet", "the film has collapsed, as the inlet has too little oil", ""),
                                    ("starved_inlet", "", "boundary or mixed lubrication")):
            ratios = {one["name"]: one for one in self.at(with_field(tree, "closures.starvation", closure), 1)["ratios"]}
            self.assertEqual((ratios["film"]["note"], ratios["lambda_ratio"]["note"]), (note, word))

    def test_the_factor_of_a_heated_inlet_is_told(self):
        hot = {"viscosity": 0.0202, "pressure_viscosity": 2e-8, "thermal": "gupta", "conductivity": 0.14, "temperature_coefficient": 0.04}
        tree = quiet_scene("smooth", lubricant=hot, friction={"slide_roll_ratio": 0.1}, outputs=["film"])
        tree = without_field(without_field(tree, "supply"), "surface")
        ratios = values(self.at(tree, 3)["ratios"])
        peak = values(self.told(tree)["contact"])["peak_pressure"]
        heat = 0.04 * 0.0202 * 9 / 0.14
        self.assert_near(ratios["thermal_reduction"], (1 - 13.2 * peak / (2 * 107.9e9) * heat ** 0.42)
                         / (1 + 0.213 * (1 + 2.23 * 0.1 ** 0.83) * heat ** 0.64), 1e-12)
        cold = with_field(tree, "lubricant", {"viscosity": 0.0202, "pressure_viscosity": 2e-8})
        self.assertNotIn("thermal_reduction", values(self.at(cold, 3)["ratios"]))
        self.assert_near(ratios["film"] / values(self.at(cold, 3)["ratios"])["film"], ratios["thermal_reduction"], 1e-12)

    def test_next_to_a_border_of_regimes_a_law_says_that_films_are_alike(self):
        gear = run("contact", str(ROOT / "reference/scenes/gear_flank.toml"), "--speed", "100", "--format", "json").json()["scenes"][0]
        holds = {one["word"]: one["holds"] for one in gear["validity"]}
        beyond = {film["law"]: film["beyond"] for film in gear["speeds"][0]["films"]}
        self.assertEqual(holds["film_law_regime"], "yes")
        self.assertTrue(beyond["dowson_toyoda_central"].endswith("next to the border: films of both regimes are alike"))
        rubber = quiet_scene(bodies={"effective_modulus": 1e7, "reduced_radius": 9.5e-3})
        far = {film["law"]: film["beyond"] for film in self.at(rubber, 0.1)["films"]}
        self.assertEqual(far["hamrock_dowson_central"], "the law is of piezoviscous_elastic contacts")

    def test_the_heat_of_sliding_is_told_and_never_judged(self):
        told = self.told(with_field(quiet_scene(speed=3), "friction.slide_roll_ratio", 2))
        flash = {one["word"]: one for one in told["validity"]}["flash_temperature"]
        self.assertEqual((flash["holds"], flash["least"], flash["greatest"], flash["unit"]), ("not known", None, None, "W"))
        self.assertIn("faces of steel would be hotter by some", flash["advice"])
        rolling = self.told(with_field(quiet_scene(speed=3), "friction.slide_roll_ratio", 0))
        self.assertNotIn("flash_temperature", {one["word"] for one in rolling["validity"]})

    def test_the_table_has_the_units_that_people_use(self):
        result = run("contact", self.folder.write("scene.toml", with_field(scene(speed=0.1), "surface.average_roughness", 1e-7)))
        for part in ("1.077 GPa", "148.9 µm", "107.9 GPa", "125.3 nm", "32.6 nm", "catalogues of bearings"):
            self.assertIn(part, result.out)
        self.assertIn("need a speed", run("contact", self.folder.write("still.json", without_field(scene(), "speed"))).out)

    def test_csv_and_json_have_the_same_numbers(self):
        path = self.folder.write("scene.toml", quiet_scene())
        told, = run("contact", path, "--format", "json").json()["scenes"]
        rows = run("contact", path, "--format", "csv").rows()
        facts = [("", part, fact) for part in ("contact", "surfaces", "lubricant") for fact in told[part]]
        facts += [(at["speed"], part, fact) for at in told["speeds"] for part in ("numbers", "films", "ratios") for fact in at[part]]
        self.assertEqual([(row["speed"] and float(row["speed"]), row["part"], row["name"],
                           float(row["value"]) if re.match(r"[\d-]", row["value"]) else row["value"]) for row in rows],
                         [(speed, part, fact["law"], fact["film"]) if part == "films" else
                          (speed, part, fact["name"], "" if fact["value"] is None else fact["value"]) for speed, part, fact in facts])


class Outputs(ContactTest):
    TREE = with_field(quiet_scene(outputs=["film", *SMOOTH], speed=[0.1, 1.0]), "surface.rms_roughness", 1e-7)

    def test_every_command_gives_the_same(self):
        points = run("solve", self.folder.write("scene.toml", self.TREE), "--format", "json").json()["points"]
        told = self.told(self.TREE)
        contact = values(told["contact"])
        for point, at in zip(points, told["speeds"]):
            self.assertEqual(list(point), ["id", "speed", "film", *SMOOTH])
            ratios = values(at["ratios"])
            self.assertEqual([point[name] for name in SMOOTH],
                             [contact["peak_pressure"], contact["mean_pressure"], ratios["minimum_film"], ratios["lambda_ratio"]])
            answer, = run("stream", stdin=json.dumps(self.TREE | {"speed": point["speed"]}) + "\n").json_lines()
            self.assertEqual(answer, {name: value for name, value in point.items() if name != "speed"})
        curve = run("curve", self.folder.write("scene.toml", self.TREE), "--format", "json").json()["points"]
        for name in SMOOTH:
            self.assert_near(curve[0][name], points[0][name])

    def test_a_sweep_gives_them_in_each_of_its_ways(self):
        grid = "{ from = 1e-7, to = 2e-7, count = 2 }"
        ways = {"curves": ({"speed": "{ from = 0.1, to = 1, count = 20 }", "load": "[20, 50]", "surface.rms_roughness": "1e-7"}, {}),
                "few_speeds": ({"speed": "[0.1, 1]", "load": "[20, 50]", "surface.rms_roughness": grid}, {}),
                "by_scene": ({"speed": "[0.1, 1]", "surface.average_roughness": grid}, {}),
                "one_contact": ({"speed": '{ distribution = "uniform", from = 0.1, to = 1 }', "surface.rms_roughness": "[6e-8, 8e-8]"},
                                {"draws": 4})}
        outputs = {"outputs": json.dumps(["film", "inlet", *SMOOTH])}
        base = without_field(quiet_scene("smooth", outputs=SMOOTH), "id")
        for way, (changes, settings) in ways.items():
            with self.subTest(way):
                path = self.folder.write(f"{way}.toml", sweep(changes | outputs, **settings))
                out = self.folder.path(f"{way}.h5")
                self.assertEqual(run("sweep", path, "-o", out).code, 0)
                for case in run("sweep", "show", out, "--cases", "--format", "json").json_lines():
                    tree = base | {"speed": case["speed"], "load": case.get("load", 50)}
                    average = case.get("surface.average_roughness")
                    tree = with_field(tree, "surface.average_roughness" if average else "surface.rms_roughness",
                                      average or case.get("surface.rms_roughness", 1e-7))
                    answer, = run("stream", stdin=json.dumps(tree) + "\n").json_lines()
                    for name in SMOOTH:
                        self.assert_near(case[name], answer[name], 1e-13)

    def test_none_is_computed_unless_it_is_asked_for(self):
        point = run("solve", self.folder.write("scene.toml", without_field(self.TREE, "outputs")), "--format", "json").json()["points"][0]
        self.assertEqual([name for name in SMOOTH if name in point], [])

    def test_lambda_without_a_roughness_is_one_line(self):
        tree = without_field(self.TREE, "surface.rms_roughness")
        path = self.folder.write("scene.toml", tree)
        for command in ("solve", "curve", "contact"):
            self.assert_refused(run(command, path), "surface.rms_roughness", "lambda_ratio needs it")
        answer, = run("stream", stdin=json.dumps(tree | {"speed": 1}) + "\n").json_lines()
        self.assertEqual(answer["error"]["field"], "surface.rms_roughness")


if __name__ == "__main__":
    unittest.main()
