# SPDX-License-Identifier: Apache-2.0
"""The examples in the READMEs are taken out of them and run as they stand, on an installed copy."""

import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import stand_ins
from stand_ins import BUILD, NEWCOMER, ROOT


def blocks_of(path):
    """(heading, language, text) of each fenced block."""
    found, heading, language, lines = [], "", None, []
    for line in (ROOT / path).read_text().splitlines():
        if line.startswith("```"):
            if language is not None:
                found.append((heading, language, "\n".join(lines) + "\n"))
            language, lines = (line[3:] if language is None else None), []
        elif language is not None:
            lines.append(line)
        elif line.startswith("## "):
            heading = line[3:]
    return found


CONFORMANCE = blocks_of("verification/conformance/README.md")
PROJECT = blocks_of("README.md")
COMMANDS = blocks_of("reports/program/README.md")
LIBRARY = blocks_of("model/include/README.md")


def blocks(page, heading, language=""):
    return [text for of, kind, text in page if (of, kind) == (heading, language)]


def words(text):
    return " ".join(text.split())


class Readme(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="tribocheck ")  # with a blank, as people's folders have it
        cls.addClassCleanup(folder.cleanup)
        cls.home = pathlib.Path(folder.name)
        cls.environment = stand_ins.put_into(cls.home)
        five_minutes, = blocks(CONFORMANCE, "In five minutes", "sh")
        cls.set_up = "\n".join(five_minutes.splitlines()[:2]) + "\n"  # make install, export PATH
        cls.five_minutes = five_minutes
        done = subprocess.run(["sh", "-ec", cls.set_up], env=cls.environment, capture_output=True, text=True)
        assert (cls.home / ".local/bin/tribocheck").is_file(), done.stderr

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.home))

    def sh(self, text, code=0):
        """stderr and then stdout of a script."""
        done = subprocess.run(["sh", "-c", text], cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, timeout=100)
        self.assertEqual(done.returncode, code, f"{text}\n{done.stdout}\n{done.stderr}")
        return done.stderr + done.stdout

    def installed(self, text, code=0):
        return self.sh(self.set_up.splitlines()[1] + "\n" + text, code)

    def test_in_five_minutes(self):
        stand_ins.asked(self.home)
        first, newcomer = blocks(CONFORMANCE, "In five minutes")
        out = self.sh(self.five_minutes, 1)
        self.assertEqual(out.splitlines()[-1] + "\n", first)
        self.assertEqual(stand_ins.asked(self.home), [f"make install PREFIX={self.home}/.local"])
        shutil.copy(NEWCOMER, self.folder / "my_solver.py")
        out = self.installed(self.five_minutes.splitlines()[-1], 1)
        self.assertIn(words(newcomer), words(out))

    def test_a_case_to_look_at(self):
        heading = "A case to look at"
        show, save = blocks(CONFORMANCE, heading, "sh")
        shown, = blocks(CONFORMANCE, heading)
        shutil.copy(NEWCOMER, self.folder / "my_solver.py")
        pattern = ".*".join(map(re.escape, shown.strip().split("…")))
        self.assertRegex(self.installed(show, 1).strip(), f"^{pattern}$")
        self.installed(save)
        cases, answers = ((self.folder / name).read_text().splitlines() for name in ("cases.jsonl", "answers.jsonl"))
        self.assertEqual(len(cases), len(answers))
        self.assertGreater(len(cases), 3000)

    def test_the_page_of_the_commands_shows_the_same(self):
        shown, = blocks(COMMANDS, "verify: this model, or your own")
        shutil.copy(NEWCOMER, self.folder / "my_solver.py")
        out = words(self.installed("tribocheck verify --subject 'python3 my_solver.py'", 1))
        for part in shown.split("…\n"):
            self.assertIn(words(part), out)

    def test_each_language_by_the_line_that_init_prints(self):
        rows = (self.home / ".local/share/tribocheck/templates/languages.tsv").read_text().splitlines()[1:]
        self.assertEqual([row.split("\t")[0] for row in rows], ["python", "octave", "c", "fortran", "cpp", "javascript", "rust"])
        verdict = blocks(CONFORMANCE, "In five minutes")[0].strip()
        built = f"{shlex.quote(str(BUILD))}/"  # the program is not on PATH: the line has to name it
        for row in rows:
            language, template, compiler = row.split("\t")[:3]
            if not shutil.which(compiler, path=self.environment["PATH"]):  # Rust's compiler is too large for every machine that runs this
                continue
            for out, sh, found in ((f"my {language}", self.installed, ""), (template, self.sh, built)):
                with self.subTest(language=language, out=out):
                    said = sh(f"{found}tribocheck init subject --language {language} --out '{out}'")
                    self.assertEqual(said.splitlines()[:2], [f"{out}: written", "next:"])
                    line, = said.splitlines()[2:]
                    self.assertEqual(sh(line, 1).splitlines()[-1], verdict)

    def test_what_it_speaks(self):
        exchange, = blocks(CONFORMANCE, "What it speaks")
        question, answer = re.match(r"(\{.*?\}) +→ (\{.*?)…", exchange).groups()
        self.assertIn(answer, self.installed(f"echo '{question}' | tribocheck stream"))

    def test_a_tolerance_of_ones_own(self):
        file, = blocks(CONFORMANCE, "Tolerances")
        (self.folder / "tolerance").write_text(file)
        said = self.installed("tribocheck verify --subject 'tribocheck stream' --sample 5 --tolerance tolerance")
        self.assertIn("COMPLETE: 99 of 99 quantities held (tolerance: tolerance).", said)

    def make_baseline(self):
        shutil.copy(NEWCOMER, self.folder / "my_solver.py")
        script, = blocks(CONFORMANCE, "As a gate in your CI", "sh")[:1]
        self.installed(script)
        self.assertEqual(stand_ins.asked(self.home)[-1:], ["git add tribocheck.json"])

    def test_init_writes_the_files_for_ci(self):
        script, = [text for text in blocks(CONFORMANCE, "As a gate in your CI", "sh") if "init ci" in text]
        self.installed(script)
        for system, path in (("github", ".github/workflows/tribocheck.yml"), ("gitlab", ".gitlab-ci.yml")):
            self.assertEqual((self.folder / path).read_bytes(),
                             (ROOT / f"verification/conformance/ci/{system}.yml").read_bytes())

    def test_ctest_holds_a_program_and_a_plugin(self):
        self.make_baseline()
        text, = blocks(CONFORMANCE, "As a gate in your CI", "cmake")
        (self.folder / "CMakeLists.txt").write_text(text)
        script, = [text for text in blocks(CONFORMANCE, "As a gate in your CI", "sh") if "ctest" in text]
        # A fresh plug-in answers nothing, and its test fails. With Hertz' contact, as the page shows it, the test passes.
        said = self.installed(script, 8)
        self.assertRegex(said, r" my_solver \.+ +Passed")
        self.assertRegex(said, r" my_library_holds \.+\*+Failed")
        init, script = script.split("\n", 1)
        self.assertIn("tribocheck init subject --language c", init)
        filled_in, = blocks(CONFORMANCE, "As a gate in your CI", "c")
        fresh = (self.folder / "my_library.c").read_text()
        start = fresh.index("static int hertz_point(")
        (self.folder / "my_library.c").write_text(
            fresh[:start] + fresh[start:].replace("  return TRIBOCHECK_NOT_OFFERED;\n", filled_in, 1))
        said = self.sh(script)
        suite = ElementTree.parse(self.folder / "build/my_solver.xml").getroot()
        self.assertEqual(suite.findall(".//failure"), [])
        for test in ("my_solver", "my_library_holds"):
            self.assertRegex(said, rf" {test} \.+ +Passed")
        worse = NEWCOMER.read_text().replace("1.5 * mean", "1.4 * mean")
        (self.folder / "my_solver.py").write_text(worse)
        with open(self.folder / "CMakeLists.txt", "a") as file:  # one more subject, without a baseline
            file.write("find_package(tribocheck 0.2 CONFIG REQUIRED)\n"
                       "tribocheck_add_subject(alone COMMAND python3 ${CMAKE_SOURCE_DIR}/my_solver.py SAMPLE 50)\n")
        said = self.sh(script, 8)
        self.assertRegex(said, r" alone \.+\*+Failed")
        self.assertIn("R/2 in place of R", said)
        self.assertRegex(said, r" my_solver \.+\*+Failed")
        self.assertIn("Worse than the baseline: hertz_point.peak_pressure: was held, is FAILED", said)
        self.assertRegex(said, r" my_library_holds \.+ +Passed")

    def test_the_speed_of_a_solver(self):
        shutil.copy(NEWCOMER, self.folder / "my_solver.py")
        for name in ("libmine.so", "libbefore.so"):
            source = shlex.quote(str(ROOT / "verification/conformance/subjects/c_plugin/solver.c"))
            self.installed(f'cc -O2 -shared -fPIC -I "$HOME/.local/include" {source} -o {name} -lm')
        script, = blocks(CONFORMANCE, "The speed of a solver", "sh")
        first, second, third = script.splitlines()
        self.assertIn("baseline written: speed.json", self.installed(first))
        self.assertIn("PASSED, no worse than speed.json: 3 of 3 rows compared, the times of 3", self.installed(second))
        self.assertEqual(ElementTree.parse(self.folder / "speed.xml").getroot().get("failures"), "0")
        self.assertIn("PASSED, no worse than ./libbefore.so: ", self.installed(third))

    def test_as_a_library(self):
        one, million = blocks(LIBRARY, "", "cpp")
        texts = {"CMakeLists.txt": blocks(LIBRARY, "", "cmake")[0], "one.cpp": one,
                 "million.cpp": million, "scene.toml": blocks(PROJECT, "A scene", "toml")[0]}
        for name, text in texts.items():
            (self.folder / name).write_text(text)
        script, = blocks(LIBRARY, "", "sh")
        self.sh(script)
        for program, shown in {"one": r"m at 0\.1 m/s", "million": r"m at most, at 0\.\d{4} m/s"}.items():
            said = self.sh(f"build/{program}")
            self.assertRegex(said, rf"^\d\.\d{{4}}e-08 {shown}\n$")
            expected = re.search(r"// (\S+)\n}", texts[f"{program}.cpp"])[1]
            self.assertEqual(said.split()[0], expected)
        (self.folder / "scene.toml").unlink()
        for program in ("one", "million"):
            self.assertRegex(self.sh(f"build/{program}", 2), r"^scene\.toml: .+\n$")


if __name__ == "__main__":
    unittest.main()
