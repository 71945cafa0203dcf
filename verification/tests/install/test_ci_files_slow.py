# SPDX-License-Identifier: Apache-2.0
"""The scripts for GitHub Actions and GitLab CI as they stand, in a root of their own: the program is cloned and built there.

`apt-get` alone is stood in for: the packages are those of this machine. The root has no network, an empty home and an
empty /tmp; it is a mount namespace, which this file starts itself again in (`unshare`). GitHub's job builds the program
(some minutes); all other runs find it in their cache.
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
        for command in (["clone", "--quiet", "--bare", ROOT, sources], ["-C", sources, "tag", "--force", tag, "HEAD"]):
            subprocess.run(["git", "-c", "safe.directory=*", *command], check=True)
        cls.environment = {"HOME": str(HOME), "PATH": f"{HOME}/bin:/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8",
                           "TRIBOCHECK_REPOSITORY": f"file://{sources}"}
        cls.first = cls.workspace("first", SOLVER)
        # The baselines are made as the head of the files says, by the program that the first job has built.
        cls.built = ci_jobs.run_github(cls.first, cls.environment)

    @classmethod
    def workspace(cls, name, text):
        folder = HOME / "work" / name
        folder.mkdir(parents=True)
        (folder / "my_solver.py").write_text(text)
        if name != "first":
            shutil.copytree(cls.first / ".tribocheck", folder / ".tribocheck")
            for baseline in ("tribocheck.json", "speed.json"):
                shutil.copy(cls.first / baseline, folder)
        return folder

    def lines_of_the_head(self):
        head = [line[1:].strip() for line in (self.jobs.FOLDER / "github.yml").read_text().splitlines()
                if line.startswith("#")]
        return [line for line in head if line.startswith("tribocheck ")]

    def test_1_the_program_is_built_and_without_baselines_both_gates_are_red(self):
        self.assertTrue((self.first / ".tribocheck/bin/tribocheck").is_file(), self.built.said)
        self.assertIn("tribocheck is installed under ", self.built.said)
        self.assertIn("--update-baseline", self.built.said)
        self.assertFalse(self.built.is_green)

    def test_2_the_lines_of_the_head_make_the_baselines(self):
        lines = self.lines_of_the_head()
        self.assertEqual(len(lines), 2)
        for line in lines:
            subprocess.run(["sh", "-c", line], cwd=self.first, check=False, stdout=subprocess.DEVNULL,
                           env={**self.environment, "PATH": f"{self.first}/.tribocheck/bin:/usr/bin:/bin"})
        for baseline in ("tribocheck.json", "speed.json"):
            self.assertTrue((self.first / baseline).is_file(), baseline)

    def run_both(self, name, text):
        github = self.workspace(f"{name} by github", text)
        gitlab = self.workspace(f"{name} by gitlab", text)
        return ((github, self.jobs.run_github(github, self.environment, is_cached=True)),
                (gitlab, self.jobs.run_gitlab(gitlab, self.environment)))

    def assert_kept(self, folder, run, red):
        """JUnit and the summary are there, and the failures in each file are those that are wanted (None: either)."""
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
            folder = self.workspace(name, text)
            (folder / "CMakeLists.txt").write_text(CTEST)
            done = subprocess.run(["sh", "-ec", "cmake -S . -B build -D CMAKE_PREFIX_PATH=$PWD/.tribocheck > configured\n"
                                   "ctest --test-dir build"], cwd=folder, env=self.environment, check=False,
                                  capture_output=True, text=True)
            with self.subTest(name=name):
                self.assertEqual(done.returncode, code, done.stdout + done.stderr)
                self.assertRegex(done.stdout, r" my_solver \.+ +Passed")
                for file in ("my_solver.xml", "my_solver_speed.xml"):
                    self.assertTrue((folder / "build" / file).is_file(), file)


if __name__ == "__main__":
    unittest.main()
