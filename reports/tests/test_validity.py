# SPDX-License-Identifier: Apache-2.0
"""Limits of validity as a user meets them: one line that warns, `accept`, --strict, `warnings` in JSON, and the table of
`solve --explain`."""

import os
import pathlib
import re
import unittest

from program import Literal, ProgramTest, json_value, quiet_scene, run, scene, toml, with_field, without_field
from sweeps import UNIFORM, sweep

REFERENCE = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "reference"
SHIPPED = sorted([*REFERENCE.glob("published/*.toml"), *REFERENCE.glob("scenes/*.toml")])
LINE = {"bodies": {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 1e-2}, "load": 2000, "speed": 1.0,
        "closures": {"film": "dowson_toyoda_central"}, "supply": None}


class ValidityTest(ProgramTest):
    def write(self, tree, name="a.toml"):
        return self.folder.write(name, tree)

    def passed(self, command, tree, *more):
        """The words of the limits that a command warns of; asserts that its warning line and its JSON have the same ones."""
        done = run(command, self.write(tree), "--format", "json", *more)
        words = [one["word"] for one in done.json()["warnings"]]
        said = re.findall(r'"(\w+)"', done.warned.rpartition("accept = ")[2])
        self.assertEqual((words, len(done.said.splitlines())), (said, 1 if words else 0), done.said)
        return words


    def explained(self, tree):
        """The advice on each limit of a scene, by the limit's word."""
        return {one["word"]: one["advice"] for one in run("solve", self.write(tree), "--explain", "--format", "json").json()["validity"]}


