# SPDX-License-Identifier: Apache-2.0
"""The table that tribocheck_bench_sweep prints agrees with its own raw numbers; no time is judged."""
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import unittest

STAGES = ["stage: draw", "stage: cases", "stage: sum up", "stage: pack points", "stage: parts of points"]
ON_THREADS = [f"{what}, threads: {threads}" for threads in (1, 2)
              for what in ("chunks with summaries", "chunks with points", "run of summaries", "run of points")]
# Workload → stages that only some workloads have.
WORKLOADS = {"film_5_fields": ["stage: prepare", "stage: points"], "film_12_fields": ["stage: prepare", "stage: points"],
             "film_of_speed": [], "onset_5_fields": ["stage: prepare", "stage: onset"]}


class SweepProgram(unittest.TestCase):
    def run_with(self, *options):
        done = subprocess.run([os.environ["TRIBOCHECK_BENCH_SWEEP"], "--benchmark_min_time=0.0001", *options], capture_output=True, text=True)
        if done.returncode == 0:
            self.assertEqual(done.stderr, "")
        return done

    def table(self, text):
        """Workload → row → median, ratio, least, and whether the time is by the clock."""
        found = {}
        for block in text.strip().split("\n\n"):
            head, columns, *rows = block.splitlines()
            self.assertEqual(columns.split(), "ns a point / alone least ns".split())
            found[head.split(":")[0]] = {}
            for row in rows:
                cells = re.fullmatch(r"(.{34}) *([\d.]+) +([\d.]+)? +([\d.]+)(  by the clock)?", row)
                self.assertIsNotNone(cells, row)
                found[head.split(":")[0]][cells[1].strip()] = (*cells.groups()[1:4], bool(cells[5]))
        return found

    def measured(self, workload, repetitions):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "raw.json"
            done = self.run_with(f"--benchmark_filter=^{workload}/", f"--benchmark_repetitions={repetitions}", f"--benchmark_out={out}",
                                 "--benchmark_out_format=json")
            self.assertEqual(done.returncode, 0)
            return self.table(done.stdout), json.loads(out.read_text())["benchmarks"]

    def test_each_job_is_there_and_gives_what_it_has_to(self):
        done = self.run_with("--benchmark_repetitions=1", "--benchmark_filter=/(alone|summaries|points|stage.*)$")
        self.assertEqual(done.returncode, 0)
        found = self.table(done.stdout)
        self.assertEqual(list(found), list(WORKLOADS))
        for workload, more in WORKLOADS.items():
            self.assertEqual(sorted(found[workload]), sorted(["alone", "summaries", "points", *STAGES, *more]), workload)
            self.assertEqual([row for row, cells in found[workload].items() if cells[3]], [])

    def test_its_numbers_are_medians_and_least_ones_of_the_repetitions(self):
        for workload, repetitions in (("film_of_speed", 3), ("onset_5_fields", 2)):
            found, raw = self.measured(workload, repetitions)
            self.assertEqual(set(found[workload]), {"alone", "summaries", "points", *STAGES, *WORKLOADS[workload], *ON_THREADS})
            ns = {}
            for row in raw:
                if row["run_type"] == "iteration":
                    name = row["name"].split("/")[1]
                    self.assertEqual(row["time_unit"], "ns")
                    ns.setdefault(name, []).append(row["real_time" if name in ON_THREADS else "cpu_time"] / row["points"])
            alone = statistics.median(ns["alone"])
            for name, times in ns.items():
                self.assertEqual(len(times), repetitions)
                self.assertEqual(found[workload][name], (f"{statistics.median(times):.2f}", f"{statistics.median(times) / alone:.2f}",
                                                         f"{min(times):.2f}", name in ON_THREADS), name)

    def test_jobs_that_are_set_side_by_side_have_the_same_points(self):
        _, raw = self.measured("film_of_speed", 1)
        points = {row["name"].split("/")[1]: row["points"] for row in raw}
        for what in ("chunks with", "run of"):
            self.assertEqual(len({count for name, count in points.items() if name.startswith(what)}), 1, what)
        self.assertEqual(len({points[name] for name in ("alone", "summaries", "points", "stage: cases")}), 1)
        self.assertGreater(points["run of points, threads: 1"], points["alone"])

    def test_a_part_without_the_work_alone_has_no_ratio(self):
        found = self.table(self.run_with("--benchmark_repetitions=1", "--benchmark_filter=^film_of_speed/stage: draw$").stdout)
        self.assertIsNone(found["film_of_speed"]["stage: draw"][1])

    def test_the_librarys_own_formats_and_options_are_taken(self):
        done = self.run_with("--benchmark_repetitions=1", "--benchmark_filter=^film_of_speed/stage: draw$", "--benchmark_format=json")
        self.assertEqual([row["name"] for row in json.loads(done.stdout)["benchmarks"]], ["film_of_speed/stage: draw"])
        self.assertEqual(self.run_with("--benchmark_lost=1").returncode, 2)


if __name__ == "__main__":
    unittest.main()
