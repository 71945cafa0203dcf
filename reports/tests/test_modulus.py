# SPDX-License-Identifier: Apache-2.0
"""verify --modulus and --ellipticity: a solver is asked with the moduli and radii that it takes. A long run is told beforehand."""

import json
import unittest

from conformance import altered
from program import PROGRAM, ProgramTest, run

TWICE = """halved = json.loads(text)
    for place in (halved, halved.get("bodies", {})):
        if "effective_modulus" in place:
            place["effective_modulus"] /= 2
    answer = json.loads(subject.answer_text(json.dumps(halved)))
    if name == "effective_modulus" and "value" in answer:
        answer["value"] *= 2"""


class Modulus(ProgramTest):
    def verdict(self, *options):
        return run("verify", "--subject", altered(self.folder, TWICE), "--sample", "15", *options)

    def test_a_solver_of_twice_the_modulus_is_right_where_it_says_so_and_wrong_elsewhere(self):
        result = self.verdict("--modulus", "E'")
        self.assertEqual((result.code, result.out.splitlines()[-1]),
                         (0, "COMPLETE: 99 of 99 quantities held (tolerance: engineering)."))
        for options in ((), ("--modulus", "E*")):
            wrong = {one["quantity"] for one in self.verdict("--format", "json", *options).json()["quantities"]
                     if one["status"] == "FAILED"}
            self.assertLessEqual({"effective_modulus", "hertz_point.radius", "hamrock_dowson_central",
                                  "operating_point.film"}, wrong)

    def test_a_shown_and_a_saved_case_are_as_they_are_asked(self):
        for options in (("--show", "f0000"), ("--save-cases", "-", "--sample", "1")):
            once, twice = (run("verify", *options, "--modulus", modulus).out for modulus in ("E*", "E'"))
            moduli = [[json.loads(line)["effective_modulus"]
                       for line in (text[text.index("{"):].splitlines() if "--show" not in options else
                                    [text[text.index("{"):text.rindex("}") + 1]])
                       if json.loads(line).get("function") == "hamrock_dowson_central"] for text in (once, twice)]
            self.assertEqual(len(moduli[0]), 1, once)
            self.assertEqual([2 * one for one in moduli[0]], moduli[1])

    def test_another_word_or_no_subject_is_refused(self):
        self.assert_refused(run("verify", "--subject", "true", "--modulus", "2E"), "--modulus")
        self.assert_refused(run("verify", "--modulus", "E'"), "--modulus", "without --subject")


# Solvers that take the moduli of both bodies in place of E*, or both radii in place of the ellipticity.
OF_BODIES = """asked = json.loads(text)
    for place in (asked, asked.get("bodies", {})):
        if "first_modulus" in place and name != "effective_modulus":
            e1, v1, e2, v2 = (place.pop(one) for one in ("first_modulus", "first_poisson_ratio", "second_modulus", "second_poisson_ratio"))
            place["effective_modulus"] = 1 / ((1 - v1**2) / e1 + (1 - %s**2) / e2)
    answer = json.loads(subject.answer_text(json.dumps(asked)))"""
OF_RADII = """asked = json.loads(text)
    if name and name.startswith("hamrock"):
        x, y = asked.pop("radius_x"), asked.pop("radius_y")
        asked["reduced_radius" if name == "hamrock_dowson_central" else "radius_x"] = x
        asked["ellipticity"] = %s * (y / x)**%s
    answer = json.loads(subject.answer_text(json.dumps(asked)))"""
FILMS = {"hamrock_dowson_central", "hamrock_dowson_minimum", "hamrock_dowson_soft_central", "hamrock_dowson_soft_minimum"}


