# SPDX-License-Identifier: Apache-2.0
"""The scripts for GitHub Actions and GitLab CI as they stand, in a root of their own: the program is cloned and built there.

Only `apt-get` has a stand-in: the packages are those of this machine. The root is a mount namespace without network, with
an empty home and an empty /tmp. This file starts itself again in it, by `unshare`. GitHub's job builds the program (some
minutes); all other runs find it in their cache.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

HOME = pathlib.Path("/tmp/home")
APT_GET = "#!/bin/sh\necho \"apt-get $*\"\n"
INSIDE = "TRIBOCHECK_IN_ITS_ROOT"
ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
SOLVER = (ROOT / "verification/conformance/subjects/small_python/my_solver.py").read_text()
SLOWER = SOLVER.replace("    x = [low", "    sum(math.exp(-i) for i in range(8000))\n    x = [low")
BROKEN = {  # what is broken: the solver's text, and which of the two gates are red
    "a changed constant": (SOLVER.replace("1.5 * mean", "1.4 * mean"), (True, False)),
    "a function that is gone": (SOLVER.replace('name == "hertz_point"', "False"), (True, None)),
    "half of the speed": (SLOWER, (False, True)),
}
# Its lines are those of the conformance README, with a gate of speed.
CTEST = """
cmake_minimum_required(VERSION 3.25)
project(my_solvers LANGUAGES CXX)
enable_testing()
find_package(tribocheck CONFIG REQUIRED)
include(tribocheck)
tribocheck_add_subject(my_solver COMMAND python3 ${CMAKE_SOURCE_DIR}/my_solver.py JUNIT my_solver.xml
                       BASELINE ${CMAKE_SOURCE_DIR}/tribocheck.json SPEED ${CMAKE_SOURCE_DIR}/speed.json)
