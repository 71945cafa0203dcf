# SPDX-License-Identifier: Apache-2.0
"""The model of many ranks: its limits, and that page and baseline say what it says."""
import copy
import json
import pathlib
import unittest

import model

HERE = pathlib.Path(__file__).resolve().parent
KNOWN = {"start": 1.0, "answer_seconds": 1e-5, "trip_seconds": 0.0, "disk_bytes_a_second": 1e9,
         "of": {keep: {"point_seconds": 1e-6, "journal_bytes_a_point": 10.0, "journal_bytes_a_chunk": 1e4,
                       "write_seconds_a_point": 1e-8, "write_seconds_a_chunk": 1e-4}
                for keep in ("summaries", "points")}}


class Model(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.baseline = json.loads((HERE.parents[1] / "reference/baselines/sweep.json").read_text())

    def seconds(self, keep, points, chunks, ranks, **changes):
        return model.time_of(copy.deepcopy(KNOWN) | changes, keep, points, chunks, ranks)["seconds"]

    def test_one_rank_takes_start_computing_and_writing(self):
        self.assertAlmostEqual(self.seconds("summaries", 10**8, 4096, 1), 1 + 100 + 0.4096)
        self.assertAlmostEqual(self.seconds("points", 10**8, 4096, 1), 1 + 100 + 1)

    def test_more_ranks_than_chunks_gain_nothing(self):
        self.assertEqual(self.seconds("summaries", 10**8, 100, 100), self.seconds("summaries", 10**8, 100, 1000))

    def test_chunks_that_do_not_come_out_even_leave_ranks_idle(self):
        self.assertAlmostEqual(self.seconds("summaries", 10**8, 101, 100) - 1 - 101e-4, 2 * 1e8 / 101 * 1e-6)

    def test_the_disk_is_the_limit_of_points(self):
        self.assertAlmostEqual(self.seconds("points", 10**10, 10**6, 10**4), 1 + 1e11 / 1e9 + 100)

    def test_rank_0_is_the_limit_where_requests_are_more_than_it_answers(self):
        slow, fast = (model.time_of(KNOWN | {"answer_seconds": seconds}, "summaries", 10**12, 10**9, 10**5)
                      for seconds in (1e-5, 1e-6))
        self.assertAlmostEqual(fast["computing"], 10)
        self.assertAlmostEqual(slow["computing"], 4 * 10)

    def test_the_page_has_the_numbers_of_the_baseline(self):
        page = (HERE / "README.md").read_text()
        self.assertEqual(model.page_block(page), model.page_text(self.baseline))

    def test_the_baseline_has_what_the_model_makes_of_its_constants(self):
        for new, old in zip(model.of(self.baseline)["rows"], self.baseline["model"]["rows"], strict=True):
            for time, kept in zip(new["times"], old["times"], strict=True):
                self.assertAlmostEqual(time["seconds"] / kept["seconds"], 1, delta=1e-3)
                self.assertEqual(time["most"], kept["most"])


if __name__ == "__main__":
    unittest.main()
