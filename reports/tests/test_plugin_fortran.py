# SPDX-License-Identifier: Apache-2.0
"""The plug-in in Fortran, and a program in it that calls the library; only where there is a compiler for it."""
import pathlib
import re
import subprocess
import tempfile
import unittest

from plugins import ask_plugin, film, hertz, lines, moment, point, shared, starved
from program import ENVIRONMENT, PROGRAM, TIMEOUT, run


class Fortran(unittest.TestCase):
    def test_it_agrees_in_what_it_offers(self):
        asked = [hertz(), film(), moment(-1.146), moment(3, 2), shared("greenwood_tripp"),
                 shared("greenwood_williamson", 0.01, 1)]
        done = ask_plugin("fortran_plugin", *asked)
        self.assertEqual((done.code, done.err), (0, ""))
        expected = run("stream", stdin=lines(asked)).json_lines()
        for found, exact in zip(done.json_lines(), expected, strict=True):
            self.assertEqual(list(found), list(exact))
            for field in list(exact)[1:]:
                self.assertAlmostEqual(found[field] / exact[field], 1, delta=1e-12)

    def test_the_rest_is_skipped(self):
        done = ask_plugin("fortran_plugin", starved("damiens", 1), point(), moment(-11), shared("greenwood_tripp", offset=20))
        self.assertEqual(done.code, 0, done.err)
        for answer in done.json_lines():
            self.assertEqual(answer.keys() - {"id"}, {"skip"})

    def test_the_example_of_the_readme_prints_what_that_in_c_prints(self):
        library = pathlib.Path(PROGRAM).resolve().parent / "reports/bindings"
        readme = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"], "reports/bindings/README.md").read_text()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "moments.f90")
            path.write_text(re.search(r"```fortran\n(.*?)```", readme, re.DOTALL)[1])
            subprocess.run(["gfortran", "-std=f2008", "-Wall", "-Werror", path, f"-L{library}", f"-Wl,-rpath,{library}", "-ltribocheck", "-o",
                            f"{folder}/moments"], check=True, timeout=TIMEOUT, cwd=folder)
            found = subprocess.run(f"{folder}/moments", capture_output=True, text=True, timeout=TIMEOUT).stdout
        expected = re.search(r"printf.*/\* (.*) \*/", readme)[1]
        self.assertEqual([f"{float(number):.6g}" for number in found.split()], expected.split())


if __name__ == "__main__":
    unittest.main()
