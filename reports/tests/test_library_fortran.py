# SPDX-License-Identifier: Apache-2.0
"""A program in Fortran that calls libtribocheck.so; only where there is a compiler for it."""
import pathlib
import re
import subprocess
import tempfile
import unittest

from program import ENVIRONMENT, PROGRAM, TIMEOUT


class Fortran(unittest.TestCase):
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
