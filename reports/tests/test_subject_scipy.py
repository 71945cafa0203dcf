# SPDX-License-Identifier: Apache-2.0
"""The example solver on SciPy; skipped where SciPy is not installed."""

import importlib.util
import unittest

from subjects import all_lines, assert_agree, assert_lockstep, functions_of, python

MISSING = None if importlib.util.find_spec("scipy") else "scipy is not installed (Debian: python3-scipy)"


@unittest.skipIf(MISSING, MISSING)
class Scipy(unittest.TestCase):
    def test_it_answers_what_it_offers_as_we_do(self):
        answered = assert_agree(self, python("python_scipy/subject.py"), all_lines(), 1e-7)
        self.assertEqual(functions_of(answered), {"gaussian_moment", "hertz_point", "hamrock_dowson_central",
                                                  "load_sharing", "operating_point"})

    def test_every_answer_is_there_before_the_next_question(self):
        assert_lockstep(self, python("python_scipy/subject.py"))


if __name__ == "__main__":
    if MISSING:
        print(MISSING)
    unittest.main()
