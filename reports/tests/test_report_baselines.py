# SPDX-License-Identifier: Apache-2.0
"""What `tribocheck report` makes of reference/baselines and reference/exact, and of what is missing."""

import json
import pathlib
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
                     "reports/gnuplot"):
            shutil.copytree(ROOT / part, self.project / part)
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

    def test_texts_of_a_baseline_cannot_break_the_page(self):
        path = self.project / "reference/baselines/planted_faults.json"
        content = json.loads(path.read_text())
        content["faults"][0] |= {"id": "a`b", "fault": "x^2 <script>alert(1)</script> ~ | \" '"}
        path.write_text(json.dumps(content))
        self.page()
        text = (self.project / "reports/out/index.html").read_text()
        self.assertNotIn("<script", text)


if __name__ == "__main__":
    unittest.main()
