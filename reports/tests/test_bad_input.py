# SPDX-License-Identifier: Apache-2.0
"""Bad scenes through the real program: exit code 2, one line that names file and field, no number."""

import os
import unittest

from program import Literal, ProgramTest, json_value, run, scene, split, toml, with_field, without_field

RANGE = {"from": 1e-4, "to": 3, "count": 20}
# path: (a good value, is it required?, is 0 legal?)
NUMBERS = {
    "load": (50, True, False),
    "speed": (0.1, True, False),
    "speed.from": (1e-4, True, False),
    "speed.to": (3, True, False),
    "speed.count": (20, False, False),
    "surface.summit_density": (5e10, True, False),
    "surface.summit_radius": (1e-5, True, False),
    "surface.summit_height_sd": (1e-7, True, False),
    "surface.summit_plane_offset": (1.146, False, True),
    "surface.offset_planes": (1, False, True),
    "bodies.effective_modulus": (107.9e9, True, False),
    "bodies.reduced_radius": (9.5e-3, True, False),
    "bodies.ellipticity": (1, False, False),
    "lubricant.viscosity": (0.0202, True, False),
    "lubricant.pressure_viscosity": (2e-8, True, False),
    "lubricant.eyring_stress": (2.5e6, False, False),
    "supply.inlet_film": (4e-7, False, False),
    "supply.inlet_film_ratio": (4, False, False),
    "supply.inlet_flow": (1e-8, False, False),
    "friction.boundary_coefficient": (0.13, False, True),
    "friction.slide_roll_ratio": (1, False, True),
    "closures.damiens_exponent": (3, False, False),
}
CHOICES = ["friction.fluid", "friction.viscosity", "closures.asperity", "closures.starvation",
           "closures.film", "speed.spacing"]


def base_for(path):
    """A good scene that has the field."""
    good = scene()
    if path.startswith("supply."):
        good = scene(supply={})
    if path == "speed":
        return scene(speed=0.1)
    return with_field(good, path, NUMBERS[path][0]) if path in NUMBERS else good


class BadInputTest(ProgramTest):
    def run_scene(self, tree, style="toml", command="solve"):
        name = f"case.{style}"
        return run(command, self.folder.write(name, tree), "--format", "csv")

    def assert_refused(self, result, *words):
        super().assert_refused(result, *words)
        self.assertLess(len(result.err), 1000)

    def assert_field_refused(self, path, tree, *words):
        for style in ["toml", "json"]:
            with self.subTest(path=path, style=style, tree=tree):
                result = self.run_scene(tree, style)
                self.assert_refused(result, f"case.{style}", split(path)[1], *words)


class EveryField(BadInputTest):
    def test_missing(self):
        for path, (_, required, _) in NUMBERS.items():
            tree = without_field(base_for(path), path)
            if path.startswith("supply."):
                self.assert_field_refused("supply", tree, "exactly one of")
            elif required:
                self.assert_field_refused(path, tree, path, "missing")
            else:
                with self.subTest(path=path):
                    self.run_scene(tree).ended(0, "")

    def test_missing_for_friction(self):
        for path in ["lubricant.eyring_stress", "friction.boundary_coefficient"]:
            tree = without_field(scene(outputs=["film", "friction"]), path)
            self.assert_field_refused(path, tree, path, "friction")

    def test_misspelt(self):
        for path, (value, _, _) in NUMBERS.items():
            section, key = split(path)
            wrong = key[:-1] + "x"
            tree = with_field(without_field(base_for(path), path),
                              f"{section}.{wrong}" if section else wrong, value)
            self.assert_field_refused(path, tree, wrong, f"did you mean {path}?")

    def test_misspelt_section(self):
        for section in ["surface", "bodies", "lubricant", "supply", "friction"]:
            tree = scene()
            tree[section + "s"] = tree.pop(section)
            self.assert_field_refused(section, tree, f"did you mean {section}?")

    def test_wrong_type(self):
        for path in NUMBERS:
            for value in ["abc", "5", True, [[1]]]:
                self.assert_field_refused(path, with_field(base_for(path), path, value), path)
        for path in CHOICES:
            for value in ["abc", "", 5, False, ["eyring"]]:
                self.assert_field_refused(path, with_field(base_for(path), path, value), path)
        self.assert_field_refused("id", scene(id=5))
        for value in ["film", [], [5], ["film", "film"], ["films"]]:
            self.assert_field_refused("outputs", scene(outputs=value))
        self.assert_field_refused("outputs", scene(outputs=["frictoin"]), "did you mean friction?")

    def test_zero(self):
        for path, (_, _, zero_is_legal) in NUMBERS.items():
            tree = with_field(base_for(path), path, 0)
            if zero_is_legal:
                self.assertEqual(self.run_scene(tree).code, 0, path)
            else:
                self.assert_field_refused(path, tree, path, "0 is not allowed")

    def test_negative(self):
        for path in NUMBERS:
            self.assert_field_refused(path, with_field(base_for(path), path, -1), path,
                                      "-1 is not allowed")

    def test_not_finite(self):
        for path in NUMBERS:
            for word in ["nan", "inf", "-inf", "+nan"]:
                with self.subTest(path=path, word=word):
                    tree = with_field(base_for(path), path, Literal(word))
                    self.assert_refused(self.run_scene(tree), "case.toml", split(path)[1])
            for word in ["NaN", "Infinity", "-Infinity"]:
                with self.subTest(path=path, word=word):
                    tree = with_field(base_for(path), path, Literal(word))
                    self.assert_refused(self.run_scene(tree, "json"), "case.json", split(path)[1])

    def test_beyond_double(self):
        for path in NUMBERS:
            for word in ["1e400", "-1e400", "1e-400"]:
                self.assert_field_refused(path, with_field(base_for(path), path, Literal(word)), path)

    def test_whole_numbers(self):
        for path in ["surface.offset_planes", "speed.count"]:
            self.assert_field_refused(path, with_field(scene(), path, 2.5), path)
        self.assert_field_refused("surface.offset_planes",
                                  with_field(scene(), "surface.offset_planes", 3))
        for count in [1, 10_000_001]:
            self.assert_field_refused("speed.count", with_field(scene(), "speed.count", count))