class Warnings(ValidityTest):
    def test_a_slip_of_unit_is_named_with_the_likely_unit(self):
        done = run("solve", self.write(with_field(quiet_scene(speed=0.1), "lubricant.viscosity", 20.2)))
        self.assertEqual((done.code, len(done.said.splitlines())), (0, 1))
        self.assertIn("a.toml: outside of the model's limits: ", done.said)
        self.assertIn("lubricant.viscosity 20.2 Pa·s (1e-5 Pa·s to 10 Pa·s; perhaps mPa·s was meant)", done.said)
        self.assertIn('accept = ["viscosity_range"] in the scene accepts them', done.said)
        tree = without_field(with_field(quiet_scene(speed=0.1), "lubricant.viscosity", 20.2), "accept")
        said = run("solve", self.write(tree)).said  # it stands before the limits that are passed because of it
        self.assertIn("a.toml: outside of the model's limits: lubricant.viscosity 20.2 Pa·s (1e-5 Pa·s to 10 Pa·s; perhaps mPa·s was meant), ", said)

    def test_a_number_just_beyond_its_bound_does_not_read_as_the_bound(self):
        tree = quiet_scene(speed=0.1)
        limit, = [one for one in run("contact", self.write(tree), "--format", "json").json()["scenes"][0]["validity"] if one["word"] == "alpha_p0"]
        for part, holds, number in ((1.001, "no", "30.03"), (0.999, "yes", "30")):
            alpha = tree["lubricant"]["pressure_viscosity"] * part * limit["greatest"] / limit["value"]
            text = run("contact", self.write(with_field(tree, "lubricant.pressure_viscosity", alpha))).out
            self.assertRegex(text, rf"\n{holds} +{number} +at most 30 ")

    def test_what_the_users_tripped_over_is_told(self):
        roller = dict(quiet_scene(**LINE), load=46e3)
        self.assertIn("length_range", self.passed("solve", with_field(roller, "bodies.length", 10.0)))
        self.assertIn("hertz_pressure", self.passed("solve", roller | {"load": 46e4}))

    @staticmethod
    def smooth_scene(speed):
        return without_field(quiet_scene(speed=speed), "supply")

    def test_what_summits_of_faces_known_by_rq_alone_carry_is_undefined_where_they_touch(self):
        faces = {"surface": {"rms_roughness": "300 nm"}, "outputs": ["film", "regime"], "accept": []}
        tree = self.smooth_scene([0.1, 1]) | faces
        done = run("solve", self.write(tree))
        self.assertRegex(done.warned, r"rough_as_smooth 0\.0\d* \(at least 3\);")
        self.assertEqual(self.explained(tree)["rough_as_smooth"], "this is Λ: the faces touch, and Rq alone does not say what the summits "
                         "carry: shares, friction and regime are undefined there; give summits or spectral moments")
        self.assertEqual(len(done.said.splitlines()), 1)
        self.assertEqual(self.passed("solve", self.smooth_scene(1) | faces | {"surface": {"rms_roughness": "1 nm"}}), [])

    UNKNOWN = {"regime", "asperity_load_share", "fluid_load_share", "real_area_ratio", "summit_count", "friction"}

    def test_a_reason_of_several_outputs_stands_once_below_a_table(self):
        tree = self.smooth_scene([0.1, 0.2]) | {"surface": {"rms_roughness": 1e-8}}
        table = run("solve", self.write(tree)).out
        self.assertEqual(table.count("Λ is below 3"), 1)
        names, = re.findall(r"(?m)^  - ([a-z_, ]+): Λ is below 3", table)
        self.assertEqual(set(names.split(", ")), self.UNKNOWN)
        collapsed = run("solve", self.write(quiet_scene(speed=[1, 3], supply={"inlet_film": 1e-8}))).out
        self.assertEqual(collapsed.count("the film has collapsed"), 1)
        self.assertNotIn("Λ is below 3", collapsed)

    def test_defaults_that_matter_are_warned_of_until_the_scene_gives_them(self):
        tree = quiet_scene(speed=0.1, accept=[], supply={"inlet_film": "60 nm"})
        self.assertLessEqual({"default_sliding", "default_inlet"}, set(self.passed("solve", tree)))
        given = with_field(with_field(tree, "friction.slide_roll_ratio", 1), "closures.starvation", "flooded_inlet")
        self.assertEqual({"default_sliding", "default_inlet"} & set(self.passed("solve", given)), set())

    def test_no_command_says_what_unknown_summits_carry(self):
        tree = self.smooth_scene([0.1, 1]) | {"surface": {"rms_roughness": 1e-8}}
        thin, thick = run("solve", self.write(tree), "--format", "json").json()["points"]
        self.assertEqual(set(thin["undefined"]), self.UNKNOWN)
        self.assertTrue(all(why.startswith("Λ is below 3: the faces touch") for why in thin["undefined"].values()))
        self.assertGreater(thin["film"], 0)
        self.assertEqual((thick["regime"], thick["asperity_load_share"], "undefined" in thick), ("elastohydrodynamic", 0, False))
        lines = "".join(json_value(tree | {"speed": speed}) + "\n" for speed in (0.1, 1))
        self.assertEqual([set(one.get("undefined", {})) for one in run("stream", stdin=lines).json_lines()], [self.UNKNOWN, set()])
        alone = tree | {"outputs": ["regime"]}  # without the film, from which Λ follows
        self.assertEqual([one["regime"] for one in run("solve", self.write(alone), "--format", "json").json()["points"]],
                         [None, "elastohydrodynamic"])
        curve = run("curve", self.write(tree), "--format", "json").json()["points"]
        self.assertEqual([set(one.get("undefined", {})) for one in curve], [self.UNKNOWN, set()])
        path = self.folder.path("sweep.toml")
        pathlib.Path(path).write_text(toml(tree | {"speed": Literal("0.1")}).replace("load = 50", "load = [50, 60]"), encoding="utf-8")
        self.assertEqual(run("sweep", path, "-o", self.folder.path("out.h5"), "--force").code, 0)
        rows = run("sweep", "show", self.folder.path("out.h5"), "--cases", "--format", "csv").rows()
        self.assertEqual([(row["regime"], row["asperity_load_share"], row["friction"]) for row in rows], [("undefined", "", "")] * 2)

    def test_a_law_of_another_regime_is_told_with_the_one_to_take(self):
        rubber = quiet_scene(bodies={"effective_modulus": 1e7, "reduced_radius": 9.5e-3}, supply=None, accept=[], load=1)
        rubber = without_field(rubber, "surface") | {"outputs": ["film"], "speed": 0.1}
        done = run("solve", self.write(rubber), "--strict").ended(1)
        self.assertRegex(done.warned, r"film_law_regime [\d.]+ \(at most 1\.2\); `tribocheck solve --explain` explains them,")
        self.assertIn("the contact is isoviscous_elastic: take hamrock_dowson_soft_central", self.explained(rubber)["film_law_regime"])
        self.assertIn("film_law_regime", self.passed("solve", rubber))
        soft = with_field(rubber, "closures.film", "hamrock_dowson_soft_central")
        self.assertEqual(self.passed("solve", soft), [])

    def test_a_number_that_follows_is_told_as_one(self):
        ball = {"first_radius_x": "25 m", "second_radius_x": -25.025, "first_radius_y": "9 mm", "second_radius_y": 1e30}
        done = run("solve", self.write(quiet_scene(speed=0.1, accept=[], bodies={"effective_modulus": 107.9e9} | ball)))
        self.assertRegex(done.warned, r"bodies\.radius_x, which follows, 2\.5e\+04 m \([^;)]*\)")

    def test_the_line_is_short_and_says_where_limits_are_explained(self):
        path = self.write(self.smooth_scene([0.1, 0.2]) | {"surface": {"rms_roughness": "300 nm"}, "outputs": ["film", "regime"], "accept": []})
        of_results, of_solve, of_contact = "the results explain", "`tribocheck solve --explain` explains", "`tribocheck contact` explains"
        for command, where in ((["contact", path], of_results), (["contact", path, "--format", "json"], of_results),
                               (["contact", path, "--format", "csv"], of_contact), (["onset", path], of_contact),
                               (["solve", path, "--explain"], of_results), (["solve", path], of_solve), (["curve", path], of_solve)):
            with self.subTest(command):
                done = run(*command)
                self.assertRegex(done.said, r"rough_as_smooth 0\.\d+ \(at least 3\)[;,] ")
                self.assertIn(f"; {where} them, and accept = [", done.said)
                self.assertNotIn("touches", done.said)
                if command[0] != "onset":  # its result has this advice without being asked
                    self.assertEqual("give summits or spectral moments" in re.sub(r"\s+", " ", done.out), where == of_results)

    def test_a_likely_unit_stands_in_the_table_in_place_of_advice(self):
        bodies = {"first_modulus": 210000, "first_poisson_ratio": 0.3, "second_modulus": 210e9, "second_poisson_ratio": 0.3, "reduced_radius": 9.5e-3}
        for modulus, is_slip in ((210000, True), (2.1e6, False)):  # 2.1e6 Pa is the modulus of a rubber
            path = self.write(quiet_scene(speed=0.1, accept=[], supply=None, bodies=bodies | {"first_modulus": modulus}))
            for command in (["contact", path], ["solve", path, "--explain"]):
                with self.subTest(command=command[0], modulus=modulus):
                    done = run(*command)
                    table = re.sub(r"\s+", " ", done.out.partition("is the model valid here?")[2])
                    self.assertEqual("bodies.first_modulus is in the range of real contacts. Perhaps MPa was meant." in table, is_slip)
                    self.assertEqual("perhaps MPa was meant" in done.said, is_slip)
                    self.assertEqual("take hamrock_dowson_soft_central" in table, not is_slip)
                    self.assertIn("film_law_regime", table)

    def test_several_scenes_have_one_line(self):
        paths = [self.write(scene(surface), f"{surface}.toml") for surface in ("rough", "medium")]
        done = run("solve", *paths)
        self.assertEqual(len(done.said.splitlines()), 1)
        self.assertRegex(done.warned, r"summit_offset 0\.0573 \([^)]*\) of [^ ]*rough\.toml and 1 more")

    def test_each_command_of_scenes_warns_and_is_strict_where_asked(self):
        loud, quiet = self.write(scene()), self.write(quiet_scene(), "quiet.toml")
        line = self.write(dict(quiet_scene(**LINE), load=5e4), "line.toml")
        still = self.write(quiet_scene(**LINE), "still.toml")
        for command, warns, is_silent in (("solve", loud, quiet), ("curve", loud, quiet), ("onset", loud, quiet),
                                          ("film", line, still)):
            for more, code in (([], 0), (["--strict"], 1)):
                with self.subTest(command=command, more=more):
                    done = run(command, warns, *more)
                    self.assertEqual((done.code, done.warned != ""), (code, True), done.said)
                    self.assertEqual(done.out, run(command, warns).out)  # the result is written all the same
                    done = run(command, is_silent, *more)
                    self.assertEqual((done.code, done.said), (0, ""))
        self.assertEqual(run("solve", loud, self.write(scene(load=-1), "bad.toml"), "--strict").code, 2)

    def test_json_tells_value_limit_and_unit(self):
        done = run("solve", self.write(quiet_scene(speed=0.1, load=5000)), "--format", "json")
        found = {one["word"]: one for one in done.json()["warnings"]}
        peak = found["hertz_pressure"]
        self.assertEqual((peak["id"], peak["limit"], peak["unit"]), ("rough", 4e9, "Pa"))
        self.assertAlmostEqual(peak["value"] / 1.0766e9, 100 ** (1/3), 3)
        self.assertEqual(peak["text"], "hertz_pressure 5 GPa (at most 4 GPa)")
        self.assertEqual(run("solve", self.write(quiet_scene()), "--format", "json").json()["warnings"], [])

    def test_options_of_film_count(self):
        tree = quiet_scene(**LINE) | {"load": 1e4}
        self.assertIn("barus", self.passed("film", tree, "--tolerance", "1e-2"))
        self.assertNotIn("barus", self.passed("film", tree, "--tolerance", "1e-2", "--viscosity", "roelands"))
        self.assertIn("inlet_heating", self.passed("film", tree, "--tolerance", "1e-2", "--speed", "50"))