"""


class InItsRoot(unittest.TestCase):
    """The only test outside of the root: it runs the others inside of it."""

    def test_in_a_root_of_its_own(self):
        unshare = ["unshare", "--mount", "--net", *([] if os.geteuid() == 0 else ["--map-root-user"])]
        enter = "mount -t tmpfs none /tmp && exec \"$@\""
        done = subprocess.run([*unshare, "sh", "-c", enter, "sh", sys.executable, "-B", "-m", "unittest", "-v",
                               "test_ci_files_slow.Jobs"], env={**os.environ, INSIDE: "1"}, check=False)
        self.assertEqual(done.returncode, 0)


@unittest.skipUnless(INSIDE in os.environ, "it changes /tmp")
class Jobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        import ci_jobs
        cls.jobs = ci_jobs
        (HOME / "bin").mkdir(parents=True)
        (HOME / "bin/apt-get").write_text(APT_GET)
        (HOME / "bin/apt-get").chmod(0o755)
        tag = ci_jobs.read("github")["env"]["TRIBOCHECK_TAG"]
        sources = HOME / "sources.git"
        # The earlier version of the solver, on the default branch of its project.
        cls.project = HOME / "project"
        cls.project.mkdir()
        (cls.project / "my_solver.py").write_text(SOLVER)
        for command in (["init", "--quiet", "--initial-branch=main"], ["add", "."],
                        ["-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "-m", "The solver"]):
            subprocess.run(["git", *command], cwd=cls.project, check=True)
        for command in (["clone", "--quiet", "--bare", ROOT, sources], ["-C", sources, "tag", "--force", tag, "HEAD"]):
            subprocess.run(["git", "-c", "safe.directory=*", *command], check=True)
        cls.environment = {"HOME": str(HOME), "PATH": f"{HOME}/bin:/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8",
                           "TRIBOCHECK_REPOSITORY": f"file://{sources}", "CI_DEFAULT_BRANCH": "main"}
        cls.first = cls.workspace("first by github", SOLVER)
        # This job builds the program. test_2 makes the baseline with it, by the command at the head of the files.
        cls.built = ci_jobs.run_github(cls.first, cls.environment)

    @classmethod
    def workspace(cls, name, text):
        folder = HOME / "work" / name
        checkouts = [folder, folder / "before"] if name.endswith("github") else [folder]
        for checkout in checkouts:
            subprocess.run(["git", "clone", "--quiet", cls.project, checkout], check=True)
        (folder / "my_solver.py").write_text(text)
        if not name.startswith("first"):
            shutil.copytree(cls.first / ".tribocheck", folder / ".tribocheck")
            shutil.copy(cls.first / "tribocheck.json", folder)
        return folder

    def lines_of_the_head(self):
        head = [line[1:].strip() for line in (self.jobs.FOLDER / "github.yml").read_text().splitlines()
                if line.startswith("#")]
        return [line for line in head if line.startswith("tribocheck ")]

    def test_1_the_program_is_built_and_without_a_baseline_the_gate_is_red(self):
        self.assertTrue((self.first / ".tribocheck/bin/tribocheck").is_file(), self.built.said)
        self.assertIn("tribocheck is installed under ", self.built.said)
        self.assertIn("--update-baseline", self.built.said)
        self.assertFalse(self.built.is_green)

    def installed(self, line, folder):
        return subprocess.run(["sh", "-c", line], cwd=folder, check=False, capture_output=True, text=True,
                              env={**self.environment, "PATH": f"{self.first}/.tribocheck/bin:/usr/bin:/bin"})

    def test_2_the_line_of_the_head_makes_the_baseline(self):
        line, = self.lines_of_the_head()
        self.installed(line, self.first)
        self.assertTrue((self.first / "tribocheck.json").is_file())

    def run_both(self, name, text):
        github = self.workspace(f"{name} by github", text)
        gitlab = self.workspace(f"{name} by gitlab", text)
        return ((github, self.jobs.run_github(github, self.environment, is_cached=True)),
                (gitlab, self.jobs.run_gitlab(gitlab, self.environment)))

    def assert_kept(self, folder, run, red):
        """JUnit files and summary are there, and each file has failures where `red` says so (None: either)."""
        for file, is_red in zip(("tribocheck.xml", "speed.xml"), red, strict=True):
            self.assertIn(file, run.kept)
            failures = ElementTree.parse(folder / file).getroot().findall(".//failure")
            if is_red is not None:
                self.assertEqual(failures != [], is_red, f"{file}: {run.said}\n{run.summary}")
        self.assertEqual(run.summary.count("### tribocheck"), 2, run.summary)

    def test_3_a_good_solver_is_green(self):
        for folder, run in self.run_both("good", SOLVER):
            with self.subTest(folder=folder.name):
                self.assertTrue(run.is_green, f"{run.said}\n{run.summary}")
                self.assert_kept(folder, run, (False, False))

    def test_4_each_break_is_red_and_junit_and_the_summary_are_kept(self):
        for name, (text, red) in BROKEN.items():
            self.assertNotEqual(text, SOLVER)
            for folder, run in self.run_both(name, text):
                with self.subTest(folder=folder.name):
                    self.assertFalse(run.is_green, f"{run.said}\n{run.summary}")
                    self.assert_kept(folder, run, red)

    def test_5_ctest_has_both_gates_too(self):
        for name, text, code in (("good in ctest", SOLVER, 0), ("slow in ctest", SLOWER, 8)):
            folder = self.workspace(name, SOLVER)
            line = "tribocheck bench --subject 'python3 my_solver.py' --baseline speed.json --update-baseline"
            self.assertEqual(self.installed(line, folder).returncode, 0)
            (folder / "my_solver.py").write_text(text)
            (folder / "CMakeLists.txt").write_text(CTEST)
            # A failed test is run again: on a busy machine a measured speed may be wrong once.
            script = 'cmake -S . -B build -D CMAKE_PREFIX_PATH="$PWD/.tribocheck"; ctest --test-dir build --repeat until-pass:2'
            done = subprocess.run(["sh", "-ec", script], cwd=folder, env=self.environment, check=False,
                                  capture_output=True, text=True)
            with self.subTest(name=name):
                self.assertEqual(done.returncode, code, done.stdout + done.stderr)
                self.assertRegex(done.stdout, r" my_solver \.+ +Passed")
                for file in ("my_solver.xml", "my_solver_speed.xml"):
                    self.assertTrue((folder / "build" / file).is_file(), file)


if __name__ == "__main__":
    unittest.main()
