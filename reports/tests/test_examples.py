# SPDX-License-Identifier: Apache-2.0
"""The examples at the end of every help text, each run as it is printed."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from plugins import plugin
from program import ENVIRONMENT, PROGRAM, SWEEP_PROGRAM, TIMEOUT, ProgramTest, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])


def subcommands(*command):
    listed = run(*command, "--help").out.partition("\nSubcommands:\n")[2].partition("\n\n")[0]
    return [[*command, name] for name in re.findall(r"(?m)^  ([a-z-]+) ", listed)]


def commands():
    """Every command and subcommand of the program."""
    return [command for first in subcommands() for command in [first, *subcommands(*first)]]


def examples(*command, **options):
    """The lines under "Example:". A line that goes on includes the lines after it that belong to it."""
    _, _, text = run(*command, "--help", **options).out.partition("\nExample:\n")
    block = re.match(r"(?:  .*\n)*", text)[0]
    return re.findall(r"(?m)^  (\S.*(?:\n    .*)*)", block)


class Examples(ProgramTest):
    def setUp(self):
        """A folder like the project's, with the program called `tribocheck`."""
        super().setUp()
        os.symlink(ROOT / "reference", self.folder.path("reference"))
        os.mkdir(self.folder.path("bin"))
        # A link would not do for `bench`, which looks for its helper beside the program.
        path = self.folder.write("bin/tribocheck", f"#!/bin/sh\nexec '{PROGRAM}' \"$@\"\n")
        os.chmod(path, 0o755)

    def run_line(self, line):
        environment = {**ENVIRONMENT, "PATH": f"{self.folder.path('bin')}:{ENVIRONMENT['PATH']}"}
        return subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=self.folder.name,
                              env=environment, capture_output=True, text=True, timeout=TIMEOUT)

    def run_examples(self, *command, codes=(0,)):
        lines = examples(*command)
        self.assertTrue(lines, command)
        for line in lines:
            with self.subTest(line=line):
                done = self.run_line(line)
                self.assertIn(done.returncode, codes, done.stderr)

    def test_every_command_has_examples_of_itself(self):
        found = commands()
        self.assertIn(["sweep", "merge"], found)
        for command in found:
            if command == ["plugin-host"]:  # only `verify` starts it
                continue
            with self.subTest(command=command):
                words = "\n".join(" ".join(line.split()) for line in examples(*command))
                self.assertIn("tribocheck " + " ".join(command), words)

    def test_of_the_program_itself(self):
        self.run_examples()

    def test_of_contact_solve_curve_onset_and_stream(self):
        self.folder.write("measured.csv", "speed [m/s],film [nm],friction\n0.1,30,0.1\n")
        for command in ["contact", "solve", "curve", "onset", "stream"]:
            self.run_examples(command)
        with open(self.folder.path("rough.csv"), encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 201)
        for picture in ["rough.png", "measured.png"]:
            self.assertTrue(os.path.exists(self.folder.path(picture)), picture)

    def test_of_film(self):
        self.run_examples("film")
        for file in ["films.csv", "profiles.csv", "roller.png"]:
            self.assertTrue(os.path.exists(self.folder.path(file)), file)

    def test_of_sweep(self):
        self.run_examples("sweep")
        for picture in ["smooth.h5", "film_map.h5", "pictures"]:
            self.assertTrue(os.path.exists(self.folder.path(picture)), picture)

    def test_of_sweep_merge_and_show(self):
        self.run_examples("sweep", "merge")
        os.remove(self.folder.path("film_map.h5"))
        self.run_examples("sweep", "show")

    def test_of_reproduce(self):
        self.run_examples("reproduce")

    def test_of_report(self):
        self.run_examples("report")

    # The examples of these two commands judge the solver that `init` writes, and a plug-in. The new solver
    # offers nothing yet, and the plug-in may miss the strict tolerance: exit code 1 is allowed.
    def test_of_init_and_verify(self):
        self.run_examples("init", codes=(0, 1))
        self.assertTrue(os.path.exists(self.folder.path("my_solver.py")))
        shutil.copy(plugin("c_plugin"), self.folder.path("libmine.so"))
        with open(self.folder.path("mine.json"), "w", encoding="utf-8") as file:
            file.write(self.run_line("tribocheck verify --plugin ./libmine.so --tolerance strict "
                                     "--format json --baseline new.json --update-baseline "
                                     ">/dev/null; cat new.json").stdout)
        self.run_examples("verify", codes=(0, 1))
        self.run_examples("field", codes=(0, 1))
        self.assertTrue(os.path.exists(self.folder.path("field/mine.html")))

    def test_of_bench(self):
        for name in ("libsolver.so", "libbefore.so"):
            shutil.copy(plugin("c_plugin"), self.folder.path(name))
        shutil.copy(ROOT / "verification/conformance/subjects/small_python/my_solver.py", self.folder.path("my_solver.py"))
        for line in examples("bench"):
            quick = line if "--quick" in line else line + " --quick"  # without --quick it takes a minute
            with self.subTest(line=line):
                done = self.run_line(quick)
                if ("--baseline" in line and "--update-baseline" not in line) or "libbefore" in line:  # a short measurement may fail
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    self.assertRegex(done.stderr, "(PASSED, no|FAILED,) worse than (speed.json|./libbefore.so)")
                else:
                    self.assertEqual(done.returncode, 0, done.stderr)


