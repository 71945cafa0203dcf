# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep show --cases gives each kept point, with the numbers of `solve` for the same scene."""

import csv
import io
import json
import unittest

from program import run, quiet_scene
from sweeps import UNIFORM, SweepTest, sweep

GRID = sweep({"load": "[10, 20, 40]", "closures.starvation": '["flooded_inlet", "damiens"]',
              "speed": "[0.1, 3.0]"})


class Cases(SweepTest):
    def cases(self, *options):
        return run("sweep", "show", self.path("out.h5"), "--cases", *options).ended(0, "").out

    def rows(self):
        return list(csv.DictReader(io.StringIO(self.cases("--format", "csv"))))

    def test_each_point_is_there_with_the_numbers_of_solve(self):
        self.swept(GRID)
        rows = self.rows()
        self.assertEqual(len(rows), 3 * 2 * 2)
        self.assertEqual({(row["load [N]"], row["closures.starvation"], row["speed [m/s]"]) for row in rows},
                         {(load, closure, speed) for load in ("10", "20", "40")
                          for closure in ("flooded_inlet", "damiens") for speed in ("0.1", "3")})
        for row in rows:
            asked = quiet_scene("smooth", load=float(row["load [N]"]), speed=float(row["speed [m/s]"]),
                          closures={"starvation": row["closures.starvation"]})
            point, = run("stream", stdin=json.dumps(asked) + "\n").json_lines()
            self.assertEqual(float(row["film [m]"]), point["film"])
            self.assertEqual(row["regime"], point["regime"])
            friction = point["friction"]
            self.assertEqual(row["friction"] and float(row["friction"]), "" if friction is None else friction)

    def test_json_has_the_same_and_null_where_a_number_is_undefined(self):
        self.swept(GRID)
        objects = [json.loads(line) for line in self.cases("--format", "json").splitlines()]
        for row, one in zip(self.rows(), objects, strict=True):
            values = [value for value in row.values()]
            self.assertEqual([("" if value is None else value if isinstance(value, str) else float(value))
                              for value in one.values()],
                             [values[0], float(values[1]),
                              *(value if not value or value[0].isalpha() else float(value) for value in values[2:])])

    def test_a_table_has_the_first_hundred_and_says_so(self):
        self.swept(sweep({"lubricant.viscosity": UNIFORM, "speed": "0.1"}, draws=300))
        lines = self.cases().splitlines()
        self.assertIn("the first 100 of 300 points", lines[0])
        self.assertEqual(len(lines), 102)

    def test_a_table_has_films_in_the_unit_of_the_summaries(self):
        self.assertRegex(self.swept(sweep({"load": "[20, 50]", "speed": "0.1", "outputs": '["film"]'})).out, r"(?m)^film +nm ")
        row = self.cases().splitlines()[2].split()
        self.assertIn("film, nm", self.cases())
        film, = run("sweep", "show", self.path("out.h5"), "--cases", "--format", "csv").rows()[:1]
        self.assertAlmostEqual(float(row[-1]) / (1e9 * float(film["film [m]"])), 1, delta=1e-4)

    def test_a_grid_has_no_mean(self):
        told = self.swept(GRID).out
        self.assertIn("least  greatest", told)
        self.assertNotIn("mean", told)
        self.assertIn("mean", self.swept(sweep({"lubricant.viscosity": UNIFORM, "speed": "0.1"}), "--force").out)

    def test_each_point_of_a_small_grid_stands_below_its_summary(self):
        told = self.swept(GRID).out
        self.assertNotIn("--cases", told)
        self.assertTrue(told.endswith("\n" + self.cases()), told)
        self.assertEqual(len(self.cases().splitlines()), 2 + 12)
        self.assertEqual(run("sweep", "show", self.path("out.h5")).out, told)
        for text in (sweep({"load": "{ from = 10, to = 20, count = 41 }", "speed": "0.1"}),
                     sweep({"load": "[10, 20]", "lubricant.viscosity": UNIFORM, "speed": "0.1"}, draws=2)):
            self.assertNotIn("case  ", self.swept(text, "--force").out)
        for form in ("csv", "json"):
            self.swept(GRID, "--force")
            self.assertNotIn("case  ", run("sweep", "show", self.path("out.h5"), "--format", form).out)

    def test_a_grid_crossed_with_a_distribution_has_quantiles_for_each_set_of_its_values(self):
        """The quantiles of each load are those of a sweep with this load alone, which has the same draws."""
        drawn = {"lubricant.viscosity": UNIFORM, "speed": "0.1"}
        alone = {}
        for load in ("20", "50"):
            self.swept(sweep(drawn | {"load": load}, draws=512), "--force")
            told = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"][0]
            self.assertEqual(told["cells"], [])
            alone[f"load {load} N"] = {column["name"]: column["values"][0] for column in told["columns"]}
        self.swept(sweep(drawn | {"load": "[20, 50]"}, draws=512), "--force")
        told = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"][0]
        self.assertEqual([one["values"] for one in told["cells"]], list(alone))
        for one in told["cells"]:
            for column in one["columns"]:
                value, wanted = column["values"][0], alone[one["values"]][column["name"]]
                self.assertEqual((value["count"], value.get("quantiles"), value.get("words")),
                                 (512, wanted.get("quantiles"), wanted.get("words")), column["name"])
        rows = run("sweep", "show", self.path("out.h5"), "--format", "csv").rows()
        films = {row["grid_values"]: float(row["quantile_0.5"]) for row in rows if row["column"] == "film"}
        self.assertEqual(set(films), {"", *alone})
        self.assertLess(films["load 50 N"], films["load 20 N"])
        table = run("sweep", "show", self.path("out.h5")).out
        self.assertEqual(len([line for line in table.splitlines() if line.startswith("film ") and "load " in line]), 2, table)
        self.assertRegex(table, r"\nfilm +load 20 N .*\nfilm +load 50 N .*\nfilm +all 2 ")
        self.swept(sweep(drawn | {"load": "[20, 50]"}, draws=512, keep='"summaries"'), "--force")
        done = run("sweep", "show", self.path("out.h5"))
        self.assertIn("; over all 2 sets of grid values", done.out)
        self.assertNotIn("load 20 N", done.out)

    def test_a_case_printed_as_a_scene_has_the_answers_of_the_sweep(self):
        varied = {"lubricant.viscosity": UNIFORM, "speed": "[0.1, 3.0]", "load": '{ distribution = "uniform", from = "20 N", to = "0.05 kN" }',
                  "id": '"a \\"name\\""', "bodies.reduced_radius": '"9.5 mm"'}
        for name, more, settings in (("drawn", {"closures.starvation": '["flooded_inlet", "damiens"]'}, {"draws": 8}),
                                     ("two matrices", {}, {"draws": 64, "sensitivity": "true"})):
            with self.subTest(name):
                self.sweep(sweep(varied | more, **settings), "--force").ended(0)
                rows = self.rows()
                for case in (0, 1, 13):
                    printed = run("sweep", self.path("sweep.toml"), "--case", str(case)).ended(0, "")
                    solved = run("solve", "-", "--format", "csv", stdin=printed.out).ended(0)
                    of_case = [row for row in rows if row["case"] == str(case)]
                    for row, point in zip(of_case, solved.rows(), strict=True):
                        self.assertEqual(point["id"], f'a "name", case {case}')
                        self.assertEqual([row["film [m]"], row["friction"], row["regime"]],
                                         [point["film"], point["friction"], point["regime"]])

    def test_a_case_keeps_the_pairs_of_an_oil_and_what_its_speed_is(self):
        self.folder.write("oil.toml", sweep({"lubricant.viscosity": None, "lubricant.density": "870", "lubricant.temperature": '["40 °C", "60 °C"]',
                                             "lubricant.kinematic_viscosity": '[["40 °C", "46 mm²/s"], ["100 °C", "6.8 mm²/s"]]',
                                             "speed": UNIFORM}, draws=4))
        self.assertEqual(run("sweep", self.path("oil.toml"), "-o", self.path("out.h5")).code, 0)
        row = self.rows()[6]
        point, = run("solve", "-", "--format", "csv", stdin=run("sweep", self.path("oil.toml"), "--case", "6").out).rows()
        self.assertEqual([row["speed [m/s]"], row["film [m]"]], [point["speed"], point["film"]])

    def test_there_is_no_case_beyond_the_last(self):
        path = self.folder.write("few.toml", sweep({"load": "[20, 50]", "speed": "0.1"}))
        self.assertEqual(run("sweep", path, "--case", "1").code, 0)
        done = run("sweep", path, "--case", "2")
        self.assertEqual((done.code, done.out, done.err), (2, "", "tribocheck: --case 2: there is no such case; allowed: 0 to 1\n"))
        self.assertEqual(run("sweep", path, path, "--case", "1").code, 2)

    def test_a_result_of_summaries_alone_has_no_cases(self):
        self.swept(sweep({"lubricant.viscosity": UNIFORM, "speed": "0.1"}, keep='"summaries"'))
        done = run("sweep", "show", self.path("out.h5"), "--cases")
        self.assertEqual((done.code, done.out, len(done.error_lines)), (2, "", 1))
        self.assertIn("keep = \"summaries\"", done.err)


if __name__ == "__main__":
    unittest.main()
