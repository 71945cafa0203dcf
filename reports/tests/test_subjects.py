# SPDX-License-Identifier: Apache-2.0
"""The example solvers in plain Python: the complete one, the small one, the hostile ones."""

import subprocess
import unittest

from program import TIMEOUT, scene, with_field, without_field
from subjects import (SUBJECTS, all_lines, answers_of, assert_agree, assert_lockstep, functions_of, numbered,
                      python, reference_answers, text_of)

COMPLETE = python("python_stdlib/subject.py")
SMALL = python("small_python/my_solver.py")


class Complete(unittest.TestCase):
    def test_it_answers_everything_as_we_do(self):
        lines = all_lines()
        answered = assert_agree(self, COMPLETE, lines, 1e-9)
        self.assertEqual(len(answered), len(lines))
        regimes = {answer["regime"] for line, answer in answered if "regime" in answer}
        self.assertEqual(regimes, {"boundary", "mixed", "elastohydrodynamic", "collapsed"})
        inlets = {answer["inlet"] for line, answer in answered if "inlet" in answer}
        self.assertEqual(inlets, {"flooded", "starved", "collapsed"})

    def test_what_is_undefined_has_a_reason(self):
        lines = numbered([scene("smooth", speed=1)])
        self.assertEqual(answers_of(COMPLETE, lines)[0]["undefined"],
                         reference_answers(lines)[0]["undefined"])

    def test_outputs(self):
        asked = scene(speed=0.1, outputs=["regime", "film"])
        self.assertEqual(list(answers_of(COMPLETE, numbered([asked]))[0]), ["id", "film", "regime"])
        without_friction = without_field(scene(speed=0.1), "friction.boundary_coefficient")
        self.assertNotIn("friction", answers_of(COMPLETE, numbered([without_friction]))[0])

    def test_extremes(self):
        lines = numbered([
            {"function": "gaussian_moment", "order": 2.5, "argument": 1e300},
            {"function": "gaussian_moment", "order": 2.5, "argument": -1e300},
            {"function": "starvation_ratio", "closure": "starved_inlet", "flooded_over_inlet": 1e300},
            {"function": "load_sharing", "asperity": "greenwood_tripp", "flooded_film_parameter": 1e300,
             "stiffness": 1e300, "offset": 10}])
        for mine, theirs in zip(reference_answers(lines), answers_of(COMPLETE, lines), strict=True):
            self.assertEqual(theirs["value"] is None, mine["value"] is None, theirs)

    def test_bad_input_is_named_as_we_name_it(self):
        good = scene(speed=0.1)
        bad = [with_field(good, "bodies.reduced_radius", -1), without_field(good, "load"),
               with_field(good, "load", "50"), with_field(good, "load", 10**400), with_field(good, "bodies.radius", 1),
               with_field(good, "closures.asperity", "gt"), with_field(good, "surface.offset_planes", 3),
               {"function": "gaussian_moment", "order": 0.25, "argument": 0},
               {"function": "hertz_point", "load": 1, "effective_modulus": 1},
               {"function": "effective_modulus", "first_modulus": 1, "first_poisson_ratio": 0.51,
                "second_modulus": 1, "second_poisson_ratio": 0.3},
               {"function": "reduced_radius", "first_radius_x": 0, "second_radius_x": 1, "first_radius_y": 1,
                "second_radius_y": 1},
               {"function": "reduced_radius", "first_radius_x": 1, "second_radius_x": 1, "first_radius_y": 5e-3,
                "second_radius_y": -4e-3}]
        for mine, theirs in zip(reference_answers(numbered(bad)), answers_of(COMPLETE, numbered(bad)),
                                strict=True):
            self.assertEqual(list(theirs), ["id", "error"])
            self.assertEqual(theirs["error"]["field"], mine["error"]["field"])

    def test_an_unknown_function_is_skipped(self):
        answer, = answers_of(COMPLETE, numbered([{"function": "stokes"}]))
        self.assertEqual(answer, {"id": "c0", "skip": "no function stokes"})
        answer, = answers_of(COMPLETE, numbered([{"function": ["stokes"]}]))
        self.assertIn("skip", answer)

    def test_every_answer_is_there_before_the_next_question(self):
        assert_lockstep(self, COMPLETE)
        assert_lockstep(self, SMALL)


class Small(unittest.TestCase):
    def test_it_is_small(self):
        text = (SUBJECTS / "small_python/my_solver.py").read_text()
        self.assertLessEqual(len(text.splitlines()), 40)

    def test_its_film_alone_is_wrong(self):
        lines = all_lines()
        films = [line for line in lines if line.get("function") == "hamrock_dowson_central"]
        others = [line for line in lines if line not in films]
        answered = assert_agree(self, SMALL, others, 1e-6)
        self.assertEqual(functions_of(answered), {"hertz_point", "gaussian_moment"})
        for mine, theirs in zip(reference_answers(films), answers_of(SMALL, films), strict=True):
            of_half_the_radius = 0.5 ** (1 - 0.67 + 2 * 0.067)  # h/R = … U^0.67 W^-0.067
            self.assertAlmostEqual(theirs["value"] / mine["value"], of_half_the_radius, delta=1e-12)


class Hostile(unittest.TestCase):
    def test_each_has_a_description(self):
        listed = subprocess.run(python("hostile/hostile.py", "--list"), capture_output=True, check=True)
        rows = [row.split("\t") for row in listed.stdout.decode().splitlines()]
        self.assertGreater(len(rows), 20)
        for row in rows:
            self.assertEqual(len(row), 2, row)

    def test_it_is_right_before_it_is_hostile(self):
        lines = all_lines()[:5]
        right = text_of(answers_of(COMPLETE, lines))
        said = {behaviour: subprocess.run(python("hostile/hostile.py", behaviour, "--after", "3"),
                                          input=text_of(lines).encode(), capture_output=True,
                                          timeout=TIMEOUT).stdout.decode()
                for behaviour in ["none", "exits", "dies_by_signal", "garbage", "missing_answers"]}
        first = "".join(right.splitlines(keepends=True)[:3])
        self.assertEqual(said["none"], right)
        self.assertEqual(said["exits"], first)
        self.assertEqual(said["dies_by_signal"], first)
        self.assertEqual(said["garbage"][:len(first)], first)
        self.assertEqual(len(said["missing_answers"].splitlines()), 4)

    def test_one_file_is_not_executable(self):
        self.assertFalse((SUBJECTS / "hostile/not_executable").stat().st_mode & 0o111)


if __name__ == "__main__":
    unittest.main()
