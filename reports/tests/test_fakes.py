# SPDX-License-Identifier: Apache-2.0
"""The fakes: each has the one mistake that it says, and their list is the one in their README."""

import math
import re
import subprocess
import unittest

from subjects import (SUBJECTS, all_lines, answers_of, effective_moduli, examples, films, hertz_ellipses, hertz_lines,
                      hertz_points, is_close, load_sharings, moments, numbered, operating_points, python,
                      reduced_radii, reference_answers, starvation_ratios)

ELEMENTARY = ("effective_modulus", "reduced_radius", "gaussian_moment", "hertz_point", "hertz_ellipse", "hertz_line",
              "hamrock_dowson_central", "starvation_ratio", *sorted({line["function"] for line in examples()}))
# The known errors of some fakes: a question, or a moment's arguments, and the relative error.
KNOWN = {
    "film_half_radius": (films()[0], -0.275),
    "hertz_approach_modulus_doubled": (hertz_points()[0], -0.37),
    "moment_simpson_201_points": ({"order": 1.5, "argument": 3}, 0.001),
    "moment_fit_power_5_2": ({"order": 2.5, "argument": 3}, -0.742),
    "moment_fit_power_2": ({"order": 2, "argument": 3}, -0.828),
    "moment_fit_exponential_5_2": ({"order": 2.5, "argument": 3}, 8.735),
    "moment_fit_exponential_2": ({"order": 2, "argument": 3}, 8.777),
    "moment_fit_error_function": ({"order": 2.5, "argument": 3}, -0.920),
}
LINES = numbered(moments() + effective_moduli() + reduced_radii() + hertz_points() + hertz_ellipses()
                 + hertz_lines() + films() + starvation_ratios() + load_sharings() + examples()
                 + operating_points()[::3])


def fake(name):
    return python("fakes/fake.py", "--mistake", name)


def listed():
    done = subprocess.run(python("fakes/fake.py", "--list"), capture_output=True, check=True)
    return [row.split("\t") for row in done.stdout.decode().splitlines()]


def wrong_functions(answers, right):
    return {line.get("function", "operating_point")
            for line, one, other in zip(LINES, answers, right, strict=True)
            if one.keys() != other.keys()
            or not all(is_close(one[name], other[name], 1e-9) for name in one)}


class Fakes(unittest.TestCase):
    def test_the_list_is_that_of_the_readme(self):
        readme = (SUBJECTS / "fakes/README.md").read_text()
        rows = re.findall(r"(?m)^\| `(\w+)` \| (.*) \| `(\w+)` \|$", readme)
        self.assertEqual([list(row) for row in rows], listed())

    def test_without_a_mistake_it_is_the_complete_solver(self):
        lines = all_lines()
        self.assertEqual(answers_of(fake("none"), lines),
                         answers_of(python("python_stdlib/subject.py"), lines))

    def test_each_is_wrong_where_it_says_and_in_nothing_that_does_not_rest_on_it(self):
        right = answers_of(fake("none"), LINES)
        for name, _, capability in listed():
            with self.subTest(name=name):
                wrong = wrong_functions(answers_of(fake(name), LINES), right)
                self.assertIn(capability, wrong)
                self.assertEqual(wrong & set(ELEMENTARY), {capability} & set(ELEMENTARY))
                if capability == "operating_point":
                    self.assertEqual(wrong, {capability})

    def test_known_errors(self):
        for name, (arguments, expected) in KNOWN.items():
            line = numbered([{"function": "gaussian_moment", **arguments}])
            field = "approach" if name.startswith("hertz") else "value"
            (wrong,), (right,) = answers_of(fake(name), line), reference_answers(line)
            error = wrong[field] / right[field] - 1
            self.assertTrue(math.isclose(error, expected, rel_tol=0.02), (name, error))

    def test_an_unknown_mistake_is_refused(self):
        done = subprocess.run(fake("nothing_like_this"), capture_output=True)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
