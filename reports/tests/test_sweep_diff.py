# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep diff: which numbers of two results differ, by how much, and which results cannot be compared."""

import math
import time
import unittest

from program import run
from sweeps import SANITIZED, UNIFORM, SweepTest, opened, sealed, sweep

POINTS = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 3.0]", "outputs": '["film", "friction", "regime"]'},
               onset='["film_maximum"]', draws=64)
SUMMARIES = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, keep='"summaries"', draws=64)
INDICES = sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }', "speed": "0.1", "outputs": '["film"]'},
                sensitivity="true", draws=64)


class Diff(SweepTest):
    def diff(self, *options, first="a.h5", second="b.h5"):
        return run("sweep", "diff", self.path(first), self.path(second), *options)

    def document(self, *options, code=1, **names):
        done = self.diff("--format", "json", *options, **names)
        self.assertEqual((done.code, done.err), (code, ""))
        return done.json()

    def pair(self, first, second=None):
        self.swept(first, "--force", out="a.h5")
        self.swept(second or first, "--force", out="b.h5")

    def change(self, path, place, value, name="b.h5"):
        """Changes one number of a result, and writes the checksum at its end anew."""
        import h5py
        with h5py.File(self.path(name), "r+") as file:
            file[path][place] = value(file[path][place]) if callable(value) else value
        self.put(name, sealed(self.bytes_of(name)))

    def refused(self, *words):
        done = self.diff()
        self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1), done.err)
        for word in words:
            self.assertIn(word, done.err)

    def test_equal_results_of_every_kind(self):
        for text in (POINTS, SUMMARIES, INDICES):
            self.pair(text)
            self.assertIn("EQUAL: all ", self.diff().ended(0, "").out.splitlines()[-1])
            one = self.document(code=0)
            self.assertEqual((one["equal"], one["differing"], one["differences"], one["notes"]), (True, 0, [], []))
            self.assertEqual(one["compared"], sum(column["compared"] for column in one["columns"]))

    def test_undefined_numbers_are_equal_to_each_other_alone(self):
        self.pair(POINTS)
        with opened(self.path("a.h5")) as file:
            friction = file["smooth/outputs/friction"][:]
        self.assertTrue(math.isnan(friction[5, 1]))
        self.assertEqual(self.diff().code, 0)
        self.change("smooth/outputs/friction", (5, 1), 0.1)
        one, = self.document("--tolerance", "1e9")["differences"]
        self.assertEqual(one, {"scene": "smooth", "of": "output", "name": "friction", "case": 5, "speed": 3,
                               "first": None, "second": 0.1, "difference": None})

    def test_one_unit_in_the_last_place(self):
        self.pair(POINTS)
        self.change("smooth/outputs/film", (7, 0), lambda x: math.nextafter(x, 1))
        one, = self.document()["differences"]
        self.assertEqual((one["name"], one["case"], one["speed"]), ("film", 7, 0.1))
        self.assertEqual(one["second"], math.nextafter(one["first"], 1))
        self.assertEqual(one["difference"], (one["second"] - one["first"]) / one["second"])
        self.assertEqual(self.diff("--tolerance", "1e-15").code, 0)
        self.assertEqual(self.diff("--tolerance", "1e-17").code, 1)
        lines = self.diff().out.splitlines()
        self.assertEqual(lines[0], f"{self.path('a.h5')} and {self.path('b.h5')}: what differs, the worst first")
        self.assertIn(repr(one["first"]), lines[2])

    def test_another_parameter_of_the_sweep_file(self):
        self.pair(POINTS, POINTS.replace("load = 50", "load = 51"))
        one = self.document("--most", "100000")
        self.assertEqual(one["notes"], ["scene smooth: the sweep files differ"])
        counts = {column["name"]: column["differing"] for column in one["columns"]}
        self.assertEqual((counts["speed"], counts["lubricant.viscosity"]), (0, 0))
        self.assertGreater(counts["film"], 60)
        self.assertGreater(counts["onset.film_maximum.speed"], 60)
        self.assertEqual(one["differing"], len(one["differences"]))
        with opened(self.path("a.h5")) as a, opened(self.path("b.h5")) as b:
            for row in one["differences"]:
                if row["name"] == "film":
                    place = (row["case"], [0.1, 3.0].index(row["speed"]))
                    self.assertEqual((row["first"], row["second"]),
                                     tuple(file["smooth/outputs/film"][place] for file in (a, b)))
        sizes = [math.inf if row["difference"] is None else row["difference"] for row in one["differences"]]
        self.assertEqual(sizes, sorted(sizes, reverse=True))
        self.assertEqual(self.diff("--tolerance", "0.1").code, 0)

    def test_inputs_words_and_speeds(self):
        self.pair(POINTS)
        self.change("smooth/outputs/regime", (3, 0), 2)
        self.change("smooth/inputs/lubricant.viscosity", 9, 0.02)
        self.change("smooth/speed", 0, 0.11)
        rows = self.diff("--format", "csv").rows()
        self.assertEqual([(row["of"], row["name"], row["case"], row["speed"]) for row in rows],
                         [("output", "regime", "3", "0.1"), ("input", "lubricant.viscosity", "9", ""), ("speed", "speed", "", "0.1")])
        self.assertEqual((rows[0]["first"], rows[0]["second"], rows[0]["difference"]), ("mixed", "elastohydrodynamic", "inf"))
        self.assertEqual(float(rows[1]["second"]), 0.02)

    def test_summaries_where_there_are_no_cases(self):
        self.pair(SUMMARIES)
        self.change("smooth/summary/film/quantiles_low", (1, 6), 1e-9)
        one, = self.document()["differences"]
        self.assertEqual((one["of"], one["name"], one["statistic"], one["speed"]), ("summary", "film", "0.5 quantile, low", 1.0))
        self.assertNotIn("case", one)
        self.swept(SUMMARIES.replace('keep = "summaries"\n', ""), "--force", out="b.h5")
        both = self.document(code=0)
        self.assertEqual({column["of"] for column in both["columns"]}, {"speed", "summary"})
        self.assertEqual(both["notes"][1], f"scene smooth: only the summaries are compared, as {self.path('a.h5')} keeps no cases")

    def test_a_sensitivity_index_is_held_to_the_difference_itself(self):
        self.pair(INDICES)
        self.change("smooth/sensitivity/film/total", (0, 0), lambda x: x + 1e-4)
        one, = self.document()["differences"]
        self.assertEqual((one["of"], one["statistic"]), ("sensitivity", "total of lubricant.viscosity"))
        self.assertAlmostEqual(one["difference"], 1e-4, delta=1e-12)
        self.assertEqual(self.diff("--tolerance", "1.1e-4").code, 0)

    def test_equal_differences_are_in_the_order_of_the_cases(self):
        self.pair(POINTS)
        for case in (40, 3, 17, 60):
            self.change("smooth/outputs/film", (case, 0), lambda x: 2 * x)
        one = self.document("--most", "3")
        self.assertEqual([(row["case"], row["difference"]) for row in one["differences"]], [(3, 0.5), (17, 0.5), (40, 0.5)])
        self.assertEqual(one["differing"], 4)
        self.assertEqual(self.document("--most", "0")["differences"], [])
        self.assertIn("the worst 3 of 4 differences", self.diff("--most", "3").out)
        self.assertIn("DIFFERENT: 4 of ", self.diff("--format", "csv").err)

    def test_results_that_cannot_be_compared(self):
        other = {"id": POINTS.replace('id = "smooth"', 'id = "other"'),
                 "cases": POINTS.replace("draws = 64", "draws = 32"),
                 "column regime": POINTS.replace(', "regime"', ""),
                 "onset.film_maximum": POINTS.replace('onset = ["film_maximum"]\n', ""),
                 "speeds": POINTS.replace("[0.1, 3.0]", "[0.1, 1.0, 3.0]"),
                 "varying field": POINTS.replace(UNIFORM, "0.02").replace("load = 50", f"load = {UNIFORM}")}
        self.swept(POINTS, out="a.h5")
        for word, text in other.items():
            self.swept(text, "--force", out="b.h5")
            self.refused("cannot be compared", {"id": "has the scene smooth", "varying field": "varying field",
                                                "cases": "64 and 32 cases", "speeds": "2 and 3 speeds"}.get(word, word))

    def test_files_that_are_no_results(self):
        self.swept(POINTS, out="a.h5")
        self.refused("b.h5", "cannot be read")
        self.put("b.h5", b"no result")
        self.refused("b.h5")
        self.put("b.h5", self.bytes_of("a.h5")[:-20])
        self.refused("b.h5")
        self.swept(POINTS, "--shard", "1/2", "--force", out="b.h5")
        self.refused("b.h5", "sweep merge")
        for words in (["a"], ["a", "b", "c"], ["a", "b", "--tolerance", "-1"], ["a", "b", "--tolerance", "nan"], ["a", "b", "--most", "-1"]):
            done = run("sweep", "diff", *words)
            self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1), done.err)

    def test_a_forged_result_is_refused(self):
        import h5py
        self.pair(POINTS)
        with h5py.File(self.path("b.h5"), "r+") as file:
            del file["smooth/outputs/film"]
            file.create_dataset("smooth/outputs/film", shape=(63, 2), dtype="f8", chunks=(63, 2))
        self.put("b.h5", sealed(self.bytes_of("b.h5")))
        self.refused("b.h5", "is no whole result")

    def test_a_million_points_take_seconds(self):
        draws = 64 if SANITIZED else 1024  # instrumented code takes ten times as long
        text = sweep({"lubricant.viscosity": UNIFORM, "speed": "{ from = 0.1, to = 1, count = 1000 }", "outputs": '["film", "inlet"]'}, draws=draws)
        self.pair(text, text.replace("load = 50", "load = 51"))
        start = time.monotonic()
        one = self.document("--most", "5")
        seconds = time.monotonic() - start
        self.assertGreater(one["compared"], 2 * draws * 1000)
        self.assertEqual(len(one["differences"]), 5)
        print(f"{one['compared']} numbers in {seconds:.2f} s", flush=True)
        self.assertLess(seconds, 30)


if __name__ == "__main__":
    unittest.main()