class Elsewhere(ProgramTest):
    """Outside of the project the examples name the scenes by their full path."""

    def scenes_in_help(self, program, *command):
        done = subprocess.run([program, *command, "--help"], cwd=self.folder.name,
                              env=ENVIRONMENT, capture_output=True, text=True, timeout=TIMEOUT)
        self.assertEqual(done.returncode, 0, done.stderr)
        return re.findall(r"(?m)[^ ]+\.toml", done.stdout.partition("\nExample:\n")[2])

    def test_the_scenes_of_an_installed_program_are_those_that_came_with_it(self):
        installed = self.folder.path("installed")
        shared = os.path.join(installed, "share/tribocheck")
        shutil.copytree(ROOT / "reference/published", os.path.join(shared, "published"))
        shutil.copytree(ROOT / "reports/page/render", os.path.join(shared, "page/render"))
        os.mkdir(os.path.join(installed, "bin"))
        program, _ = [shutil.copy(one, os.path.join(installed, "bin")) for one in (PROGRAM, SWEEP_PROGRAM)]
        for command in [[], ["solve"], ["curve"], ["onset"], ["sweep"], ["sweep", "merge"]]:
            with self.subTest(command=command):
                files = self.scenes_in_help(program, *command)
                self.assertTrue(files)
                for file in files:
                    self.assertTrue(os.path.isfile(file), file)
                    self.assertTrue(file.startswith(shared), file)

    def test_those_of_the_built_program_are_the_projects(self):
        files = self.scenes_in_help(PROGRAM, "solve")
        self.assertTrue(files)
        for file in files:
            self.assertTrue(os.path.isfile(file), file)
            self.assertTrue(pathlib.Path(file).resolve().is_relative_to(ROOT.resolve()), file)


def has_fma():
    """Whether fused multiply-add is used. Without it last digits may differ."""
    off = os.environ.get("GLIBC_TUNABLES", "")
    flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    return " fma " in flags and "-FMA" not in off and "-AVX2" not in off


def page(path):
    return (ROOT / path).read_text(encoding="utf-8")


FIRST, COMMANDS, SWEEPS = map(page, ["README.md", "reports/program/README.md", "model/sweep/README.md"])


