# SPDX-License-Identifier: Apache-2.0
"""The files for GitHub Actions and GitLab CI: their structure, and what their scripts do with a good and a broken solver.

`make`, `git`, `apt-get` and `bench` have stand-ins here. test_ci_files_slow.py uses the real ones, except for `apt-get`.
"""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import ci_jobs
import stand_ins
from stand_ins import BUILD, NEWCOMER, ROOT

# Closed lists of the keys that a step may have (by GitHub's documentation), of the settings, and of the JUnit files.
GITHUB_STEP = {"name", "id", "if", "uses", "with", "run"}
SETTINGS = {"TRIBOCHECK_REPOSITORY", "TRIBOCHECK_TAG", "SOLVER"}
JUNIT = ["tribocheck.xml", "speed.xml"]
# Libraries that Debian's smallest system has, and MPI's, which is linked only on machines that have its headers.
ALWAYS_THERE = {"libc6", "libgcc-s1", "libstdc++6", "zlib1g", "libopenmpi3"}

# Installs the program with a `bench` that measures nothing: a solver is slow where its text has the word `slow`. This
# `bench` refuses all arguments but those that the files give it.
MAKE_WITH_BENCH = stand_ins.MAKE.replace("exec ", "") + r"""
mv "$prefix/bin/tribocheck" "$prefix/bin/real"
cat > "$prefix/bin/tribocheck" << 'END'
#!/bin/sh
[ "$1" = bench ] || exec "$(dirname "$0")/real" "$@"
[ "$2 $4 $5 $6 $7 $8 $9" = "--subject --subject env -C before $3 --junit speed.xml --format markdown" ] || exit 2
[ -f "before/${3#python3 }" ] || exit 2
end=PASSED; grep -q 'slow' "${3#python3 }" && end=FAILED
echo '<testsuites/>' > speed.xml
echo "### tribocheck bench: $end"
[ $end = PASSED ]
END
chmod +x "$prefix/bin/tribocheck"
"""


def text_of(system):
    return (ci_jobs.FOLDER / f"{system}.yml").read_text()


