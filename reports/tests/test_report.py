# SPDX-License-Identifier: Apache-2.0
"""tribocheck report: every file it promises, its numbers against solve and onset, its failures.

Needs gnuplot, as the program does.
"""

import collections
import csv
import io
import json
import math
import os
import pathlib
import re
import shutil
import struct
import tomllib
import unittest
import xml.etree.ElementTree as xml

from program import PROGRAM, folder_until, run
from report_files import (DATA, FIGURES, JOBS, NOT_RUN, PAGES, PAPER_FIGURES, PICTURES, PUBLISHED, RESULTS,
                          ROOT, SCENES, WORK_FIGURES, PageReader, WrittenReport, files_below,
                          project_copy, report, table, told_page)


def solved(folder, speeds, scene, **changes):
    """`tribocheck solve` of a published scene, changed, at these speeds: rows of its CSV."""
    tree = tomllib.loads((PUBLISHED / f"{scene}.toml").read_text())
    tree.update(changes, speed=[float(speed) for speed in speeds])
    path = pathlib.Path(folder) / "changed.json"
    path.write_text(json.dumps({key: value for key, value in tree.items() if value is not None}))
    done = run("solve", path, "--format", "csv")
    assert done.code == 0, done.err
    return done.rows()


def without_environment(name, text):
    """A page without the only part that depends on the time and the place at which it was made."""
    if name == "index.html":
        text = re.sub(r'<section id="environment".*?</section>', "", text, flags=re.DOTALL)
    if name == "report.md":
        text = re.sub(r"(?m)^## Where and when.*?(?=^## )", "", text, flags=re.DOTALL)
    if name == "report.json":
        return json.dumps(json.loads(text) | {"environment": None})
    return re.sub(r"(?m)^(- |<li>)This software: .*$", "", text)  # this line names the commit


class EveryPromisedFile(WrittenReport):
    def test_exit_code_and_silence(self):
        self.assertEqual((self.done.code, self.done.said), (0, ""))

    def test_files_are_those_promised(self):
        self.assertEqual(files_below(self.out), sorted(DATA + RESULTS + PICTURES + PAGES))

    def test_it_ends_with_the_verdict_in_short_and_the_page(self):
        scores = [one["score"] for one in self.told["ledger"]["readings"] if one["name"] in ("corrected", "m = 2", "equal faces")]
        self.assertIn(f"\nThe paper: {self.told['ledger']['summary']}. This is with the offset D_d (E9, m = 1); depending on E9 "
                      f"{min(scores)} to {max(scores)} are reproduced.\n", self.done.out)
        lines = self.done.out.splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("This software: "))
        software, *missed, page = lines[start:]
        count = collections.Counter(one["standing"] for one in self.told["findings"] if one["about"] == "software")
        targets = re.search(r"; (\d+|one) targets? (?:is|are) missed", (self.out / "report.md").read_text())  # what the page counts
        said = "no check misses a target"
        if targets:
            number = int(targets[1].replace("one", "1"))
            said = f"{count['missed']} {'misses' if count['missed'] == 1 else 'miss'} {number} {'target' if number == 1 else 'targets'}"
        self.assertEqual(software, f"This software: {count['holds']} checks hold, 0 fail, {said}, 0 did not run.")
        self.assertEqual(len(missed), count["missed"])
        self.assertEqual(told_page(page), (self.out / "index.html", len(files_below(self.out))))

    def test_svg_is_xml_that_needs_nothing_else(self):
        for figure in FIGURES + WORK_FIGURES:
            with self.subTest(figure):
                text = (self.out / f"figures/{figure}.svg").read_text()
                self.assertTrue(xml.fromstring(text).tag.endswith("svg"))
                self.assertGreater(text.count("<path"), 20)
                self.assertNotRegex(text, r"<script|href=.https?:")

    def test_png_is_wide_enough_to_read(self):
        for figure in FIGURES + WORK_FIGURES:
            with self.subTest(figure):
                content = (self.out / f"figures/{figure}.png").read_bytes()
                self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
                width, height = struct.unpack(">II", content[16:24])
                self.assertGreaterEqual(width, 1200)
                self.assertGreaterEqual(height, width / 2)
                self.assertEqual(content[-8:-4], b"IEND")

    def test_pictures_name_the_figure_units_and_onset(self):
        for figure in PAPER_FIGURES:
            with self.subTest(figure):
                text = "".join(xml.parse(self.out / f"figures/{figure}.svg").getroot().itertext())
                self.assertIn(f"Figure {int(figure[-2:])} redrawn", text)
                self.assertIn("u (m/s)", text)
                self.assertRegex(text, r"onset \(film maximum\)")

    def test_work_precision_data_are_the_baseline(self):
        baseline = json.loads((ROOT / "reference/baselines/work_precision.json").read_text())
        for job in JOBS:
            lines = (self.out / f"data/work_precision/{job}.blocks.tsv").read_text().splitlines()
            rows = [line.split("\t") for line in lines if line and line[0] not in '#"']
            expected = [row for row in baseline["error_against_work"] if row["job"] == job]
            self.assertEqual(sorted(row[3] for row in rows),
                             sorted(row["name"] for row in expected))
            self.assertEqual(sorted(float(row[4]) for row in rows),
                             sorted(row["ns"] for row in expected))

    def test_written_again_over_itself_it_has_the_same_bytes_but_for_the_environment(self):
        again = pathlib.Path(self.folder.name) / "again"
        shutil.copytree(self.out, again)
        for path in (again / name for name in files_below(again)):
            os.utime(path, (0, 0))
        self.assertEqual(report("--out", again, "--commit", "another",
                                environment={"SOURCE_DATE_EPOCH": "4102444800"}).code, 0)
        self.assertEqual(files_below(again), files_below(self.out))
        for name in DATA + PAGES + [p for p in PICTURES if p.endswith(".svg")]:
            with self.subTest(name):
                self.assertEqual(without_environment(name, (self.out / name).read_text()),
                                 without_environment(name, (again / name).read_text()))
        for name in RESULTS:
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes())
        self.assertEqual([name for name in files_below(again) if (again / name).stat().st_mtime == 0], [])