class Accepted(ValidityTest):
    def test_a_scene_that_accepts_all_it_passes_is_silent(self):
        words = self.passed("solve", scene())
        self.assertGreater(len(words), 2)
        self.assertEqual(self.passed("solve", scene(accept=words)), [])
        self.assertEqual(self.passed("solve", scene(accept=words[1:])), words[:1])
        self.assertEqual(run("solve", self.write(scene(accept=words)), "--strict").code, 0)

    def test_an_unknown_word_is_one_line_with_the_list(self):
        done = run("solve", self.write(scene(accept=["barus", "hertz_presure"])))
        self.assertEqual((done.code, done.out, len(done.said.splitlines())), (2, "", 1))
        for text in ('accept[1]: "hertz_presure" is not known; allowed: a list of hertz_pressure, half_space', "smooth_film_law",
                     "viscosity_range", "did you mean hertz_pressure?"):
            self.assertIn(text, done.said)

    def test_shipped_scenes_are_silent(self):
        done = run("solve", *SHIPPED, "--strict", "--format", "csv")
        self.assertEqual((done.code, done.said), (0, ""))
        for one in ("roller", "gear_flank"):
            done = run("film", REFERENCE / f"scenes/{one}.toml", "--speed", "1", "--strict", "--tolerance", "1e-2")
            self.assertEqual((done.code, done.said), (0, ""))

    def test_the_scene_of_the_readme_is_silent(self):
        text = (REFERENCE.parent / "README.md").read_text(encoding="utf-8")
        path = pathlib.Path(self.folder.path("scene.toml"))
        path.write_text(re.search(r"(?s)## A scene\n.*?```toml\n(.*?)```", text)[1], encoding="utf-8")
        for command in ("solve", "onset", "curve"):
            self.assertEqual(run(command, path).said, "")


