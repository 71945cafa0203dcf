# SPDX-License-Identifier: Apache-2.0
"""Tests plant.py with a small catalogue of this test: faults that cannot be planted, faults that survive, and faults that count as caught."""
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import plant

FAULT = {"id": "one", "fault": "1 is 2", "file": "formula.txt", "find": "= 1;", "replace": "= 2;",
         "check": "program.test_formula"}
GREEN = '<testsuite><testcase name="program.test_formula" status="{}" time="1.5"/></testsuite>'


def finished(code, text=""):
    return subprocess.CompletedProcess([], code, text)


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "formula.txt").write_text("y = 1;\n")
        self.green = self.folder / "green.xml"
        self.green.write_text(GREEN.format("run"))
        root = mock.patch.object(plant, "ROOT", self.folder)
        root.start()
        self.addCleanup(root.stop)


class Stale(Tree):
    def test_a_text_that_stands_once_is_not(self):
        self.assertIsNone(plant.stale(FAULT))

    def test_a_text_that_stands_twice_or_never_is(self):
        self.assertIn("0 times", plant.stale(FAULT | {"find": "= 3;"}))
        (self.folder / "formula.txt").write_text("y = 1; z = 1;\n")
        self.assertIn("2 times", plant.stale(FAULT))

    def test_a_file_that_is_not_there_is(self):
        self.assertIn("is not there", plant.stale(FAULT | {"file": "none.txt"}))


class Targets(unittest.TestCase):
    """The build targets that a check needs, in the real tree."""

    def test_of_each_kind_of_check(self):
        for check, targets in (("program.test_solve", ["tribocheck", "verification/conformance/subjects/all"]),
                               ("gates.work_counters", ["tribocheck_gate_kernels"]),
                               ("gates.test_rules", []),
                               ("support.Judge.PassesInsideTheBoundAndFailsOutside", ["judge_test"]),
                               ("inventory:support.Judge.PassesInsideTheBoundAndFailsOutside", ["judge_test"])):
            self.assertEqual(plant.targets_of(check), targets)

    def test_of_every_fault_of_the_catalogue_are_found(self):
        for fault in plant.read_catalogue():
            with self.subTest(fault["id"]):
                plant.targets_of(fault["check"])

    def test_a_check_that_no_source_has_ends_the_run(self):
        with self.assertRaises(SystemExit):
            plant.targets_of("support.Judge.DoesNothingOfTheKind")


class Look(Tree):
    """The verdict on a fault, given the result of CTest."""

    def look(self, check, *ends):
        scratch = plant.Scratch.__new__(plant.Scratch)
        scratch.build = scratch.tree = self.folder
        with mock.patch.object(plant, "run", side_effect=[finished(*end) for end in ends]):
            return scratch.look(check)

    def assert_red(self, words, check, *ends):
        with self.assertRaisesRegex(plant.Red, words):
            self.look(check, *ends)

    def test_a_check_that_fails_or_runs_out_of_time_has_caught_it(self):
        self.assertEqual(self.look("program.test_formula", (8, "***Failed")), "failed")
        self.assertEqual(self.look("program.test_formula", (8, "***Timeout")), "timed out")

    def test_a_check_has_the_more_time_the_longer_it_takes_without_a_fault(self):
        fault = {"file": "text.py", "find": "right", "replace": "wrong", "check": "program.test_formula"}
        (self.folder / "text.py").write_text("right")
        scratch = plant.Scratch.__new__(plant.Scratch)
        scratch.build = scratch.tree = self.folder
        for took, seconds in ((0, "180"), (30, "180"), (40, "240")):
            with mock.patch.object(plant, "run", side_effect=[finished(0, ""), finished(8, "***Failed")]) as ran:
                self.assertEqual(scratch.try_fault(fault, took), "failed")
            command = ran.call_args.args[0]
            self.assertEqual(command[command.index("--timeout") + 1], seconds)
        self.assertEqual((self.folder / "text.py").read_text(), "right")

    def test_a_check_that_passes_or_is_not_there_has_not(self):
        self.assert_red("survived", "program.test_formula", (0, "Passed"))
        self.assert_red("not there to run", "program.test_formula", (0, "No tests were found!!!"))

    def test_the_inventory_has_to_be_red_of_a_test_that_is_green(self):
        self.assertEqual(self.look("inventory:program.test_formula", (0, ""), (1, "9 cases\nmore")), "9 cases")
        self.assert_red("survived", "inventory:program.test_formula", (0, ""), (0, ""))
        self.assert_red("itself failed", "inventory:program.test_formula", (8, ""), (1, ""))


