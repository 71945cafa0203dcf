# SPDX-License-Identifier: Apache-2.0
"""The page's live part without a browser: the model in WebAssembly under Node, against the program and the certified tables."""

import decimal
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest

from live import ask, random_scene, text, tree
from program import run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
sys.path.insert(0, str(ROOT / "reports/live"))
sys.path.insert(0, str(ROOT / "reports/page/render"))
import live_part  # noqa: E402
import make_live  # noqa: E402

OUTPUTS = ["film_flooded", "film", "separation", "film_parameter", "asperity_load_share", "fluid_load_share", "real_area_ratio",
           "summit_count", "friction", "regime", "inlet", "peak_pressure", "mean_pressure", "minimum_film", "lambda_ratio"]
SCENES = sorted([*(ROOT / "reference/scenes").glob("*.toml"), *(ROOT / "reference/published").glob("*.toml")])
CONTRACT = (8, 16)  # for operating points: ulp, and ulp for each unit of the condition number
STEP = 1e-6


def solved(scenes):
    lines = "".join(json.dumps({"id": str(i), **tree(scene), "outputs": OUTPUTS}) + "\n" for i, scene in enumerate(scenes))
    return run("stream", stdin=lines).json_lines()


class Numbers(unittest.TestCase):
    COUNT = 1000

    def test_random_scenes_give_the_programs_numbers_within_the_contract(self):
        """Each number lies within the bound of its contract. The condition number is computed from the program's answers at changed inputs."""
        made = [random_scene(seed) for seed in range(self.COUNT)]
        here = ask([["solve", text(scene), scene["speed"]] for scene, _ in made])
        there = solved([scene for scene, _ in made])
        beside = iter(solved([scene | {path: scene[path] * (1 + STEP)} for scene, numbers in made for path in numbers]))
        compared, worst, words = 0, 0, 0
        for (scene, numbers), ours, answer in zip(made, here, there, strict=True):
            moved = [next(beside) for _ in numbers]
            self.assertNotIn("error", answer)
            for output in OUTPUTS:
                value, got = answer[output], ours[output]
                with self.subTest(scene=scene, output=output):
                    if isinstance(value, str) or value is None:
                        self.assertEqual(got, value)
                        words += isinstance(value, str)
                        continue
                    condition = sum(abs(math.log(one[output] / value)) / STEP for one in moved if one[output] and value > 0)
                    bound = max(CONTRACT[0], CONTRACT[1] * max(1, condition)) * math.ulp(value)
                    worst = max(worst, abs(got - value) / bound)
                    self.assertLessEqual(abs(got - value), bound, condition)
                    compared += 1
        print(f"{compared} numbers and {words} words; the greatest difference takes {100 * worst:.2g} % of its bound", file=sys.stderr)
        self.assertGreater(compared, 10 * self.COUNT)
        self.assertGreater(words, self.COUNT)

    def test_shipped_scenes_have_the_programs_onsets(self):
        answers = ask([["ask", path.read_text(), "live_onsets"] for path in SCENES])
        for path, lines in zip(SCENES, answers, strict=True):
            told = run("onset", path, "--format", "json").json()
            told = {one["criterion"]: one for one in told["onsets"]}
            for name, _, speed, film, _, why in lines:
                with self.subTest(scene=path.name, criterion=name):
                    if why:
                        self.assertEqual(told[name]["undefined"]["speed"], why)
                    else:  # a search for the lowest friction finds half of the digits
                        part = 1e-6 if name == "friction_minimum" else 1e-12
                        self.assertAlmostEqual(float(speed) / told[name]["speed"], 1, delta=part)
                        self.assertAlmostEqual(float(film) / told[name]["film"], 1, delta=part)

    def test_films_by_each_law_are_the_programs(self):
        for path in SCENES:
            told = run("contact", path, "--format", "json").json()["scenes"][0]["speeds"]
            for one in told:
                lines = {law: rest for law, *rest in ask([["ask", path.read_text(), "live_films", one["speed"]]])[0]}
                self.assertIn("solved", lines)
                for film in one["films"]:
                    with self.subTest(scene=path.name, law=film["law"]):
                        self.assertAlmostEqual(float(lines[film["law"]][1]) / film["film"], 1, delta=1e-12)


    def test_solved_least_films_are_the_programs_to_the_rounding_of_their_tables(self):
        scenes = []
        for scene, _ in (random_scene(seed) for seed in range(self.COUNT)):
            if "bodies.radius_y" in scene:
                continue
            scene = {path: value for path, value in scene.items() if not path.startswith(("supply.", "closures.starvation", "closures.damiens"))}
            scenes.append(scene | {"closures.film": "solved"} | ({"bodies.ellipticity": 1.0} if "bodies.ellipticity" in scene else {}))
        known = dict.fromkeys(("bodies.length", "bodies.ellipticity"), 0)
        for scene, here, there in zip(scenes, ask([["ask", text(scene), "live_films", scene["speed"]] for scene in scenes]), solved(scenes), strict=True):
            (_, _, central, *_), (_, is_minimum, least, why, _) = here[-2:]
            with self.subTest(scene=scene):
                self.assertEqual((here[-2][:2], is_minimum), (["solved", "0"], "1"))
                if there["film"]:
                    self.assertEqual(why == "", there["minimum_film"] is not None)
                if there["film"] and there["minimum_film"]:
                    self.assertAlmostEqual(float(least) / float(central) / (there["minimum_film"] / there["film"]), 1, delta=1e-4)
                    known["bodies.length" if "bodies.length" in scene else "bodies.ellipticity"] += 1
        self.assertGreater(min(known.values()), 30)


