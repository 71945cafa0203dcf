# SPDX-License-Identifier: Apache-2.0
"""solve and curve: numbers, formats that agree to the last bit, several scenes."""

import math
import unittest

from program import Literal, ProgramTest, json_value, quiet_scene, run, scene

NUMBERS = ["film_flooded", "film", "separation", "film_parameter", "asperity_load_share",
           "fluid_load_share", "real_area_ratio", "summit_count", "friction"]
OUTPUTS = NUMBERS + ["regime", "inlet"]
UNBALANCED = ["asperity_load_share", "fluid_load_share", "friction"]
COLLAPSED = "the film has collapsed: nothing balances the load"


class SolveTest(ProgramTest):
    def solved(self, tree, *arguments, command="solve"):
        return run(command, self.folder.write("scene.toml", tree), *arguments).ended(0, "")

    def points(self, tree, command="solve"):
        return self.solved(tree, "--format", "json", command=command).json()["points"]


class Numbers(SolveTest):
    def test_table_1_at_the_lowest_speed(self):
        expected = {"rough": (0.765412364174454, 3.88840686142501e-10),
                    "medium": (0.642288015366864, 3.65851178220415e-10),
                    "smooth": (0.537872259415982, 3.51904815844975e-10)}
        for surface, (share, film) in expected.items():
            with self.subTest(surface=surface):
                point = self.points(scene(surface, speed=1e-4))[0]
                self.assertAlmostEqual(point["asperity_load_share"] / share, 1, delta=1e-14)
                self.assertAlmostEqual(point["film"] / film, 1, delta=1e-14)

    def test_speeds_are_those_of_the_scene(self):
        speeds = [p["speed"] for p in self.points(scene(speed={"from": 1e-4, "to": 3, "count": 5}))]
        self.assertEqual((len(speeds), speeds[0], speeds[-1]), (5, 1e-4, 3))
        self.assertEqual(speeds, sorted(speeds))
        self.assertEqual([p["speed"] for p in self.points(scene(speed=[2, 0.1, 0.5]))],
                         [2, 0.1, 0.5])

    def test_each_of_many_points_is_that_of_its_speed_alone(self):
        # The speeds fill more than two chunks of the program (65536 speeds) and many pieces of a thread (2048 speeds).
        tree = scene(speed={"from": 1e-4, "to": 3, "count": 140_000}, outputs=["film", "friction"])
        texts = [self.solved(tree, "--format", "csv", "--threads", str(count)).out for count in (1, 3)]
        self.assertTrue(texts[0] == texts[1])
        rows = texts[0].splitlines()[1:]
        speeds = [float(row.split(",")[1]) for row in rows]
        self.assertEqual((len(rows), speeds[0], speeds[-1]), (140_000, 1e-4, 3))
        self.assertTrue(all(one < other for one, other in zip(speeds, speeds[1:])))
        chosen = sorted({place for size in (512, 2048, 65_536) for end in range(0, 140_000, size)
                         for place in (end - 1, end, end + 1) if 0 <= place < 140_000})
        tree["speed"] = [speeds[place] for place in chosen]
        alone = self.solved(tree, "--format", "csv").out.splitlines()[1:]
        self.assertEqual([rows[place] for place in chosen], alone)

    def test_only_the_outputs_that_are_asked_for(self):
        point = self.points(scene(speed=1, outputs=["inlet", "film"]))[0]
        self.assertEqual(list(point), ["id", "speed", "film", "inlet"])

    def test_outputs_without_their_inputs_are_left_out(self):
        point = self.points(scene(speed=1, friction=None))[0]
        self.assertEqual(list(point), ["id", "speed"] + [o for o in OUTPUTS if o != "friction"])

    def test_a_table_says_why_it_has_no_friction(self):
        whole = scene("rough")
        stress = {key: value for key, value in whole["lubricant"].items() if key != "eyring_stress"}
        both = "lubricant.eyring_stress and friction.boundary_coefficient are"
        for tree, missing in ((scene("rough", lubricant=stress), "lubricant.eyring_stress is"),
                              (scene("rough", friction={}), "friction.boundary_coefficient is"),
                              (scene("rough", lubricant=stress, friction={}), both),
                              (whole, ""), (scene("rough", lubricant=stress, outputs=["film"]), "")):
            for command in ("solve", "curve"):
                told = run(command, self.folder.write("scene.toml", tree)).out
                lines = [line for line in told.splitlines() if line.startswith("  - friction: not")]
                self.assertEqual(lines, [f"  - friction: not computed, as {missing} not given"] if missing else [], told)
        for form in ("csv", "json"):
            self.assertNotIn("not computed", run("solve", self.folder.write("scene.toml", scene("rough", friction={})), "--format", form).out)

    def test_the_id_is_the_files_name_where_the_scene_has_none(self):
        self.assertEqual(self.points(scene(id=None, speed=1))[0]["id"], "scene")
        result = run("solve", "-", "--format", "csv", stdin=json_value(scene(id=None, speed=1)))
        self.assertEqual(result.rows()[0]["id"], "stdin")

    def test_what_is_undefined_says_why(self):
        point = self.points(scene("smooth", speed=3))[0]
        self.assertEqual((point["inlet"], point["regime"], point["film"], point["separation"]),
                         ("collapsed", "collapsed", 0, 0))
        self.assertGreater(min(point["real_area_ratio"], point["summit_count"]), 0)  # limits for a film of 0
        self.assertEqual([point[name] for name in UNBALANCED], [None, None, None])
        self.assertEqual(point["undefined"], dict.fromkeys(UNBALANCED, COLLAPSED))

    def test_each_output_asked_alone_says_why_it_is_undefined(self):
        for name in OUTPUTS:
            point = self.points(scene("smooth", speed=3, outputs=[name]))[0]
            self.assertEqual(point.get("undefined"), {name: COLLAPSED} if name in UNBALANCED else None)

    def test_a_collapse_onto_a_floor_leaves_the_load_to_the_asperities(self):
        tree = scene("rough", speed=5)
        tree["surface"]["offset_planes"] = 2
        point = self.points(tree)[0]
        self.assertEqual((point["inlet"], point["regime"], point["film"]), ("collapsed", "boundary", 0))
        self.assertEqual((point["asperity_load_share"], point["fluid_load_share"]), (1, 0))
        self.assertGreater(point["friction"], 0.13)
        self.assertNotIn("undefined", point)

    def test_an_overflow_is_undefined_not_infinite(self):
        tree = scene(speed=1e300)
        tree["surface"]["summit_height_sd"] = 1e-200
        del tree["supply"]
        path = self.folder.write("huge.toml", tree)
        result = run("solve", path, "--format", "json").ended(0)
        self.assertIn("speed_range", result.warned)
        point = result.json()["points"][0]
        self.assertIsNone(point["film_parameter"])
        self.assertEqual(point["undefined"]["film_parameter"],
                         "outside the range of double precision")
        row = run("solve", path, "--format", "csv").rows()[0]
        self.assertEqual(row["film_parameter"], "")
        table = run("solve", path).out
        self.assertIn("  - film_parameter: outside the range of double precision\n", table)
        for word in ["nan", "inf"]:
            self.assertNotRegex(table, rf"\b{word}\b")

    def test_a_film_beyond_double_has_no_inlet_state(self):
        tree = scene(speed=1e300, supply=None, outputs=["inlet"])
        tree["lubricant"]["viscosity"] = 1e300
        path = self.folder.write("thick.toml", tree)
        point = run("solve", path, "--format", "json").json()["points"][0]
        self.assertIsNone(point["inlet"])
        self.assertEqual(point["undefined"]["inlet"], "outside the range of double precision")


