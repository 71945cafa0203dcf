# SPDX-License-Identifier: Apache-2.0
"""The archive of `make data`: whole, the same each time, and enough to judge a function without the program."""

import csv
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest
import zipfile

import jsonschema

from program import PROGRAM, folder_until, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
PACKAGES = ROOT / "reports/bindings/packages"

SUBJECT = """
import sys
for line in sys.stdin:
    question = json.loads(line)
    name, id = question.pop("function", ""), question.pop("id")
    print(json.dumps({"id": id, **(my_contact(**question) if name == "hertz_point" else {"skip": True})}), flush=True)
"""


class Data(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = folder_until(cls.addClassCleanup)
        made = subprocess.run([sys.executable, "-B", PACKAGES / "data.py", PROGRAM, cls.folder], stdout=subprocess.PIPE, text=True, check=True)
        cls.archive = pathlib.Path(made.stdout.strip())
        with zipfile.ZipFile(cls.archive) as archive:
            cls.dates = {info.date_time for info in archive.infolist()}
            archive.extractall(cls.folder)
        cls.data = cls.folder / cls.archive.stem

    def text(self, name):
        return (self.data / name).read_text(encoding="utf-8")

    def test_the_reader_of_its_page_counts_as_verify_does(self):
        reader, = re.findall(r"```python\n(.*?)```", self.text("README.md"), re.DOTALL)
        self.assertLessEqual(len([line for line in reader.partition("def rows")[2].splitlines() if line]), 20)
        for factor in ("2 * mean", "(1.5 if load < 10 else 1.501) * mean"):
            text = reader.replace("2 * mean", factor)
            counted = subprocess.run([sys.executable, "-c", text], cwd=self.data, capture_output=True, text=True, check=True).stdout
            subject = self.folder / "subject.py"
            subject.write_text(text.partition("def rows")[0] + SUBJECT)
            verdict = json.loads(run("verify", "--subject", f"{sys.executable} {subject}", "--format", "json").out)
            expected = [f"{row['quantity'].removeprefix('hertz_point.')} {row['asked']} {row['held']}"
                        for row in verdict["quantities"] if row["quantity"].startswith("hertz_point.")]
            self.assertEqual(counted.splitlines(), expected, factor)
        self.assertNotIn("peak_pressure 50 0", expected)  # with the second factor some cases hold

    def test_each_file_has_its_checksum_and_the_dates_are_fixed(self):
        sums = dict(line.split("  ")[::-1] for line in self.text("SHA256SUMS").splitlines())
        there = {path.relative_to(self.data).as_posix() for path in self.data.rglob("*") if path.is_file()}
        self.assertEqual({*sums}, there - {"SHA256SUMS"})
        for name, checksum in sums.items():
            self.assertEqual(hashlib.sha256((self.data / name).read_bytes()).hexdigest(), checksum, name)
        self.assertEqual(self.dates, {(1980, 1, 1, 0, 0, 0)})
        self.assertTrue({"README.md", "LICENSE", "CITATION.cff"} <= there)
        again = subprocess.run([sys.executable, "-B", PACKAGES / "data.py", PROGRAM, self.folder / "again"], check=True, cwd="/",
                               stdout=subprocess.PIPE, text=True, env={**os.environ, "TZ": "Asia/Tokyo", "PYTHONHASHSEED": "7"}).stdout.strip()
        self.assertEqual(pathlib.Path(again).read_bytes(), self.archive.read_bytes())

    def test_lines_are_what_their_schema_says_and_have_the_numbers_of_the_table(self):
        names = sorted(path.relative_to(self.data).as_posix().removesuffix(".jsonl") for path in self.data.rglob("*.jsonl"))
        self.assertEqual(names, sorted(["cases", "mistakes", *(f"{path.parent.name}/{path.stem}" for folder in ("exact", "ehl")
                                                              for path in (ROOT / "reference" / folder).glob("*.csv"))]))
        for name in names:
            rows = [json.loads(line) for line in self.text(f"{name}.jsonl").splitlines()]
            table = list(csv.DictReader(line for line in self.text(f"{name}.csv").splitlines() if not line.startswith("#")))
            self.assertEqual(len(rows), len(table), name)
            schema = json.loads(self.text(f"{name}.schema.json"))
            jsonschema.Draft202012Validator.check_schema(schema)
            validator = jsonschema.Draft202012Validator(schema)
            for row, cells in list(zip(rows, table))[::37]:
                validator.validate(row)
                for member, value in row.items():
                    cell = cells[member]
                    if isinstance(value, str):
                        read = cell
                    elif value is None:
                        value, read = "", cell
                    else:
                        read = float.fromhex(cell) if "0x" in cell else json.loads(cell)
                    self.assertEqual(value, read, (name, row))
                self.assertFalse([member for member, cell in cells.items() if cell and member not in row], (name, row))

    def test_cases_are_those_that_verify_saves(self):
        saved = [json.loads(line) for line in run("verify", "--save-cases", "-").out.splitlines()]
        self.assertEqual([json.loads(line) for line in self.text("cases.jsonl").splitlines()], saved)
        self.assertGreater(len(saved), 5000)


if __name__ == "__main__":
    unittest.main()