class CertifiedRows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.judged = ask([["ask", SCENES[0].read_text(), "live_verify"]])[0]

    def test_each_row_is_within_its_bound(self):
        for function, output, rows, part, worst in self.judged:
            with self.subTest(function=function, output=output):
                self.assertLessEqual(float(part), 1, worst)
                self.assertGreater(float(part), 0)

    def test_at_least_fifty_rows_of_each_function_and_output_of_a_point(self):
        rows = {}
        for function, output, count, *_ in self.judged:
            name = (function, output) if function == "operating_point" else function
            rows[name] = rows.get(name, 0) + int(float(count))
        self.assertGreaterEqual(min(rows.values()), 50)
        self.assertEqual(set(rows), {*make_live.SHOWN, *(("operating_point", name) for name in OUTPUTS[:9])})
        self.assertEqual(sum(rows.values()), len(list(make_live.row_lines())))

    def test_the_worst_conditioned_row_is_among_them(self):
        there = {}
        for line in make_live.row_lines():
            name, output, row, _, _, condition, *_ = line.split(",")
            there.setdefault((name, output if name == "operating_point" else ""), {})[row] = float(condition)
        for (name, output), rows in there.items():
            with self.subTest(function=name, output=output):
                every = [row for row in make_live.read_rows(name) if not output or row["output"] == output]
                every = [row for row in every if "solved" not in (row.get("film"), row.get("starvation"))]
                self.assertEqual(max(rows.values()), max(float(row["condition"]) for row in every))