class Numbers(WrittenReport):
    def assert_close(self, mine, other, tolerance=1e-12):
        mine, other = float(mine), float(other)
        self.assertLessEqual(abs(mine - other), tolerance * abs(other), f"{mine!r} {other!r}")

    def assert_points_agree(self, rows, others):
        """The tolerance follows the conditions: close to its collapse a film h* is proportional to 1 − r, and a share has fewer
        digits where the other share is nearly the whole load."""
        numbers = ["film_flooded", "film", "film_parameter", "asperity_load_share",
                   "fluid_load_share", "real_area_ratio", "summit_count", "friction"]
        self.assertEqual(len(rows), len(others))
        for row, other in zip(rows, others):
            self.assertEqual((row["regime"], row["inlet"]), (other["regime"], other["inlet"]))
            flooded = float(row["film_flooded"])
            lambda_flooded = flooded / float(row["film"]) * float(row["film_parameter"]) \
                if float(row["film"]) else 4
            condition = 1 / abs(1 - lambda_flooded / 4) if lambda_flooded != 4 else 1
            for name in numbers:
                if other[name] == "":  # marks then have the limits of the shares, which the paper prints
                    self.assertEqual((row["regime"], row["inlet"]), ("collapsed", "collapsed"))
                    self.assertEqual(row[name] == "NaN", "event" not in row or name == "friction")
                    continue
                scale = 1 if name.endswith("load_share") else abs(float(other[name]))
                self.assertLessEqual(abs(float(row[name]) - float(other[name])),
                                     1e-12 * max(1, condition) * scale,
                                     f"{name} at {row['speed']}")

    def test_curves_agree_with_solve(self):
        for scene in SCENES:
            with self.subTest(scene):
                rows = table(self.out / f"data/curve_{scene}.tsv")
                speeds = [row["speed"] for row in rows]
                self.assertEqual(speeds, sorted(speeds, key=float))
                self.assert_points_agree(rows, solved(self.folder.name, speeds, scene))

    def test_groups_are_what_the_commands_answer(self):
        """The report has each number that `reproduce`, `verify` and `film` print."""
        ledger = run("reproduce", "--format", "json", cwd=ROOT).json()
        self.assertEqual((ledger.pop("schema"), ledger.pop("version")), ("reproduce/1", self.told["version"]))
        self.assertEqual({name: self.told["ledger"][name] for name in ledger}, ledger)
        quantities = run("verify", "--format", "json", cwd=ROOT).json()["quantities"]
        shown = {line.split()[0]: line.split() for line in run("verify", cwd=ROOT).out.splitlines() if " held" in line}
        for mine, other in zip(self.told["certified"]["quantities"], quantities, strict=True):
            other["held"] = other.pop("passed")
            self.assertEqual(mine, other | {"worst_part_of_bound": mine["worst_part_of_bound"]})
            allowed = f"{other['allowed_ulp']:g}" + (f" or {other['allowed_ulp_per_condition']:g} × cond." if other["allowed_ulp_per_condition"] else "")
            self.assertEqual(" ".join(shown[other["quantity"]]), " ".join((
                other["quantity"], str(other["cases"]), f"{other['worst_ulp']:.3g}", f"{other['worst_ulp_per_condition']:.3g}", allowed,
                f"{100 * mine['worst_part_of_bound']:.3g}", other["worst_row"], "held")))
        profile = self.told["line_films"]["profile"]
        film, = run("film", ROOT / profile["file"], "--speed", profile["speed"], "--format", "json").json()["films"]
        for name in ("load_number", "material_number", "half_width", "peak_pressure"):
            self.assert_close(profile[name], film[name])
        for name, other in (("central", film["central_film"]), ("minimum", film["minimum_film"])):
            self.assertEqual(profile[name], other)
        for end, value in film["spike_place"].items():
            self.assert_close(profile["spike_place"][end], value / film["half_width"])

    def test_scenes_of_the_json_are_those_of_solve(self):
        """Points of the scenes: half the load on the asperities, the least friction, and the share of faces in contact."""
        scenes = self.told["paper"]["scenes"]
        marks = {(row["event"], row["surface"], row["model"]): row for row in table(self.out / "data/marks.tsv")}
        for name, one in scenes.items():
            speeds = [one[point]["speed"] for point in ("slowest", "onset", "fastest")] + [one["equal_share_speed"]]
            *points, half = solved(self.folder.name, speeds, name)
            for at, row in zip(("slowest", "onset", "fastest"), points):
                for key, value in one[at].items():
                    if row[key] != "":
                        self.assert_close(value, row[key], 1e-9)
            self.assert_close(half["asperity_load_share"], 0.5, 1e-9)
            curve = [row for row in table(self.out / f"data/curve_{name}.tsv") if row["inlet"] != "collapsed"]
            self.assert_close(one["least_friction"], min(float(row["friction"]) for row in curve), 1e-3)
            self.assertLessEqual(one["least_friction"], min(float(row["friction"]) for row in curve) * (1 + 1e-12))
            for event in ("slowest", "onset", "collapse"):
                mark = marks.get((event, one["surface"], one["model"]))
                self.assertEqual(mark is None, one[event] is None)
                for key, value in (one[event] or {}).items():
                    if value is not None and mark[key] != "NaN":
                        self.assert_close(mark[key], value)
            printed = marks.get(("printed", one["surface"], one["model"]))
            if printed:
                self.assert_close(printed["asperity_load_share"], one["contact_share"])

    def test_slopes_of_figure_4_are_those_of_its_curves(self):
        two = self.told["paper"]["two_slopes"]
        guides = {}
        for row in table(self.out / "data/figure_04_guides.tsv"):
            guides.setdefault(row["slope of ln film in ln speed"], []).append((math.log(float(row["speed"])), math.log(float(row["film"]))))
        self.assertEqual(list(guides), ["0.67", "-1"])
        for slope, ((a, b), *_, (c, d)) in guides.items():
            self.assertAlmostEqual((d - b) / (c - a), float(slope), delta=1e-9)
        for name, slopes in two["curves"].items():
            rows = table(self.out / ("data/curve_smooth.tsv" if name == "paper" else f"data/figure_04_{name}.tsv"))
            for key, (a, b) in (("first_slope", rows[:2]), ("last_slope", rows[-2:])):
                if slopes[key] is not None:
                    slope = math.log(float(b["film"]) / float(a["film"])) / math.log(float(b["speed"]) / float(a["speed"]))
                    self.assertAlmostEqual(slopes[key], slope, delta=1e-3)

    def test_curves_span_the_scenes_speeds(self):
        for scene in SCENES:
            rows = table(self.out / f"data/curve_{scene}.tsv")
            self.assertGreaterEqual(len(rows), 600)
            self.assert_close(rows[0]["speed"], 1e-4, 1e-8)
            self.assert_close(rows[-1]["speed"], 3, 1e-8)

    def test_figure_4_agrees_with_solve(self):
        header = (self.out / "data/figure_04_damiens.tsv").read_text()
        flow = float(re.search(r"inlet_flow = (\S+) m2/s", header)[1])
        for name, changes in (("flooded", {"supply": None}),
                              ("damiens", {"supply": {"inlet_flow": flow}}),
                              ("starved_inlet", {"supply": {"inlet_flow": flow}})):
            with self.subTest(name):
                rows = table(self.out / f"data/figure_04_{name}.tsv")
                closures = {"asperity": "greenwood_tripp",
                            "starvation": "flooded_inlet" if name == "flooded" else name}
                others = solved(self.folder.name, [r["speed"] for r in rows], "smooth",
                                closures=closures, **changes)
                for row, other in zip(rows, others, strict=True):
                    self.assert_close(row["film"], other["film"])

    def test_figure_4_has_both_slopes(self):
        def last_slope(name):
            first, last = table(self.out / f"data/figure_04_{name}.tsv")[-2:]
            return (math.log(float(last["film"]) / float(first["film"])) /
                    math.log(float(last["speed"]) / float(first["speed"])))
        self.assertAlmostEqual(last_slope("flooded"), 0.67, delta=1e-3)
        self.assertAlmostEqual(last_slope("damiens"), -1, delta=1e-3)
        self.assertAlmostEqual(last_slope("starved_inlet"), -1, delta=0.02)

    def test_onsets_agree_with_onset(self):
        paths = [PUBLISHED / f"{scene}.toml" for scene in SCENES]
        onsets = {}
        for line in run("onset", *paths, "--format", "csv").out.splitlines()[1:]:
            cells = next(csv.reader([line]))
            onsets[cells[0], cells[1]] = cells[2:]
        for row in table(self.out / "data/comparison.tsv"):
            if row["criterion"] == "-":
                continue
            scene = row["surface"] + ("_gw" if row["model"] == "GW" else "")
            speed, _, film_parameter = onsets[scene, row["criterion"]][:3]
            expected = speed if row["quantity"] == "onset_speed" else film_parameter
            with self.subTest(scene=scene, criterion=row["criterion"], quantity=row["quantity"]):
                if expected == "":
                    self.assertEqual(row["computed"], "NaN")
                    self.assertNotIn(row["verdict"], ("", "no number in the paper"))
                else:
                    self.assert_close(row["computed"], expected)

    def test_onset_film_parameter_is_that_of_the_closed_form(self):
        for row in table(self.out / "data/comparison.tsv"):
            if (row["quantity"], row["criterion"]) == ("onset_film_parameter", "film_maximum"):
                self.assert_close(row["computed"], 1.43166235170080, 1e-13)
                self.assertEqual(row["verdict"], "reproduced")

    def test_slow_shares_are_those_of_the_specification(self):
        shares = {row["surface"]: row["computed"] for row in table(self.out / "data/comparison.tsv")
                  if (row["quantity"], row["model"]) == ("slow_asperity_share", "GT")}
        for surface, share in (("rough", 0.765412364174454), ("medium", 0.642288015366864),
                               ("smooth", 0.537872259415982)):
            self.assert_close(shares[surface], share, 1e-13)

    def test_factors_are_computed_over_reported(self):
        lines = (PUBLISHED / "claims.tsv").read_text().splitlines()
        claims = csv.DictReader((line for line in lines if not line.startswith("#")), delimiter="\t")
        claims = {(row["quantity"], row["surface"]): row for row in claims}
        reported = {key: (row["value"], row["last_digit"]) for key, row in claims.items()}
        rows = table(self.out / "data/comparison.tsv")
        with_factor = [row for row in rows if row["computed/reported"] != "NaN"]
        self.assertEqual(len(rows), 24 + 24 + 6)
        self.assertGreater(len(with_factor), 40)
        for row in rows:
            claim = claims.get((row["quantity"], row["surface"]))
            is_reported = claim is not None and claim["model"] in (row["model"], "both")
            self.assertEqual(row["reported"] != "NaN", is_reported, row)
        for row in with_factor:
            value, last_digit = map(float, reported[row["quantity"], row["surface"]])
            self.assertEqual(float(row["reported"]), value)
            self.assert_close(row["computed/reported"], float(row["computed"]) / value)
            is_inside = abs(float(row["computed"]) - value) <= last_digit / 2
            self.assertEqual(row["verdict"] == "reproduced", is_inside, row)

    def test_verdicts_count_what_agrees(self):
        rows = table(self.out / "data/comparison.tsv")
        for quantity, found in self.told["paper"]["comparisons"].items():
            told = [row for row in rows if row["quantity"] == quantity and row["reported"] != "NaN"
                    and row["criterion"] in ("-", "film_maximum")]
            inside = sum(row["verdict"] == "reproduced" for row in told)
            self.assertEqual((found["agreeing"], found["counted"]), (inside, len(told)))
            factors = [float(row["computed/reported"]) for row in told]
            self.assertEqual(found["factors"], [min(factors), max(factors)])
            self.assertRegex(self.text, rf"{inside} of {len(told)} values \([^)]*\) round to what the paper prints")
            standing = next(one["standing"] for one in self.told["findings"] if one["id"] == quantity)
            self.assertEqual(standing, "holds" if inside == len(told) else "differs")

    def test_claims_are_told_by_their_verdicts(self):
        verdicts = {}
        for row in csv.DictReader(io.StringIO((self.out / "data/ledger.csv").read_text())):
            if row["reading"] == "corrected":
                verdicts[row["claim"]] = row["claim_verdict"]
        told = {"reproduced": [], "in between": [], "not reproduced": []}
        for claim, verdict in verdicts.items():
            told[verdict if verdict in told else "in between"].append(claim)
        count = [len(claims) for claims in told.values()]
        summary = "{} of the paper's 17 claims are reproduced, {} partly, {} not".format(*count)
        self.assertEqual(self.told["ledger"]["summary"], summary)
        lists = [", ".join(claims) or "none of them" for claims in told.values()]
        self.assertIn("reproduced: {}; partly: {}; not: {}.".format(*lists), self.text)

    def test_page_and_terminal_begin_with_the_ledgers_numbers(self):
        ledger = {row["item"]: row for row in csv.DictReader(io.StringIO((self.out / "data/ledger.csv").read_text()))
                  if row["reading"] == "corrected"}
        first = self.text.split("\n## ")[0]
        for item in ("C1.smooth", "C1.medium", "C1.rough", "C2.smooth", "C4.rough", "C4.smooth"):
            row = ledger[item]
            computed = f"{float(row['computed']):.4g}"
            times = "" if row["verdict"] == "reproduced" else r" \([\d.]+ times\)"
            self.assertRegex(first, rf"\| {float(row['reported']):g} \| {float(row['computed']):#.3g}{times}: {row['verdict']} \|")
            self.assertRegex(self.done.out, rf"(?m) {float(row['reported']):g}( m/s)? +{computed}( m/s)? +.* "
                                               rf"{row['verdict']}$")

    def test_the_least_friction_has_the_same_digits_everywhere(self):
        speeds = {row["surface"]: row["computed"] for row in table(self.out / "data/comparison.tsv")
                  if (row["quantity"], row["model"], row["criterion"]) == ("onset_speed", "GT", "friction_minimum")}
        for row in table(self.out / "data/ledger_surfaces.tsv"):
            self.assertEqual(row["friction_minimum"], speeds[row["surface"]])

    def test_inputs_are_those_of_the_scenes(self):
        """All inputs, with the defaults for fields that the file does not have."""
        inputs = {one["field"]: one for one in self.told["paper"]["inputs"]}
        for scene in SCENES:
            self.assertEqual((self.out / f"data/scenes/{scene}.toml").read_bytes(),
                             (PUBLISHED / f"{scene}.toml").read_bytes())
            tree = tomllib.loads((PUBLISHED / f"{scene}.toml").read_text())
            for section, value in tree.items():
                for name, one in (value.items() if isinstance(value, dict) else [(None, value)]):
                    field = f"{section}.{name}" if name else section
                    if field not in ("id", "accept", "speed.count", "speed.spacing"):
                        self.assertEqual(inputs[field]["values"][scene], one, field)
        self.assertEqual(inputs["friction.slide_roll_ratio"]["values"]["rough"], 1)
        self.assertEqual({field for field, one in inputs.items() if one["erratum"] in ("E17", "E18")},
                         {"surface.summit_radius", "bodies.reduced_radius"})

    def test_marks_lie_on_the_curves(self):
        for row in table(self.out / "data/marks.tsv"):
            scene = row["surface"] + ("_gw" if row["model"] == "GW" else "")
            other = solved(self.folder.name, [row["speed"]], scene)
            self.assert_points_agree([row], other)
            if row["event"] == "printed":  # the limits A(0) and 1 - A(0) go on to the highest speed
                self.assertEqual(row["regime"], "collapsed")
                collapse, = (one for one in table(self.out / "data/marks.tsv") if one["event"] == "collapse" and
                             (one["surface"], one["model"]) == (row["surface"], row["model"]))
                for share in ("asperity_load_share", "fluid_load_share"):
                    self.assertEqual(row[share], collapse[share])
                self.assertAlmostEqual(float(row["asperity_load_share"]) + float(row["fluid_load_share"]), 1, 15)
            if row["event"] == "collapse":
                self.assertEqual((row["inlet"], float(row["film"])), ("collapsed", 0))
                before = solved(self.folder.name, [math.nextafter(float(row["speed"]), 0)], scene)
                self.assertNotEqual(before[0]["inlet"], "collapsed")


