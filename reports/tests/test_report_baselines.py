# SPDX-License-Identifier: Apache-2.0
"""What `tribocheck report` makes of reference/baselines and reference/exact, and of what is missing."""

import csv
import io
import json
import pathlib
import re
import shutil
import tempfile
import unittest

from report_files import FIGURES, ROOT, PageReader, report


class Baselines(unittest.TestCase):
    """A project of its own, whose reference/exact and reference/baselines are as a test leaves them."""
    FILES = {"accuracy.json": "verification", "stress.json": "worst-inputs",
             "planted_faults.json": "planted-faults", "work_precision.json": "work-precision",
             "performance.json": "gates", "gates.json": "gates",
             "sweep.json": "sweep-speed"}

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.project = pathlib.Path(self.folder.name) / "project"
        for part in ("reference/published", "reference/exact", "reference/baselines",
                     "reports/page/gnuplot"):
            shutil.copytree(ROOT / part, self.project / part)
        # A ledger lacks new faults until the next run that plants a part of them.
        path = self.project / "reference/baselines/planted_faults.json"
        ledger = json.loads(path.read_text())
        path.write_text(json.dumps(ledger | {"catalogue": len(ledger["faults"])}))
        (self.project / "empty").mkdir()

    def page(self, sections=None):
        """report.json of the project, without pictures; of these sections, else of those here."""
        if sections is None:
            sections = ["environment", *self.FILES.values()]
        asked = [word for name in sections for word in ("--section", name)]
        done = report(*asked, cwd=self.project, environment={"PATH": str(self.project / "empty")})
        self.assertIn(done.returncode, (0, 1), done.stderr)  # 1: no figures where there are some
        text = (self.project / "reports/out/report.json").read_text()
        page = json.loads(text)
        self.missing = [row for one in page["sections"][-1]["tables"] for row in one["rows"]
                        if "gnuplot" not in row[1]]
        self.sections = {section["id"]: section for section in page["sections"]}
        self.reader = PageReader((self.project / "reports/out/index.html").read_text())
        self.assertEqual(self.reader.problems, [])
        return page

    def assert_missing(self, name, why):
        self.page()
        section = self.sections[self.FILES[name]]
        self.assertEqual(len(self.missing), 1, self.missing)
        self.assertIn(why, self.missing[0][1])
        self.assertIn("make ", self.missing[0][2])
        self.assertIn(why, json.dumps(section, ensure_ascii=False))
        self.assertTrue(section["tables"] or "Not here" in section["paragraphs"][-1])

    def test_with_all_of_them_nothing_is_missing(self):
        self.page(sections=[])
        self.assertEqual(self.missing, [])

    def test_one_that_is_not_there_is_said_in_its_place(self):
        for name in self.FILES:
            with self.subTest(name):
                (self.project / "reference/baselines" / name).rename(self.project / name)
                self.assert_missing(name, "is not there")
                (self.project / name).rename(self.project / "reference/baselines" / name)

    def test_only_the_sections_that_are_asked_for_are_made(self):
        for sections in (["sweep"], ["gates", "environment"], ["uncertainty", "inputs"]):
            page = self.page(sections)
            self.assertEqual({section["id"] for section in page["sections"]},
                             {*sections, "not-run"})
        done = report("--section", "sweeps", cwd=self.project)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("sweeps is not one of environment, claims", done.stderr)

    def test_one_that_is_not_json(self):
        path = self.project / "reference/baselines/stress.json"
        path.write_text(path.read_text()[:1000])
        self.assert_missing("stress.json", "is not JSON")

    def test_one_of_another_shape(self):
        for content in ("[]", "{}", '{"faults": 3}', '{"faults": [{}], "catalogue": 1}', "null"):
            with self.subTest(content):
                (self.project / "reference/baselines/planted_faults.json").write_text(content)
                self.assert_missing("planted_faults.json", "has another shape")

    def test_without_any_and_without_certified_tables(self):
        shutil.rmtree(self.project / "reference/baselines")
        shutil.rmtree(self.project / "reference/exact")
        page = self.page(sections=[])
        absent = [verdict["section"] for verdict in page["verdicts"]
                  if verdict["standing"] == "not run"]
        for section in ("verification", "planted-faults", "worst-inputs", "work-precision", "gates",
                        "sweep-speed", "not-run"):
            self.assertIn(section, absent)
        self.assertEqual(self.reader.figures, FIGURES)

    def test_a_fault_that_survived_is_a_broken_promise_on_top(self):
        path = self.project / "reference/baselines/planted_faults.json"
        content = json.loads(path.read_text())
        content["faults"][7] |= {"caught": False, "said": "passed"}
        path.write_text(json.dumps(content))
        page = self.page()
        self.assertEqual(page["verdicts"][0]["standing"], "FAILS")
        self.assertEqual(page["verdicts"][0]["section"], "planted-faults")
        self.assertIn(content["faults"][7]["id"],
                      self.sections["planted-faults"]["tables"][0]["rows"][0][0])

    def standing_of(self, section):
        """What the page promises of a section, and its words."""
        page = self.page([section, "environment"])
        return next((one["standing"], one["text"]) for one in page["verdicts"] if one["section"] == section)

    def changed(self, name, change):
        path = self.project / "reference/baselines" / name
        content = json.loads(path.read_text())
        before = json.dumps(content)
        change(content)
        path.write_text(json.dumps(content))
        self.addCleanup(path.write_text, before)

    def test_one_thing_that_is_not_held_breaks_the_promise_of_its_section(self):
        def not_proved(content):
            content["planted"][-1]["gates"][0]["proved"] = False

        def not_held(content):
            content["outputs"][2]["held"] = False
        for section, name, change in (("gates", "gates.json", not_proved),
                                      ("worst-inputs", "stress.json", not_held)):
            with self.subTest(section):
                self.assertEqual(self.standing_of(section)[0], "holds")
                self.changed(name, change)
                self.assertEqual(self.standing_of(section)[0], "FAILS")

    def test_one_certified_value_that_is_not_kept_breaks_the_promise(self):
        standing, before = self.standing_of("verification")
        self.assertEqual(standing, "holds")
        path = self.project / "reference/exact/hertz_point.csv"
        row = path.read_text().splitlines()[-1]
        high = row.split(",")[-4]
        moved = (float.fromhex(high) * (1 + 2**-40)).hex()
        path.write_text(path.read_text().replace(row, row.replace(high, moved)))
        standing, text = self.standing_of("verification")
        self.assertEqual(standing, "FAILS")
        worst = [float(re.search(r"takes ([\d.]+)", words)[1]) for words in (before, text)]
        self.assertLessEqual(worst[0], 100)
        self.assertGreater(worst[1], 1000)
        table = self.sections["verification"]["tables"][0]
        self.assertEqual([row[0] for row in table["rows"] if row[-1] == "FAILED"], ["hertz_point"])

    def test_the_worst_of_all_quantities_is_told(self):
        text = self.standing_of("verification")[1]
        parts = [float(row[6].split()[0]) for row in self.sections["verification"]["tables"][0]["rows"]]
        self.assertEqual(float(re.search(r"takes ([\d.]+)", text)[1]), max(parts))

    def test_faults_of_the_catalogue_that_were_not_planted_are_said_to_be(self):
        def more(content):
            content["catalogue"] = len(content["faults"]) + 5
        self.changed("planted_faults.json", more)
        self.page()
        self.assertEqual([row[0] for row in self.missing], ["planted faults"])

    def test_a_gate_that_was_not_held_did_not_run(self):
        path = self.project / "reference/baselines/gates.json"
        content = json.loads(path.read_text())
        content["same_program"][2] |= {"verdict": "not held", "proved": False, "workloads": 0,
                                       "greatest_ratio": None, "why": "the machine is busy"}
        path.write_text(json.dumps(content))
        page = self.page()
        self.assertEqual(page["verdicts"][0]["section"], "gates")
        self.assertIn("the machine is busy", self.missing[0][1])

    def test_sweeps_that_are_slower_than_aimed_at_are_said_to_be(self):
        path = self.project / "reference/baselines/sweep.json"
        content = json.loads(path.read_text())
        content["ratios"]["film_5_fields"]["summaries"] = 7 * content["ratios"]["film_5_fields"]["alone"]
        path.write_text(json.dumps(content))
        page = self.page()
        said = next(verdict for verdict in page["verdicts"] if verdict["section"] == "sweep-speed")
        self.assertIn("NOT REACHED", said["text"])
        self.assertIn("7.00 times", said["text"])

    def test_each_of_the_aims_of_sweeps_has_to_be_reached(self):
        def slower(content):
            one = next(iter(content["ratios"].values()))
            one["summaries"] = 1.6 * one["alone"]

        def no_gain(content):
            content["threads"]["speedup"]["summaries"] = 1.7

        def larger(content):
            of = next(iter(content["memory"].values()))["mb_of_rank"]
            of[next(iter(of))] = 301

        def all_reached(content):
            for times in content["ratios"].values():
                times["summaries"] = times["alone"]
            content["threads"]["speedup"]["summaries"] = 1.9
            for of in content["memory"].values():
                of["mb_of_rank"] = {rank: 100 for rank in of["mb_of_rank"]}
        self.changed("sweep.json", all_reached)
        self.assertIn("is reached", self.standing_of("sweep-speed")[1])
        for change in (slower, no_gain, larger):
            with self.subTest(change.__name__):
                self.changed("sweep.json", all_reached)
                self.changed("sweep.json", change)
                self.assertIn("NOT REACHED", self.standing_of("sweep-speed")[1])

    def test_a_changed_verdict_breaks_the_ledgers_promise_and_a_moved_number_does_not(self):
        path = self.project / "reference/baselines/ledger.csv"
        whole = path.read_text()
        rows = list(csv.reader(io.StringIO(whole)))
        for column, value, standing in (("computed", "2.2", "holds"), ("verdict", "in part", "FAILS")):
            with self.subTest(column):
                path.write_text(whole.replace(",".join(rows[1]), ",".join(
                    value if name == column else cell for name, cell in zip(rows[0], rows[1]))))
                page = self.page(["claims"])
                self.assertEqual([one["standing"] for one in page["verdicts"]
                                  if one["text"].endswith("against the committed ledger.")
                                  or "changed against the committed ledger:" in one["text"]], [standing])

    def test_texts_of_a_baseline_cannot_break_the_page(self):
        path = self.project / "reference/baselines/planted_faults.json"
        content = json.loads(path.read_text())
        content["faults"][0] |= {"id": "a`b", "fault": "x^2 <script>alert(1)</script> ~ | \" '"}
        path.write_text(json.dumps(content))
        self.page()
        text = (self.project / "reports/out/index.html").read_text()
        self.assertNotIn("<script", text)
        rows = [line for line in (self.project / "reports/out/report.md").read_text().splitlines()
                if "alert(1)" in line]
        self.assertEqual([len(re.findall(r"(?<!\\)\|", row)) for row in rows], [7])  # six cells


if __name__ == "__main__":
    unittest.main()
