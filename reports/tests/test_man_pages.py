# SPDX-License-Identifier: Apache-2.0
"""Man pages and the completion for bash, made of --help: nothing is missing, and man and bash can read them."""

import gzip
import json
import os
import re
import subprocess
import sys
import unittest

from program import PROGRAM, folder_until, run
from test_usage import COMMANDS, ROOT

FORMS = [[], *[[command] for command in COMMANDS], ["plugin-host"], ["sweep", "merge"], ["sweep", "show"], ["sweep", "diff"]]


def options_of(command):
    return re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", run(*command, "--help").out)


class ManPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = folder_until(cls.addClassCleanup)
        subprocess.run([sys.executable, "-B", ROOT / "reports/bindings/packages/man_pages.py", PROGRAM, cls.folder], check=True,
                       env={**os.environ, "SOURCE_DATE_EPOCH": "86400"})
        cls.pages = {path.name.removesuffix(".gz"): gzip.decompress(path.read_bytes()).decode() for path in cls.folder.glob("man/man?/*")}

    def completed(self, *words):
        """What bash proposes for the last word."""
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _tribocheck "$1"; '
                  '[ ${#COMPREPLY[@]} = 0 ] || printf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "-c", script, "bash", self.folder / "completions/tribocheck", PROGRAM, *words],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout.splitlines()

    def test_each_option_of_each_help_is_in_the_man_page_and_in_the_completion(self):
        self.assertEqual({f"{name}.1" for name in ("-".join(["tribocheck", *form]) for form in FORMS)},
                         {*self.pages} - {"tribocheck-functions.7", "tribocheck_sweep.1"})
        for form in FORMS:
            page = self.pages["-".join(["tribocheck", *form]) + ".1"].replace("\\-", "-")
            options = options_of(form)
            self.assertIn("--help", options)
            for option in options:
                self.assertRegex(page, rf"(?m)^\\fB(-\w, )?{option}\\fR", form)
            self.assertEqual({*options}, {name for name in self.completed(*form, "-") if name.startswith("--")}, form)

    def test_man_renders_each_page_without_a_warning_and_with_all_its_words(self):
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "80"}
        for name in self.pages:
            path = self.folder / f"man/man{name[-1]}/{name}.gz"
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", path], cwd=self.folder / "man",
                                  env=environment, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, b""), name)
        shown = subprocess.run(["man", "-l", self.folder / "man/man1/tribocheck-sweep.1.gz"], env=environment, capture_output=True, text=True).stdout
        for words in ("log_normal", "--shard TEXT", "{table,csv,json}", "sweep SWEEP.toml -o SWEEP.h5", "1970-01-02"):
            self.assertIn(words, shown)
        self.assertEqual([line for line in shown.splitlines() if len(line) > 80 and " /usr/share/" not in line], [])

    def test_each_function_of_the_catalogue_has_its_part_with_every_argument(self):
        page = self.pages["tribocheck-functions.7"].replace("\\-", "-")
        functions = json.loads(run("functions", "--format", "json").out)["functions"]
        self.assertGreater(len(functions), 20)
        for function in functions:
            part = page.partition(f"\n.SS {function['name']}\n")[2].partition("\n.S")[0]
            for row in (*function["parameters"], *function["results"]):
                self.assertIn(f"\n\\fB{row['name']}\\fR [{row['unit'] or '-'}]\n", part, function["name"])
        self.assertEqual(self.completed("functions", ""), [function["name"] for function in functions])

    def test_the_completion_knows_commands_and_the_words_of_an_option(self):
        for words, proposed in ((["so"], ["solve"]), (["solve", "--format", ""], ["table", "csv", "json"]), (["solve", "--ab"], ["--about"]),
                                (["solve", "--format", "=", "c"], ["csv"]), (["sweep", "sh"], ["show"]), (["verify", "--modulus", "b"], ["bodies"]),
                                (["sweep", "diff", "--mo"], ["--most"]), (["init", "s"], ["subject"]), (["solve", "sc"], [])):
            self.assertEqual(self.completed(*words), proposed, words)


if __name__ == "__main__":
    unittest.main()
