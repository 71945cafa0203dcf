# SPDX-License-Identifier: Apache-2.0
"""verify --modulus: a solver that takes and gives E' = 2E* is judged by that; how long a run will take is told."""

import json
import unittest

from conformance import altered
from program import ProgramTest, run

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
                         (0, "COMPLETE: 98 of 98 quantities held (tolerance: engineering)."))
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


class HowLong(ProgramTest):
    SLOW = "import time; time.sleep(0.2 if globals().setdefault('count', 0) < 25 else 0); globals()['count'] += 1"

    def test_a_long_run_is_told_once(self):
        result = run("verify", "--subject", altered(self.folder, self.SLOW), "--sample", "5")
        self.assertEqual(result.code, 0, result.out)
        self.assertRegex(result.err, r"^tribocheck: the \d+ cases will take some \d+ s\n$")

    def test_a_short_run_says_nothing(self):
        self.assertEqual(run("verify", "--subject", altered(self.folder, "pass"), "--sample", "5").err, "")


if __name__ == "__main__":
    unittest.main()
