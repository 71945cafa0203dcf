# SPDX-License-Identifier: Apache-2.0
"""init: writes a solver to start from, which runs and skips everything, and overwrites no file of the user."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, TIMEOUT, ProgramTest, Result, run
from subjects import all_lines, answers_of, python

TEMPLATES = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/templates"
LANGUAGES = [line.split("\t") for line in (TEMPLATES / "languages.tsv").read_text().splitlines()[1:]]


def init(language, *arguments, **options):
    return run("init", "subject", "--language", language, *arguments, **options)


def run_on_path(path, *arguments, **options):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=TIMEOUT,
                          env={**ENVIRONMENT, "PATH": path}, **options)
    return Result(done.returncode, done.stdout, done.stderr)


class Init(ProgramTest):
    def assert_all_functions(self, text):
        """Each function with its arguments and results is there, and no mark of the template is left."""
        functions = run("functions", "--format", "json").json()["functions"]
        self.assertGreaterEqual(len(functions), 5)
        for function in functions:
            self.assertIn(function["name"], text)
            self.assertIn(function["meaning"], text)
            for entry in [*function["parameters"], *function["results"]]:
                self.assertIn(entry["meaning"], text)
        self.assertNotIn("{{", text)

    def test_every_language_gives_its_template_with_all_functions(self):
        self.assertGreaterEqual({row[0] for row in LANGUAGES}, {"python", "octave", "javascript", "c", "fortran", "cpp", "rust"})
        for language, name, *_ in LANGUAGES:
            with self.subTest(language=language):
                self.assertEqual(init(language, cwd=self.folder.name).ended(0).out.splitlines()[:2], [f"{name}: written", "next:"])
                written = pathlib.Path(self.folder.path(name)).read_text()
                template = (TEMPLATES / (name + ".mustache")).read_text()
                self.assertEqual(written.splitlines()[0], template.splitlines()[0])
                self.assert_all_functions(written)

    def test_every_template_is_listed(self):
        files = {path.name for path in TEMPLATES.iterdir()} - {"languages.tsv"}
        self.assertEqual(files, {row[1] + ".mustache" for row in LANGUAGES})

    def test_help_and_a_missing_language_name_every_language(self):
        names = ", ".join(row[0] for row in LANGUAGES)
        self.assertIn(f"language of the solver: {names} ", re.sub(r"\s+", " ", run("init", "--help").out))
        for arguments, words in (([], "--language is required"), (["--language", "cobol"], "--language: no template for cobol")):
            result = run("init", "subject", *arguments, cwd=self.folder.name)
            self.assertEqual((result.code, result.out, result.err), (2, "", f"tribocheck: {words}; allowed: {names}\n"))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_what_its_line_needs_and_is_not_on_path_is_told_and_the_file_is_written(self):
        for language, name, program, package, _ in LANGUAGES:
            with self.subTest(language=language):
                result = run_on_path(self.folder.name, "init", "subject", "--language", language,
                                     cwd=self.folder.name).ended(0)
                self.assertEqual(result.error_lines, [
                    f"tribocheck: no program {program} is on PATH, and the line above needs it; "
                    f"on Debian: apt-get install {package}"])
                self.assertTrue(os.path.isfile(self.folder.path(name)))

    def test_the_printed_line_calls_this_very_program(self):
        os.symlink(PROGRAM, self.folder.path("tribocheck"))
        for path, called in ((self.folder.name, "tribocheck"), ("/nowhere", os.path.realpath(PROGRAM))):
            result = run_on_path(path, "init", "subject", "--language", "python", "--force",
                                 cwd=self.folder.name)
            self.assertEqual(result.out.splitlines()[2], f"  {called} verify --subject 'python3 solver.py'")

    def test_the_python_solver_skips_everything(self):
        path = self.folder.path("mine.py")
        result = init("python", "--out", path)
        self.assertIn(f" verify --subject 'python3 {path}'", result.out)
        lines = all_lines()
        for line, answer in zip(lines, answers_of(python(path), lines), strict=True):
            self.assertEqual(answer, {"id": line["id"],
                                      "skip": f"no {line.get('function', 'operating point')} yet"})

    def test_the_python_solver_gives_what_is_filled_in(self):
        path = pathlib.Path(self.folder.path("mine.py"))
        init("python", "--out", path)
        filled = path.read_text().replace("return None  # h₀", "return 1 / 3  # h₀").replace(
            "a²/R, of the two bodies, in m\n    return None", 'a²/R, of the two bodies, in m\n    return {"radius": load}')
        path.write_text(filled)
        lines = [line for line in all_lines()
                 if line.get("function") in ("hamrock_dowson_central", "hertz_point")]
        for line, answer in zip(lines, answers_of(python(path), lines), strict=True):
            expected = {"radius": line["load"]} if line["function"] == "hertz_point" else {"value": 1 / 3}
            self.assertEqual(answer, {"id": line["id"], **expected})

    def test_an_exception_or_a_print_in_a_python_solver_is_of_its_own_case(self):
        path = pathlib.Path(self.folder.path("mine.py"))
        init("python", "--out", path)
        path.write_text(path.read_text().replace(
            "return None  # h₀", "print('film'); os.system('echo film'); return 1 / (load - load)  # h₀", 1).replace(
            "a²/R, of the two bodies, in m\n    return None", 'a²/R, of the two bodies, in m\n    return {"radius": load}'))
        verdict = run("verify", "--subject", f"python3 {path}", "--sample", "5", "--format", "json").ended(1, "").json()
        self.assertEqual((verdict["notes"], verdict["violations"], verdict["starts"]), ([], [], 1))
        reasons = {one["quantity"]: one["reason"] for one in verdict["quantities"]}
        self.assertEqual(reasons["hamrock_dowson_central"], "f0000: ZeroDivisionError: float division by zero")
        self.assertIn("off by", reasons["hertz_point.radius"])
        for words in ("film\n", "Traceback", "ZeroDivisionError"):
            self.assertIn(words, verdict["last_errors"])

    def test_the_printed_line_builds_a_library_from_where_it_was_printed(self):
        for language, name, program, _, command in LANGUAGES:
            if "{library}" not in command or shutil.which(program) is None:
                continue
            for out in (name, f"a b/my_{name}"):
                with self.subTest(language=language, out=out):
                    line = init(language, "--out", out, cwd=self.folder.name).out.splitlines()[2].strip()
                    self.assertIn(line, pathlib.Path(self.folder.path(out)).read_text())
                    done = subprocess.run(["sh", "-c", line + " --sample 2"], capture_output=True, text=True,
                                          timeout=TIMEOUT, cwd=self.folder.name, env=ENVIRONMENT)
                    self.assertEqual((done.returncode, done.stderr), (1, ""))
                    self.assertIn("NOTHING: 0 of 99", done.stdout)

    def test_an_exception_in_a_cpp_solver_is_of_its_own_case(self):
        path = pathlib.Path(self.folder.path("solver.cpp"))
        line = init("cpp", "--out", path).out.splitlines()[2].strip()
        path.write_text(path.read_text().replace(
            "{\n  return not_offered;", "{\n  if (std::puts(\"called\") < 0) throw 1;\n"
            "  throw std::runtime_error(\"no root\");", 1).replace("#include <optional>",
                                                               "#include <optional>\n#include <stdexcept>"))
        done = subprocess.run(["sh", "-c", line + " --sample 2 --format json"], capture_output=True, text=True,
                              timeout=TIMEOUT, env=ENVIRONMENT)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        verdict = json.loads(done.stdout)
        self.assertEqual((verdict["starts"], verdict["notes"]), (1, []))
        self.assertEqual([(one["failed"], one["skipped"]) for one in verdict["quantities"][:2]], [(2, 0), (0, 2)])
        self.assertIn("effective_modulus: no root", verdict["last_errors"])

    def test_the_templates_have_the_defaults_that_questions_leave_out(self):
        for language, sign in (("python", "    ellipticity=1,"), ("javascript", "    ellipticity = 1,"),
                               ("octave", "q.ellipticity = 1;")):
            path = self.folder.path(language)
            init(language, "--out", path)
            self.assertIn(sign, pathlib.Path(path).read_text())

    def test_a_javascript_solver_answers_skips_and_fails_case_by_case(self):
        if shutil.which("node") is None:
            self.skipTest("no node is on PATH")
        path = pathlib.Path(self.folder.path("solver.js"))
        line = init("javascript", "--out", path).out.splitlines()[2].strip()
        self.assertTrue(line.endswith(f" verify --subject 'node {path}'"), line)
        lines = all_lines()
        for asked, answer in zip(lines, answers_of(["node", path], lines), strict=True):
            self.assertEqual(answer, {"id": asked["id"],
                                      "skip": f"no {asked.get('function', 'operating point')} yet"})
        head, rest = path.read_text().split("  hertz_point({")
        path.write_text(head + "  hertz_point({" + rest.replace("return undefined;", """console.log("called");
    if (load > 1e4) throw new Error("too much");
    return { radius: Math.cbrt(0.75 * load * reduced_radius / effective_modulus), approach: NaN };""", 1))
        verdict = run("verify", "--subject", f"node {path}", "--sample", "30", "--format", "json").json()
        found = {one["quantity"]: one for one in verdict["quantities"]}
        self.assertEqual((verdict["starts"], verdict["notes"]), (1, []))
        self.assertGreater(found["hertz_point.radius"]["held"], 5)
        self.assertIn("Error: too much", found["hertz_point.radius"]["reason"])
        self.assertEqual((found["hertz_point.approach"]["held"], found["hertz_point.approach"]["status"]), (0, "FAILED"))
        self.assertEqual(found["hertz_point.peak_pressure"]["status"], "not offered")
        self.assertIn("called", verdict["last_errors"])

    def test_a_panic_in_a_rust_solver_is_of_its_own_case(self):
        if shutil.which("rustc") is None:
            self.skipTest("no rustc is on PATH")
        header = (TEMPLATES.parent / "tribocheck_plugin.h").read_text()
        path = pathlib.Path(self.folder.path("solver.rs"))
        line = init("rust", "--out", path).out.splitlines()[2].strip()
        written = path.read_text()
        version, = re.findall(r"TRIBOCHECK_PLUGIN_VERSION = (\d+)", header)
        self.assertIn(f"const VERSION: c_int = {version};", written)
        head, rest = written.split("fn hertz_point(")
        path.write_text(head + "fn hertz_point(" + rest.replace("\n    None\n", """
    if load > 1e4 {
        panic!("too much");
    }
    Some(hertz_point_result {
        radius: Some((0.75 * load * reduced_radius / effective_modulus).cbrt()),
        approach: Some(f64::NAN),
        ..Default::default()
    })