class OtherArguments(ProgramTest):
    def verdict(self, change, *options):
        result = run("verify", "--subject", altered(self.folder, change), "--sample", "15", "--format", "json", *options)
        return result, {one["quantity"] for one in result.json()["quantities"] if one["status"] == "FAILED"}

    def test_this_model_is_right_however_it_is_asked(self):
        for options in (("--modulus", "bodies"), ("--ellipticity", "radii"), ("--modulus", "bodies", "--ellipticity", "radii")):
            result = run("verify", "--subject", f"{PROGRAM} stream", "--sample", "40", *options)
            self.assertEqual(result.out.splitlines()[-1], "COMPLETE: 99 of 99 quantities held (tolerance: engineering).")
            self.assertEqual(result.code, 0)
        # The radii give the ellipticity so closely that the contracts hold.
        run("verify", "--subject", f"{PROGRAM} stream", "--tolerance", "strict", "--ellipticity", "radii").ended(0)

    def test_a_solver_of_bodies_is_right_and_one_poisson_ratio_for_both_is_seen_everywhere(self):
        right, wrong = self.verdict(OF_BODIES % "v2", "--modulus", "bodies")
        self.assertEqual((right.code, wrong), (0, set()))
        _, wrong = self.verdict(OF_BODIES % "v1", "--modulus", "bodies")
        self.assertLessEqual({"hertz_point.radius", "hertz_line.half_width", "operating_point.film", *FILMS}, wrong)

    def test_the_authors_fits_of_k_are_held_and_told_where_radii_are_asked(self):
        for factor, exponent, told in (("1.03", "0.64", "the fit k = 1.03 (R_y/R_x)^0.64"),
                                       ("1.0339", "0.636", "the fit k = 1.0339 (R_y/R_x)^0.636"), ("1.05", "0.64", "")):
            result, wrong = self.verdict(OF_RADII % (factor, exponent), "--ellipticity", "radii")
            self.assertEqual(wrong, set() if told else FILMS)
            notes = [note for note in result.json()["notes"] if "is held to the law with the fit" in note]
            self.assertEqual(len(notes), len(FILMS) if told else 0)
            for note in notes:
                self.assertIn(told, note)

    def test_the_lines_have_the_other_numbers_alone_and_all_else_as_it_was(self):
        usual, other = (run("verify", "--save-cases", "-", "--sample", "5", *options).json_lines()
                        for options in ((), ("--modulus", "bodies", "--ellipticity", "radii")))
        self.assertEqual(len(usual), len(other))
        seen = set()
        for before, after in zip(usual, other):
            for place in ((), ("bodies",)):
                was, now = (one.get(*place, {}) if place else one for one in (before, after))
                changed = {key for key in {*was, *now} if was.get(key) != now.get(key) and key != "bodies"}
                self.assertLessEqual(changed, {"effective_modulus", "first_modulus", "first_poisson_ratio", "second_modulus",
                                               "second_poisson_ratio", "reduced_radius", "ellipticity", "radius_x", "radius_y"})
                seen |= changed
                if "effective_modulus" in was:
                    self.assertEqual((now["first_modulus"], now["second_modulus"]), (was["effective_modulus"], 4 * was["effective_modulus"]))
                self.assertNotIn("effective_modulus", now)
            if before.get("function") in FILMS:
                self.assertNotIn("ellipticity", after)
                self.assertEqual(after["radius_x"], before.get("reduced_radius", before.get("radius_x")))
        self.assertLessEqual({"second_poisson_ratio", "radius_y"}, seen)

    def test_what_cannot_be_asked_so_is_refused(self):
        library = self.folder.write("libmine.so", "")
        for options in (("--modulus", "bodies"), ("--ellipticity", "radii")):
            self.assert_refused(run("verify", "--plugin", library, *options), " ".join(options), "is for --subject")
            self.assert_refused(run("verify", *options), options[0], "without --subject")
        self.assert_refused(run("verify", "--subject", "true", "--ellipticity", "axes"), "--ellipticity")

    def test_stream_says_what_is_missing_or_given_twice(self):
        point = {"function": "hertz_point", "load": 50, "reduced_radius": 9.5e-3}
        bodies = {"first_modulus": 1e11, "first_poisson_ratio": 0.5, "second_modulus": 4e11, "second_poisson_ratio": 0}
        film = {"function": "hamrock_dowson_minimum", "speed": 1, "viscosity": 0.04, "pressure_viscosity": 2e-8, "load": 20}
        for line, field, said in (
                ({**point, **bodies, "effective_modulus": 1e11}, "first_modulus", "it stands for effective_modulus"),
                ({**point, **bodies, "second_poisson_ratio": 0.6}, "second_poisson_ratio", "0.6 is not allowed"),
                ({**point, "first_modulus": 1e11}, "first_poisson_ratio", "missing"),
                ({**point, **bodies, "first_modulus": 1e-320, "first_poisson_ratio": -0.9999999}, "first_modulus",
                 "with the others it gives effective_modulus ="),
                ({**film, **bodies, "radius_y": 0.1}, "radius_x", "missing"),
                ({**film, **bodies, "radius_x": 0.1, "radius_y": 0.1, "ellipticity": 1}, "radius_y", "it stands for ellipticity"),
                ({"function": "effective_modulus", **bodies, "effective_modulus": 1e11}, "effective_modulus", "unknown argument"),
                ({**point, "effective_modulus": 1e11, "radius_y": 1}, "radius_y", "unknown argument")):
            error, = (one["error"] for one in run("stream", stdin=json.dumps(line) + "\n").json_lines())
            self.assertEqual(error["field"], field, error)
            self.assertIn(said, error["message"])


class HowLong(ProgramTest):
    SLOW = "import time; time.sleep(0.2 if globals().setdefault('count', 0) < 25 else 0); globals()['count'] += 1"

    def test_a_long_run_is_told_once(self):
        result = run("verify", "--subject", altered(self.folder, self.SLOW), "--sample", "5").ended(0)
        self.assertRegex(result.err, r"^tribocheck: the \d+ cases will take some \d+ s\n$")

    def test_a_short_run_says_nothing(self):
        self.assertEqual(run("verify", "--subject", altered(self.folder, "pass"), "--sample", "5").err, "")


if __name__ == "__main__":
    unittest.main()
