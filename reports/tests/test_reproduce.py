# SPDX-License-Identifier: Apache-2.0
"""reproduce: the ledger of the paper's claims, its formats, and the effect of a changed verdict."""

import csv
import fcntl
import functools
import io
import os
import pathlib
import re
import shutil
import struct
import termios
import unittest

import page_tables
from program import ProgramTest, read_terminal, run, start

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
LEDGER = ROOT / "reference/baselines/ledger.csv"
CLAIMS = [f"C{i}" for i in range(1, 18)]


@functools.cache
def reproduced(*arguments):
    """The output of reproduce, computed once for all tests; it takes a second or two."""
    return run("reproduce", *arguments)


class ReproduceTest(ProgramTest):
    def rows(self, *arguments):
        return reproduced("--format", "csv", *arguments).ended(0, "").rows()

    def changed_ledger(self, change):
        with LEDGER.open() as file:
            rows = list(csv.DictReader(file))
        change(rows)
        text = io.StringIO()
        writer = csv.DictWriter(text, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        return self.folder.write("ledger.csv", text.getvalue())

    def table(self, caption, *arguments):
        """The lines below a caption, up to the next empty one."""
        result = reproduced(*arguments).ended(0, "")
        found = [block for block in result.out.split("\n\n") if block.startswith(caption)]
        self.assertEqual(len(found), 1, result.out)
        return found[0].splitlines()[1:]

    def test_no_verdict_changed_against_the_committed_ledger(self):
        result = reproduced().ended(0, "")
        for claim in CLAIMS:
            self.assertIn(f"\n{claim} ", result.out)

    def test_it_starts_with_the_sum_of_the_verdicts(self):
        with LEDGER.open() as file:
            verdicts = {row["claim"]: row["claim_verdict"] for row in csv.DictReader(file)
                        if row["reading"] == "corrected"}
        count = [sum(one == "reproduced" for one in verdicts.values()), 0,
                 sum(one == "not reproduced" for one in verdicts.values())]
        count[1] = len(verdicts) - count[0] - count[2]
        self.assertTrue(reproduced().out.startswith(
            "{} of the paper's 17 claims are reproduced, {} partly, {} not".format(*count)))

    def test_each_claim_is_said_in_words_beside_its_verdicts(self):
        said, claim = {}, None
        heading, _, *lines = self.table("What the paper claims")  # two lines of headings
        end = heading.index("corrected")
        for line in lines:
            if line.startswith("GT: "):
                break
            claim = line[:5].strip() or claim
            said[claim] = said.get(claim, "") + " " + line[7:end].strip()
            if line[:5].strip() in CLAIMS:
                self.assertRegex(line[end:], r"^ *((yes|partly|no)( \(\?\))? +){7}(none|[0-9.]+ %)$")
        with (ROOT / "reference/published/statements.tsv").open() as file:
            lines = csv.DictReader((one for one in file if not one.startswith("#")), delimiter="\t")
            statements = {line["claim"]: line["statement"] for line in lines}
        self.assertEqual(list(statements), CLAIMS)
        for name, statement in statements.items():
            marked = " (arithmetic)" if name == "C17" else ""
            self.assertEqual(" ".join(said[name].split()), statement + marked)

    def test_a_statement_is_data(self):
        folder = self.published("statements.tsv", "C14\tfriction is higher", "C14\trubbing is harder")
        self.assertIn("\nC14    rubbing is", run("reproduce", "--published", folder).out)

    def published(self, name, old, new):
        """A copy of the data with one text changed."""
        folder = pathlib.Path(self.folder.path("published"))
        shutil.copytree(ROOT / "reference/published", folder)
        text = (folder / name).read_text()
        self.assertIn(old, text)
        (folder / name).write_text(text.replace(old, new, 1))
        return str(folder)

    def test_each_reading_is_told_once(self):
        result = reproduced()
        told = self.table("The readings")
        names = [line.split("  ")[0] for line in told if not line.startswith((" ", "reading", "What"))]
        self.assertEqual(names, ["corrected", "m = 2", "equal faces", "literal", "best 1", "best 2", "best 3"])
        for switches in ["asperity_prefactor=8 nominal_area=a2 offset_planes=2 inlet=as_printed",
                         "asperity_prefactor=8 offset_planes=2 speed_modulus=E* speed=sum;"]:
            self.assertEqual(" ".join(result.out.split()).count(" " + switches), 1, result.out)

    def test_a_reading_that_is_there_already_is_not_shown_again(self):
        best = next(row for row in self.rows() if row["reading"] == "best 1")["departures"].replace(" ", ",")
        asked = ["corrected", "speed=sum", "best"]
        once, twice = (self.rows("--claim", "C3", *(word for one in readings for word in ("--reading", one)))
                       for readings in (asked, [*asked, "speed=mean", "speed=sum", best]))
        self.assertEqual([row["reading"] for row in once], ["corrected", "best 1", "best 2", "best 3", "speed=sum"])
        self.assertEqual(len({row["departures"] for row in once}), len(once))
        self.assertEqual(twice, once)

    def test_a_claim_on_the_smooth_surface_has_the_smooth_surfaces_values_and_units(self):
        ledger = reproduced("--format", "json").json()
        inputs = [line for line in (ROOT / "reference/published/inputs.tsv").read_text().splitlines()
                  if not line.startswith("#")]
        values = {(row["field"], row["surface"]): row
                  for row in csv.DictReader(inputs, delimiter="\t")}
        surfaces = {item["item"]: item["surface"] for item in ledger["items"]}
        seen = set()
        for one in ledger["requirements"]:
            surface = surfaces[one["item"]] if surfaces[one["item"]] != "–" else "rough"
            row = values.get((one["input"], surface)) or values[one["input"], "all"]
            self.assertEqual((one["surface"], one["unit"]), (surface, row["unit"]))
            self.assertEqual(one["paper_value"], float(row["value"]))
            if one["factor"] is not None:
                self.assertAlmostEqual(one["value"] / one["paper_value"] / one["factor"], 1, delta=1e-12)
            seen.add((one["item"], surface))
        self.assertTrue({("C1.rough", "rough"), ("C1.medium", "medium"), ("C1.smooth", "smooth"),
                         ("C4.smooth", "smooth")} <= seen)
        lines = self.table("What would make C1.smooth hold", "--claim", "C1")
        sd, = [line for line in lines if line.startswith("summit_height_sd")]
        self.assertIn("2.5 × 10⁻⁸", sd)
        self.assertIn("(m)", " ".join(lines))
        self.assertIn("smooth surface", " ".join(lines))

    def test_numbers_have_their_units(self):
        speed, = [line for line in self.table("The numbers and comparisons")
                  if line.startswith("C1.rough")]
        self.assertRegex(speed, r"onset speed, +0.5 m/s +2\.097 m/s +4\.19 times +not +0\.282$")

    def test_every_verdict_has_its_margin_and_its_numerical_error(self):
        found = {(row["reading"], row["item"]): row for row in self.rows()}
        ledger = reproduced("--format", "json").json()
        for item in ledger["items"]:
            for name, told in item["readings"].items():
                with self.subTest(item=item["item"], reading=name):
                    row = found[name, item["item"]]
                    self.assertEqual(row["decided"], "yes" if told["decided"] else "no")
                    self.assertEqual(row["beyond_collapse"].split(), told.get("beyond_collapse", []))
                    self.assertEqual(told["computed"] is None, "margin" not in told)
                    if told["computed"] is None:
                        self.assertEqual((row["margin"], row["numerical_error"]), ("", ""))
                        continue
                    margin = told["margin"]
                    self.assertEqual((float(row["margin"]), row["margin_of"]), (margin["distance"], margin["of"]))
                    self.assertEqual(told["decided"], margin["distance"] > margin["error"])
                    # Refined numbers have small relative errors; numbers below 1 have small absolute errors.
                    self.assertLess(told["numerical_error"], 1e-10 * max(1, abs(told["computed"])))
                    self.assertAlmostEqual(float(row["margin_error"]) / (margin["error"] or 1),
                                           1 if margin["error"] else 0, delta=0.06)

    def test_a_verdict_that_the_numerical_error_leaves_open_says_so(self):
        """With the equations as printed the area is the same on all surfaces: ratios differ from 1 only by rounding."""
        told = {row["item"]: row for row in self.rows() if row["reading"] == "literal"}
        self.assertEqual([name for name, row in told.items() if row["decided"] == "no"], ["C9"])
        self.assertAlmostEqual(float(told["C9"]["computed"]), 1, delta=float(told["C9"]["numerical_error"]))
        text = " ".join(reproduced("--reading", "literal").out.split())
        self.assertIn("no (?)", text)
        self.assertIn("(?): the margin is below the numerical error.", text)
        self.assertNotIn("(?)", reproduced("--reading", "corrected").out)

    def test_claims_that_rest_on_a_collapsed_film_say_so(self):
        text = " ".join(reproduced("--reading", "corrected").out.split())
        self.assertIn("C6 rests on points beyond the film's collapse (medium, smooth)", text)
        self.assertEqual(text.count("C6 rests on points beyond"), 2)
        found = {row["item"]: row["beyond_collapse"] for row in self.rows() if row["reading"] == "corrected"}
        self.assertEqual({item: name for item, name in found.items() if name}, {"C6": "medium smooth"})

    def test_tolerances_of_speeds_are_computed_from_the_papers_axis(self):
        ledger = reproduced("--format", "json").json()
        exact = (3 / 0.0001) ** 0.01 - 1
        tolerances = {item["item"]: item["tolerance"] for item in ledger["items"]}
        for item in ("C10", "C15"):
            self.assertAlmostEqual(tolerances[item], exact, delta=1e-12)
            line, = [line for line in self.table("The numbers and comparisons") if line.startswith(item)]
            self.assertIn(f"1 ± {100 * exact:.4g} %", line)

    def test_where_a_comparison_holds_is_said_in_words(self):
        text = reproduced("--reading", "best").out
        self.assertIn("at all speeds", text)
        self.assertIn("at no speed", text)
        self.assertNotIn("none of", reproduced().out)

    def test_every_line_fits(self):
        self.assertRegex(reproduced("--claim", "C1").out, r"\nclaim .*corrected +m = 2 ")  # the head of a column is whole
        for arguments in [[], ["--section", "all"], ["--claim", "C1"]]:
            for line in reproduced(*arguments).out.splitlines():
                self.assertLessEqual(len(line), 100)

    def test_on_a_terminal_of_80_columns_every_line_fits(self):
        reader, writer = os.openpty()
        fcntl.ioctl(writer, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        process = start("reproduce", stdout=writer)
        os.close(writer)
        said = read_terminal(reader)
        self.assertEqual(process.wait(timeout=120), 0)
        lines = said.decode().splitlines()
        self.assertGreater(len(lines), 60)
        for line in lines:
            self.assertLessEqual(len(line), 80)

    def test_json_holds_all_of_it(self):
        ledger = reproduced("--format", "json").json()
        self.assertEqual([claim["claim"] for claim in ledger["claims"]], CLAIMS)
        self.assertEqual([one["erratum"] for one in ledger["errata"]],
                         [f"E{i}" for i in range(1, 27)])
        self.assertEqual(sum(ledger["ranking"]["readings_by_score"]), ledger["ranking"]["readings"])
        for item in ledger["items"]:
            for reading in ledger["readings"]:
                self.assertIn("verdict", item["readings"][reading["name"]])
        for section in ["arguments", "requirements", "uncertainty", "independent"]:
            self.assertTrue(ledger[section], section)

    def test_sentences_under_the_tables_say_the_numbers_of_the_json(self):
        ledger = reproduced("--format", "json").json()
        ranking = ledger["ranking"]

        text = " ".join(reproduced("--section", "all").out.split())

        def grouped(count):
            return f"{count:,}".replace(",", " ") if count > 9999 else str(count)
        self.assertIn(f"There are {grouped(ranking['readings'])} readings: every combination of the {len(ledger['switches'])} switches. One drawn at "
                      f"random reproduces {ranking['mean_score']:.3g} claims (standard deviation {ranking['score_standard_deviation']:.2g}). "
                      f"{grouped(ranking['above_corrected'])} readings reproduce more than the corrected one, and "
                      f"{grouped(ranking['equal_to_corrected'] - 1)} others as many:", text)
        spread = {"print": "print precision", "plausible": "plausible ranges"}
        for one in ledger["uncertainty"]:
            self.assertIn(f"{spread[one['inputs_varied']]}: {one['draws']} draws; all three onset speeds print as reported in "
                          f"{one['all_onsets_as_reported']} of them.", text)
        first = next(claim for claim in ledger["claims"] if claim["claim"] == "C1")
        self.assertEqual("C1: no combination of interpretations gives all three speeds." in text, first["met_by"] == 0, first)

    def test_uncertain_numbers_stand_beside_what_the_paper_reports(self):
        speeds, shares = {"rough": 0.5, "medium": 0.15, "smooth": 0.09}, {"rough": "0.820", "medium": "–", "smooth": "0.600"}
        reported = {f"onset speed, {name}, m/s": f"{speed:#.3g}" for name, speed in speeds.items()}
        reported |= {f"asperity share at the lowest speed, {name}": share for name, share in shares.items()}
        reported |= {"onset speeds, medium/smooth": f"{0.15 / 0.09:.3g}", "onset speeds, rough/medium": f"{0.5 / 0.15:.3g}", "λ at the onset": "1.40"}
        found = {}
        for line in self.table("How sure", "--section", "all"):
            cells = re.split(r" {2,}", line.strip())
            if len(cells) == 6 and cells[0] != "number":
                found.setdefault(cells[0], set()).add(cells[5])
        self.assertEqual(found, {name: {text} for name, text in reported.items()})

    def test_csv_agrees_with_onset_and_reads_back(self):
        found = {row["item"]: row for row in self.rows() if row["reading"] == "corrected"}
        for surface in ["rough", "medium", "smooth"]:
            path = str(ROOT / f"reference/published/{surface}.toml")
            onset = run("onset", path, "--criterion", "film_maximum", "--format", "json").json()["onsets"][0]
            self.assertAlmostEqual(float(found[f"C1.{surface}"]["computed"]) / onset["speed"], 1,
                                   delta=1e-12)
            factor = float(found[f"C1.{surface}"]["computed"]) / float(found[f"C1.{surface}"]["reported"])
            self.assertEqual(float(found[f"C1.{surface}"]["factor"]), factor)

    def test_a_claim_is_shown_with_what_would_have_to_be_true(self):
        result = reproduced("--claim", "C1").ended(0)
        self.assertIn("abstract; conclusion", result.out)
        self.assertIn("viscosity", result.out)
        claims = result.out.split("\n\n")[1]
        self.assertIn("\nC1 ", claims)
        self.assertNotIn("\nC17", claims)

    def test_a_reading_of_ones_own_is_a_column(self):
        rows = self.rows("--reading", "speed=sum", "--reading", "corrected", "--claim", "C1", "--claim", "C4")
        self.assertEqual({row["claim"] for row in rows}, {"C1", "C4"})
        self.assertEqual({row["reading"] for row in rows}, {"corrected", "speed=sum"})
        speed = {(row["reading"], row["item"]): float(row["computed"]) for row in rows}
        # The sum in place of the mean doubles U, as twice the speed would.
        for surface in ["rough", "medium", "smooth"]:
            ratio = speed["corrected", f"C1.{surface}"] / speed["speed=sum", f"C1.{surface}"]
            self.assertAlmostEqual(ratio, 2, delta=1e-12)

    def test_a_changed_verdict_and_another_best_reading_are_named_and_exit_with_1(self):
        def change(rows):
            rows[0]["verdict"] = "reproduced"
            for row in rows:
                if row["reading"] == "best 1":
                    row["departures"] = "speed=sum"
        result = run("reproduce", "--ledger", self.changed_ledger(change), "--format", "csv").ended(1)
        self.assertEqual(len(result.err.splitlines()), 2, result.err)
        self.assertIn("verdict changed: C1.rough, corrected: was reproduced", result.err)
        self.assertIn("verdict changed: best 1: was speed=sum, is ", result.err)
        self.assertTrue(result.out)

    def test_a_moved_number_is_named_and_exits_with_0(self):
        def change(rows):
            rows[0]["computed"] = "2.2"
        result = run("reproduce", "--ledger", self.changed_ledger(change), "--format", "csv").ended(0)
        self.assertIn("number moved: C1.rough, corrected: was 2.2, is 2.09", result.err)

    def test_a_changed_input_changes_a_verdict(self):
        folder = pathlib.Path(self.folder.path("published"))
        shutil.copytree(ROOT / "reference/published", folder)
        for name in ["rough", "medium", "smooth", "smooth_gw"]:
            scene = folder / f"{name}.toml"
            scene.write_text(scene.read_text().replace("inlet_film_ratio = 4 ", "inlet_film_ratio = 3 "))
        self.assertIn("verdict changed: C2.rough, corrected: was reproduced", run("reproduce", "--published", str(folder)).ended(1).err)

    def test_markdown_has_every_section_when_asked(self):
        result = reproduced("--section", "all", "--format", "markdown").ended(0)
        for text in ["What the paper claims", "The readings", "The switches", "What each item tells apart", "How sure",
                     "The misprints", "beside another library", "C1 as a departure"]:
            self.assertIn(text, result.out)

    def test_each_cell_of_the_markdown_is_that_of_the_json(self):
        """Compares with the page's tables. Where these have more or fewer digits, numbers agree to the fewer digits."""
        ledger = reproduced("--format", "json").json()
        text = reproduced("--section", "all", "--format", "markdown").out
        tables = {}
        for caption, body in re.findall(r"(?m)^\*\*(.*?)\*\*\n\n((?:\|.*\n)+)", text):
            head, _, *rows = [[page_tables.plain(cell) for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in body.splitlines()]
            tables[page_tables.plain(caption)] = [dict(zip(head, row, strict=True)) for row in rows]
        compared = 0
        for make in (page_tables.claims, page_tables.readings, page_tables.requirements, page_tables.of_ledger, page_tables.misprints):
            for caption, head, rows in make({"ledger": ledger}):
                shown = tables.get(page_tables.plain(caption).partition(", onset by")[0])
                if shown is None:  # the table of another reading than the first
                    self.assertIn("decide, under the reading", caption)
                    continue
                self.assertEqual(len(shown), len(rows), caption)
                for mine, row in zip(rows, shown):
                    told = dict(zip(map(page_tables.plain, head), map(page_tables.plain, mine)))
                    if "effect of +1 %, %" in told:
                        told["effect of +1 %"] = re.sub(r"^(?=[\d.])", "+", told["effect of +1 %, %"]) + " %"
                        told["input"] += "" if told["unit"] == "–" else f" ({told['unit']})"
                    for name in row.keys() - {"where it departs from the corrected reading"}:
                        compared += 1
                        self.assertTrue(page_tables.alike(told[name], row[name]), (caption, name, told[name], row[name]))
        self.assertGreater(compared, 1000)

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
            result = run("reproduce", *arguments).ended(2)
            self.assertEqual(len(result.err.splitlines()), 1, result.err)
            for word in words:
                self.assertIn(word, result.err)

    def test_what_is_asked_for_is_refused_before_anything_is_computed(self):
        # Without scenes nothing can be computed.
        folder = pathlib.Path(self.folder.path("claims_alone"))
        folder.mkdir()
        shutil.copy(ROOT / "reference/published/claims.tsv", folder)
        missing = self.folder.path("none")
        for arguments, word in [(["--claim", "C99"], "--claim: C99"), (["--ledger", missing], missing),
                                (["--reading", "inlet=floods"], "inlet"),
                                (["--section", "claim"], "--section"), ([], "rough.toml")]:
            with self.subTest(arguments=arguments):
                result = run("reproduce", "--published", str(folder), *arguments)
                self.assertEqual((result.code, result.out), (2, ""))
                self.assertEqual(len(result.error_lines), 1, result.err)
                self.assertIn(word, result.err)

    def test_a_broken_data_file_is_named(self):
        folder = pathlib.Path(self.folder.path("published"))
        shutil.copytree(ROOT / "reference/published", folder)
        for name, old, new, words in [
                ("claims.tsv", "\tnumber\t", "\tnumbers\t", ["C1.rough", "numbers is no rule"]),
                ("errata.tsv", "E25\t", "E27\t", ["E27", "nothing computes this erratum"]),
                ("statements.tsv", "C17\t", "C18\t", ["C18 is no claim"]),
                ("statements.tsv", "\nC17\t", "\n#C17\t", ["C17 has no statement"]),
                ("inputs.tsv", "viscosity\tall", "viscous\tall", ["viscous is no input"]),
                ("independent.tsv", "801694948.59", "much", ["much is no number"])]:
            path = folder / name
            good = path.read_text()
            path.write_text(good.replace(old, new, 1))
            result = run("reproduce", "--published", str(folder)).ended(2)
            self.assertEqual(len(result.err.splitlines()), 1, result.err)
            for word in [str(path)] + words:
                self.assertIn(word, result.err)
            path.write_text(good)


if __name__ == "__main__":
    unittest.main()