class Rules(BadInputTest):
    def test_two_kinds_of_supply(self):
        kinds = {"inlet_film": 4e-7, "inlet_film_ratio": 4, "inlet_flow": 1e-8}
        for first in kinds:
            for second in kinds:
                if first < second:
                    both = {first: kinds[first], second: kinds[second]}
                    self.assert_field_refused("supply", scene(supply=both), first, second)
        self.assert_field_refused("supply", scene(supply={}))

    def test_speeds(self):
        for speed in [{"from": 3, "to": 1e-4}, {"from": 1, "to": 1}, []]:
            self.assert_field_refused("speed", scene(speed=speed))
        self.assert_field_refused("speed", scene(speed=[1, -1]), "-1")

    def test_what_follows_from_legal_numbers_has_to_be_a_double_with_all_its_digits(self):
        bodies = {"first_modulus": 3e-308, "first_poisson_ratio": 0.3, "second_modulus": 3e-308,
                  "second_poisson_ratio": 0.3, "reduced_radius": 9.5e-3}
        result = self.run_scene(scene(bodies=bodies), "json")
        self.assertEqual((result.code, result.out), (2, ""))
        self.assertIn("bodies.first_modulus: the effective modulus that follows is 1.65e-308", result.err)
        bodies["first_modulus"] = bodies["second_modulus"] = 6e-308
        self.assertEqual(self.run_scene(scene(bodies=bodies), "json").code, 0)

    def test_keys_given_twice(self):
        for text in [toml(scene()).replace("load = 50\n", "load = 50\nload = 60\n"),
                     toml(scene()) + "[surface]\nsummit_radius = 1\n"]:
            self.assert_refused(run("solve", self.folder.write("twice.toml", text)), "twice.toml")
        text = json_value(scene()).replace('"load": 50', '"load": 50, "load": 60')
        self.assert_refused(run("solve", self.folder.write("twice.json", text)),
                            "twice.json: load: given twice")

    def test_every_command_refuses(self):
        for command in ["solve", "curve", "onset"]:
            for style in ["toml", "json"]:
                result = self.run_scene(scene(load=-1), style, command)
                self.assert_refused(result, f"case.{style}: load: -1")