class About(SolveTest):
    """`solve --about` tells facts of a scene in place of its points."""

    def about(self, tree):
        """The values of each part of the answer, by their names."""
        told, = self.solved(tree, "--about", "--format", "json").json()["scenes"]
        return {part: {one["name"]: one["value"] for one in told[part]} for part in ("inputs", "contact", "outputs", "work")}

    def test_inputs_are_those_of_the_scene_what_follows_and_defaults(self):
        tree = quiet_scene(speed=[2, 0.5, 1])
        inputs = self.about(tree)["inputs"]
        given = {f"{section}.{name}": value for section, fields in tree.items() if isinstance(fields, dict)
                 for name, value in fields.items()} | {"load": 50, "speed": "2, 0.5, 1", "accept": ", ".join(tree["accept"])}
        defaults = {"surface.offset_planes": 1, "bodies.ellipticity": 1, "friction.slide_roll_ratio": 1, "friction.fluid": "eyring",
                    "friction.viscosity": "barus", "closures.asperity": "greenwood_tripp", "closures.starvation": "flooded_inlet",
                    "closures.film": "hamrock_dowson_central"}
        self.assertEqual({name: value for name, value in inputs.items() if value is not None}, given | defaults)
        self.assertIn("supply.inlet_flow", inputs)

    def test_a_range_is_told_by_its_ends_and_defaults_are_marked(self):
        told = self.about(quiet_scene(speed={"from": 0.5, "to": 2}))["inputs"]
        parts = ("speed", "speed.from", "speed.to", "speed.count", "speed.spacing")
        self.assertEqual([told[name] for name in parts], [None, 0.5, 2, 200, "log"])
        told = self.about(quiet_scene(speed={"from": 0.5, "to": 2, "count": 50, "spacing": "lin"}))["inputs"]
        self.assertEqual([told[name] for name in parts], [None, 0.5, 2, 50, "lin"])
        told = self.about(quiet_scene(speed=[float(speed) for speed in range(1, 31)]))["inputs"]
        self.assertEqual([told[name] for name in parts], [None, 1, 30, 30, None])
        table = self.solved(quiet_scene(speed={"from": 0.5, "to": 2}), "--about").out
        self.assertIn("\n  speed.count                   200, the default\n", table)
        table = self.solved(quiet_scene(), "--about").out
        self.assertIn("\n  friction.slide_roll_ratio     1 [-], the default\n", table)

    def test_a_blank_stands_behind_the_longest_name(self):
        tree = quiet_scene(speed=1, friction={"boundary_coefficient": 0.13, "slide_roll_ratio": 1})
        tree["lubricant"] |= {"thermal": "gupta", "conductivity": 0.14, "temperature_coefficient": 0.04}
        lines = [line for line in self.solved(tree, "--about").out.splitlines() if line.startswith("  lubricant.")]
        self.assertIn("  lubricant.temperature_coefficient 0.04 [1/K]", lines)
        self.assertEqual({len(line) - len(line[36:].lstrip()) for line in lines}, {36})

    def test_numbers_of_bodies_and_profiles_follow_from_these(self):
        tree = scene() | dict(surface={"m0": 1e-14, "m2": 1e-3, "m4": 4e8}, bodies={
            "first_modulus": 2e11, "first_poisson_ratio": 0.3, "second_modulus": 2e11, "second_poisson_ratio": 0.3,
            "first_radius_x": 0.02, "second_radius_x": 0.02, "length": 0.01}, closures={"film": "dowson_toyoda_central"})
        told = self.about(tree)
        self.assertAlmostEqual(told["contact"]["effective_modulus"] / 1e11 * 0.91, 1, delta=1e-14)
        self.assertAlmostEqual(told["inputs"]["bodies.effective_modulus"], told["contact"]["effective_modulus"])
        self.assertAlmostEqual(told["inputs"]["bodies.radius_x"], 0.01, delta=1e-16)
        self.assertGreater(told["inputs"]["surface.summit_density"], 0)
        self.assertEqual([told["contact"][name] for name in ("shape", "length", "semi_axis_y", "approach")], ["line", 0.01, None, None])

    def test_the_contact_is_that_of_the_functions(self):
        told = self.about(quiet_scene())["contact"]
        question = {"function": "hertz_point", "load": 50, "effective_modulus": 107.9e9, "reduced_radius": 9.5e-3}
        hertz, = run("stream", stdin=json_value(question) + "\n").json_lines()
        for name, other in (("semi_axis_x", "radius"), ("semi_axis_y", "radius"), ("mean_pressure", "mean_pressure"),
                            ("peak_pressure", "peak_pressure"), ("approach", "approach")):
            self.assertAlmostEqual(told[name] / hertz[other], 1, delta=1e-15)
        self.assertEqual((told["shape"], told["ellipticity"], told["length"], told["speed_power"]), ("circle", 1, None, 0.67))

    def test_work_is_that_of_the_outputs_asked_for(self):
        full = self.about(quiet_scene())
        self.assertEqual((full["work"]["points"], full["work"]["moments"], full["work"]["starvation_ratios"]), (20, 40, 20))
        self.assertEqual([name for name, is_asked in full["outputs"].items() if not is_asked],
                         ["peak_pressure", "mean_pressure", "minimum_film", "lambda_ratio"])
        film = self.about(quiet_scene(outputs=["film"]))
        self.assertEqual([name for name, is_asked in film["outputs"].items() if is_asked], ["film"])
        self.assertEqual((film["work"]["moments"], film["work"]["shares_skipped_not_asked"]), (0, 20))
        self.assertEqual(film["work"]["root_steps"], full["work"]["root_steps"])

    def test_formats_agree(self):
        tree = quiet_scene()
        told, = self.solved(tree, "--about", "--format", "json").json()["scenes"]
        entries = [(part, one) for part in ("inputs", "contact", "outputs", "work") for one in told[part]]
        rows = self.solved(tree, "--about", "--format", "csv").rows()
        for (part, one), row in zip(entries, rows, strict=True):
            self.assertEqual((row["id"], row["part"], row["name"], row["unit"], row["meaning"]),
                             ("rough", part, one["name"], one["unit"], one["meaning"]))
            value = one["value"]
            if isinstance(value, float):
                self.assertEqual(float(row["value"]), value)
            else:
                self.assertEqual(row["value"], "" if value is None else str(value).lower() if isinstance(value, bool) else str(value))
        table = self.solved(tree, "--about").out
        self.assertEqual(table.count("rough: "), 4)
        for _, one in entries:
            self.assertEqual(len([line for line in table.splitlines() if line.split()[:1] == [one["name"]]]) > 0, one["value"] is not None)
        self.assertIn("\n  load                          50 [N]\n", table)
        film = self.solved(quiet_scene(outputs=["film"]), "--about").out
        self.assertRegex(film, r"\n  film +computed\n")
        self.assertRegex(film, r"\n  friction +not computed\n")


