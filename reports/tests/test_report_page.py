# SPDX-License-Identifier: Apache-2.0
"""The page of `tribocheck report` as HTML, Markdown and JSON. Needs gnuplot, as the program does."""

import datetime
import json
import pathlib
import re
import unittest

from report_files import FIGURES, ROOT, SECTIONS, WORK_FIGURES, PageReader, WrittenReport, report


class Page(WrittenReport):
    def test_html_is_well_formed_and_its_targets_exist(self):
        page = PageReader((self.out / "index.html").read_text())
        self.assertEqual(page.problems, [])
        self.assertEqual(page.figures, FIGURES + WORK_FIGURES)
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
        self.assertNotIn("<script", (self.out / "index.html").read_text())
        self.assertEqual(page.headings[0], 1)
        self.assertEqual(page.headings.count(1), 1)
        for above, below in zip(page.headings, page.headings[1:]):
            self.assertLessEqual(below, above + 1)

    def test_picture_in_the_page_is_the_svg_file(self):
        """With identifiers of its own, and each that is used is set."""
        text = (self.out / "index.html").read_text()
        used = set(re.findall(r"(?:href=['\"]|url\()#([^'\")]+)", text))
        self.assertGreater(len(used), 100)
        self.assertLessEqual(used, set(PageReader(text).ids))
        for figure in FIGURES + WORK_FIGURES:
            picture = re.search(f'<figure id="{figure}">.*?(<svg.*?</svg>)', text, re.DOTALL)[1]
            paths = re.findall(r" d='[^']+'", (self.out / f"figures/{figure}.svg").read_text())
            self.assertEqual(re.findall(r" d='[^']+'", picture), paths)

    def test_each_figure_links_its_data(self):
        text = (self.out / "index.html").read_text()
        for figure in FIGURES + WORK_FIGURES:
            caption = re.search(f'<figure id="{figure}">.*?<figcaption>(.*?)</figcaption>', text,
                                re.DOTALL)[1]
            self.assertRegex(caption, r'<a href="data/[^"]+\.tsv">')
            self.assertIn(f'<a href="figures/{figure}.png">', caption)

    def test_markdown_targets_exist(self):
        text = (self.out / "report.md").read_text()
        targets = re.findall(r"\]\(([^)]+)\)", text)
        self.assertEqual(len([t for t in targets if t.endswith(".png")]),
                         len(FIGURES + WORK_FIGURES))
        for target in targets:
            self.assertTrue((self.out / target).is_file(), target)

    def test_json_has_what_the_page_shows(self):
        page = json.loads((self.out / "report.json").read_text())
        self.assertEqual([section["id"] for section in page["sections"]], SECTIONS)
        text = (self.out / "index.html").read_text()
        figures = [figure["id"] for section in page["sections"] for figure in section["figures"]]
        self.assertEqual(figures, FIGURES + WORK_FIGURES)
        tables = [one for section in page["sections"] for one in section["tables"]]
        self.assertEqual(len(tables), text.count("<table>"))
        for one in tables:
            self.assertTrue(one["rows"], one["caption"])
            for row in one["rows"]:
                self.assertEqual(len(row), len(one["columns"]), one["caption"])
        self.assertGreater(len(page["verdicts"]), 8)
        standings = {verdict["standing"] for verdict in page["verdicts"]}
        self.assertLessEqual(standings, {"holds", "differs", "measured"})

    def test_environment_says_where_and_what(self):
        again = pathlib.Path(self.folder.name) / "told"
        done = report("--out", again, "--commit", "0123abc & more",
                      environment={"SOURCE_DATE_EPOCH": "4102444800"})  # 2100-01-01
        self.assertEqual(done.returncode, 0)
        section = json.loads((again / "report.json").read_text())["sections"][0]
        page, baselines = section["tables"]
        self.assertEqual(section["id"], "environment")
        told = dict(page["rows"])
        self.assertEqual((told["commit"], told["date"]), ("0123abc & more", "2100-01-01"))
        self.assertTrue(all(told[name] for name in ("compiler", "processor", "kernel")))
        names = [column["name"] for column in baselines["columns"]]
        for row in baselines["rows"]:
            row = dict(zip(names, row))
            left = json.loads((ROOT / "reference/baselines" / row["file"]).read_text())
            self.assertEqual(row["date"], left["date"])
            days = (datetime.date(2100, 1, 1) - datetime.date.fromisoformat(left["date"])).days
            self.assertEqual(row["age"], f"{days} days")
            self.assertTrue(left["commit"].startswith(row["commit"][:12]))


if __name__ == "__main__":
    unittest.main()