class Files(BadInputTest):
    def test_missing_empty_and_directory(self):
        empty = self.folder.write("empty.toml", "")
        blank = self.folder.write("blank.json", " \n\t")
        for path in [self.folder.path("none.toml"), self.folder.name, empty, blank, "/dev/null", "/dev/zero"]:
            for command in ["solve", "curve", "onset"]:
                with self.subTest(path=path, command=command):
                    self.assert_refused(run(command, path), path)

    def test_too_large(self):
        path = self.folder.write("large.toml", toml(scene()) + "#" * (1 << 20))
        self.assert_refused(run("solve", path), path)
        self.assert_refused(run("solve", "-", stdin="#" * ((1 << 20) + 1)), "-")

    def test_stdin_is_empty(self):
        self.assert_refused(run("solve", "-"), "-")

    def test_pipes_are_read_like_standard_input(self):
        read, write = os.pipe()
        os.write(write, toml(scene()).encode())
        os.close(write)
        expected = run("solve", "-", "--format", "csv", stdin=toml(scene())).out
        self.assertEqual(run("solve", f"/dev/fd/{read}", "--format", "csv", pass_fds=[read]).out, expected)
        os.close(read)
        self.assertEqual(run("solve", "/dev/stdin", "--format", "csv", stdin=toml(scene())).out, expected)
        self.assert_refused(run("solve", "/dev/stdin", stdin="#" * ((1 << 20) + 1)), "too large")

    def test_other_encodings_are_named(self):
        for text, name in [(toml(scene()), "case.toml"), (json_value(scene()), "case.json")]:
            for encoding in ["utf-16", "utf-16-le", "utf-16-be", "utf-32"]:
                with self.subTest(name=name, encoding=encoding):
                    path = self.folder.write(name, text.encode(encoding))
                    said = f"{path}: the file is UTF-{encoding[4:6]}; save it as UTF-8"
                    self.assert_refused(run("solve", path), said)
                    self.assert_refused(run("sweep", path, "-o", "x.h5"), said)
        path = self.folder.write("case.toml", b"\xef\xbb\xbf" + toml(scene()).encode())
        self.assertEqual(run("solve", path).code, 0)

    def test_a_sweep_is_told_from_a_scene(self):
        normal = Literal('{ distribution = "normal", mean = 0.02, sd = 0.001 }')
        for tree in [scene(sweep={"draws": 64}), with_field(scene(), "lubricant.viscosity", normal),
                     scene(load=Literal('{ printed = "50" }')),
                     scene(load=Literal("{ from = 40, to = 60, count = 3 }"))]:
            path = self.folder.write("case.toml", tree)
            for command in ["solve", "curve", "onset"]:
                with self.subTest(tree=tree, command=command):
                    result = run(command, path)
                    self.assert_refused(result)
                    self.assertEqual(
                        result.err, f"tribocheck: {path}: this is a sweep: use `tribocheck sweep`\n")
        with open(path, encoding="utf-8") as file:
            self.assert_refused(run("solve", "-", stdin=file.read()), "this is a sweep")

    def test_the_other_scenes_beside_a_sweep_are_still_solved(self):
        sweep = self.folder.write("sweep.toml", scene(sweep={"draws": 64}))
        good = self.folder.write("good.toml", scene())
        result = run("solve", sweep, good, "--format", "csv")
        self.assertEqual((result.code, len(result.error_lines)), (2, 1))
        self.assertEqual(result.out, run("solve", good, "--format", "csv").out)

    def test_results_and_shards_of_sweeps_are_no_scenes(self):
        sweep = self.folder.write("sweep.toml", scene(load={"printed": "50"}, sweep={"draws": 64}))
        result, shard = self.folder.path("result.h5"), self.folder.path("part.shard")
        self.assertEqual(run("sweep", sweep, "-o", result).code, 0)
        self.assertEqual(run("sweep", sweep, "--shard", "1/2", "-o", shard).code, 0)
        for command in [["solve"], ["curve"], ["onset"], ["sweep", "-o", self.folder.path("x.h5")]]:
            self.assert_refused(run(*command, result), f"{result}: this is an HDF5 file",
                                "`tribocheck sweep show`")
            self.assert_refused(run(*command, shard), f"{shard}: this is a shard or part of a sweep",
                                "`tribocheck sweep merge`", "--resume")
        with open(result, "ab") as file:
            file.write(bytes(1 << 20))  # the message is about its kind, not its size
        self.assert_refused(run("solve", result), "this is an HDF5 file")

    def test_broken_toml(self):
        good = toml(scene()).encode()
        cases = [b"load = \n", b"load 50\n", b"[surface\n", b"load = '50\n", b"= 5\n", b"load = 5 5\n",
                 b"\xff\xfe\n", b"l\xc3\xb6ad = 5\n", b"\xe2\x80\xa8 = 1\n", b"a = \"\x00\"\n",
                 b"load = \"\"\"\n", b"load = [1,\n", b"a.b.c = 1\n", b"\x00\n", b"}\n", b"[[load]]\n"]
        for case in cases:
            with self.subTest(case=case):
                path = self.folder.write("broken.toml", case + good.replace(b"load = 50\n", b""))
                result = run("solve", path)
                self.assertEqual((result.code, result.out), (2, ""))
                self.assertIn("broken.toml", result.error_lines[0])

    def test_broken_json(self):
        good = json_value(scene())
        cases = [good[:-1], good + "}", good.replace(":", "", 1), good.replace('"load"', "load"),
                 "{", "[]", "[" * 100000, '{"a":' * 100000, "{,}", good.replace("50", "050"),
                 "{'load': 50}", good + good, '{"id": "\\ud800"}', "{\"id\": \"\udcff\"}"]
        for case in cases:
            with self.subTest(case=case[:60]):
                path = self.folder.write("broken.json", case.encode("utf-8", "surrogateescape"))
                result = run("solve", path)
                self.assertEqual((result.code, result.out), (2, ""))
                self.assertIn("broken.json", result.error_lines[0])

    def test_every_beginning_of_a_scene(self):
        for style, text in [("toml", toml(scene())), ("json", json_value(scene()))]:
            for end in range(0, len(text) - 20, 7):
                with self.subTest(style=style, end=end):
                    path = self.folder.write(f"part.{style}", text[:end])
                    self.assertIn(run("onset", path).code, [0, 2])


if __name__ == "__main__":
    unittest.main()