class Explained(ValidityTest):
    def test_the_table_follows_the_points(self):
        tree = scene(load=5000, accept=["smooth_film_law"])
        done = run("solve", self.write(tree), "--explain")
        points, _, table = done.out.partition("\nrough: is the model valid here?\n")
        self.assertEqual(points, run("solve", self.write(tree)).out)
        rows = [re.split(r"  +", line.strip()) for line in table.splitlines()]
        holds = {row[4]: row[0] for row in rows if len(row) >= 6}
        self.assertEqual({holds[word] for word in ("hertz_pressure", "summit_offset")}, {"no"})
        self.assertEqual((holds["half_space"], holds["smooth_film_law"]), ("yes", "accepted"))
        self.assertNotIn("line_length", holds)

    def test_json_has_the_same_rows(self):
        told = run("solve", self.write(scene(load=5000)), "--explain", "--format", "json").json()
        rows = {one["word"]: one for one in told["validity"]}
        self.assertEqual({word for word, one in rows.items() if one["holds"] == "no"},
                         {one["word"] for one in told["warnings"]})
        self.assertEqual((rows["half_space"]["least"], rows["half_space"]["greatest"]), (None, 0.5))
        self.assertEqual((rows["half_space"]["touches"], rows["smooth_film_law"]["touches"]), ("everything", "film"))
        self.assertIn("below the boundary coefficient", rows["summit_capacity"]["advice"])
        for one in rows.values():
            self.assertTrue(one["assumption"].endswith(".") and one["source"], one)

    def test_it_has_no_place_in_csv(self):
        done = run("solve", self.write(scene()), "--explain", "--format", "csv")
        self.assertEqual((done.code, done.out, len(done.said.splitlines())), (2, "", 1))


