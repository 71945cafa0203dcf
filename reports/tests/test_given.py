# SPDX-License-Identifier: Apache-2.0
"""Scenes as people give them: numbers with units, smooth bodies, oils by their data sheets, heated inlets.

The expected numbers are computed here from the printed formulas.
"""

import json
import math
import unittest

from program import ProgramTest, quiet_scene, run, scene, toml, with_field, without_field

# Values of quiet_scene("smooth"), in SI and with units.
WITH_UNITS = {
    "load": "0.05 kN", "surface.summit_density": "2e5 1/mm²", "surface.summit_radius": "10 µm",
    "surface.summit_height_sd": "25 nm", "bodies.effective_modulus": "107.9 GPa", "bodies.reduced_radius": "9.5 mm",
    "lubricant.viscosity": "20.2 mPa s", "lubricant.pressure_viscosity": "20 GPa^-1", "lubricant.eyring_stress": "2.5 N/mm²",
    "supply.inlet_flow": "0.01 mm²/s", "speed": {"from": "0.1 mm/s", "to": "3 m/s", "count": 20}}
GRADE = {"iso_vg": 46, "viscosity_index": 95, "density": 870, "temperature": 333.15, "pressure_viscosity": 2e-8}


def flow_scene(**changes):
    return quiet_scene("smooth", supply={"inlet_flow": 1e-8}, **changes)


def smooth_scene(**changes):
    """A scene without surface and supply, unless `changes` have them."""
    tree = {**scene(), "supply": None, "surface": None, **changes}
    return {key: value for key, value in tree.items() if value is not None}


def flooded_film(u, viscosity=0.0202):
    """Hamrock and Dowson's central film in m of the scenes here, at the speed u in m/s."""
    modulus, radius = 2 * 107.9e9, 9.5e-3
    return (radius * 2.69 * (viscosity * u / (modulus * radius)) ** 0.67 * (2e-8 * modulus) ** 0.53
            * (50 / (modulus * radius ** 2)) ** -0.067 * (1 - 0.61 * math.exp(-0.73)))


def walther(first, second, temperature):
    """The viscosity in mm²/s on the line of ASTM D341 through two pairs (temperature in K, mm²/s)."""
    place = lambda nu: math.log10(math.log10(nu + 0.7))
    slope = (place(first[1]) - place(second[1])) / (math.log10(second[0]) - math.log10(first[0]))
    return 10 ** 10 ** (place(first[1]) - slope * (math.log10(temperature) - math.log10(first[0]))) - 0.7


class GivenTest(ProgramTest):
    def answer(self, command, tree, *options):
        return run(command, self.folder.write("scene.toml", tree), *options).ended(0, "").out

    def points(self, tree, command="solve"):
        return json.loads(self.answer(command, tree, "--format", "json"))["points"]

    def swept(self, text):
        self.folder.write("sweep.toml", text)
        run("sweep", self.folder.path("sweep.toml"), "-o", self.folder.path("out.h5"), "--force").ended(0)
        return run("sweep", "show", self.folder.path("out.h5"), "--cases", "--format", "csv").ended(0)

    def assert_scene_refused(self, tree, *words):
        for name in ["scene.toml", "scene.json"]:
            self.assert_refused(run("solve", self.folder.write(name, tree)), name, *words)