class Structure(unittest.TestCase):
    def keys(self, mapping, required, allowed=()):
        self.assertLessEqual(set(required), set(mapping))
        self.assertLessEqual(set(mapping), {*required, *allowed})

    def test_github(self):
        workflow = ci_jobs.read("github")
        self.keys(workflow, {"name", "on", "env", "permissions", "jobs"})
        self.assertEqual(set(workflow["on"]), {"push", "pull_request"})
        self.assertEqual(workflow["permissions"], {"contents": "read"})
        self.assertEqual(set(workflow["env"]), SETTINGS)
        self.assertEqual(set(workflow["jobs"]), {"tribocheck"})
        job = workflow["jobs"]["tribocheck"]
        self.keys(job, {"runs-on", "container", "timeout-minutes", "steps"})
        self.assertIn(job["timeout-minutes"], range(10, 61))
        steps = job["steps"]
        for step in steps:
            with self.subTest(step=step):
                self.keys(step, (), GITHUB_STEP)
                self.assertEqual(("uses" in step) + ("run" in step), 1)
                self.assertLessEqual("with" in step, "uses" in step)
                if "uses" in step:
                    self.assertRegex(step["uses"], r"^actions/[a-z-]+(/[a-z]+)?@v\d+$")
                self.assertNotIn("${{", step.get("run", ""))  # it would put texts of others into a script
        ids = {step.get("id") for step in steps}
        self.assertLessEqual(set(re.findall(r"steps\.(\w+)\.", text_of("github"))), ids)
        kinds = [step.get("uses", "").partition("@")[0] for step in steps]
        first, before = (step for step, kind in zip(steps, kinds, strict=True) if kind == "actions/checkout")
        self.assertEqual(("with" in first, before["with"]["path"]), (False, "before"))
        self.assertEqual(set(before["with"]), {"ref", "path"})
        restored, saved = (steps[kinds.index(f"actions/cache/{way}")]["with"] for way in ("restore", "save"))
        self.assertEqual(restored, saved)
        self.assertIn("${{ env.TRIBOCHECK_TAG }}", restored["key"])
        self.assertEqual(steps[kinds.index("actions/upload-artifact")]["with"]["path"].split(), JUNIT)

    def test_gitlab(self):
        file = ci_jobs.read("gitlab")
        self.assertEqual(set(file), {"tribocheck"})
        job = file["tribocheck"]
        self.keys(job, {"image", "timeout", "variables", "cache", "before_script", "script", "artifacts"})
        self.assertEqual(set(job["variables"]), SETTINGS)
        self.assertRegex(job["timeout"], r"^\d\d minutes$")
        self.assertEqual(job["cache"], {"key": "tribocheck-$TRIBOCHECK_TAG-debian-12", "paths": [".tribocheck/"],
                                        "when": "always"})
        for line in [*job["before_script"], *job["script"]]:
            self.assertIsInstance(line, str)
        artifacts = job["artifacts"]
        self.keys(artifacts, {"when", "paths", "reports", "expose_as"})
        self.assertEqual(artifacts["when"], "always")
        self.assertEqual(artifacts["reports"], {"junit": JUNIT})
        self.assertEqual(artifacts["paths"], ["summary.md", *JUNIT])

    def test_each_setting_stands_once_at_the_top_and_the_tag_is_this_version(self):
        version = re.search(r"^project\(tribocheck VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
        settings = (ci_jobs.read("github")["env"], ci_jobs.read("gitlab")["tribocheck"]["variables"])
        self.assertEqual(settings[0], settings[1])
        self.assertEqual(settings[0]["TRIBOCHECK_TAG"], f"v{version}")
        for system in ("github", "gitlab"):
            text = text_of(system)
            _, after = text.split("# CHANGE these three: ")
            self.assertEqual(re.findall(r"^ *(\w+): ", after, re.M)[:3], list(settings[0]))
            for name, value in settings[0].items():
                self.assertEqual(re.findall(rf"^ *{name}: (.*)$", text, re.M), [value])
            for value in (settings[0]["TRIBOCHECK_REPOSITORY"], settings[0]["TRIBOCHECK_TAG"]):
                self.assertEqual(text.count(value), 1)

    def test_the_packages_are_those_of_the_installed_programs(self):
        listed = [set(re.findall(r"\blib(?!raries)[\w-]+", text_of(system))) for system in ("github", "gitlab")]
        self.assertEqual(listed[0], listed[1])
        needed = set()
        for program in ("tribocheck", "tribocheck_sweep"):
            dynamic = subprocess.run(["readelf", "--dynamic", BUILD / program], capture_output=True, text=True, check=True)
            needed.update(re.findall(r"NEEDED.*\[(.*)\]", dynamic.stdout))
        owners = subprocess.run(["dpkg-query", "--search", *(f"*/x86_64-linux-gnu/{library}" for library in needed)],
                                capture_output=True, text=True, check=True).stdout
        packages = {line.partition(":")[0] for line in owners.splitlines()}
        self.assertEqual(packages - ALWAYS_THERE, listed[0])


class Jobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="tribocheck ")
        cls.addClassCleanup(folder.cleanup)
        cls.home = pathlib.Path(folder.name)
        cls.environment = stand_ins.put_into(cls.home, make=MAKE_WITH_BENCH)
        cls.baseline = cls.home / "tribocheck.json"
        # The exit code is 1: the newcomer's film is wrong, and the baseline records it as allowed.
        subprocess.run([BUILD / "tribocheck", "verify", "--subject", f"python3 {NEWCOMER}", "--baseline",
                        cls.baseline, "--update-baseline"], capture_output=True, check=False)

    def fill(self, folder, text):
        """Writes a solver of this text, its baseline, and the version before, which the real systems check out."""
        (folder / "my_solver.py").write_text(text)
        shutil.copy(self.baseline, folder)
        (folder / "before").mkdir()
        shutil.copy(NEWCOMER, folder / "before")

    def run_both(self, text, is_green, verdict, failed):
        """Runs a solver of this text in both systems; checks the results and the commands given to the stand-ins."""
        for system in ("github", "gitlab"):
            with self.subTest(system=system):
                folder = pathlib.Path(tempfile.mkdtemp(dir=self.home))
                self.fill(folder, text)
                stand_ins.asked(self.home)
                run = getattr(ci_jobs, f"run_{system}")(folder, self.environment)
                self.assertEqual(run.is_green, is_green, run.said)
                self.assertEqual(set(run.kept) - {"summary.md"}, set(JUNIT))
                self.assertIn(verdict, run.summary.replace("\\", ""))
                self.assertIn("### tribocheck bench: ", run.summary)
                suite = ElementTree.parse(folder / "tribocheck.xml").getroot()
                self.assertEqual(suite.findall(".//failure") != [], failed)
                update, install, clone, make, *before = stand_ins.asked(self.home)
                self.assertEqual([line.split()[3] for line in before], ["fetch", "worktree"] if system == "gitlab" else [])
                self.assertEqual(update, "apt-get update")
                self.assertTrue(install.startswith("apt-get install -y --no-install-recommends "), install)
                tag = ci_jobs.read("github")["env"]["TRIBOCHECK_TAG"]
                self.assertEqual(clone, f"git clone --depth 1 --branch {tag} https://example.org/tribocheck.git "
                                        "/tmp/tribocheck")
                self.assertEqual(make, f"make -C /tmp/tribocheck install PREFIX={folder}/.tribocheck")

    def test_a_good_solver_is_green(self):
        self.run_both(NEWCOMER.read_text(), True, "PASSED, no worse than tribocheck.json", False)

    def test_wrong_values_are_red_and_speed_is_measured_nevertheless(self):
        self.run_both(NEWCOMER.read_text().replace("1.5 * mean", "1.4 * mean"), False, "FAILED", True)

    def test_a_function_that_is_gone_is_red(self):
        self.run_both(NEWCOMER.read_text().replace('name == "hertz_point"', "False"), False, "FAILED", True)

    def test_a_slow_solver_is_red(self):
        self.run_both(NEWCOMER.read_text() + "# slow\n", False, "PASSED, no worse than tribocheck.json", False)

    def test_where_no_version_before_runs_no_speed_is_compared(self):
        for system in ("github", "gitlab"):
            folder = pathlib.Path(tempfile.mkdtemp(dir=self.home))
            self.fill(folder, NEWCOMER.read_text())
            (folder / "before/my_solver.py").unlink()
            run = getattr(ci_jobs, f"run_{system}")(folder, self.environment)
            self.assertTrue(run.is_green, run.said)
            self.assertIn("the version before does not run, so that no speed is compared", run.summary)
            self.assertEqual(set(run.kept) - {"summary.md"}, {"tribocheck.xml"})

    def test_a_program_that_is_in_the_cache_is_not_built_again(self):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.home))
        self.fill(folder, NEWCOMER.read_text())
        self.assertTrue(ci_jobs.run_gitlab(folder, self.environment).is_green)
        stand_ins.asked(self.home)
        for run in (ci_jobs.run_gitlab(folder, self.environment),
                    ci_jobs.run_github(folder, self.environment, is_cached=True)):
            self.assertTrue(run.is_green, run.said)
        asked = stand_ins.asked(self.home)
        self.assertEqual({line.split()[0] for line in asked}, {"apt-get", "git"})
        self.assertNotIn("clone", " ".join(asked))


if __name__ == "__main__":
    unittest.main()
