# SPDX-License-Identifier: Apache-2.0
"""tribocheck bench --plugin: a plug-in in the table of all contenders."""
import unittest

from plugins import plugin
from program import ProgramTest, run


def bench(library, pattern, *arguments):
    return run("bench", "--quick", "--plugin", library, "--filter", pattern, *arguments)


class Rows(unittest.TestCase):
    def rows(self, name, pattern):
        return bench(plugin(name), pattern, "--format", "json").ended(0, "").json()["rows"]

    def test_every_job_that_is_offered(self):
        rows = self.rows("own_model_plugin", "/plugin/")
        self.assertEqual([row["job"] for row in rows], ["moment_5_2", "moment_2", "root_wide",
                                                        "root_one_surface", "curve_200", "points_1e6"])
        for row in rows:
            self.assertEqual((row["family"], row["name"]), ("plugin", "own model"))
            self.assertEqual(row["failures"], 0)
            self.assertGreater(row["judged"], 30)
            self.assertLess(row["max_ulp"], 250)

    def test_beside_ours_with_the_same_errors(self):
        rows = self.rows("own_model_plugin", "moment_5_2/(plugin/|tribocheck/scalar)")
        theirs, ours = sorted(rows, key=lambda row: row["family"])
        self.assertEqual((theirs["family"], ours["family"]), ("plugin", "tribocheck"))
        for column in ["max_ulp", "p99_ulp", "mean_ulp", "judged", "failures"]:
            self.assertEqual(theirs[column], ours[column])
        self.assertGreater(theirs["ratio"], 0)

    def test_what_is_not_offered_has_no_row(self):
        self.assertEqual([row["job"] for row in self.rows("c_plugin", "/plugin/")], ["moment_5_2", "moment_2"])

    def test_what_it_prints_is_not_in_the_table(self):
        done = bench(plugin("talkative"), "moment_2/plugin", "--format", "json").ended(0)
        row, = done.json()["rows"]
        self.assertEqual((row["name"], row["failures"]), ("talkative plug-in", row["judged"]))
        self.assertIn("greeting", done.err)

    def test_cases_that_are_not_offered_are_not_judged_and_others_without_the_status_done_are_failures(self):
        all_of_them, = self.rows("own_model_plugin", "moment_2/plugin")
        row, = self.rows("every_status", "moment_2/plugin")
        self.assertEqual(row["failures"], row["judged"])
        self.assertLess(row["judged"], all_of_them["judged"])
        self.assertGreater(row["judged"], all_of_them["judged"] / 2)


class Refusals(ProgramTest):
    def test_a_library_that_cannot_be_used(self):
        for library, word in [("no_such.so", "No such file"), (plugin("wrong_version"), "version 3"),
                              (plugin("no_version"), "tribocheck_plugin_version")]:
            self.assert_refused(bench(library, "/plugin/"), library, word)

    def test_a_crash_is_told_of_the_plugin(self):
        library = plugin("crashing")
        self.assert_refused(bench(library, "/plugin/"), library, "signal 6", code=1)


if __name__ == "__main__":
    unittest.main()
