# SPDX-License-Identifier: Apache-2.0
"""Tests the parts of the report that come from reference/baselines and reference/exact, also if these files are missing or changed."""

import json
import math
import random
import re
import shutil
import unittest

import page_sources
from page_perturbed import changed
from program import folder_until
from report_files import FIGURES, FITS_FIGURES, ROOT, STARVED_FIGURES, PageReader, project_copy, report


class Baselines(unittest.TestCase):
    """Each test has its own copy of the project, and may change its reference/exact and reference/baselines."""
    FILES = {"accuracy.json": "verification", "stress.json": "worst-inputs",
             "mutants.json": "mutants", "planted_faults.json": "planted-faults", "diagnosis.json": "diagnosis",
             "work_precision.json": "work-precision",
             "performance.json": "gates", "gates.json": "gates",
             "sweep.json": "sweep-speed"}
    GROUPS = {"accuracy.json": "certified", "performance.json": "gates", "sweep.json": "sweep_speed"} | {
        f"{name}.json": name for name in ("stress", "mutants", "planted_faults", "diagnosis", "work_precision", "gates")}
    TITLES = {"verification": "Accuracy, quantity by quantity",
              "worst-inputs": "Accuracy at random inputs", "mutants": "Random changes: how many do the tests notice?",
              "planted-faults": "Planted faults: do the checks find errors?",
              "diagnosis": "Wrong solvers: are their mistakes named?",
              "work-precision": "Run time against error", "gates": "Checks of run time",
              "sweep-speed": "Run time of sweeps over many inputs"}

    def setUp(self):
        self.project = project_copy(folder_until(self.addCleanup), "published", "scenes", "ehl", "exact", "baselines")
        shutil.copy(ROOT / "reference/mistakes.toml", self.project / "reference")
        # The ledger may lack new faults of the catalogue until they are planted. Here it counts as complete.
        path = self.project / "reference/baselines/planted_faults.json"
        ledger = json.loads(path.read_text())
        path.write_text(json.dumps(ledger | {"catalogue": len(ledger["faults"])}))
        # Some of the drawn mutants may not have run yet. Here all count as run.
        path = self.project / "reference/baselines/mutants.json"
        ledger = json.loads(path.read_text())
        for one in ledger["score"]["rooms"]:
            one["ran"] = one["drawn"]
        path.write_text(json.dumps({**ledger, "samples": []}))
        (self.project / "empty").mkdir()

    def page(self, sections=None):
        """Writes a report without gnuplot in PATH, of these sections (None: those of FILES and environment; empty: all). Returns its report.json."""
        if sections is None:
            sections = ["environment", *self.FILES.values()]
        asked = [word for name in sections for word in ("--section", name)]
        done = report(*asked, cwd=self.project, environment={"PATH": str(self.project / "empty")})
        self.assertIn(done.code, (0, 1), done.err)  # 1: figures could not be drawn
        page = json.loads((self.project / "reports/out/report.json").read_text())
        self.terminal = done.out
        self.text = (self.project / "reports/out/report.md").read_text()
        self.sections = {part.partition("\n")[0]: part for part in self.text.split("\n## ")[1:]}
        self.missing = [row for row in self.rows("What is missing from this page") if "gnuplot" not in row[1]]
        self.findings = {one["id"]: one for one in page["findings"]}
        self.reader = PageReader((self.project / "reports/out/index.html").read_text())
        self.assertEqual(self.reader.problems, [])
        return page

    def rows(self, section):
        """The rows of all tables of a section, without the heads."""
        lines = [line for line in self.sections[section].splitlines() if line.startswith("|")]
        heads = {i for i, line in enumerate(lines) for i in ((i - 1, i) if line.startswith("| ---") else ())}
        return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for i, line in enumerate(lines)
                if i not in heads]

    def assert_missing(self, name, why):
        page = self.page()
        self.assertEqual(len(self.missing), 1, self.missing)
        self.assertIn(why, self.missing[0][1])
        self.assertIn("make ", self.missing[0][2])
        group = self.GROUPS[name]
        self.assertIn(why, json.dumps(page[group], ensure_ascii=False))
        self.assertIn(why, self.sections[self.TITLES[self.FILES[name]]])
        if "missing" in page[group]:
            self.assertEqual((self.findings[group]["standing"], why in self.findings[group]["why"]), ("absent", True))
            self.assertIn("1 did not run", self.terminal)

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
        for sections, groups in ((["uncertainty"], {"ledger", "onset_uncertainty"}),
                                 (["gates", "environment"], {"gates", "environment"}),
                                 (["skipped-work", "work-precision"], {"skipped_work", "work_precision", "ellipse_fits"})):
            page = self.page(sections)
            self.assertEqual(set(page["sections"]), set(sections))
            self.assertEqual(set(page) - {"schema", "version", "sections", "findings", "not_run", "files"}, groups)
        done = report("--section", "sweeps", cwd=self.project)
        self.assertEqual((done.code, done.out), (2, ""))
        self.assertIn("sweeps is not one of figures, comparison", done.err)

    def test_a_report_of_more_sections_is_left_alone(self):
        self.page(["gates", "environment"])
        out = self.project / "reports/out"
        before = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
        done = report("--section", "gates", cwd=self.project)
        self.assertEqual({path: path.read_bytes() for path in before}, before)
        self.assertIn(f": {out}/gates/", done.out.splitlines()[-1])
        self.assertEqual(json.loads((out / "gates/report.json").read_text())["sections"], ["gates"])
        self.page(["environment", "gates", "skipped-work"])  # a report of as many or more sections replaces it

    def test_one_that_is_not_json(self):
        path = self.project / "reference/baselines/stress.json"
        path.write_text(path.read_text()[:1000])
        self.assert_missing("stress.json", "is not JSON")

    def test_one_of_another_shape(self):
        for content in ("[]", "{}", '{"faults": 3}', '{"faults": [{}], "catalogue": 1}', "null"):
            with self.subTest(content):
                (self.project / "reference/baselines/planted_faults.json").write_text(content)
                self.assert_missing("planted_faults.json", "has another shape")

    def test_a_part_of_another_shape(self):
        for name, of in (("accuracy.json", "quantities"), ("performance.json", "time"), ("stress.json", "outputs"),
                         ("gates.json", "planted"), ("sweep.json", "ratios"),
                         ("work_precision.json", "error_against_work"), ("planted_faults.json", "environment")):
            with self.subTest(name):
                path = self.project / "reference/baselines" / name
                whole = path.read_text()
                path.write_text(json.dumps(json.loads(whole) | {of: [3]}))
                self.assert_missing(name, "has another shape")
                path.write_text(whole)

    def test_without_any_and_without_certified_tables(self):
        shutil.rmtree(self.project / "reference/baselines")
        shutil.rmtree(self.project / "reference/exact")
        page = self.page(sections=[])
        absent = {one["section"] for one in page["findings"] if one["standing"] == "absent"}
        self.assertLessEqual({"verification", "planted-faults", "worst-inputs", "work-precision", "gates",
                              "sweep-speed"}, absent)
        self.assertEqual(sorted(self.reader.figures), sorted(set(FIGURES + FITS_FIGURES) - set(STARVED_FIGURES)))

    def test_a_fault_that_survived_is_a_broken_promise_on_top(self):
        path = self.project / "reference/baselines/planted_faults.json"
        content = json.loads(path.read_text())
        content["faults"][7] |= {"caught": False, "said": "passed"}
        path.write_text(json.dumps(content))
        self.page()
        self.assertEqual(self.findings["planted_faults"]["standing"], "fails")
        self.assertIn("FAILS: planted_faults", self.terminal)
        self.assertIn("1 fail", self.terminal)
        first = next(part for part in self.sections["Results: checks of this software"].split("\n\n") if "](#" in part)
        self.assertRegex(first, "^FAILS ")
        self.assertIn("](#planted-faults)", first)
        row = self.rows(self.TITLES["planted-faults"])[0]
        self.assertEqual((row[0], row[2]), (f"`{content['faults'][7]['id']}`", "SURVIVED: passed"))

    def standing_of(self, section):
        """The standing of a section's finding, and its text on the page."""
        page = self.page([section, "environment"])
        standing = next(one["standing"] for one in page["findings"] if one["section"] == section)
        return standing, " ".join(next(part for part in self.text.split("\n\n") if f"](#{section})" in part).split())

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

        def nothing_proved(content):
            content["same_program"] = content["planted"] = []
        outputs = len(json.loads((ROOT / "reference/baselines/stress.json").read_text())["outputs"])
        for section, name, change, said in (("gates", "gates.json", not_proved, "1 of 8 gates did not say"),
                                            ("gates", "gates.json", nothing_proved, "0 of 0 gates did not say"),
                                            ("worst-inputs", "stress.json", not_held, f"{outputs - 1} of {outputs} outputs keep")):
            with self.subTest(change.__name__):
                shutil.copy(ROOT / "reference/baselines" / name, self.project / "reference/baselines" / name)
                standing, text = self.standing_of(section)
                self.assertEqual(standing, "holds")
                self.assertNotIn(said, text)
                self.changed(name, change)
                standing, text = self.standing_of(section)
                self.assertEqual(standing, "fails")
                self.assertIn(said, text)

    def test_one_certified_value_that_is_not_kept_breaks_the_promise(self):
        before = self.page(["verification"])["certified"]
        self.assertEqual(self.findings["certified_values"]["standing"], "holds")
        path = self.project / "reference/exact/hertz_point.csv"
        row = path.read_text().splitlines()[-1]
        high = row.split(",")[-4]
        moved = (float.fromhex(high) * (1 + 2**-40)).hex()
        path.write_text(path.read_text().replace(row, row.replace(high, moved)))
        after = self.page(["verification"])["certified"]
        self.assertEqual(self.findings["certified_values"]["standing"], "fails")
        self.assertLessEqual(before["worst_part_of_bound"], 1)
        self.assertGreater(after["worst_part_of_bound"], 10)
        self.assertEqual(before["held"] - after["held"], 1)
        self.assertGreaterEqual(before["held"], 17)
        self.assertEqual([row[0] for row in self.rows(self.TITLES["verification"]) if row[-1] == "FAILED"],
                         ["`hertz_point`"])

    def test_the_worst_of_all_quantities_is_told(self):
        certified = self.page(["verification"])["certified"]
        self.assertEqual(certified["worst_part_of_bound"],
                         max(one["worst_part_of_bound"] for one in certified["quantities"]))
        parts = [float(row[6].split()[0]) for row in self.rows(self.TITLES["verification"])]
        told = self.standing_of("verification")[1]
        taken = 100 if "meets its bound exactly" in told else float(re.search(r"takes ([\d.]+)", told)[1])
        self.assertEqual(taken, max(parts))

    def test_faults_of_the_catalogue_that_were_not_planted_are_said_to_be(self):
        def more(content):
            content["catalogue"] = len(content["faults"]) + 5
        self.changed("planted_faults.json", more)
        self.page()
        self.assertEqual([row[0] for row in self.missing], ["planted faults"])

    def test_mutants_that_wait_are_said_to_and_a_goal_is_reached_or_missed(self):
        for is_reached, standing in ((True, "holds"), (False, "missed")):
            self.changed("mutants.json", lambda content: content["score"].update(goals_reached=is_reached))
            self.assertEqual(self.standing_of("mutants")[0], standing)
            self.assertEqual(self.missing, [])
        def why():
            return next(one["why"] for one in self.page(["mutants"])["findings"] if one["id"] == "mutants")
        rooms = json.loads((ROOT / "reference/baselines/mutants.json").read_text())["score"]["rooms"]
        missed = f"{sum(one['score'] < one['goal'] for one in rooms)} of {len(rooms)} goals are missed"
        self.assertEqual(why(), missed + ".")
        self.changed("mutants.json", lambda content: content["score"]["rooms"][1].update(drawn=content["score"]["rooms"][1]["ran"] + 7))
        self.assertIn(" 7 more wait for slow tests.", self.standing_of("mutants")[1])
        self.assertEqual([row[:2] for row in self.missing], [["random changes", "7 of those that were drawn wait for slow tests"]])
        self.assertEqual(why(), missed + "; 7 changes wait for slow tests.")

    def test_a_gate_that_was_not_held_did_not_run(self):
        path = self.project / "reference/baselines/gates.json"
        content = json.loads(path.read_text())
        content["same_program"][2] |= {"verdict": "not held", "proved": False, "workloads": 0,
                                       "greatest_ratio": None, "why": "the machine is busy"}
        path.write_text(json.dumps(content))
        self.page()
        self.assertEqual(self.findings["gates"]["standing"], "fails")
        self.assertIn("the machine is busy", self.missing[0][1])

    def test_each_of_the_targets_of_sweeps_has_to_be_reached(self):
        def slower(content):
            one = next(iter(content["ratios"].values()))
            one["summaries"] = math.nextafter(150, 151)

        def no_gain(content):
            content["threads"]["speedup"]["summaries"] = math.nextafter(1.8, 0)

        def larger(content):
            of = next(iter(content["memory"].values()))["mb_of_rank"]
            of[next(iter(of))] = 300

        def all_reached(content):
            for times in content["ratios"].values():
                times |= {"alone": 100, "summaries": 150}
            content["threads"]["speedup"]["summaries"] = 1.8
            for of in content["memory"].values():
                of["mb_of_rank"] = {rank: math.nextafter(300, 0) for rank in of["mb_of_rank"]}
        self.changed("sweep.json", all_reached)
        standing, text = self.standing_of("sweep-speed")
        self.assertEqual(standing, "holds")
        self.assertIn("all 3 speed targets are reached", text)
        self.assertIn(" no check misses a target,", self.terminal)
        for change, target, said in ((slower, "times_alone", "1.50 times as long"),
                                     (no_gain, "two_threads", "1.80 times as fast"), (larger, "mb_of_rank", "300 MB")):
            with self.subTest(change.__name__):
                self.changed("sweep.json", all_reached)
                self.changed("sweep.json", change)
                standing, text = self.standing_of("sweep-speed")
                self.assertEqual(standing, "missed")
                self.assertIn("one of 3 speed targets is missed", text)
                self.assertIn(said, text)
                self.assertEqual(text.count(", missed)"), 1)
                self.assertIn(" 1 misses 1 target,", self.terminal)
                targets = self.page(["sweep-speed"])["sweep_speed"]["targets"]
                self.assertEqual([name for name, one in targets.items() if not one["reached"]], [target])

    def test_each_group_is_its_baseline_whatever_the_numbers(self):
        """page_sources computes each field, sum, worst and fastest value again, also from baselines with random numbers."""
        folder = self.project / "reference/baselines"
        names = [name.removesuffix(".json") for name in self.FILES]
        bases = {name: json.loads((folder / f"{name}.json").read_text()) for name in names}
        for seed in (None, 1, 2):
            if seed is not None:
                bases = {name: changed(base, random.Random(seed)) for name, base in bases.items()}
            for name, base in bases.items():
                (folder / f"{name}.json").write_text(json.dumps(base))
            page = self.page()
            for name, group in page_sources.promised(bases.get).items():
                with self.subTest(name, seed=seed):
                    self.assertEqual(page[name], group)
            self.assertEqual(page["certified"]["before"], page_sources.before(bases["accuracy"]))

    def test_an_alternative_that_fails_or_is_not_judged_is_not_compared(self):
        def only_failures(content):
            for row in content["error_against_work"]:
                if row["family"] != "tribocheck":
                    row |= {"failures": 1} if row["job"] == "moment_2" else {"max_ulp": None}
        self.changed("work_precision.json", only_failures)
        page = self.page(["work-precision"])
        self.assertEqual(page["work_precision"]["alternatives"]["jobs"], 0)
        self.assertEqual(self.findings["work_precision"]["standing"], "absent")
        for job in page["work_precision"]["jobs"]:
            self.assertEqual({way["family"] for way in job["ways"]}, {"tribocheck"})

    def test_exponents_in_texts_of_a_baseline_stay_apart(self):
        self.page(["gates"])
        self.assertIn("2<sup>−90</sup> for 2<sup>−55</sup>:", self.text)

    def test_texts_of_a_baseline_cannot_break_the_page(self):
        path = self.project / "reference/baselines/planted_faults.json"
        content = json.loads(path.read_text())
        content["faults"][0] |= {"id": "a`b", "fault": "x^2 <script>alert(1)</script> ~ | \" '"}
        path.write_text(json.dumps(content))
        self.page()
        text = (self.project / "reports/out/index.html").read_text()
        self.assertNotIn("<script>alert", text)
        self.assertIn("&lt;script&gt;alert(1)&lt;/script&gt; ~ | &quot; '", text)
        self.assertIn("<code>a`b</code>", text)
        rows = [line for line in self.text.splitlines() if "alert(1)" in line]
        self.assertEqual([len(re.findall(r"(?<!\\)\|", row)) for row in rows], [6])  # five cells


if __name__ == "__main__":
    unittest.main()