class Failures(unittest.TestCase):
    def setUp(self):
        self.path = folder_until(self.addCleanup)

    def assert_refused(self, done, *words, code=2):
        self.assertEqual(done.code, code, done.err)
        self.assertEqual(done.out, "")
        for word in words:
            self.assertIn(word, done.err)
        self.assertTrue(all(line.startswith("tribocheck: ") for line in done.error_lines))

    def scenes(self):
        copy = self.path / "scenes"
        shutil.copytree(PUBLISHED, copy)
        return copy

    def test_without_gnuplot_all_but_the_figures_is_written(self):
        out = self.path / "out"
        (out / "figures").mkdir(parents=True)
        (out / "figures/figure_07.svg").write_text("an old one")
        (self.path / "empty").mkdir()
        done = report("--out", out, environment={"PATH": str(self.path / "empty")}).ended(1)
        self.assertEqual(len(done.error_lines), 1, done.err)
        self.assertIn("gnuplot was not found", done.err)
        self.assertIn("onset speed, smooth", done.out)
        self.assertEqual(files_below(out), sorted(DATA + RESULTS + PAGES))
        self.assertEqual(told_page(done.out), (out / "index.html", len(files_below(out))))
        page = PageReader((out / "index.html").read_text())
        self.assertEqual((page.problems, page.pictures), ([], []))
        text = (out / "index.html").read_text()
        self.assertEqual(text.count("Not drawn"), len(FIGURES + WORK_FIGURES))
        missing = re.search(r'<section id="not-run".*?</section>', text, re.DOTALL)[0]
        self.assertEqual(missing.count("<tr>") - 1, len(FIGURES + WORK_FIGURES) + NOT_RUN)

    def test_without_a_package_of_python_the_data_are_written(self):
        (self.path / "jinja2.py").write_text('raise ImportError(name="jinja2")\n')
        out = self.path / "out"
        done = report("--out", out, "--section", "work-precision", environment={"PYTHONPATH": str(self.path)})
        self.assertEqual((done.code, len(done.error_lines)), (1, 1), done.err)
        self.assertIn("jinja2 is missing", done.err)
        self.assertIn(f"The data: {out}/report.json", done.out)
        written = json.loads((out / "report.json").read_text())
        self.assertEqual(files_below(out), sorted([*written["files"], "report.json", "report.schema.json"]))

    def test_gnuplot_that_fails_is_quoted(self):
        fake = self.path / "gnuplot"
        fake.write_text("#!/bin/sh\necho half > \"$6\"\necho no such terminal >&2\nexit 3\n")
        fake.chmod(0o755)
        out = self.path / "out"
        done = report("--out", out, "--section", "figures",
                      environment={"PATH": f"{self.path}:{os.environ.get('PATH', '')}"}).ended(1)
        self.assertEqual(len(done.error_lines), len(PAPER_FIGURES))
        self.assertIn("no such terminal", done.err)
        self.assertEqual([name for name in files_below(out) if name.startswith("figures/")], [])
        self.assertLessEqual({*PAGES, "data/marks.tsv"}, set(files_below(out)))

    def test_unwritable_folder_is_one_clear_line(self):
        file = self.path / "file"
        file.write_text("")
        for out in (file, file / "below", "/proc/none"):
            with self.subTest(str(out)):
                done = report("--out", out)
                self.assert_refused(done, "cannot write", str(out), code=1)
                self.assertEqual(len(done.error_lines), 1)

    def test_file_that_cannot_replace_a_folder(self):
        out = self.path / "out"
        (out / "data/marks.tsv").mkdir(parents=True)
        done = report("--out", out, "--section", "comparison")
        self.assert_refused(done, "cannot write", "marks.tsv", code=1)
        self.assertEqual([name for name in files_below(out) if "/." in name], [])

    def test_bad_scenes_are_all_named(self):
        scenes = self.scenes()
        (scenes / "rough.toml").unlink()
        (scenes / "smooth.toml").write_text("load = -1\n")
        done = report("--scenes", scenes, "--out", self.path / "out")
        self.assert_refused(done, "rough.toml", "smooth.toml", "load")
        self.assertFalse((self.path / "out").exists())

    def test_scene_of_the_wrong_model(self):
        scenes = self.scenes()
        shutil.copy(scenes / "rough.toml", scenes / "rough_gw.toml")
        done = report("--scenes", scenes, "--out", self.path / "out")
        self.assert_refused(done, "rough_gw.toml", "greenwood_williamson")

    def test_scenes_of_ellipses_and_lines_are_listed_with_their_own_inputs(self):
        """The ledger, which is about the paper's circle, refuses other contacts with a reason."""
        for fields, film in (({"radius_x": 9.5e-3, "radius_y": 19e-3}, "hamrock_dowson_central"),
                             ({"radius_x": 9.5e-3, "length": 5e-4}, "dowson_toyoda_central")):
            with self.subTest(film):
                scenes, out = self.path / film, self.path / f"{film}.out"
                shutil.copytree(PUBLISHED, scenes)
                for scene in SCENES:
                    path = scenes / f"{scene}.toml"
                    text = re.sub(r"(?m)^reduced_radius = .*", "\n".join(f"{k} = {v}" for k, v in fields.items()),
                                  path.read_text())
                    path.write_text(text.replace("[closures]", f'[closures]\nfilm = "{film}"'))
                report("--scenes", scenes, "--out", out, "--section", "comparison", "--section", "claims").ended(0)
                told = json.loads((out / "report.json").read_text())
                inputs = {one["field"]: one["values"]["smooth"] for one in told["paper"]["inputs"]}
                self.assertEqual({name: inputs.get(f"bodies.{name}") for name in
                                  ("reduced_radius", "ellipticity", "radius_x", "radius_y", "length")},
                                 {"reduced_radius": None, "ellipticity": None, "radius_y": None, "length": None} | fields)
                self.assertEqual(inputs["closures.film"], film)
                self.assertIn("the ledger needs bodies.reduced_radius", told["ledger"]["missing"]["why"])
                rows = table(out / "data/curve_smooth.tsv")
                path = scenes / "smooth.toml"
                path.write_text(re.sub(r"(?m)^speed = .*", f"speed = {float(rows[99]['speed'])!r}", path.read_text()))
                solved = run("solve", path, "--format", "csv").rows()[0]
                self.assertAlmostEqual(float(rows[99]["film"]) / float(solved["film"]), 1, delta=1e-12)

    def test_scene_without_a_range_of_speeds(self):
        scenes = self.scenes()
        text = (scenes / "rough.toml").read_text()
        (scenes / "rough.toml").write_text(re.sub(r"(?m)^speed = .*", "speed = 1", text))
        done = report("--scenes", scenes, "--out", self.path / "out")
        self.assert_refused(done, "rough.toml", "range of speeds")

    def test_missing_or_broken_reported_values(self):
        scenes = self.scenes()
        original = (scenes / "claims.tsv").read_text()
        for text, word in ((original.replace("\t0.82\t", "\t0,820\t"), "is no number"),
                           (original + "C1\tonset_speed\n", "columns"),
                           (None, "cannot be read")):
            with self.subTest(word):
                (scenes / "claims.tsv").unlink()
                if text is not None:
                    (scenes / "claims.tsv").write_text(text)
                done = report("--scenes", scenes, "--out", self.path / "out")
                self.assert_refused(done, "claims.tsv", word)
                (scenes / "claims.tsv").touch()

    def test_scenes_that_never_starve_have_no_onset(self):
        """No mark is drawn, no number is made up, and gnuplot draws the figures."""
        scenes = self.scenes()
        for scene in SCENES:
            path = scenes / f"{scene}.toml"
            path.write_text(re.sub(r"inlet_film_ratio = 4", "inlet_film_ratio = 1e4",
                                   path.read_text()))
        out = self.path / "out"
        report("--scenes", scenes, "--out", out, "--section", "figures", "--section", "comparison").ended(0, "")
        self.assertNotIn("onset\trough", (out / "data/marks.tsv").read_text())

    def test_folder_outside_the_project(self):
        """The program finds the project above itself, or tells where it has looked."""
        done = report("--out", self.path / "out", "--section", "environment", cwd=self.path)
        if any((one / "reports/page/render").is_dir() for one in pathlib.Path(PROGRAM).resolve().parents):
            self.assertEqual((done.code, done.err), (0, ""))
            self.assertTrue((self.path / "out/index.html").is_file())
        else:
            self.assert_refused(done, "reports/page/render")

    def test_scenes_folder_that_is_none(self):
        self.assert_refused(report("--scenes", self.path / "none", "--out", self.path / "out"),
                            "none", "--scenes")

    def test_default_folders_are_the_projects(self):
        project = project_copy(self.path, "published")
        (project / "deep/below").mkdir(parents=True)
        report("--section", "comparison", cwd=project / "deep/below").ended(0)
        self.assertTrue((project / "reports/out/index.html").is_file())
        self.assertIn("reference/published/rough.toml",
                      (project / "reports/out/data/curve_rough.tsv").read_text())

    def test_a_changed_verdict_breaks_the_ledgers_promise_and_a_moved_number_does_not(self):
        project = project_copy(self.path, "published", "baselines")
        path = project / "reference/baselines/ledger.csv"
        whole = path.read_text()
        rows = list(csv.reader(io.StringIO(whole)))
        for column, value, standing in (("computed", "2.2", "holds"), ("verdict", "in part", "fails"), (None, "", "absent")):
            with self.subTest(column):
                path.write_text(whole.replace(",".join(rows[1]), ",".join(
                    value if name == column else cell for name, cell in zip(rows[0], rows[1]))))
                if column is None:
                    path.unlink()
                done = report("--section", "claims", cwd=project).ended(0, "")
                page = json.loads((project / "reports/out/report.json").read_text())
                self.assertEqual([one["standing"] for one in page["findings"] if one["id"] == "committed_ledger"],
                                 [standing])
                self.assertEqual("  FAILS: committed_ledger: verdict changed: C1.rough" in done.out,
                                 standing == "fails", done.out)
                self.assertEqual([one["how_to"] for one in page["not_run"]],
                                 ["`make ledger`"] if standing == "absent" else [])

    def test_help_has_an_example(self):
        self.assertIn("Example", report("--help").ended(0).out)


if __name__ == "__main__":
    unittest.main()