class Formats(SolveTest):
    def assert_csv_agrees(self, points, row_list):
        self.assertEqual(len(points), len(row_list))
        for point, row in zip(points, row_list):
            self.assertEqual(list(row), ["id", "speed"] + OUTPUTS)
            for name, text in row.items():
                value = point[name]
                if value is None:
                    self.assertEqual(text, "")
                elif isinstance(value, str):
                    self.assertEqual(text, value)
                else:
                    self.assertEqual(float(text), value)

    def assert_table_agrees(self, points, lines):
        self.assertEqual(len(points), len(lines))
        for point, line in zip(points, lines):
            shown = ["-" if point[name] is None else
                     point[name] if isinstance(point[name], str) else f"{point[name]:.5g}"
                     for name in ["speed"] + OUTPUTS]
            self.assertEqual(line.split(), shown)

    def test_all_three_agree_to_the_last_bit(self):
        for surface in ["rough", "smooth"]:
            for command in ["solve", "curve"]:
                with self.subTest(surface=surface, command=command):
                    tree = scene(surface)
                    points = self.points(tree, command)
                    self.assertEqual(len(points), 20)
                    table = self.solved(tree, command=command).out.splitlines()
                    self.assert_csv_agrees(
                        points, self.solved(tree, "--format", "csv", command=command).rows())
                    self.assert_table_agrees(points, table[5:25])

    def test_the_stream_agrees_to_the_last_bit(self):
        points = self.points(scene("smooth"))
        lines = "".join(json_value(scene("smooth", speed=p["speed"])) + "\n" for p in points)
        for point, answer in zip(points, run("stream", stdin=lines).json_lines(), strict=True):
            del point["speed"]
            self.assertEqual(point, answer)

    def test_json_is_one_object_a_line(self):
        lines = self.solved(scene(), "--format", "json").out.splitlines()
        self.assertEqual((lines[0].split()[-1], lines[-1].partition(" [")[0], len(lines)), ("[", '], "warnings":', 22))

    def test_csv_has_one_header_for_all_scenes(self):
        first = self.folder.write("a.toml", scene(id='a,"b"', speed=1, outputs=["film", "friction"]))
        second = self.folder.write("b.toml", scene(speed=1, outputs=["film", "inlet"]))
        result = run("solve", first, second, "--format", "csv")
        self.assertEqual(result.out.splitlines()[0], "id,speed,film,friction,inlet")
        rows = result.rows()
        self.assertEqual([row["id"] for row in rows], ['a,"b"', "rough"])
        self.assertEqual((rows[0]["inlet"], rows[1]["friction"]), ("", ""))
        self.assertNotEqual(rows[0]["friction"], "")

    def test_the_table_has_units_and_aligned_columns(self):
        lines = self.solved(scene("smooth")).out.splitlines()
        self.assertEqual(lines[:2], ["smooth: 20 speeds", "-----------------"])
        units = lines[4].split()
        self.assertEqual(units, ["[m/s]", "[m]", "[m]", "[m]"] + ["[-]"] * 6)
        ends = {len(line) for line in [lines[3], *lines[5:25]]}
        self.assertEqual(len(ends), 1)
        for line in [lines[3], *lines[5:25]]:  # two blanks between the columns, everywhere
            self.assertEqual(line[12:14], "  ")
        self.assertEqual(lines[25:], [f"  - {', '.join(UNBALANCED)}: {COLLAPSED}"])

    def test_a_title_is_underlined_as_long_as_it_looks(self):
        lines = run("solve", "-", stdin=json_value(scene(id="ü ρ", speed=1))).out.splitlines()
        self.assertEqual(lines[:2], ["ü ρ: 1 speed", "-" * len("ü ρ: 1 speed")])

    def test_ids_of_any_text(self):
        for name in ["ü ρ", "a\\b", 'quo"te', "tab\there", "new\nline", "'"]:
            with self.subTest(name=name):
                tree = json_value(scene(id=name, speed=1))
                self.assertEqual(run("solve", "-", "--format", "json", stdin=tree).json()["points"][0]["id"], name)
                rows = run("solve", "-", "--format", "csv", stdin=tree).rows()
                self.assertEqual([row["id"] for row in rows], [name])
                self.assertEqual(run("stream", stdin=tree).json_lines()[0]["id"], name)