""", 1))
        done = subprocess.run(["sh", "-c", line + " --sample 30 --format json"], capture_output=True, text=True,
                              timeout=TIMEOUT, env=ENVIRONMENT)
        verdict = json.loads(done.stdout)
        found = {one["quantity"]: one for one in verdict["quantities"]}
        self.assertEqual((done.returncode, verdict["starts"]), (1, 1))
        self.assertGreater(found["hertz_point.radius"]["held"], 5)
        self.assertGreater(found["hertz_point.radius"]["failed"], 0)
        self.assertEqual((found["hertz_point.approach"]["held"], found["hertz_point.approach"]["status"]), (0, "FAILED"))
        self.assertIn("too much", verdict["last_errors"])

    def test_a_file_that_is_there_is_left_alone_unless_forced(self):
        path = self.folder.write("solver.py", "mine")
        self.assert_refused(init("python", cwd=self.folder.name), "solver.py", "--force")
        self.assertEqual(pathlib.Path(path).read_text(), "mine")
        self.assertEqual(init("python", "--force", cwd=self.folder.name).code, 0)
        self.assert_all_functions(pathlib.Path(path).read_text())

    def test_places_that_cannot_be_written(self):
        in_the_way = self.folder.write("file", "")
        self.assert_refused(init("python", "--out", f"{in_the_way}/solver.py"), in_the_way, code=1)
        self.assert_refused(init("python", "--out", self.folder.name), "is there already")
        self.assert_refused(init("python", "--force", "--out", self.folder.name), "irectory", code=1)
        self.assert_refused(init("python", "--force", "--out", "/dev/full"), "/dev/full", "no regular file", code=1)

    def test_bad_usage(self):
        self.assert_refused(init("cobol"), "cobol", "python, octave")
        self.assert_refused(run("init", "subject"), "--language")
        self.assert_refused(run("init", "--language", "python"), "what")
        self.assert_refused(run("init", "scene", "--language", "python"), "scene")
        self.assert_refused(run("init", "subject", "--language", "python", "--for", "github"), "--for", "ci")
        self.assert_refused(run("init", "ci"), "--for")
        self.assert_refused(run("init", "ci", "--for", "nobody"), "nobody", "github, gitlab")
        self.assert_refused(run("init", "ci", "--for", "github", "--language", "c"), "--language", "subject")

    def test_a_file_for_ci_is_written_as_it_stands_in_the_project(self):
        for system in ("github", "gitlab"):
            for out, options in ((f"{system}.yml", []), ("new/folders/a.yml", ["--out", "new/folders/a.yml", "--force"])):
                with self.subTest(system=system, out=out):
                    result = run("init", "ci", "--for", system, *options, cwd=self.folder.name)
                    self.assertEqual((result.code, result.out.splitlines()[0]), (0, f"{out}: written"))
                    self.assertEqual(pathlib.Path(self.folder.path(out)).read_bytes(),
                                     (TEMPLATES.parent / "ci" / f"{system}.yml").read_bytes())
        self.assert_refused(run("init", "ci", "--for", "github", cwd=self.folder.name), "github.yml", "--force")


if __name__ == "__main__":
    unittest.main()