class Sweeps(ValidityTest):
    def run_sweep(self, varied, *more):
        path = self.folder.path("sweep.toml")
        pathlib.Path(path).write_text(sweep(varied), encoding="utf-8")
        return run("sweep", path, "-o", self.folder.path("out.h5"), "--force", *more)

    def test_the_ends_of_a_grid_count_and_those_of_a_distribution_do_not(self):
        drawn = '{ distribution = "log_normal", median = 0.02, log_sd = 0.5 }'
        for viscosity, words in (("[0.02, 20.2]", {"viscosity_range"}), ("[0.02, 0.03]", set()), (drawn, set())):
            with self.subTest(viscosity=viscosity):
                done = self.run_sweep({"lubricant.viscosity": viscosity, "speed": "0.1"}, "--format", "json")
                found = {one["word"] for one in done.json()["warnings"]}
                self.assertEqual({word for word in found if word.endswith("_range")}, words)
                self.assertEqual(len(done.warned), len(done.said.rstrip("\n")))
                shown = run("sweep", "show", self.folder.path("out.h5"), "--format", "json")
                self.assertEqual(shown.json()["warnings"], done.json()["warnings"])

    def test_it_is_told_how_many_cases_of_a_distribution_are_beyond_which_limit(self):
        """p₀ of a circle is 4 GPa at 2564 N: of loads spread evenly from 1700 N to 3000 N a third is beyond."""
        drawn = {"load": '{ distribution = "uniform", from = 1700, to = 3000 }', "speed": "0.1"}
        done = self.run_sweep(drawn, "--format", "json", "--strict").ended(1)
        cases, judged, of_all = re.search(r"hertz_pressure [^;]*; in (\d+) of (\d+) cases looked at, a sample of (\d+), furthest in case \d+",
                                          done.warned).groups()
        self.assertEqual((judged, of_all), ("1024", "16384"))
        self.assertAlmostEqual(int(cases) / 1024, (3000 - 2564) / 1300, delta=0.01)
        found = {one["word"]: one for one in done.json()["warnings"]}
        self.assertGreater(found["hertz_pressure"]["value"], 4.1e9)
        shown = run("sweep", "show", self.folder.path("out.h5"), "--format", "json")
        self.assertEqual(shown.json()["warnings"], done.json()["warnings"])

    def test_tails_of_a_distribution_are_not_told(self):
        few = {"load": '{ distribution = "uniform", from = 1700, to = 2569 }', "speed": "0.1"}
        self.assertNotIn("hertz_pressure", self.run_sweep(few).warned)

    def test_a_value_of_a_grid_whose_cases_alone_are_beyond_is_counted(self):
        done = self.run_sweep({"load": "[50, 5000]", "lubricant.viscosity": UNIFORM, "speed": "0.1"}, "--format", "json")
        self.assertRegex(done.warned, r"hertz_pressure 5 GPa \(at most 4 GPa; in 512 of 1024 cases looked at, a sample of 32768, furthest in case 16384\)")

    def test_all_cases_are_no_sample(self):
        path = self.folder.write("few.toml", sweep({"load": "5000", "lubricant.viscosity": UNIFORM, "speed": "0.1"}, draws=64))
        done = run("sweep", path, "--estimate")
        self.assertIn("hertz_pressure 5 GPa (at most 4 GPa; in 64 of 64 cases, furthest in case 0)", done.said)
        self.assertNotIn("sample", done.said)

    def test_the_command_that_a_warning_names_repeats_the_case(self):
        drawn = {"load": '{ distribution = "uniform", from = 1700, to = 3000 }', "speed": "0.1"}
        for settings, last in (({}, "solve - --explain"), ({"onset": '["film_maximum"]'}, "contact -")):
            with self.subTest(last):
                path = self.folder.write("drawn.toml", sweep(drawn, **settings))
                said = run("sweep", path, "--estimate").said
                value, = re.search(r"hertz_pressure ([\d.]+) GPa \(", said).groups()
                first, case, second = re.search(r"`tribocheck (sweep \S+ --case (\d+)) \| tribocheck ([^`]*)` tells", said).groups()
                self.assertEqual((second, first.split()[1]), (last, path))
                table = run(*second.split(), stdin=run(*first.split()).out).out
                self.assertRegex(table, rf"(?m)^no +{value} GPa +at most 4 GPa .* hertz_pressure ")

    def test_a_grid_alone_has_no_case_that_is_furthest(self):
        path = self.folder.write("grid.toml", sweep({"load": "[50, 5000]", "speed": "0.1"}))
        said = run("sweep", path, "--estimate").said
        self.assertIn(f"`tribocheck sweep {path} --case N | tribocheck solve - --explain` tells all limits of case N", said)
        self.assertNotIn("furthest", said)

    def test_strict_is_exit_code_one_after_the_result(self):
        varied = {"lubricant.viscosity": "[0.02, 20.2]", "speed": "0.1"}
        self.assertEqual(self.run_sweep(varied).code, 0)
        self.assertEqual(self.run_sweep(varied, "--strict").code, 1)
        self.assertEqual(run("sweep", "show", self.folder.path("out.h5")).code, 0)

    def test_shipped_sweeps_are_silent(self):
        paths = list(REFERENCE.glob("published/sweeps/*.toml"))
        self.assertGreaterEqual(len(paths), 4)
        for path in paths:
            done = run("sweep", path, "--estimate", "--strict")
            self.assertEqual((done.code, done.said), (0, ""), path)


if __name__ == "__main__":
    unittest.main()