class Scenes(unittest.TestCase):
    BAD = ["load = -1", "load = 'much'", "lode = 50", "", "load = 50\nload = 60", "load = 1e400", "load = [1, 2]", "load = '5 kg'", "load = nan",
           "load = 50 # N\n[surface]\nsummit_density = 1", "x = [", "load = '9,5 N'"]

    def test_a_fault_has_the_programs_sentence(self):
        base = (ROOT / "reference/published/rough.toml").read_text()
        texts = [re.sub(r"(?m)^load = .*$", lambda _: bad, base, count=1) for bad in self.BAD]
        for field, values in {"bodies.reduced_radius": ('"-1 mm"', '"abc mm"', '"0 mm"', '"9.5 GPa"'), "surface.offset_planes": ("1.5", "3"),
                              "closures.film": ('"hamrock"', '"dowson_toyoda_central"'), "friction.slide_roll_ratio": ("-1", '"2 mm"'),
                              "speed": ("{ from = 3, to = 1 }", "{ from = 0, to = 1 }", "[]", "-1")}.items():
            name = field.rpartition(".")[2]
            texts += [re.sub(rf"(?m)^{name} = .*$", f"{name} = {value}", base) if re.search(rf"(?m)^{name} = ", base)
                      else base + f"{name} = {value}\n" for value in values]
        for toml, told in zip(texts, ask([["read", toml] for toml in texts]), strict=True):
            with self.subTest(toml=toml):
                said = run("solve", "-", stdin=toml).error_lines
                ours = [(field, sentence) for kind, field, sentence in told if kind == "error"]
                self.assertGreater(len(ours), 0)
                for field, sentence in ours:
                    self.assertTrue(any(line.endswith(sentence) and field in line for line in said), (field, sentence, said))
                self.assertEqual(len(ours), len([line for line in said if line.startswith("tribocheck: -")] or said))

    def test_a_form_gives_the_scene_that_it_was_filled_from(self):
        """The scene goes through the units and the text of the form, and through a link. Numbers that follow from others have six digits."""
        texts = [path.read_text() for path in SCENES]
        forms = ask([["form", toml] for toml in texts])
        for path, toml, (form, shared) in zip(SCENES, texts, forms, strict=True):
            with self.subTest(path.name):
                self.assertEqual(form, shared)
                part = 1e-4 if "m0 =" in toml else 1e-15
                for got, want in zip(*(run("solve", "-", "--format", "json", stdin=re.sub(r"(?m)^speed = .*$", "speed = 0.5", one)).json()["points"]
                                       for one in (form, toml)), strict=True):
                    for output, value in want.items():
                        if isinstance(value, float):
                            self.assertAlmostEqual(got[output] / value, 1, delta=part, msg=output)

    def test_a_supply_of_solved_starved_films_is_refused(self):
        toml = (ROOT / "reference/published/rough.toml").read_text().replace('starvation = "flooded_inlet"', 'starvation = "solved"')
        told = ask([["read", toml]])[0]
        self.assertEqual([(kind, field) for kind, field, _ in told], [("error", "closures.starvation")])

    def test_decimals_keep_their_digits(self):
        texts = ["0.0095", "5e10", "1e-7", "123456.78", "-0.001", "0.00001234", "1", "1000000", "0", "1e300", "9.50", "+3", ".5", "5.", "1E5"]
        cases = [(one, power) for one in texts for power in (-9, -3, 0, 3, 9)]
        for (one, power), got in zip(cases, ask([["shifted", *case] for case in cases]), strict=True):
            self.assertEqual(decimal.Decimal(got), decimal.Decimal(one).scaleb(power), (one, power))
        self.assertEqual(ask([["shifted", one, 3] for one in ("", "abc", "1 2", "1,5", "-")]), [None] * 5)

    def test_the_python_call_gives_the_programs_number(self):
        """The call is valid Python, and its scene is that of the form."""
        state = ask([["state", (ROOT / "reference/published/rough.toml").read_text()]])[0]
        call, = ask([["python", state]])
        toml, = ask([["toml", state]])
        asked = {}
        class Scene:
            def __init__(self, text):
                asked["text"] = text
            def solve(self, speeds, outputs):
                asked["speeds"], asked["outputs"] = speeds, outputs
            def onset(self):
                asked["onset"] = True
        package = type(sys)("tribocheck")
        package.Scene = Scene
        sys.modules["tribocheck"] = package
        self.addCleanup(sys.modules.pop, "tribocheck")
        with open(os.devnull, "w") as nowhere:
            exec(call, {"print": lambda *what: print(*what, file=nowhere)})
        self.assertEqual(asked["text"].strip(), toml.strip())
        self.assertEqual(asked["speeds"], [float(state["values"]["at"])])
        self.assertTrue(asked["onset"])
        self.assertIn("friction", asked["outputs"])
        state["values"]["friction.boundary_coefficient"] = " "
        self.assertNotIn("friction", ask([["python", state]])[0].rpartition("outputs=")[2])


