# SPDX-License-Identifier: Apache-2.0
"""Tests the example solver and the template in GNU Octave. The tests are skipped if it is not installed."""

import json
import shutil
import subprocess
import unittest

from program import TIMEOUT, folder_until, run
from subjects import (SUBJECTS, all_lines, answers_of, assert_agree, assert_lockstep, functions_of,
                      text_of)

MISSING = None if shutil.which("octave-cli") else "octave-cli is not installed (Debian: octave)"
OCTAVE = ["octave-cli", "--norc", "--quiet", "--no-history"]


@unittest.skipIf(MISSING, MISSING)
class Octave(unittest.TestCase):
    def test_it_answers_what_it_offers_as_we_do(self):
        answered = assert_agree(self, [*OCTAVE, SUBJECTS / "octave/subject.m"], all_lines(), 1e-7)
        self.assertEqual(functions_of(answered), {"gaussian_moment", "hertz_point", "hamrock_dowson_central",
                                                  "starvation_ratio"})
        closures = {line["closure"] for line, _ in answered if line.get("function") == "starvation_ratio"}
        self.assertEqual(closures, {"flooded_inlet", "damiens"})

    def test_every_answer_is_there_before_the_next_question(self):
        assert_lockstep(self, [*OCTAVE, SUBJECTS / "octave/subject.m"])
        assert_lockstep(self, [*OCTAVE, self.template()])

    def template(self, *filled_in):
        """The path of the template, in which each mark is replaced by what stands beside it."""
        path = folder_until(self.addCleanup) / "solver.m"
        run("init", "subject", "--language", "octave", "--out", path).ended(0)
        text = path.read_text(encoding="utf-8")
        for mark, put in filled_in:
            self.assertIn(mark, text)
            text = text.replace(mark, put)
        path.write_text(text, encoding="utf-8")
        return path

    def test_the_template_skips_everything(self):
        lines = all_lines()
        self.assertEqual(answers_of([*OCTAVE, self.template()], lines), [{"id": line["id"], "skip": "not offered yet"} for line in lines])

    def test_an_error_or_a_print_in_the_template_is_of_its_own_case(self):
        path = self.template(("answer = [];  % h₀", "error ('no \"root\"');  % h₀"),
                             ('answer = [];  % struct ("film"', 'disp (7); answer = struct ("film", 1);  %'))
        lines = [{"id": "a", "function": "hamrock_dowson_central"}, {"id": "p"}]
        done = subprocess.run([*OCTAVE, path], input=text_of(lines).encode(), capture_output=True, timeout=TIMEOUT)
        self.assertEqual([json.loads(line) for line in done.stdout.decode().splitlines()],
                         [{"id": "a", "error": 'no "root"'}, {"id": "p", "film": 1}])
        self.assertEqual(done.stderr.decode().splitlines(), ['a: error: no "root"', "7"])

    def test_the_template_writes_what_is_filled_in(self):
        path = self.template(("answer = [];  % h₀", "answer = 1 / 3;  % h₀"),
                             ('answer = [];  % struct ("film"', 'answer = struct ("friction", NaN, "regime", "mixed");  %'))
        lines = [{"id": "a\"b", "function": "hamrock_dowson_central"}, {"id": "p"}]
        self.assertEqual(answers_of([*OCTAVE, path], lines),
                         [{"id": "a\"b", "value": 1 / 3}, {"id": "p", "friction": None, "regime": "mixed"}])


if __name__ == "__main__":
    unittest.main()