class Units(GivenTest):
    def test_same_bytes_as_in_si(self):
        tree = flow_scene()
        for path, value in WITH_UNITS.items():
            tree = with_field(tree, path, value)
        for command, options in [("solve", ["--format", "csv"]), ("solve", ["--about"]), ("curve", ["--format", "json"]),
                                 ("onset", ["--format", "json"])]:
            self.assertEqual(self.answer(command, tree, *options), self.answer(command, flow_scene(), *options), command)

    def test_same_bytes_in_a_stream(self):
        plain = with_field(flow_scene(), "speed", 0.1)
        lines = [plain]
        for path, value in WITH_UNITS.items():
            lines.append(with_field(plain, path, "10 cm/s" if path == "speed" else value))
        done = run("stream", stdin="".join(json.dumps(line) + "\n" for line in lines))
        self.assertEqual(set(done.out.splitlines()), {done.out.splitlines()[0]})
        refused = run("stream", stdin=json.dumps(with_field(plain, "load", "50 Pa")) + "\n")
        self.assertIn("not in a unit that fits", json.loads(refused.out)["error"]["message"])

    def test_same_cases_in_sweeps(self):
        tree = toml(with_field(flow_scene(), "speed", 0.1))
        for si, with_units in [
                ("[0.01, 0.02]", '["10 mPa s", "20 cP"]'),
                ("{ from = 0.01, to = 0.02, count = 3 }", '{ from = "10 mPas", to = "20 mPa.s", count = 3 }'),
                ('{ distribution = "normal", mean = 0.02, sd = 0.001 }',
                 '{ distribution = "normal", mean = "20 mPa s", sd = "1 mPa s" }'),
                ('{ distribution = "uniform", from = 0.01, to = 0.02 }',
                 '{ distribution = "uniform", from = "10 mPa s", to = "0.2 P" }'),
                ('{ printed = "0.0202" }', '{ printed = "20.2 mPa s" }')]:
            cases = [self.swept(tree.replace("viscosity = 0.0202", "viscosity = " + way, 1) + "[sweep]\n"
                                + ("draws = 64\n" if "distribution" in way or "printed" in way else "")).out
                     for way in (si, with_units)]
            self.assertEqual(*cases)

    def test_a_bad_unit_is_one_line(self):
        self.assert_scene_refused(with_field(flow_scene(), "lubricant.viscosity", "20 cSt"), "lubricant.viscosity", '"20 cSt"',
                                  "mPa s, cP or Pa s")
        text = toml(with_field(flow_scene(), "speed", 0.1)).replace(
            "viscosity = 0.0202", 'viscosity = { distribution = "normal", mean = "20 m", sd = "1 mPa s" }', 1)
        self.folder.write("sweep.toml", text)
        self.assert_refused(run("sweep", self.folder.path("sweep.toml"), "-o", self.folder.path("o.h5")),
                            "lubricant.viscosity.mean", '"20 m"', "cP")


class SmoothBodies(GivenTest):
    def test_the_film_is_that_of_the_formula_and_carries_all(self):
        points = self.points(smooth_scene())
        self.assertEqual(len(points), 20)
        for point in points:
            self.assertAlmostEqual(point["film"] / flooded_film(point["speed"]), 1, delta=1e-12)
            self.assertEqual(point["film"], point["separation"])
            self.assertEqual((point["asperity_load_share"], point["fluid_load_share"]), (0, 1))
            self.assertEqual((point["real_area_ratio"], point["summit_count"]), (0, 0))
            self.assertEqual((point["regime"], point["inlet"]), ("elastohydrodynamic", "flooded"))
            self.assertNotIn("film_parameter", point)

    def test_friction_is_the_shear_of_the_film(self):
        for point in self.points(smooth_scene()):
            radius = (3 * 50 * 9.5e-3 / (4 * 107.9e9)) ** (1 / 3)
            pressure = 50 / (math.pi * radius ** 2)
            shear = 0.0202 * math.exp(2e-8 * pressure) * point["speed"] / point["film"]
            self.assertAlmostEqual(point["friction"] / (2.5e6 * math.asinh(shear / 2.5e6) / pressure), 1, delta=1e-11)

    def test_a_starved_inlet(self):
        tree = smooth_scene(supply={"inlet_film": "100 nm"}, closures={"starvation": "damiens", "damiens_exponent": 3})
        for point in self.points(tree):
            h = flooded_film(point["speed"])
            self.assertAlmostEqual(point["film"] / (h / (1 + (h / 1e-7) ** 3) ** (1 / 3)), 1, delta=1e-12)
        last = self.points(smooth_scene(supply={"inlet_film": 1e-7}))[-1]
        self.assertEqual((last["film"], last["regime"], last["asperity_load_share"]), (0, "collapsed", None))

    def test_it_is_the_limit_of_few_summits(self):
        few = with_field(smooth_scene(), "surface", {"summit_density": 1e-6, "summit_radius": 1e-5, "summit_height_sd": 1e-7})
        path = self.folder.write("few.toml", few)
        limit = json.loads(run("solve", path, "--format", "json").out)["points"]
        for one, other in zip(self.points(smooth_scene()), limit):
            self.assertAlmostEqual(one["film"] / other["film"], 1, delta=1e-12)
            self.assertAlmostEqual(one["friction"] / other["friction"], 1, delta=1e-12)

    def test_curves_streams_and_sweeps_agree(self):
        speeds = [1e-3, 0.1, 2]
        solved = self.points(smooth_scene(speed=speeds))
        self.assertEqual([point["film"] for point in self.points(smooth_scene(), "curve")],
                         [point["film"] for point in self.points(smooth_scene())])
        lines = "".join(json.dumps({**smooth_scene(speed=u), "id": "a"}) + "\n" for u in speeds)
        self.assertEqual([json.loads(line)["friction"] for line in run("stream", stdin=lines).out.splitlines()],
                         [point["friction"] for point in solved])
        text = toml(without_field(smooth_scene(), "speed")).replace("load = 50", "load = [50]\nspeed = [1e-3, 0.1, 2]")
        cases = self.swept(text).rows()
        self.assertEqual([float(row["film [m]"]) for row in cases], [point["film"] for point in solved])

    def test_onsets_without_a_film_parameter(self):
        path = self.folder.write("scene.toml", smooth_scene(supply={"inlet_film": 1e-7}))
        onsets = {one["criterion"]: one for one in json.loads(run("onset", path, "--format", "json").out)["onsets"]}
        maximum = onsets["film_maximum"]
        self.assertAlmostEqual(maximum["film"] / 1e-7, 0.3579155879252, delta=1e-10)
        self.assertAlmostEqual(flooded_film(maximum["speed"]) / 1e-7, 0.6327757634209, delta=1e-10)
        self.assertIsNone(maximum["film_parameter"])
        self.assertIn("smooth", maximum["undefined"]["film_parameter"])
        self.assertIn("smooth", onsets["asperity_minimum"]["undefined"]["speed"])

    def test_a_roughness_for_the_ratio_alone_leaves_them_smooth(self):
        rough = smooth_scene(surface={"rms_roughness": ["40 nm", 3e-8]}, outputs=["film", "minimum_film", "lambda_ratio"])
        for point, smooth in zip(self.points(rough), self.points(smooth_scene())):
            self.assertEqual(point["film"], smooth["film"])
            self.assertAlmostEqual(point["lambda_ratio"] / (point["minimum_film"] / 5e-8), 1, delta=1e-12)
        told = json.loads(self.answer("contact", rough, "--format", "json"))
        self.assertIn("smooth", json.dumps(told))

    def test_what_needs_the_roughness_is_refused(self):
        self.assert_scene_refused(smooth_scene(outputs=["film", "film_parameter"]), "outputs", "film_parameter", "smooth")
        self.assert_scene_refused(smooth_scene(supply={"inlet_film_ratio": 4}), "supply.inlet_film_ratio", "smooth")
        self.assert_scene_refused(smooth_scene(surface={"summit_density": 5e10, "summit_radius": 1e-5}),
                                  "surface.summit_height_sd", "missing")
        self.points(smooth_scene(outputs=["film"]))