class Curve(SolveTest):
    def test_every_point_is_that_of_solve_at_its_speed(self):
        for closure in ["flooded_inlet", "starved_inlet", "printed_exponents", "damiens"]:
            for supply in [None, {"inlet_film": 4e-7}, {"inlet_flow": 1e-8}]:
                with self.subTest(closure=closure, supply=supply):
                    tree = scene(supply=supply, closures={"starvation": closure})
                    curve = self.points(tree, "curve")
                    tree["speed"] = [point["speed"] for point in curve]
                    self.assert_close(curve, self.points(tree))

    def assert_close(self, curve, solved):
        self.assertEqual(len(curve), 20)
        for point, other in zip(curve, solved, strict=True):
            for name in NUMBERS:
                if other[name] is None:
                    self.assertIsNone(point[name])
                else:
                    self.assertTrue(math.isclose(point[name], other[name], rel_tol=1e-9,
                                                 abs_tol=1e-12), (name, point, other))

    def test_it_spans_the_range(self):
        speeds = [point["speed"] for point in self.points(scene(), "curve")]
        self.assertEqual(speeds, sorted(speeds))
        self.assertAlmostEqual(speeds[0] / 1e-4, 1, delta=1e-2)
        self.assertAlmostEqual(speeds[-1] / 3, 1, delta=1e-2)

    def test_a_list_gives_the_range(self):
        speeds = [p["speed"] for p in self.points(scene(speed=[1, 0.01, 0.1]), "curve")]
        self.assertEqual((len(speeds), speeds), (3, sorted(speeds)))

    def test_one_speed_is_no_curve(self):
        for speed in [1, [1], [1, 1]]:
            with self.subTest(speed=speed):
                result = run("curve", self.folder.write("scene.toml", scene(speed=speed)))
                self.assertEqual((result.code, result.out, len(result.error_lines)), (2, "", 1))
                self.assertIn("rough: speed: ", result.err)


