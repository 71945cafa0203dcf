# SPDX-License-Identifier: Apache-2.0
"""The plug-in in Fortran; only where there is a compiler for it."""
import unittest

from plugins import ask_plugin, film, hertz, lines, moment, point, shared, starved
from program import run


class Fortran(unittest.TestCase):
    def test_it_agrees_in_what_it_offers(self):
        asked = [hertz(), film(), moment(-1.146), moment(3, 2), shared("greenwood_tripp"),
                 shared("greenwood_williamson", 0.01, 1)]
        done = ask_plugin("fortran_plugin", *asked).ended(0, "")
        expected = run("stream", stdin=lines(asked)).json_lines()
        for found, exact in zip(done.json_lines(), expected, strict=True):
            self.assertEqual(list(found), list(exact))
            for field in list(exact)[1:]:
                self.assertAlmostEqual(found[field] / exact[field], 1, delta=1e-12)

    def test_the_rest_is_skipped(self):
        done = ask_plugin("fortran_plugin", starved("damiens", 1), point(), moment(-11), shared("greenwood_tripp", offset=20)).ended(0)
        for answer in done.json_lines():
            self.assertEqual(answer.keys() - {"id"}, {"skip"})


if __name__ == "__main__":
    unittest.main()