class Oils(GivenTest):
    def viscosity_of(self, **lubricant):
        tree = smooth_scene(outputs=["film"], speed=1, lubricant={"pressure_viscosity": 2e-8, **lubricant})
        return 0.0202 * (self.points(tree)[0]["film"] / flooded_film(1)) ** (1 / 0.67)

    def test_two_viscosities(self):
        first, second = (313.15, 46), (373.15, 6.8)
        for temperature in [293.15, 333.15, 373.15]:
            wanted = 870e-6 * walther(first, second, temperature)
            for pairs in [[[313.15, 46e-6], [373.15, 6.8e-6]], [["100 °C", "6.8 cSt"], ["40 °C", "46 mm²/s"]]]:
                got = self.viscosity_of(kinematic_viscosity=pairs, density="0.87 g/cm³", temperature=temperature)
                self.assertAlmostEqual(got / wanted, 1, delta=1e-10)

    def test_a_grade(self):
        # ASTM D2270's oils of 8.86 mm²/s at 100 °C: 119.9588 mm²/s at 40 °C for the index 0, 69.4765 for 100 (X2.5).
        for index, at_40 in [(0, 119.9588), (100, 69.4765), (40, 0.6 * 119.9588 + 0.4 * 69.4765)]:
            got = self.viscosity_of(iso_vg=at_40, viscosity_index=index, density=870, temperature="100 °C")
            self.assertAlmostEqual(got / (870 * 8.86e-6), 1, delta=2e-6)
        self.assertAlmostEqual(self.viscosity_of(iso_vg=46, viscosity_index=95, density=870, temperature="40 °C")
                               / (870 * 46e-6), 1, delta=1e-12)

    def test_the_temperature_may_vary_in_a_sweep(self):
        tree = toml(smooth_scene(outputs=["film"], speed=1, lubricant=GRADE))
        films = [float(row["film [m]"]) for row in
                 self.swept(tree.replace("temperature = 333.15", 'temperature = ["40 °C", "60 °C", "80 °C"]')).rows()]
        alone = [self.points(smooth_scene(outputs=["film"], speed=1, lubricant={**GRADE, "temperature": t}))[0]["film"]
                 for t in (313.15, 333.15, 353.15)]
        self.assertEqual(films, alone)
        self.assertEqual(films, sorted(films, reverse=True))

    def test_pairs_do_not_vary_in_a_sweep(self):
        tree = toml(smooth_scene(outputs=["film"], speed=1, lubricant=GRADE)).replace("viscosity_index = 95\n", "")
        spread = '{ distribution = "uniform", from = 4e-5, to = 5e-5 }'
        for pairs in (f"[[313.15, {spread}], [373.15, 6.8e-6]]", '[[{ printed = "313" }, 46e-6], [373.15, 6.8e-6]]',
                      f"[[313.15, 46e-6], {spread}]", spread):
            self.folder.write("sweep.toml", tree.replace("iso_vg = 46", f"kinematic_viscosity = {pairs}"))
            done = run("sweep", self.folder.path("sweep.toml"), "-o", self.folder.path("o.h5"))
            self.assert_refused(done, "sweep.toml: lubricant.kinematic_viscosity: its pairs do not vary; allowed: "
                                      "lubricant.viscosity alone, or lubricant.iso_vg")
            self.assertNotIn("nothing varies", done.err)

    def test_in_a_stream(self):
        line = {**smooth_scene(outputs=["film"], speed=1, lubricant={
            "kinematic_viscosity": [["40 °C", 46e-6], [373.15, "6.8 cSt"]], "density": 870, "temperature": 333.15,
            "pressure_viscosity": 2e-8}), "id": "a"}
        done = run("stream", stdin=json.dumps(line) + "\n")
        self.assertEqual(json.loads(done.out)["film"], self.points(line)[0]["film"])

    def test_exactly_one_way(self):
        tree = smooth_scene(lubricant=GRADE)
        self.assert_scene_refused(with_field(tree, "lubricant.viscosity", 0.02), "lubricant.", "given beside")
        self.assert_scene_refused(without_field(tree, "lubricant.density"), "lubricant.density", "missing")
        self.assert_scene_refused(smooth_scene(lubricant={"pressure_viscosity": 2e-8}), "lubricant.viscosity", "missing",
                                  "iso_vg")

    def test_viscosities_that_make_no_oil(self):
        pairs = {key: value for key, value in GRADE.items() if key not in ("iso_vg", "viscosity_index")}
        for bad, words in [([[313.15, 46e-6]], ["two pairs"]), (5, ["two pairs"]), ([[313.15, 46e-6], [373.15]], ["two pairs"]),
                           ([[313.15, 46e-6], [373.15, "6.8 m"]], ["[1][1]", "cSt"]),
                           ([[313.15, 46e-6], [313.15, 6.8e-6]], ["no viscosity"]),
                           ([[313.15, 6.8e-6], [373.15, 46e-6]], ["no viscosity"]),
                           ([[313.15, 46e-6], [373.15, 1e-7]], ["no viscosity"])]:
            self.assert_scene_refused(smooth_scene(lubricant={**pairs, "kinematic_viscosity": bad}),
                                      "lubricant.kinematic_viscosity", *words)
        self.assert_scene_refused(smooth_scene(lubricant={**GRADE, "iso_vg": 3}), "lubricant.viscosity_index", "index")

    def test_temperatures_that_were_meant_in_celsius(self):
        self.assert_scene_refused(smooth_scene(lubricant={**GRADE, "temperature": 70}), "lubricant.temperature: 70 K is -203 °C",
                                  'allowed: "70 °C", or a number from 150 on, in K')
        pairs = {key: value for key, value in GRADE.items() if key not in ("iso_vg", "viscosity_index")}
        self.assert_scene_refused(smooth_scene(lubricant={**pairs, "kinematic_viscosity": [[40, 46e-6], [100, 6.8e-6]]}),
                                  "lubricant.kinematic_viscosity: 40 K is -233 °C")