class OfMutants(Tree):
    """Mutants that the ledger of mutants lists as caught are planted in an overlay on the built tree."""

    def above(self, *ends):
        layer, seen = plant.Above(self.folder / "layer"), []

        def inside(*command):
            seen.append(command[0])
            self.assertEqual((self.folder / "layer/upper/formula.hpp").read_text(), "y = 2;\n")
            return finished(*ends[len(seen) - 1])
        (self.folder / "formula.hpp").write_text("y = 1;\n")
        with mock.patch.object(layer, "inside", inside), mock.patch.object(plant, "targets_of", return_value=["formula_test"]):
            try:
                return layer.try_fault(FAULT | {"file": "formula.hpp"}), seen
            finally:
                self.assertFalse((self.folder / "layer").exists())
                self.assertEqual((self.folder / "formula.hpp").read_text(), "y = 1;\n")

    def test_a_red_test_has_caught_it_and_a_green_one_has_not(self):
        red, green = (f"100% tests passed, {failed} tests failed out of 1" for failed in (1, 0))
        self.assertEqual(self.above((0, ""), (8, red)), ("failed", ["ninja", "ctest"]))
        self.assertEqual(self.above((0, ""), (8, "***Timeout\n" + red)), ("timed out", ["ninja", "ctest"]))
        with self.assertRaisesRegex(plant.Red, "survived"):
            self.above((0, ""), (0, green))
        with self.assertRaisesRegex(plant.Red, "does not build"):
            self.above((1, ""))

    def test_a_command_that_cannot_be_started_in_the_layer_has_caught_nothing(self):
        with self.assertRaisesRegex(SystemExit, "unshare: operation not permitted"):
            self.above((0, ""), (1, "unshare: operation not permitted"))

    def planted(self, compiled, tested):
        """The number of mutants planted of ten asked for, out of thirty; `compiled` and `tested` are the seconds that each takes."""
        built = mock.Mock(seconds=lambda file, targets: compiled)
        faults = [FAULT | {"id": str(i), "file": "formula.hpp"} for i in range(30)]
        with mock.patch.object(plant.Above, "try_fault", lambda *_: "failed"), contextlib.redirect_stdout(io.StringIO()):
            return len(plant.plant_above(faults, 10, "x", self.folder, {FAULT["check"]: tested}, 2, built))

    def test_those_that_take_more_than_twice_their_share_of_the_time_are_passed_over(self):
        share = plant.MOST_SECONDS / 10
        for compiled, tested, planted in ((share / 2, share / 2, 10), (share, share, 1), (share, share + 1, 0), (2 * share + 1, 0, 0)):
            self.assertEqual(self.planted(compiled, tested), planted, (compiled, tested))

    def test_what_reads_a_file_is_compiled_again_as_far_as_it_is_needed(self):
        (self.folder / ".ninja_log").write_text("# ninja log v5\n0\t1000\t1\told.o\tx\n10\t9010\t1\told.o\tx\n5\t6\t1\tcached.o\tx\n")
        deps = "old.o: #deps 2, deps mtime 1 (VALID)\n    /t/a.hpp\n    /t/b.hpp\n\n" + "".join(
            f"{name}: #deps 1, deps mtime 1 (VALID)\n    {file}\n\n" for name, file in
            (("cached.o", "/t/a.hpp"), ("new.o", os.path.relpath("/t/b.hpp", self.folder)), ("other.o", "/t/b.hpp"), ("x/pch.gch", "/t/c.hpp"),
             ("verification/tests/CMakeFiles/t.o", "/t/d.cpp")))
        needed = "old.o\ncached.o\nnew.o\nx/pch.gch\nverification/tests/CMakeFiles/t.o\nlib.a\n"
        with mock.patch.object(plant, "run", lambda command: finished(0, needed if "inputs" in command else deps)):
            built = plant.Built(self.folder)
            for file, seconds in (("a.hpp", 9 + plant.COMPILED_AT_LEAST), ("b.hpp", 9 + plant.COMPILED_AT_MOST),
                                  ("c.hpp", 2 * plant.COMPILED_AT_MOST), ("d.cpp", plant.COMPILED_AT_MOST), ("e.hpp", 0)):
                self.assertEqual(built.seconds("/t/" + file, ["it"]), seconds, file)

    def test_a_mutant_that_brings_in_a_member_which_is_gone_is_passed_over(self):
        for replace, lost in (("a.there", None), ("a.gone", "gone"), ("a->gone + b.there", "gone"), ("gone + 1", None), ("a.old", None)):
            self.assertEqual(plant.lost_member({"find": "a.old", "replace": replace}, {"there"}), lost, replace)

    def test_only_what_is_called_caught_is_planted_and_what_changed_since_is_not(self):
        row = {"id": "m", "operator": "constant", "original": "1", "replacement": "2", "file": "formula.txt", "find": "= 1;", "replace": "= 2;",
               "by": "program.test_formula"}
        text = json.dumps({"samples": [{"mutants": [{**row, "verdict": "caught"}, {**row, "verdict": "survived"}, row]}]})
        one, = plant.caught_mutants(text)
        self.assertEqual(one | {"fault": ""}, FAULT | {"id": "m", "fault": ""})
        for content, has_layer, code in (("y = 1;\n", True, 0), ("y = 3;\n", True, 1), ("y = 1;\n", False, plant.NO_LAYER)):
            (self.folder / "formula.txt").write_text(content)
            (self.folder / "mutants.json").write_text(text)
            with mock.patch.object(plant, "MUTANTS", self.folder / "mutants.json"), mock.patch.object(plant, "commit", return_value="c"), \
                    mock.patch.object(plant.Above, "try_fault", lambda *_: "failed"), mock.patch.object(plant, "Built"), \
                    mock.patch.object(plant.Above, "can_be", return_value=has_layer), \
                    mock.patch.object(sys, "argv", ["plant.py", "--mutants", "1", "--green", str(self.green)]), \
                    contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                self.assertEqual(plant.main(), code)