class OwnNumber(unittest.TestCase):
    """The diagnosis of one number: the right one, one with each known mistake, and one that no known mistake gives."""
    SCENE, AT = (ROOT / "reference/published/rough.toml").read_text(), 1

    @classmethod
    def setUpClass(cls):
        cls.mistakes = live_part.mistakes()
        cls.quantities = ask([["quantities", cls.SCENE, cls.AT]])[0]

    def quantity(self, name, result):
        return next(one for one in self.quantities if (one["name"], one["result"]) == (name, result))

    def asked(self, quantity, number, doubt):
        return ask([["causes", self.SCENE, self.AT, self.mistakes, quantity, number, doubt]])[0]

    def program(self, name, result, **arguments):
        return run("stream", stdin=json.dumps({"id": "1", "function": name} | arguments)).json_lines()[0][result]

    def test_the_arguments_are_those_of_the_scene_and_the_right_number_is_right(self):
        self.assertGreater(len(self.mistakes), 100)
        self.assertEqual(self.quantities[0]["name"], "hamrock_dowson_central", "the scene's law stands first")
        for one in self.quantities:
            with self.subTest(one["name"], result=one["result"]):
                right = self.program(one["name"], one["result"], **one["given"])
                self.assertEqual(self.asked(one, right, 1e-6 * right)["texts"], [""])

    def test_each_known_mistake_is_named(self):
        """For the film and for Hertz' pressure and radius. The program computes the wrong numbers."""
        named = 0
        for name, result in (("hamrock_dowson_central", "value"), ("hertz_point", "peak_pressure"), ("hertz_point", "radius")):
            quantity = self.quantity(name, result)
            right = self.program(name, result, **quantity["given"])
            for one in self.mistakes:
                if name not in one["functions"] and not (quantity["isFilm"] and "film_laws" in one["functions"]):
                    continue
                if set(one["input"]) - set(quantity["given"]) or one["result"].get(result, {}).get("over"):
                    continue
                arguments = dict(quantity["given"])
                for argument, change in one["input"].items():
                    arguments[argument] = change.get("is", 1 / arguments[argument] if change.get("inverted") else arguments[argument] * change.get("times", 1))
                wrong = self.program(name, result, **arguments) * one["result"].get(result, {}).get("times", 1)
                if abs(wrong / right - 1) < 1e-9:
                    continue
                with self.subTest(one["name"]):
                    told = self.asked(quantity, wrong, 1e-5 * wrong)
                    self.assertAlmostEqual(told["right"] / right, 1, delta=1e-12)
                    self.assertTrue(any(f"({one['name']})" in text for text in told["texts"]), told)
                    named += 1
        self.assertGreater(named, 25)

    def test_the_film_of_another_law_is_named(self):
        quantity = self.quantity("hamrock_dowson_central", "value")
        other = self.quantity("hamrock_dowson_minimum", "value")
        number = self.program(other["name"], "value", **other["given"])
        self.assertEqual(self.asked(quantity, number, 1e-4 * number)["texts"], ["the film of hamrock_dowson_minimum in place of that of hamrock_dowson_central"])

    def test_a_number_that_nothing_gives_has_no_cause(self):
        quantity = self.quantity("hamrock_dowson_central", "value")
        self.assertEqual(self.asked(quantity, 1.2345e-7, 5e-12)["texts"], [])

    def test_a_typed_number_has_its_unit_and_half_of_its_last_digit(self):
        for text, unit, number, doubt in (("152 nm", "m", 152e-9, 0.5e-9), ("1.5e-7", "m", 1.5e-7, 0.05e-7), ("1.08 GPa", "Pa", 1.08e9, 0.005e9), ("0.15 µm", "m", 0.15e-6, 0.005e-6),
                                          ("3", "", 3, 0.5)):
            told = ask([["typed", text, unit]])[0]
            self.assertAlmostEqual(told["number"] / number, 1, delta=1e-12)
            self.assertAlmostEqual(told["doubt"] / doubt, 1, delta=1e-12)
        self.assertEqual(ask([["typed", *one] for one in (("152 GPa", "m"), ("", "m"), ("much", "m"), ("-3", "m"), ("3 nm", ""), ("1,5 nm", "m"))]), [None] * 6)


class Packing(unittest.TestCase):
    def test_base_85_is_unpacked_as_pythons(self):
        import base64
        packed = [bytes(range(n)) for n in (1, 2, 3, 4, 5, 250, 255)] + [b"\xff" * 7, b"\0" * 9]
        self.assertEqual(ask([["unpacked", base64.b85encode(one).decode()] for one in packed]), [list(one) for one in packed])

    def test_the_script_is_readable(self):
        lines = (ROOT / "reports/live/live.js").read_text().splitlines()
        self.assertLess(len(lines), 800)
        self.assertEqual(subprocess.run(["node", "--check", ROOT / "reports/live/live.js"], capture_output=True).returncode, 0)


if __name__ == "__main__":
    unittest.main()