class HeatedInlets(GivenTest):
    GUPTA = {"thermal": "gupta", "conductivity": 0.14, "temperature_coefficient": 0.04}

    def heated(self, **changes):
        lubricant = {"viscosity": 0.0202, "pressure_viscosity": 2e-8, "eyring_stress": 2.5e6, **self.GUPTA}
        return smooth_scene(lubricant=lubricant, **{"friction": {"boundary_coefficient": 0.13, "slide_roll_ratio": 1}} | changes)

    @staticmethod
    def factor(u):
        radius = (3 * 50 * 9.5e-3 / (4 * 107.9e9)) ** (1 / 3)
        peak = 1.5 * 50 / (math.pi * radius ** 2)
        heating = 0.04 * 0.0202 * u ** 2 / 0.14
        return ((1 - 13.2 * peak / (2 * 107.9e9) * heating ** 0.42)
                / (1 + 0.213 * (1 + 2.23 * 1 ** 0.83) * heating ** 0.64))

    def test_the_factor_is_on_the_film(self):
        for point in self.points(self.heated()):
            self.assertAlmostEqual(point["film"] / (flooded_film(point["speed"]) * self.factor(point["speed"])), 1, delta=1e-11)

    def test_none_is_as_if_it_were_not_there(self):
        tree = flow_scene()
        off = tree
        for name, value in {**self.GUPTA, "thermal": "none"}.items():
            off = with_field(off, f"lubricant.{name}", value)
        for command in ("solve", "onset"):
            self.assertEqual(self.answer(command, off, "--format", "csv"), self.answer(command, tree, "--format", "csv"))

    def test_curves_streams_and_sweeps_agree(self):
        solved = self.points(self.heated(speed=[0.1, 1, 3]))
        lines = "".join(json.dumps({**self.heated(speed=u), "id": "a"}) + "\n" for u in (0.1, 1, 3))
        self.assertEqual([json.loads(line)["film"] for line in run("stream", stdin=lines).out.splitlines()],
                         [point["film"] for point in solved])
        text = toml(without_field(self.heated(), "speed")).replace("load = 50", "load = [50]\nspeed = [0.1, 1, 3]")
        self.assertEqual([float(row["film [m]"]) for row in self.swept(text).rows()], [point["film"] for point in solved])
        ways = toml(self.heated(speed=1)).replace('thermal = "gupta"', 'thermal = ["none", "gupta"]')
        off, on = (float(row["film [m]"]) for row in self.swept(ways).rows())
        self.assertAlmostEqual(on / off, self.factor(1), delta=1e-11)

    def test_all_of_it_or_nothing(self):
        for name in self.GUPTA:
            self.assert_scene_refused(without_field(self.heated(), f"lubricant.{name}"), f"lubricant.{name}", "missing")

    def test_it_is_told_which_sliding_heats_it_where_the_scene_does_not_say(self):
        """The default slide-to-roll ratio is 1. It halves the film of a rolling bearing, so that a warning is needed."""
        silent = self.heated(speed=2, friction={"boundary_coefficient": 0.13})
        words = r"friction\.slide_roll_ratio: missing, and the heated inlet of lubricant\.thermal .* default of 1 is taken"
        path = self.folder.write("scene.json", silent)
        for command in ("solve", "contact", "onset"):
            done = run(command, path, "--strict")
            self.assertEqual((done.code, len(done.error_lines)), (1, 1), done.err)
            self.assertRegex(done.err, words)
        for given in (self.heated(speed=2), with_field(silent, "friction.slide_roll_ratio", 0),
                      with_field(silent, "lubricant.thermal", "none"), without_field(smooth_scene(), "friction.slide_roll_ratio")):
            self.assertEqual(run("solve", self.folder.write("scene.json", given)).err, "")
        told = json.loads(self.answer("contact", self.heated(speed=2), "--format", "json"))["scenes"][0]["lubricant"]
        self.assertEqual([fact["value"] for fact in told if fact["name"] == "slide_roll_ratio"], [1])
        ways = toml(silent).replace('thermal = "gupta"', 'thermal = ["none", "gupta"]')
        self.folder.write("sweep.toml", ways)
        done = run("sweep", self.folder.path("sweep.toml"), "-o", self.folder.path("out.h5"), "--force", "--strict").ended(1)
        self.assertRegex(done.err, words)

    def test_beyond_its_law_it_is_refused(self):
        self.assert_scene_refused(self.heated(speed=900), "lubricant.thermal", "gupta", "900 m/s")

    def test_onsets_from_the_film_are_told_as_none(self):
        path = self.folder.write("scene.toml", self.heated(supply={"inlet_film": 1e-7}))
        onsets = json.loads(run("onset", path, "--format", "json").out)["onsets"]
        for one in onsets:
            if one["criterion"] != "friction_minimum":
                self.assertIn("lubricant.thermal: `curve` shows where the film is starved", one["undefined"]["speed"])
            else:
                self.assertNotIn("thermal", one["undefined"]["speed"])


if __name__ == "__main__":
    unittest.main()
