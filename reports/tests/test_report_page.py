# SPDX-License-Identifier: Apache-2.0
"""The page of `tribocheck report` as HTML, Markdown and JSON. Needs gnuplot, as the program does."""

import copy
import datetime
import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

import jsonschema
import page_pictures
import page_sentences
import page_tables
from page_perturbed import perturbed
from report_files import FIGURES, ROOT, SECTIONS, WORK_FIGURES, PageReader, WrittenReport, report, table


COMMON = {"schema", "version", "sections", "findings", "not_run", "files"}


class Page(WrittenReport):
    def test_html_is_well_formed_and_its_targets_exist(self):
        page = PageReader((self.out / "index.html").read_text())
        self.assertEqual(page.problems, [])
        self.assertEqual(sorted(page.figures), sorted(FIGURES + WORK_FIGURES))
        self.assertEqual(sorted(page.figures[-len(WORK_FIGURES):]), sorted(WORK_FIGURES))
        self.assertEqual(len(page.pictures), len(page.figures))
        self.assertEqual(sorted(set(page.ids)), sorted(page.ids))
        for picture in page.pictures:
            self.assertEqual(picture["role"], "img")
            self.assertLessEqual(set(picture["aria-labelledby"].split()), set(page.ids))
        for target in page.links:
            if target.startswith("#"):
                self.assertIn(target[1:], page.ids)
            else:
                self.assertTrue((self.out / target).is_file(), target)
        self.assertEqual(page.headings[0], 1)
        self.assertEqual(page.headings.count(1), 1)
        for above, below in zip(page.headings, page.headings[1:]):
            self.assertLessEqual(below, above + 1)

    def test_picture_in_the_page_is_the_svg_file(self):
        """The page gives pictures other identifiers, and defines each identifier that it uses. Its paths have the numbers of the file's
        paths in the same order. It writes 86.4 for 86.40, and leaves out the command L, which SVG implies."""
        def paths(svg):
            drawn = re.findall(r" d='([^']+)'", svg.split("</defs>", 1)[1])
            return [[one if one.isalpha() else float(one) for one in re.findall(r"[A-KM-Za-z]|-?\d+\.?\d*", path)] for path in drawn]

        text = (self.out / "index.html").read_text()
        used = set(re.findall(r"(?:href=['\"]|url\()#([^'\")]+)", text))
        self.assertGreater(len(used), 100)
        self.assertLessEqual(used, set(PageReader(text).ids))
        for figure in FIGURES + WORK_FIGURES:
            picture = re.search(f'<figure id="{figure}">.*?(<svg.*?</svg>)', text, re.DOTALL)[1]
            file = paths((self.out / f"figures/{figure}.svg").read_text())
            self.assertGreater(sum(map(len, file)), 50)
            self.assertEqual(paths(picture), file)

    def test_each_figure_links_its_data(self):
        text = (self.out / "index.html").read_text()
        for figure in FIGURES + WORK_FIGURES:
            caption = re.search(f'<figure id="{figure}">.*?<figcaption>(.*?)</figcaption>', text,
                                re.DOTALL)[1]
            self.assertRegex(caption, r'<a href="data/[^"]+\.tsv">')
            self.assertIn(f'<a href="figures/{figure}.png">', caption)

    def test_markdown_targets_exist(self):
        text = re.sub(r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", "", self.text)  # without code
        targets = re.findall(r"\]\(([^)]+)\)", text)
        self.assertEqual(sorted(re.findall(r"!\[[^\]]*\]\(figures/([^)]+)\.png\)", text)), sorted(FIGURES + WORK_FIGURES))
        for target in targets:
            if target.startswith("#"):
                self.assertIn(f'<a id="{target[1:]}"></a>', text)
            elif not target.startswith("https://"):
                self.assertTrue((self.out / target).is_file(), target)

    def test_pictures_take_the_columns_of_a_curve_by_their_places(self):
        names = next(iter(table(self.out / "data/curve_rough.tsv")))
        frame = (ROOT / "reports/page/gnuplot/stribeck.gp").read_text()
        places = dict(re.findall(r"(\w+) = (\d+)[;\n]", frame))
        called = {"asperity_share": "asperity_load_share", "fluid_share": "fluid_load_share", "area": "real_area_ratio",
                  "summits": "summit_count"}
        self.assertEqual(set(places), {"speed", "film", "film_parameter", "friction", "inlet", *called})
        for name, place in places.items():
            self.assertEqual(list(names)[int(place) - 1], called.get(name, name), "stribeck.gp counts other columns than curves have")

    def test_sections_and_tables_are_whole(self):
        text = (self.out / "index.html").read_text()
        self.assertEqual(self.told["sections"], SECTIONS)
        self.assertEqual(re.findall(r'<section id="([^"]+)"', text), SECTIONS + ["not-run", "data"])
        tables = re.findall(r"<table>.*?</table>", text, re.DOTALL)
        self.assertGreater(len(tables), 20)
        for one in tables:
            head, *rows = re.findall(r"<tr>(.*?)</tr>", one, re.DOTALL)
            self.assertTrue(rows, one[:200])
            for row in rows:
                self.assertEqual(row.count("<td") + row.count("<th"), head.count("<th"), row)
        self.assertGreater(len(self.told["findings"]), 8)
        standings = {one["standing"] for one in self.told["findings"]}
        self.assertLessEqual(standings, {"holds", "differs", "missed", "measured"})
        self.assertLessEqual({one["section"] for one in self.told["findings"]}, set(SECTIONS))
        self.assertEqual(len(re.findall('<div class="finding ', text)), len(self.told["findings"]))
        self.assertNotIn("It has no data.", text)

    def assert_tells(self, page, told):
        """Asserts that the tables have the numbers of the JSON with the digits of their columns, in the order of the page, and no other
        cells. Asserts that the prose has the numbers of the JSON."""
        shown, promised = list(page_tables.shown(page)), list(page_tables.promised(told))
        self.assertEqual([caption for caption, _, _ in shown], [caption for caption, _, _ in promised])
        for (caption, head, rows), (_, names, cells) in zip(shown, promised):
            with self.subTest(caption):
                self.assertEqual(head, names)
                if cells is not None:
                    self.assertEqual([row for row in rows if "gnuplot was not found in PATH" not in row], cells)
        page = re.sub(r"<(svg|script|style|table)\b.*?</\1>", "", page, flags=re.DOTALL)
        text = re.sub("[ \n]+", " ", page_tables.read(page))
        for sentence in page_sentences.promised(told):
            with self.subTest(sentence):
                if isinstance(sentence, tuple):
                    self.assertNotIn(page_tables.plain(sentence[1]), text)
                else:
                    self.assertIn(page_tables.plain(sentence), text)
        badges = re.findall(r'<div class="finding (\w+)">', page)
        ranks = {"fails": 0, "missed": 1}
        self.assertEqual(badges, [one["standing"] for about in ("paper", "software") for one in sorted(
            (one for one in told["findings"] if one["about"] == about), key=lambda one: ranks.get(one["standing"], 2))])

    def test_each_cell_and_each_number_of_the_prose_is_that_of_the_json(self):
        self.assert_tells((self.out / "index.html").read_text(), self.told)

    def test_so_are_those_of_other_numbers(self):
        """Real numbers may be equal or far from a limit, and would not show exchanged fields or wrong thresholds. These are random."""
        out = pathlib.Path(self.folder.name) / "other"
        out.mkdir()
        for seed in (1, 2, 3):
            told = perturbed(self.told, seed)
            (out / "report.json").write_text(json.dumps(told))
            done = subprocess.run([sys.executable, "-B", ROOT / "reports/page/render/render.py", out], env={"PATH": ""}, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            with self.subTest(seed=seed):
                self.assert_tells((out / "index.html").read_text(), told)

    def test_summaries_are_of_their_rows(self):
        """The fits' greatest errors up to both radius ratios are those of their data. The numbers of skipped work fit together."""
        fits = self.told["ellipse_fits"]
        names = {"ellipticity": "ellipticity", "semi_axis_x": "semi-axis a_x", "peak_pressure": "peak pressure", "approach": "approach"}
        for one, (title, rows) in zip(fits["fits"], page_pictures.blocks(self.out / "data/ellipse_fits.blocks.tsv"), strict=True):
            self.assertEqual(one["name"], title)
            for to, ratio in (("moderate", fits["moderate_ratio"]), ("greatest", fits["greatest_ratio"])):
                for key, column in names.items():
                    self.assertEqual(one[to][key], max(abs(float(row[column])) for row in rows if float(row["R_y/R_x"]) <= ratio))
        work = self.told["skipped_work"]
        saved = [row["saved"] for row in work["rows"]]
        self.assertEqual((work["least_saved"], work["greatest_saved"]), (min(saved), max(saved)))
        speeds = {}
        for row in work["rows"]:
            collapsed = self.told["paper"]["scenes"][row["scene"]]["collapse"]
            self.assertEqual(row["starvation_skipped"] > 0, collapsed is not None)
            if collapsed:  # speeds are spaced evenly in their logarithm; those beyond the collapse are skipped
                low, high = (self.told["paper"]["scenes"][row["scene"]][end]["speed"] for end in ("slowest", "fastest"))
                part = math.log(high / collapsed["speed"]) / math.log(high / low)
                self.assertAlmostEqual(row["starvation_skipped"] / work["speeds"], part, delta=2 / work["speeds"])
            both = row["roots_that_are_film"] + row["roots_that_are_floor"]
            self.assertEqual(speeds.setdefault(row["scene"], (row["root_steps"], both)), (row["root_steps"], both))
            self.assertEqual(row["shares_skipped"] > 0, row["asked"] in (["film"], ["real_area_ratio"]), row)

    def test_each_picture_draws_its_data_at_the_places_that_its_axes_tell(self):
        """Each series has the name, the colour and the points of its data, and nothing is drawn where no point is."""
        data = page_pictures.Data(self.out, self.told)
        for figure in FIGURES + WORK_FIGURES:
            with self.subTest(figure):
                self.assertEqual(page_pictures.differences(self.out / f"figures/{figure}.svg", figure, data), [])

    def test_no_template_leaves_its_marks(self):
        """No mark of Jinja or of indices is left, no cell has a word of Python, and no number has all its digits."""
        for name in ("index.html", "report.md"):
            text = re.sub(r"<(?:svg|script|style).*?</(?:svg|script|style)>|`[^`]*`|<code>.*?</code>", "",
                          (self.out / name).read_text(), flags=re.DOTALL)
            for mark in (r"\{\{|\}\}|\{%|%\}", r"(?<=[>|]) ?(?:None|True|False|nan) ?(?=[<|])", r"&lt;su[bp]&gt;",
                         r"\w~[\w/]+~", r"[1-9]\.\d{15,}|\b0\.0*[1-9]\d{15,}"):
                found = re.search(f".{{0,40}}(?:{mark}).{{0,40}}", text)
                self.assertIsNone(found, found and (name, found[0]))

    def test_the_paper_and_this_software_are_told_apart(self):
        text = self.text
        paper = text.split("\n## Results: the paper\n")[1].split("\n## ")[0]
        software = text.split("\n## Results: checks of this software\n")[1].split("\n## ")[0]
        for about, part in (("paper", paper), ("software", software)):
            found = sorted(one["section"] for one in self.told["findings"] if one["about"] == about)
            self.assertEqual(sorted(re.findall(r"\(#([a-z-]+)\)", part)), found)

    def test_environment_says_where_and_what(self):
        again = pathlib.Path(self.folder.name) / "told"
        done = report("--out", again, "--commit", "0123abc & more", "--section", "environment",
                      environment={"SOURCE_DATE_EPOCH": "4102444800"})  # 2100-01-01
        self.assertEqual(done.code, 0)
        told = json.loads((again / "report.json").read_text())["environment"]
        page = (again / "report.md").read_text()
        self.assertEqual((told["commit"], told["date"]), ("0123abc & more", "2100-01-01"))
        self.assertTrue(all(told[name] for name in ("compiler", "processor", "kernel")))
        self.assertIn("| commit | `0123abc & more` |", page)
        self.assertGreater(len(told["baselines"]), 6)
        for row in told["baselines"]:
            left = json.loads((ROOT / "reference/baselines" / row["file"]).read_text())
            days = (datetime.date(2100, 1, 1) - datetime.date.fromisoformat(left["date"])).days
            self.assertEqual((row["date"], row["age_in_days"], row["commit"]), (left["date"], days, left["commit"]))
            self.assertRegex(page, rf"\| `{row['file']}` .*`{left['commit'][:12]}[^|]*` \| {left['date']} \| {days} \|")


def values(schema, path="report"):
    """Yields the schema of each value, with its path. A schema in `oneOf` is no value: only its properties are yielded."""
    yield path, schema
    for name, one in schema.get("properties", {}).items():
        yield from values(one, f"{path}.{name}")
    for key in ("items", "additionalProperties"):
        if isinstance(schema.get(key), dict):
            yield from values(schema[key], f"{path}.{key}")
    for one in schema.get("oneOf", []):
        for name, inner in one.get("properties", {}).items():
            yield from values(inner, f"{path}.{name}")


class Schema(WrittenReport):
    """report.json agrees with report.schema.json beside it, which describes each of its values."""
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.schema = json.loads((cls.out / "report.schema.json").read_text())

    def problems(self, report):
        return [f"{error.json_path}: {error.message[:300]}"
                for error in jsonschema.Draft202012Validator(self.schema).iter_errors(report)]

    def test_the_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)

    def test_the_report_is_what_it_says(self):
        self.assertEqual(self.problems(self.told), [])

    def test_each_group_is_there_and_described(self):
        groups = set(self.told) - COMMON
        self.assertEqual(self.schema, json.loads((ROOT / "reports/page/groups/report.schema.json").read_text()))
        self.assertEqual(set(self.schema["properties"]), groups | COMMON)
        for name in groups:
            self.assertNotIn("missing", self.told[name], name)

    def test_each_value_says_what_it_is(self):
        for path, schema in values(self.schema):
            if not path.endswith((".items", ".additionalProperties")):
                self.assertTrue(schema.get("description"), path)
            if schema.get("type") == "object" and schema.get("properties"):
                self.assertIs(schema["additionalProperties"], False, path)

    def test_what_is_lacking_unknown_or_of_another_type_is_seen(self):
        for name in set(self.told) - COMMON:
            for key, value in self.told[name].items():
                with self.subTest(group=name, key=key):
                    other = copy.deepcopy(self.told)
                    other[name][key] = "text" if isinstance(value, list) else [[]]
                    self.assertTrue(self.problems(other))
            with self.subTest(group=name):
                self.assertTrue(self.problems(self.told | {name: self.told[name] | {"unknown": 1}}))
                self.assertTrue(self.problems(self.told | {name: dict(list(self.told[name].items())[1:])}))


if __name__ == "__main__":
    unittest.main()
