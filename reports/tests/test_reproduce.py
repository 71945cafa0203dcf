# SPDX-License-Identifier: Apache-2.0
"""reproduce: the ledger of the paper's claims, its formats, and what a changed verdict does."""

import csv
import io
import os
import pathlib
import shutil
import unittest

from program import Folder, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
LEDGER = ROOT / "reference/baselines/ledger.csv"
CLAIMS = [f"C{i}" for i in range(1, 18)]


class ReproduceTest(unittest.TestCase):
    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.cleanup)

    def rows(self, *arguments):
        result = run("reproduce", "--format", "csv", *arguments)
        self.assertEqual((result.code, result.err), (0, ""))
        return list(csv.DictReader(io.StringIO(result.out)))

    def changed_ledger(self, change):
        with LEDGER.open() as file:
            rows = list(csv.DictReader(file))
        change(rows)
        text = io.StringIO()
        writer = csv.DictWriter(text, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        return self.folder.write("ledger.csv", text.getvalue())

    def test_no_verdict_changed_against_the_committed_ledger(self):
        result = run("reproduce")
        self.assertEqual((result.code, result.err), (0, ""))
        for claim in CLAIMS:
            self.assertIn(f"\n{claim} ", result.out)

    def test_json_holds_all_of_it(self):
        ledger = run("reproduce", "--format", "json").json()
        self.assertEqual([claim["claim"] for claim in ledger["claims"]], CLAIMS)
        self.assertEqual([one["erratum"] for one in ledger["errata"]],
                         [f"E{i}" for i in range(1, 26)])
        self.assertEqual(sum(ledger["ranking"]["readings_by_score"]), ledger["ranking"]["readings"])
        for item in ledger["items"]:
            for reading in ledger["readings"]:
                self.assertIn("verdict", item["readings"][reading["name"]])
        for section in ["arguments", "requirements", "uncertainty", "independent"]:
            self.assertTrue(ledger[section], section)

    def test_csv_agrees_with_onset_and_reads_back(self):
        rows = self.rows("--reading", "corrected")
        found = {row["item"]: row for row in rows}
        for surface in ["rough", "medium", "smooth"]:
            path = str(ROOT / f"reference/published/{surface}.toml")
            onset = run("onset", path, "--criterion", "film_maximum", "--format", "json").json()[0]
            self.assertAlmostEqual(float(found[f"C1.{surface}"]["computed"]) / onset["speed"], 1,
                                   delta=1e-12)
            factor = float(found[f"C1.{surface}"]["computed"]) / float(found[f"C1.{surface}"]["reported"])
            self.assertEqual(float(found[f"C1.{surface}"]["factor"]), factor)

    def test_a_claim_is_shown_with_what_would_have_to_be_true(self):
        result = run("reproduce", "--claim", "C1")
        self.assertEqual(result.code, 0)
        self.assertIn("abstract; conclusion", result.out)
        self.assertIn("viscosity", result.out)
        self.assertNotIn("C17", result.out.replace("C17\n", "").split("\n\n")[0])
        self.assertEqual({row["claim"] for row in self.rows("--claim", "C1", "--claim", "C4")},
                         {"C1", "C4"})

    def test_a_reading_of_ones_own_is_a_column(self):
        rows = self.rows("--reading", "speed=sum", "--reading", "corrected", "--claim", "C1")
        speed = {(row["reading"], row["item"]): float(row["computed"]) for row in rows}
        # The sum for the mean doubles U, as doubling the speed would.
        for surface in ["rough", "medium", "smooth"]:
            ratio = speed["corrected", f"C1.{surface}"] / speed["speed=sum", f"C1.{surface}"]
            self.assertAlmostEqual(ratio, 2, delta=1e-12)

    def test_a_changed_verdict_is_named_and_exits_with_1(self):
        def change(rows):
            rows[0]["verdict"] = "reproduced"
        result = run("reproduce", "--ledger", self.changed_ledger(change), "--format", "csv")
        self.assertEqual(result.code, 1)
        self.assertEqual(len(result.err.splitlines()), 1)
        self.assertIn("verdict changed: C1.rough, corrected: was reproduced", result.err)
        self.assertTrue(result.out)

    def test_a_moved_number_is_named_and_exits_with_0(self):
        def change(rows):
            rows[0]["computed"] = "2.2"
        result = run("reproduce", "--ledger", self.changed_ledger(change), "--format", "csv")
        self.assertEqual(result.code, 0)
        self.assertIn("number moved: C1.rough, corrected: was 2.2, is 2.09", result.err)

    def test_another_best_reading_is_a_changed_verdict(self):
        def change(rows):
            for row in rows:
                if row["reading"] == "best 1":
                    row["departures"] = "speed=sum"
        result = run("reproduce", "--ledger", self.changed_ledger(change))
        self.assertEqual(result.code, 1)
        self.assertIn("verdict changed: best 1: was speed=sum, is ", result.err)

    def test_a_changed_input_changes_a_verdict(self):
        folder = pathlib.Path(self.folder.path("published"))
        shutil.copytree(ROOT / "reference/published", folder)
        for name in ["rough", "medium", "smooth", "smooth_gw"]:
            scene = folder / f"{name}.toml"
            scene.write_text(scene.read_text().replace("inlet_film_ratio = 4 ", "inlet_film_ratio = 3 "))
        result = run("reproduce", "--published", str(folder))
        self.assertEqual(result.code, 1)
        self.assertIn("verdict changed: C2.rough, corrected: was reproduced", result.err)

    def test_markdown_has_every_section_when_asked(self):
        result = run("reproduce", "--section", "all", "--format", "markdown")
        self.assertEqual(result.code, 0)
        for text in ["The claims under", "The switches", "What each item tells apart", "How sure",
                     "The misprints", "beside another library", "C1 as a departure"]:
            self.assertIn(text, result.out)

    def test_bad_usage_gets_one_line_and_exits_with_2(self):
        missing = self.folder.path("none")
        for arguments, words in [
                (["--reading", "inlet=floods"], ["inlet: floods is not one of flooded_inlet"]),
                (["--reading", "inlets=as_printed"], ["inlets: no such switch", "inlet="]),
                (["--reading", "speed=sum,"], ["no such switch"]),
                (["--claim", "C18"], ["--claim: C18 is not one of C1"]),
                (["--section", "claim"], ["--section"]),
                (["--format", "xml"], ["--format"]),
                (["--published", missing], [missing]),
                (["--ledger", missing], [missing, "cannot be read"])]:
            result = run("reproduce", *arguments)
            self.assertEqual(result.code, 2, arguments)
            self.assertEqual(len(result.err.splitlines()), 1, result.err)
            for word in words:
                self.assertIn(word, result.err)

    def test_a_broken_data_file_is_named(self):
        folder = pathlib.Path(self.folder.path("published"))
        shutil.copytree(ROOT / "reference/published", folder)
        for name, old, new, words in [
                ("claims.tsv", "\tnumber\t", "\tnumbers\t", ["C1.rough", "numbers is no rule"]),
                ("errata.tsv", "E25\t", "E26\t", ["E26", "nothing computes this erratum"]),
                ("inputs.tsv", "viscosity\tall", "viscous\tall", ["viscous is no input"]),
                ("independent.tsv", "801694948.59", "much", ["much is no number"])]:
            path = folder / name
            good = path.read_text()
            path.write_text(good.replace(old, new, 1))
            result = run("reproduce", "--published", str(folder))
            self.assertEqual(result.code, 2, name)
            self.assertEqual(len(result.err.splitlines()), 1, result.err)
            for word in [str(path)] + words:
                self.assertIn(word, result.err)
            path.write_text(good)


if __name__ == "__main__":
    unittest.main()
