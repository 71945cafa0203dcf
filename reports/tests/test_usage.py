# SPDX-License-Identifier: Apache-2.0
"""Help, version and exit codes of every command."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, SWEEP_PROGRAM, Folder, run, scene

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])


def commands_in(text):
    """The commands that a help text lists."""
    return re.findall(r"(?m)^  ([a-z]+) ", text.partition("\nSubcommands:\n")[2].partition("\n\n")[0])


# Every command that the program says it has.
COMMANDS = commands_in(run("--help").out)


class Help(unittest.TestCase):
    def test_every_command_has_help_with_an_example(self):
        for arguments in [[], *[[command] for command in COMMANDS]]:
            for flag in ["--help", "-h"]:
                with self.subTest(arguments=arguments, flag=flag):
                    result = run(*arguments, flag).ended(0, "")
                    self.assertIn("Usage: tribocheck", result.out)
                    self.assertIn("Example:\n", result.out)

    def test_help_fits_80_columns_but_for_examples_and_long_words(self):
        for arguments in [[], *[[command] for command in COMMANDS], ["init", "subject"], ["sweep", "show"],
                          ["sweep", "merge"], ["sweep", "diff"]]:
            text, _, _ = run(*arguments, "--help").out.partition("\nExample:\n")
            self.assertEqual([line for line in text.splitlines() if len(line) > 80 and len(line.split()) > 1], [],
                             arguments)

    def test_help_of_the_program_names_every_command(self):
        for command in ["contact", "solve", "curve", "onset", "film", "stream"]:
            self.assertIn(command, COMMANDS)

    def test_every_command_tells_the_version(self):
        for arguments in [[], *[[command] for command in COMMANDS]]:
            with self.subTest(arguments=arguments):
                result = run(*arguments, "--version").ended(0, "")
                self.assertRegex(result.out, r"^tribocheck \d+\.\d+\.\d+ \(commit ([0-9a-f]{40}(-dirty)?|unknown), "
                                 r"instruction set [A-Z]+[0-9A-Z_]*\)\n$")

    def test_the_citation_and_the_list_of_changes_have_the_programs_version(self):
        version = run("--version").out.split()[1]
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text())
        self.assertIn(f"\n## {version}", (ROOT / "CHANGELOG.md").read_text())


class Start(unittest.TestCase):
    def test_only_sweeps_load_hdf5_and_mpi(self):
        loaded = {program: re.findall(r"(?m)^\s+lib(\w+)", subprocess.run(["ldd", program], capture_output=True, text=True).stdout)
                  for program in (PROGRAM, SWEEP_PROGRAM)}
        self.assertIn("hdf5_serial", loaded[SWEEP_PROGRAM])
        self.assertIn("fmt", loaded[PROGRAM])
        self.assertEqual([one for one in loaded[PROGRAM] if one.startswith(("hdf5", "mpi", "curl", "ssl", "z"))], [])

    def test_without_the_program_of_sweeps_one_line_says_where_it_belongs(self):
        folder = Folder()
        self.addCleanup(folder.cleanup)
        alone = shutil.copy(PROGRAM, folder.path("tribocheck"))
        done = subprocess.run([alone, "sweep", "--help"], env=ENVIRONMENT, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, "tribocheck: the program tribocheck_sweep is not there; it is built and installed "
                                      "with this one, and has to be in the same folder\n")
        pathlib.Path(folder.path("tribocheck_sweep")).write_text("no program\n")
        done = subprocess.run([alone, "sweep"], env=ENVIRONMENT, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, r"^tribocheck: .*/tribocheck_sweep cannot be started: Permission denied\n$")


class BadUsage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Folder()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.file = cls.folder.write("rough.toml", scene())

    def assert_refused(self, *arguments):
        with self.subTest(arguments=arguments):
            result = run(*arguments)
            self.assertEqual((result.code, result.out), (2, ""))
            self.assertEqual(len(result.error_lines), 1, result.err)
            self.assertTrue(result.err.startswith("tribocheck: "), result.err)

    def test_without_or_with_an_unknown_command(self):
        self.assert_refused()
        self.assert_refused("solv")
        self.assert_refused("--bogus")

    def test_a_misspelt_command_is_told_with_the_one_that_is_meant(self):
        for word, meant in [("slove", "solve"), ("Onset", "onset"), ("reproduc", "reproduce"),
                            ("reprot", "report"), ("sweeps", "sweep")]:
            for more in [[], [self.file], ["--help"]]:
                with self.subTest(word=word, more=more):
                    result = run(word, *more)
                    self.assertEqual((result.code, result.out), (2, ""))
                    self.assertEqual(result.err, f'tribocheck: unknown command "{word}"; '
                                                 f"did you mean {meant}?\n")

    def test_another_word_and_no_word_are_told_with_all_commands(self):
        for arguments, what in [([], "no command is given"), (["foo"], 'unknown command "foo"'),
                                (["--bogus", "solve"], 'unknown option "--bogus"')]:
            self.assert_refused(*arguments)
            result = run(*arguments)
            self.assertIn(what, result.err)
            for command in COMMANDS:
                self.assertIn(f" {command}", result.err)

    def test_a_misspelt_subcommand_of_sweep(self):
        for word, meant in [("shwo", "show"), ("mrege", "merge"), ("merg", "merge")]:
            for more in [[], ["a.h5"], ["a", "b", "-o", "c"]]:
                self.assert_refused("sweep", word, *more)
                self.assertIn(f'unknown command "sweep {word}", and there is no such file; '
                              f"did you mean sweep {meant}?", run("sweep", word, *more).err)
        result = run("sweep", "no_such.toml", "-o", self.folder.path("x.h5"))
        self.assertEqual((result.code, result.err.count("\n")), (2, 1))
        self.assertIn("no_such.toml: cannot be read", result.err)

    def test_a_sweep_may_be_called_nearly_like_a_subcommand(self):
        self.folder.write("shwo", scene())
        self.assertIn("shwo: nothing varies", run("sweep", "shwo", "-o", "x.h5", cwd=self.folder.name).ended(2).err)

    def test_scenes_are_needed(self):
        for command in ["contact", "solve", "curve", "onset", "film"]:
            self.assert_refused(command)
            self.assert_refused(command, "")

    def test_bad_options(self):
        for command in ["contact", "solve", "curve", "onset", "film"]:
            self.assert_refused(command, self.file, "--format", "xml")
            self.assert_refused(command, self.file, "--format")
            self.assert_refused(command, self.file, "--format", "csv", "--format", "json")
            self.assert_refused(command, self.file, "--bogus")
        self.assert_refused("stream", self.file)
        self.assert_refused("onset", self.file, "--criterion", "film_minimum")

    def test_departure_is_between_0_and_1(self):
        for value in ["0", "1", "-0.1", "2", "nan", "inf", "1e400", "1e-400", "", "0.1x", "0,1"]:
            self.assert_refused("onset", self.file, "--departure", value)

    def test_stdin_only_once(self):
        self.assert_refused("solve", "-", "-")

    def test_a_file_may_be_called_like_a_command_or_in_brackets(self):
        for name in ["curve", "[a,b]"]:
            self.folder.write(name, scene(id=None))
            run("solve", name, "--format", "csv", cwd=self.folder.name).ended(0, "")

    def test_control_signs_of_an_argument_do_not_reach_the_terminal(self):
        result = run("solve", self.file, "--format", "\x1b[31m\n")
        self.assertEqual(len(result.error_lines), 1)
        self.assertNotIn("\x1b", result.err)


if __name__ == "__main__":
    unittest.main()