class OfTheReadmes(ProgramTest):
    """Commands that the READMEs show with what they print, to the last digit. A first or last line "…" stands for all other lines."""

    def setUp(self):
        super().setUp()
        scene, = re.findall(r"(?s)## A scene\n.*?```toml\n(.*?)```", FIRST)
        self.scene = self.folder.write("scene.toml", scene)

    def assert_shown(self, printed, shown):
        if shown.startswith("…\n"):
            shown = shown.removeprefix("…\n")
            printed = printed[printed.index(shown.partition("\n")[0] + "\n"):]
        if shown.endswith("…\n"):
            shown = shown.removesuffix("…\n")
            printed = "".join(printed.splitlines(keepends=True)[:shown.count("\n")])
        if has_fma():
            return self.assertEqual(printed, shown)
        words = [re.split(r"([\s,]+)", text) for text in (printed, shown)]
        self.assertEqual(*map(len, words))
        for one, other in zip(*words):
            if one != other:
                self.assertAlmostEqual(float(one)/float(other), 1, delta=1e-12)

    def test_a_command_and_the_block_below_it(self):
        shown = re.findall(r"`tribocheck ((?:contact|solve|onset|curve) scene\.toml[^`\n]*|reproduce)`[^`]*\n```\n(.*?)```",
                           FIRST + COMMANDS, re.S)
        self.assertEqual([line.split()[0] for line, _ in shown], ["solve", "onset", "contact", "solve", "curve", "reproduce"])
        for line, answer in shown:
            with self.subTest(line=line):
                self.assert_shown(run(*line.replace("scene.toml", self.scene).split()).ended(0, "").out, answer)

    def answered(self, text):
        """A line after "$", run by a shell in the folder, and what the page shows below it."""
        (line, shown), = re.findall(r"(?s)```\n\$ ([^\n]*)\n(.*?)```", text)
        environment = {**ENVIRONMENT, "PATH": f"{os.path.dirname(PROGRAM)}:{ENVIRONMENT['PATH']}"}
        done = subprocess.run(["sh", "-c", line], cwd=os.path.dirname(self.scene), env=environment, timeout=TIMEOUT,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_shown(done.stdout, shown)

    def test_a_line_of_json(self):
        self.answered(COMMANDS)

    def test_an_uncertain_input(self):
        changed, added = re.search(r"(?s)```toml\n(viscosity[^\n]*)\n(.*?)```", SWEEPS).groups()
        scene, count = re.subn(r"(?m)^viscosity = .*$", changed, page("reference/published/smooth.toml"))
        self.assertEqual(count, 1)
        self.folder.write("smooth.toml", scene + added)
        self.answered(SWEEPS)

    def test_how_many_readings_there_are(self):
        counted, = re.findall(r"There are ([\d\s]+) readings", run("reproduce", "--section", "ranking").out)
        for text in (COMMANDS, page("verification/README.md")):
            self.assertEqual([told.split() for told in re.findall(r"(?i)all ([\d\s]+) readings", text)], [counted.split()])

    def test_what_one_types_for_a_question(self):
        lines = [line for line in re.findall(r"(?m)^\| [^|]*\| `tribocheck ([^`]*)` \|", FIRST) if "my_solver" not in line]
        self.assertGreater(len(lines), 5)
        for line in lines:
            with self.subTest(line=line):
                for name, path in {"reference/": f"{ROOT}/reference/", " scene.toml": f" {self.scene}",
                                   "onset.h5": self.folder.path("onset.h5")}.items():
                    line = line.replace(name, path)
                done = run(*line.split()).ended(0)
                if self.scene in line:
                    self.assertEqual(done.err, "")

    def test_a_mistake(self):
        shown, = re.findall(r"```\n(tribocheck: bad\.toml.*\n)```", COMMANDS)
        bad = self.folder.write("bad.toml", pathlib.Path(self.scene).read_text(encoding="utf-8").replace(
            "[surface]", "[surface]\nsumit_radius = -1\n#"))
        done = run("solve", bad)
        self.assertEqual((done.code, done.err.replace(bad, "bad.toml")), (2, shown))

    def test_the_table_of_commands_has_all_of_them_with_their_formats(self):
        rows = dict(re.findall(r"(?m)^\| \[?`([\w-]+)`.*\| ([^|]*)\|$", COMMANDS))
        self.assertEqual(list(rows), [name for name, in subcommands()])
        for name, formats in rows.items():
            told = re.search(r"--format TEXT:\{(\S+)\}[^(]*\(default: (\w+)\)", run(name, "--help").out)
            self.assertEqual(re.findall(r"`(\w+)`", formats), told[1].split(",") if told else [], name)
            self.assertIn(told and told[2], [None, *re.findall(r"\w+", formats)[:1]])


class Outputs(unittest.TestCase):
    """The meaning of an output is one text, wherever it is told."""

    def test_the_readme_of_the_model_and_the_help_say_the_same(self):
        rows = re.findall(r"(?m)^\| `(\w+)` \| (?:m|Pa|–) \| (.*) \|$",
                          (ROOT / "model/README.md").read_text(encoding="utf-8").partition("### Outputs\n")[2])
        self.assertEqual(len(rows), 15)
        told = " ".join(run("solve", "--help").out.split())
        for name, meaning in rows:
            self.assertIn(f" {name} {meaning} ", told)
        self.assertIn("h₀", dict(rows)["film_flooded"])


if __name__ == "__main__":
    unittest.main()
