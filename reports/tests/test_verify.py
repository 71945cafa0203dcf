# SPDX-License-Identifier: Apache-2.0
"""tribocheck verify: the model keeps its contracts on the certified tables, and broken contracts and tables are told."""
import hashlib
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml
from fractions import Fraction

from program import ENVIRONMENT, PROGRAM, TIMEOUT, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
EXACT = ROOT / "reference/exact"
TABLES = sorted(path.stem for path in EXACT.glob("*.csv"))


def rows_of(path):
    lines = path.read_text().splitlines(keepends=True)
    return [line for line in lines if not line.startswith("#")][1:]


class Tables(unittest.TestCase):
    def test_headers_carry_provenance_and_the_checksum_of_the_rows(self):
        for table in TABLES:
            path = EXACT / f"{table}.csv"
            header = dict(line[2:].rstrip().split(": ", 1)
                          for line in path.read_text().splitlines() if line.startswith("# "))
            for field in ("quantity", "definition", "units", "domain", "generator", "digits",
                          "first method", "second method", "date"):
                self.assertTrue(header[field], f"{table}: {field}")
            digest = hashlib.sha256("".join(rows_of(path)).encode()).hexdigest()
            self.assertEqual(header["sha256 of the rows"], digest, table)

    def test_decimal_value_and_the_two_doubles_are_one_number(self):
        for table in TABLES:
            lines = (EXACT / f"{table}.csv").read_text().splitlines()
            columns = [line for line in lines if line.startswith("id,")][0].split(",")
            value, high, low = (columns.index(name) for name in ("value", "high", "low"))
            for row in rows_of(EXACT / f"{table}.csv"):
                cells = row.split(",")
                if not cells[value]:
                    continue
                exact = Fraction(cells[value])
                pair = Fraction(float.fromhex(cells[high])) + Fraction(float.fromhex(cells[low]))
                # 2^-104 of the value, and half a subnormal unit
                self.assertLessEqual(abs(exact - pair), abs(exact) / 2**104 + Fraction(2)**-1075, row)

    def test_regions_that_the_tables_promise_are_there(self):
        for table, regions in (("gaussian_moment", {"dense", "near_zero", "branch", "worst"}),
                               ("load_sharing", {"regular", "critical", "extreme", "worst", "end"}),
                               ("operating_point", {"film", "floor", "collapsed", "undefined"})):
            found = {row.rstrip().split(",")[-1] for row in rows_of(EXACT / f"{table}.csv")}
            self.assertEqual(found, regions, table)


class Verify(unittest.TestCase):
    def test_every_contract_holds(self):
        results = run("verify", "--format", "json", cwd=ROOT).ended(0).json()["quantities"]
        self.assertEqual(sum(r["cases"] for r in results),
                         sum(1 for t in TABLES for row in rows_of(EXACT / f"{t}.csv")
                             if not row.rstrip().endswith(",undefined")))
        self.assertTrue(all(r["passed"] for r in results))

    def test_a_junit_file_that_cannot_be_written_is_one_line_and_no_bad_usage(self):
        done = run("verify", "--junit", "/nonexistent/verify.xml", cwd=ROOT)
        self.assertEqual((done.code, len(done.error_lines)), (1, 1), done.err)
        self.assertIn("cannot write /nonexistent/verify.xml", done.err)

    def test_table_and_junit_name_every_quantity(self):
        with tempfile.TemporaryDirectory() as folder:
            junit = pathlib.Path(folder) / "verify.xml"
            done = run("verify", "--junit", junit, cwd=ROOT).ended(0)
            suite = xml.parse(junit).getroot()
            self.assertEqual(suite.get("failures"), "0")
            for case in suite:
                self.assertIn(case.get("name"), done.out)
            cases = run("verify", "--format", "json", cwd=ROOT).json()["quantities"]
            self.assertEqual(done.out.splitlines()[-1],
                             f"COMPLETE: {len(suite)} of {len(suite)} quantities held, "
                             f"in {sum(one['cases'] for one in cases)} cases.")

    def with_changed(self, table, change, *more):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "exact"
            shutil.copytree(EXACT, copy)
            path = copy / f"{table}.csv"
            path.write_text(change(path.read_text()))
            return run("verify", "--reference", str(copy), *(more or ("--format", "json")))

    def test_a_value_off_by_more_than_the_contract_is_found(self):
        for table in TABLES:
            row = rows_of(EXACT / f"{table}.csv")[1]
            cells = row.split(",")
            moved = (float.fromhex(cells[-4]) * (1 + 2**-20)).hex()  # high
            wrong = ",".join([*cells[:-4], moved, *cells[-3:]])
            done = self.with_changed(table, lambda text, row=row, wrong=wrong: text.replace(row, wrong)).ended(1)
            failed = [r for r in done.json()["quantities"] if not r["passed"]]
            self.assertEqual([r["worst_row"] for r in failed], [cells[0]])

    def test_a_quantity_without_certified_rows_is_told_as_such(self):
        report = tempfile.NamedTemporaryFile(suffix=".xml")
        self.addCleanup(report.close)
        told = self.with_changed("operating_point", lambda text: "".join(
            line for line in text.splitlines(keepends=True) if ",friction," not in line), "--format", "table", "--junit", report.name)
        self.assertEqual(told.code, 1)
        self.assertEqual(told.out.splitlines()[-1].partition("; ")[2],
                         "failed: operating_point.friction (no table of reference/exact has a row of it).")
        failed, = xml.parse(report.name).iter("failure")
        self.assertEqual(failed.get("message"), "no table of reference/exact has a row of it")

    def test_the_last_line_of_the_table_names_what_failed(self):
        done = self.with_changed("onset_constant", lambda text: text.replace("0x1.", "0x1.8"), "--format",
                                 "table").ended(1)
        self.assertRegex(done.out.splitlines()[-1],
                         r"^FAILED: \d+ of \d+ quantities held, in \d+ cases; failed: .*onset_constant")

    def test_a_program_without_its_tables_says_what_to_do(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = pathlib.Path(folder) / "bin/tribocheck"
            alone.parent.mkdir()
            shutil.copy(PROGRAM, alone)
            for more in ([], ["--subject", "true"]):
                done = subprocess.run([alone, "verify", *more], cwd=folder, capture_output=True, text=True,
                                      timeout=TIMEOUT, env=ENVIRONMENT)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (
                    2, "", "tribocheck: reference tables not found; pass --reference, or run in the project\n"))
            answered = subprocess.run([alone, "verify", "--subject", f"{PROGRAM} stream", "--sample", "5",
                                       "--reference", EXACT], cwd=folder, capture_output=True, text=True,
                                      timeout=TIMEOUT, env=ENVIRONMENT)
            self.assertEqual(answered.returncode, 0, answered.stderr)

    def test_broken_tables_are_one_line_and_exit_code_2(self):
        for change in (lambda text: "", lambda text: text.replace("high", "hi"),
                       lambda text: text + "m9999,1\n", lambda text: text.replace("0x1", "zz")):
            done = self.with_changed("gaussian_moment", change).ended(2)
            self.assertEqual(len(done.error_lines), 1, done.err)
        nowhere = run("verify", "--reference", "/nowhere")
        self.assertEqual((nowhere.code, nowhere.out, nowhere.err),
                         (2, "", "tribocheck: --reference: /nowhere is not a folder\n"))


if __name__ == "__main__":
    unittest.main()
