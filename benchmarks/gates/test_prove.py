# SPDX-License-Identifier: Apache-2.0
"""Tests prove.py on a made-up tree with planted changes: its builds, the restored files, and when a gate counts as proved."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import gate
import measure
import prove
import solver_rates

PLANT = {"id": "twice", "work": "each thing twice", "gates": ["counters"], "patch": [
    {"file": "a.hpp", "find": "once", "replace": "twice"}, {"file": "a.hpp", "find": "one", "replace": "two"}, {"file": "b.hpp", "find": "b", "replace": "bb"}]}
TEXTS = {"a.hpp": "once one\n", "b.hpp": "b\n"}


def verdict(name, of="counters"):
    made = gate.Verdict(of, lambda *_: None)
    made.compared = 7
    made.see(1.234567)
    made.red = ["root"] if name == "red" else []
    return made.skip("no valgrind") if name == "not held" else made


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Planted(Folder):
    def setUp(self):
        super().setUp()
        self.scratch = prove.Scratch.__new__(prove.Scratch)
        self.scratch.tree, self.scratch.build = self.folder / "tree", self.folder / "build"
        for folder in (self.scratch.tree, self.scratch.build):
            folder.mkdir()
        for name, text in TEXTS.items():
            (self.scratch.tree / name).write_text(text)

    def texts(self):
        return {name: (self.scratch.tree / name).read_text() for name in TEXTS}

    def test_the_program_is_built_with_all_patches_and_the_tree_is_as_before(self):
        def built(command, folder):
            self.assertEqual((self.texts(), folder), ({"a.hpp": "twice two\n", "b.hpp": "bb\n"}, self.scratch.tree))
            self.assertEqual(command[:5], ["cmake", "--build", self.scratch.build, "--target", prove.TARGET])
            (self.scratch.build / prove.TARGET).write_text("with the plant")
        with mock.patch.object(prove, "run", built):
            program = self.scratch.planted(PLANT)
        self.assertEqual((program.name, program.read_text()), (f"{prove.TARGET}-twice", "with the plant"))
        self.assertEqual(self.texts(), TEXTS)

    def test_a_text_that_does_not_stand_once_is_not_measured(self):
        for find, times in (("none", 0), ("o", 2)):
            stale = PLANT | {"patch": [PLANT["patch"][2], {"file": "a.hpp", "find": find, "replace": ""}]}
            with mock.patch.object(prove, "run"), self.assertRaisesRegex(measure.Unmeasured, f"twice: its text stands {times} times in a.hpp"):
                self.scratch.planted(stale)
            self.assertEqual(self.texts(), TEXTS)

    def test_a_build_that_fails_is_not_measured_and_tells_its_end(self):
        with self.assertRaisesRegex(measure.Unmeasured, "sh -c .*: no compiler"):
            prove.run(["sh", "-c", "echo no compiler; exit 1"], self.folder)
        self.assertEqual(prove.run(["pwd"], self.folder).strip(), str(self.folder.resolve()))

    def test_the_copy_has_what_git_lists_and_the_build_is_of_the_copy(self):
        asked = []

        def run(command, folder):
            asked.append((command, folder))
            return "tree/a.hpp\0gone.hpp\0" if command[0] == "git" else ""
        with mock.patch.object(prove, "run", run), mock.patch.object(measure, "ROOT", self.folder):
            made = prove.Scratch(self.folder / "copy")
        self.assertEqual([path.name for path in made.tree.rglob("*") if path.is_file()], ["a.hpp"])
        self.assertEqual((made.tree / "tree/a.hpp").read_text(), TEXTS["a.hpp"])
        self.assertEqual(asked[1][0][:5], ["cmake", "-S", made.tree, "-B", made.build])
        self.assertIn("-DCMAKE_BUILD_TYPE=Release", asked[1][0])


class Proved(Folder):
    def test_a_row_is_proved_where_the_verdict_is_the_expected_one(self):
        for expected in ("passed", "red"):
            for name in ("passed", "red", "not held"):
                row = prove.row(expected, verdict(name))
                self.assertEqual((row["proved"], row["expected"], row["verdict"]), (name == expected, expected, name))
                self.assertEqual((row["gate"], row["workloads"], row["greatest_ratio"], row["red"]), ("counters", 7, 1.2346, ["root"] if name == "red" else []))
                self.assertEqual(row.get("why"), "no valgrind" if name == "not held" else None)
        self.assertIsNone(prove.row("passed", gate.Verdict("time", print))["greatest_ratio"])

    def main(self, same, planted, *options):
        """The exit code and the ledger, given the verdicts of the gates on the same program and on each plant."""
        held = []

        def hold(gates, program, base, _):
            held.append((tuple(gates), str(program), str(base)))
            return {"counters": verdict(planted if "planted" in str(program) else same)}
        plants, out = self.folder / "plants.toml", self.folder / "gates.json"
        plants.write_text("".join(f'[[plant]]\nid = "{name}"\nwork = "more"\ngates = ["counters"]\npatch = [{{file = "{name}.hpp", find = "x", replace = "y"}}]\n'
                                  for name in ("one", "two")))
        with mock.patch.object(prove, "PLANTS", plants), mock.patch.object(gate, "hold", hold), mock.patch.object(prove, "Scratch") as scratch, \
                mock.patch.object(measure, "commit", lambda: "abc"), mock.patch.object(measure, "environment", lambda _: {"cpu": "c"}), \
                mock.patch.object(sys, "argv", ["prove.py", "program", "--out", str(out), *options]), contextlib.redirect_stdout(io.StringIO()) as said, \
                contextlib.redirect_stderr(io.StringIO()):
            scratch.return_value.planted = lambda plant: f"planted {plant['id']}"
            code = prove.main()
        return code, json.loads(out.read_text()), held, said.getvalue()

    def test_the_same_program_has_to_pass_and_each_plant_to_be_red(self):
        for same, planted, code in (("passed", "red", 0), ("red", "red", 1), ("passed", "passed", 1), ("not held", "red", 1), ("passed", "not held", 1)):
            got, ledger, held, said = self.main(same, planted)
            self.assertEqual(got, code, (same, planted))
            self.assertEqual(held, [(gate.GATES, "program", "program"), (("counters",), "planted one", "program"), (("counters",), "planted two", "program")])
            self.assertEqual(([one["verdict"] for one in ledger["same_program"]], [(one["id"], one["work"], one["files"], one["gates"][0]["verdict"]) for one in ledger["planted"]]),
                             ([same], [("one", "more", ["one.hpp"], planted), ("two", "more", ["two.hpp"], planted)]))
            self.assertEqual((ledger["commit"], ledger["environment"]["cpu"]), ("abc", "c"))
            self.assertEqual(said.count("NOT PROVED"), (same != "passed") + 2 * (planted != "red"))

    def test_one_plant_alone_can_be_asked_for(self):
        self.assertEqual([one["id"] for one in self.main("passed", "red", "--only", "two")[1]["planted"]], ["two"])

    def test_what_cannot_be_measured_is_exit_code_2(self):
        with mock.patch.object(gate, "hold", side_effect=measure.Unmeasured("it does not run")), mock.patch.object(sys, "argv", ["prove.py", "program"]), \
                contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(prove.main(), 2)
        self.assertEqual(said.getvalue(), "prove.py: it does not run\n")
        with mock.patch.object(sys, "argv", ["prove.py", "program", "--only", "typo"]), contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(prove.main(), 2)
        self.assertEqual(said.getvalue(), "prove.py: --only: typo is no plant of planted_work.toml\n")


class Rates(Folder):
    """Tests solver_rates.py with a made-up program. By the solver that it gets, the program fails (red), says "a little slower"
    (told), or passes (silent)."""

    ANSWERS = {"unchanged": (0, "PASSED, "), "slower_10": (0, "PASSED, a little slower"), "slower_25": (1, "FAILED, ")}

    def test_an_outcome_is_red_told_or_silent_and_anything_else_ends_the_run(self):
        for code, said, expected in ((1, "FAILED, a little slower", "red"), (0, "PASSED, a little slower", "told"), (0, "PASSED, ", "silent")):
            self.assertEqual(solver_rates.outcome(mock.Mock(returncode=code, stderr=said)), expected)
        for code, said in ((2, "FAILED, "), (0, "no solver")):
            with self.assertRaisesRegex(SystemExit, said):
                solver_rates.outcome(mock.Mock(returncode=code, stderr=said))

    def test_each_solver_is_asked_by_each_way_and_its_outcomes_are_counted(self):
        asked, out = [], self.folder / "rates.json"

        def run(words, **_):
            if words[0] == "cc" or words[1] == "--version":
                return mock.Mock(returncode=0, stdout="tribocheck 1 (commit abc, instruction set AVX2)\n")
            asked.append(words)
            if "--update-baseline" in words:
                return mock.Mock(returncode=0, stderr="")
            code, said = next(answer for name, answer in self.ANSWERS.items() if f"/{name}/" in " ".join(words[4:7]))
            return mock.Mock(returncode=code, stderr=said)
        argv = ["solver_rates.py", "tribocheck", "--runs", "10", "--ways", "subject,plugin,pair", "--out", str(out)]
        with mock.patch.object(sys, "argv", argv), mock.patch.object(solver_rates.subprocess, "run", run), \
                mock.patch.object(solver_rates.subprocess, "Popen") as busy, contextlib.redirect_stdout(io.StringIO()):
            solver_rates.main()
        found = json.loads(out.read_text())
        self.assertEqual(found["commit"], "abc")
        self.assertEqual([{key: row[key] for key in row if key != "load"} for row in found["rates"]],
                         [{"way": way, "state": state, "solver": solver, "runs": runs, "red": red, "told": told}
                          for way in ("subject", "plugin", "pair") for state in ("quiet", "loaded")
                          for solver, runs, red, told in (("unchanged", 10, 0, 0), ("slower_10", 2, 0, 2), ("slower_25", 10, 10, 0))])
        self.assertEqual((busy.call_count, busy.return_value.kill.call_count), (6, 6))
        self.assertEqual(len(asked), 3 * 2 * 22 + 2)
        for words in asked:
            way = "subject" if "--subject" in words else "plugin" if "--alone" in words else "pair"
            self.assertEqual(("--baseline" in words, words.count("--plugin")), (way != "pair", {"subject": 0, "plugin": 1, "pair": 2}[way]))


class Plants(unittest.TestCase):
    def test_each_text_of_planted_work_stands_once_in_its_file(self):
        for plant in prove.tomllib.loads(prove.PLANTS.read_text())["plant"]:
            for patch in plant["patch"]:
                self.assertEqual((measure.ROOT / patch["file"]).read_text().count(patch["find"]), 1, plant["id"])
            self.assertLessEqual(set(plant["gates"]), set(gate.GATES))


if __name__ == "__main__":
    unittest.main()
