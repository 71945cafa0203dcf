# SPDX-License-Identifier: Apache-2.0
"""init: a solver to start from, that runs and skips everything, and nothing of the user's overwritten."""

import os
import pathlib
import unittest

from program import Folder, run
from subjects import all_lines, answers_of, python

TEMPLATES = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/templates"
LANGUAGES = [line.split("\t")[:2] for line in (TEMPLATES / "languages.tsv").read_text().splitlines()[1:]]


def init(language, *arguments, **options):
    return run("init", "subject", "--language", language, *arguments, **options)


class Init(unittest.TestCase):
    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.cleanup)

    def assert_refused(self, result, code, *words):
        self.assertEqual((result.code, result.out), (code, ""))
        line, = result.error_lines
        for word in words:
            self.assertIn(word, line)

    def test_every_language_gives_its_template(self):
        there = [row for row in LANGUAGES if (TEMPLATES / row[1]).is_file()]
        self.assertGreaterEqual({language for language, _ in there}, {"python", "octave"})
        for language, name in there:
            with self.subTest(language=language):
                result = init(language, cwd=self.folder.name)
                self.assertEqual((result.code, result.err), (0, ""))
                self.assertIn(name, result.out)
                written = pathlib.Path(self.folder.path(name)).read_bytes()
                self.assertEqual(written, (TEMPLATES / name).read_bytes())

    def test_every_template_is_listed(self):
        files = {path.name for path in TEMPLATES.iterdir()} - {"languages.tsv"}
        self.assertLessEqual(files, {name for _, name in LANGUAGES})

    def test_the_python_solver_skips_everything(self):
        path = self.folder.path("mine.py")
        result = init("python", "--out", path)
        self.assertIn(f'tribocheck verify --subject "python3 {path}"', result.out)
        lines = all_lines()
        for line, answer in zip(lines, answers_of(python(path), lines), strict=True):
            self.assertEqual(answer, {"id": line["id"],
                                      "skip": f"no {line.get('function', 'operating point')} yet"})

    def test_the_python_solver_gives_what_is_filled_in(self):
        path = pathlib.Path(self.folder.path("mine.py"))
        init("python", "--out", path)
        filled = path.read_text().replace("return None  # m\n", "return 1 / 3\n").replace(
            'return None  # {"radius"', 'return {"radius": load}  # {"radius"')
        path.write_text(filled)
        lines = [line for line in all_lines()
                 if line.get("function") in ("hamrock_dowson_central", "hertz_point")]
        for line, answer in zip(lines, answers_of(python(path), lines), strict=True):
            expected = {"radius": line["load"]} if line["function"] == "hertz_point" else {"value": 1 / 3}
            self.assertEqual(answer, {"id": line["id"], **expected})

    def test_a_file_that_is_there_is_left_alone_unless_forced(self):
        path = self.folder.write("solver.py", "mine")
        self.assert_refused(init("python", cwd=self.folder.name), 2, "solver.py", "--force")
        self.assertEqual(pathlib.Path(path).read_text(), "mine")
        self.assertEqual(init("python", "--force", cwd=self.folder.name).code, 0)
        self.assertEqual(pathlib.Path(path).read_bytes(), (TEMPLATES / "solver.py").read_bytes())

    def test_places_that_cannot_be_written(self):
        self.assert_refused(init("python", "--out", self.folder.path("no/such/solver.py")), 1, "no/such")
        self.assert_refused(init("python", "--out", self.folder.name), 2, "is there already")
        self.assert_refused(init("python", "--force", "--out", self.folder.name), 1, "irectory")
        self.assert_refused(init("python", "--force", "--out", "/dev/full"), 1, "/dev/full", "space")

    def test_bad_usage(self):
        self.assert_refused(init("cobol"), 2, "cobol", "python, octave")
        self.assert_refused(run("init", "subject"), 2, "--language")
        self.assert_refused(run("init", "--language", "python"), 2, "what")
        self.assert_refused(run("init", "scene", "--language", "python"), 2, "scene")


if __name__ == "__main__":
    unittest.main()