class InstructionSets(unittest.TestCase):
    """A kernel's text for one instruction set alone is tested on that set."""
    TEXT = """#if defined(X) == defined(HWY_TARGET_TOGGLE)
#else
#endif
all
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
avx512
#elif HWY_TARGET == HWY_AVX2
avx2
#else
plain
#endif
#if HWY_TARGET != HWY_SCALAR
vector
#endif
#if HWY_NATIVE_FMA
fused
#else
apart
#endif
"""
    RUN_ON = {"all": "325", "avx512": "3", "avx2": "2", "plain": "5", "vector": "325", "fused": "32", "apart": "5"}
    NAMES = {"3": "HWY_AVX3", "2": "HWY_AVX2", "5": "HWY_SSE4"}

    def test_a_text_is_run_where_its_branch_is_taken(self):
        for word, sets in self.RUN_ON.items():
            for short, name in self.NAMES.items():
                self.assertEqual(plant.runs_on(self.TEXT, self.TEXT.index(f"\n{word}\n") + 1, name), short in sets, (word, name))

    def test_the_best_set_that_the_machine_has_is_asked(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(plant, "ROOT", pathlib.Path(folder)):
            (plant.ROOT / "a-inl.hpp").write_text(self.TEXT)
            (plant.ROOT / "a.hpp").write_text(self.TEXT)
            for here in ("325", "25", "5"):
                for word, sets in self.RUN_ON.items():
                    mutant = {"file": "a-inl.hpp", "find": f"\n{word}\n", "replace": f"\n{word[:1]}!\n"}
                    with mock.patch.object(plant, "instruction_sets_here", lambda here=here: [self.NAMES[one] for one in here]):
                        best = next((self.NAMES[one] for one in here if one in sets), None)
                        self.assertEqual(plant.instruction_set_for(mutant), best, (here, word))
                        self.assertEqual(plant.instruction_set_for(mutant | {"file": "a.hpp"}), self.NAMES[here[0]])


class LayerOfAnInstructionSet(Tree):
    def test_commands_in_the_layer_run_without_the_better_sets(self):
        (self.folder / "a-inl.hpp").write_text(InstructionSets.TEXT)
        for word, tunables in (("avx512", None), ("avx2", "glibc.cpu.hwcaps=-AVX512F"), ("apart", "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA")):
            layer, asked = plant.Above(self.folder / "layer"), []
            with mock.patch.object(plant, "instruction_sets_here", lambda: list(plant.INSTRUCTION_SETS)), mock.patch.dict(plant.os.environ), \
                    mock.patch.object(plant, "run", lambda command, env: asked.append(env.get("GLIBC_TUNABLES"))):
                plant.os.environ.pop("GLIBC_TUNABLES", None)
                with layer.planted({"file": "a-inl.hpp", "find": f"\n{word}\n", "replace": "\n!\n"}):
                    layer.inside("ctest")
            self.assertEqual(asked, [tunables], word)


class Try(Tree):
    def test_the_file_is_whole_again_whatever_comes_of_it(self):
        scratch = plant.Scratch.__new__(plant.Scratch)
        scratch.tree = self.folder
        seen = []

        def make(targets):
            seen.append((targets[0], (self.folder / "formula.txt").read_text()))
            raise plant.Red("does not build")
        scratch.make = make
        with self.assertRaises(plant.Red):
            scratch.try_fault(FAULT)
        self.assertEqual(seen, [("tribocheck", "y = 2;\n")])
        self.assertEqual((self.folder / "formula.txt").read_text(), "y = 1;\n")


class Ledger(Tree):
    """The ledger keeps the last verdict on each fault, even if the run is stopped. It drops the verdict on a fault that has changed."""
    CATALOGUE = [FAULT, FAULT | {"id": "two"}, FAULT | {"id": "three"}]

    def ledger(self):
        return plant.Ledger(self.folder / "ledger.json", self.CATALOGUE)

    def row(self, name, said="failed"):
        return {"id": name, "caught": said == "failed", "said": said, "seconds": 1}

    def leave(self, **dates):
        """Writes a ledger that has one verdict for each fault named, with its date."""
        rows = [self.row(name) | {"digest": plant.digest(FAULT), "commit": f"of {name}", "date": date}
                for name, date in dates.items()]
        (self.folder / "ledger.json").write_text(json.dumps({"faults": rows}))

    def test_it_is_written_after_each_fault_and_read_again(self):
        self.ledger().add(self.row("two"), "first")
        self.ledger().add(self.row("one", "survived"), "second")
        self.ledger().add(self.row("two", "survived"), "third")
        kept = json.loads((self.folder / "ledger.json").read_text())
        self.assertEqual([(row["id"], row["said"], row["commit"]) for row in kept["faults"]],
                         [("one", "survived", "second"), ("two", "survived", "third")])
        self.assertEqual(kept["catalogue"], 3)

    def test_its_commit_and_date_are_those_of_the_oldest_verdict(self):
        self.leave(one="2000-01-01T10:00", gone="1999-01-01")
        self.ledger().add(self.row("two"), "new")
        kept = json.loads((self.folder / "ledger.json").read_text())
        self.assertEqual((kept["commit"], kept["date"]), ("of one", "2000-01-01"))
        self.assertEqual([row["commit"] for row in kept["faults"]], ["of one", "new"])

    def test_a_verdict_on_a_fault_that_has_changed_is_dropped(self):
        for field in ("file", "find", "replace", "check"):
            self.leave(one="2000-01-01", two="2000-01-01")
            changed = [FAULT | {field: "another"}, *self.CATALOGUE[1:]]
            ledger = plant.Ledger(self.folder / "ledger.json", changed)
            self.assertEqual(list(ledger.rows), ["two"], field)
            self.assertEqual(ledger.oldest(changed, 1)[0]["id"], "one")
            ledger.add(self.row("three"), "new")
            kept = json.loads((self.folder / "ledger.json").read_text())
            self.assertEqual([row["id"] for row in kept["faults"]], ["two", "three"], field)

    def test_a_verdict_stays_where_only_the_words_for_the_fault_have_changed(self):
        self.leave(one="2000-01-01")
        said_otherwise = [FAULT | {"fault": "2 in place of 1"}, *self.CATALOGUE[1:]]
        self.assertEqual(list(plant.Ledger(self.folder / "ledger.json", said_otherwise).rows), ["one"])

    def test_what_was_never_planted_comes_first_and_then_what_is_oldest(self):
        self.leave(one="2000-01-01", two="1999-01-01")
        chosen = self.ledger().oldest(self.CATALOGUE, 2)
        self.assertEqual([fault["id"] for fault in chosen], ["three", "two"])

    def test_without_a_file_nothing_is_kept(self):
        ledger, before = plant.Ledger(None, self.CATALOGUE), set(self.folder.rglob("*"))
        ledger.add(self.row("one"), "new")
        self.assertEqual((ledger.rows, set(self.folder.rglob("*"))), ({}, before))


class Main(Tree):
    """The exit code of plant.py, which builds nothing here."""

    def main(self, said, *faults):
        def row(fault):
            return {"id": fault["id"], "check": fault["check"], "caught": said != "survived", "said": said,
                    "seconds": 1}
        with mock.patch.object(plant, "read_catalogue", lambda: list(faults or [FAULT])), \
                mock.patch.object(plant, "commit", lambda: "0"), \
                mock.patch.object(plant, "plant", lambda faults, *_: [row(fault) for fault in faults]), \
                mock.patch.object(sys, "argv", ["plant.py", "--green", str(self.green)]), \
                contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            return plant.main()

    def test_all_caught_is_0_and_a_survivor_1(self):
        self.assertEqual(self.main("failed"), 0)
        self.assertEqual(self.main("survived"), 1)

    def test_a_fault_that_does_not_apply_is_1(self):
        self.assertEqual(self.main("failed", FAULT | {"find": "= 3;"}), 1)

    def test_a_check_that_did_not_pass_without_the_fault_is_1(self):
        for status in ("fail", "notrun", "disabled"):
            self.green.write_text(GREEN.format(status))
            self.assertEqual(self.main("failed"), 1, status)

    def test_without_a_run_to_go_by_it_is_2(self):
        self.green.unlink()
        self.assertEqual(self.main("failed"), 2)


if __name__ == "__main__":
    unittest.main()