class SeveralScenes(SolveTest):
    def test_a_bad_one_is_reported_and_the_good_ones_are_solved(self):
        good = [self.folder.write(f"{name}.toml", scene(name)) for name in ["rough", "smooth"]]
        bad = self.folder.write("bad.toml", scene(load=Literal("-5")))
        missing = self.folder.path("missing.toml")
        for command in ["solve", "curve", "onset"]:
            with self.subTest(command=command):
                alone = run(command, *good, "--format", "json").ended(0, "")
                mixed = run(command, good[0], bad, missing, good[1], "--format", "json")
                self.assertEqual((mixed.code, mixed.out), (2, alone.out))
                self.assertEqual(len(mixed.error_lines), 2)
                self.assertIn("bad.toml: load: ", mixed.error_lines[0])
                self.assertIn("missing.toml: ", mixed.error_lines[1])

    def test_one_speed_beside_a_curve_is_reported_and_the_curve_is_drawn(self):
        good = self.folder.write("good.toml", scene())
        one = self.folder.write("one.toml", scene("smooth", speed=1))
        alone = run("curve", good, "--format", "json")
        for order in ([good, one], [one, good]):
            mixed = run("curve", *order, "--format", "json")
            self.assertEqual((mixed.code, mixed.out, len(mixed.error_lines)), (2, alone.out, 1))

    def test_reasons_stand_under_their_own_table(self):
        collapsed = self.folder.write("smooth.toml", scene("smooth", speed=[3, 2]))
        whole = self.folder.write("rough.toml", scene(speed=1e-3))
        for order, place in (([collapsed, whole], 0), ([whole, collapsed], 1)):
            tables = run("solve", *order).out.split("\n\n")
            self.assertEqual([table.count(COLLAPSED) for table in tables],
                             [int(i == place) for i in (0, 1)])

    def test_only_bad_ones_leave_stdout_empty(self):
        bad = self.folder.write("bad.toml", scene(load=0))
        for style in ["table", "csv", "json"]:
            result = run("solve", bad, "--format", style)
            self.assertEqual((result.code, result.out), (2, ""))

    def test_stdin_among_files(self):
        file = self.folder.write("rough.toml", scene(speed=1))
        result = run("solve", file, "-", "--format", "csv", stdin=json_value(scene("smooth", speed=1)))
        self.assertEqual([row["id"] for row in result.rows()], ["rough", "smooth"])

    def test_implausible_values_get_a_warning_and_a_result(self):
        tree = scene(speed=1)
        tree["bodies"]["reduced_radius"] = 9.5
        result = run("solve", self.folder.write("ball.toml", tree), "--format", "csv")
        self.assertEqual((result.code, len(result.rows())), (0, 1))
        self.assertRegex(result.warned, r"warning: .*ball\.toml: .*bodies\.reduced_radius 9\.5 m .*perhaps mm was meant")


if __name__ == "__main__":
    unittest.main()
