# SPDX-License-Identifier: Apache-2.0
"""Checks scaling.py on made-up measurements: the runs that it asks for, and the numbers that it computes from the times."""
import contextlib
import io
import json
import os
import pathlib
import sys
import tempfile
import tomllib
import unittest
from unittest import mock

import scaling

SMALL, LARGE = 1, 1 << 22


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.sweeps = scaling.Sweeps(self.folder / "build", self.folder)
        self.asked = []

    def answering(self, answer):
        """Replaces the run of a command: notes the command and returns answer(command)."""
        def run(command):
            self.asked.append([str(word) for word in command])
            return answer(self.asked[-1])
        self.sweeps.run = run
        return self.sweeps


def draws_of(command):
    return tomllib.loads(pathlib.Path(command[command.index("sweep") + 1]).read_text())["sweep"]["draws"]


class Commands(Folder):
    def test_a_sweep_file_has_its_fields_draws_and_what_is_kept(self):
        for fields in (scaling.FIVE, scaling.OF_SPEED):
            path = self.sweeps.file(fields, 7, "points")
            scene = tomllib.loads(path.read_text())
            self.assertEqual((scene["sweep"], scene["outputs"]), ({"draws": 7, "keep": "points"}, ["film"]))
            given = {"load": scene["load"], "speed": scene["speed"], "viscosity": scene["lubricant"]["viscosity"],
                     "density": scene["surface"]["summit_density"], "sd": scene["surface"]["summit_height_sd"]}
            for name, value in given.items():
                self.assertEqual(value, tomllib.loads(f"x = {fields[name]}")["x"], name)
            self.assertNotEqual(path, self.sweeps.file(fields, 7, "summaries"))

    def test_a_command_is_the_programs_own_or_one_of_ranks(self):
        program = [self.folder.resolve() / "build/tribocheck", "sweep", "s.toml", "-o", self.folder / "out.h5", "--force", "--format", "json"]
        self.assertEqual(self.sweeps.command("s.toml", "--threads", "2"), [*program, "--threads", "2"])
        self.assertEqual(self.sweeps.command("s.toml", ranks=4), ["mpirun", "--oversubscribe", "-n", "4", *program])

    def test_a_command_that_fails_ends_the_run_with_what_it_said(self):
        self.assertEqual(self.sweeps.run(["sh", "-c", "echo out; echo err >&2"]), "out\n")
        with self.assertRaisesRegex(SystemExit, "exit code 3: no room"):
            self.sweeps.run(["sh", "-c", "echo no room >&2; exit 3"])


class Times(Folder):
    def test_the_quietest_are_kept_and_their_medians_and_greatest_disturbance_are_told(self):
        runs = [(10, 0.5, 20), (1, 0.1, 2), (4, 0.3, 9), (3, 0.2, 4), (7, 0.6, 30)]
        self.assertEqual(scaling.quietest(runs), {"seconds": 3, "cpu_seconds": 4, "others": 0.3})

    def test_what_others_used_is_all_but_its_own(self):
        # In 4 s all processes used 12 CPU seconds, 5 of them by the work itself: others used 7/4 processors.
        with mock.patch.object(scaling, "busy_seconds", side_effect=[100, 112]), mock.patch.object(scaling, "own_seconds", side_effect=[30, 35]), \
                mock.patch.object(scaling.time, "perf_counter", side_effect=[50, 54]):
            self.assertEqual(scaling.timed(lambda: self.asked.append("work")), (4, 7 / 4, 5))
        self.assertEqual(self.asked, ["work"])
        with mock.patch.object(scaling, "busy_seconds", side_effect=[0, 1]), mock.patch.object(scaling, "own_seconds", side_effect=[0, 2]):
            self.assertEqual(scaling.timed(lambda: None)[1], 0)

    def test_processor_seconds_grow_by_those_of_a_child(self):
        all_before, own_before = scaling.busy_seconds(), scaling.own_seconds()
        self.sweeps.run([sys.executable, "-c", "import time\nwhile time.process_time() < 0.3: pass"])
        own = scaling.own_seconds() - own_before
        self.assertGreater(own, 0.29)
        self.assertGreater(scaling.busy_seconds() - all_before, own - 0.1)

    def test_works_take_turns_and_each_second_round_is_in_the_other_order(self):
        order = []
        with mock.patch.object(scaling, "timed", lambda work: (work(), 0, 1)):
            found = scaling.interleaved({name: lambda name=name: order.append(name) or len(order) for name in "abc"})
        self.assertEqual("".join(order), "abccba" * 3 + "abc")
        self.assertEqual(found["a"], {"seconds": 6, "cpu_seconds": 1, "others": 0})  # the 1st, 6th and 7th of all

    def test_a_contenders_number_is_the_median_of_its_fastest_third_a_point(self):
        def row(name, cpu, real, points=10, kind="iteration", **more):
            return {"name": name, "run_type": kind, "cpu_time": cpu, "real_time": real, "points": points, **more}
        rows = [row("w/alone/iterations:3", cpu, 1e9) for cpu in (500, 100, 300, 200, 900, 800, 700)]
        rows += [row("w/chunks with points, threads: 2", 1e9, real, threads=2) for real in (70, 60, 50, 40, 30, 20, 10)]
        rows += [row("v/stage: draw", 5, 1, points=1), row("w/alone", 1, 1, kind="aggregate")]
        sweeps = self.answering(lambda command: json.dumps({"benchmarks": rows}))
        self.assertEqual(scaling.bench(sweeps, "/alone$", 7),
                         {"w": {"alone": 20, "chunks with points, threads: 2": 2}, "v": {"stage: draw": 5}})
        self.assertEqual(self.asked, [[str(self.folder.resolve() / "build/tribocheck_bench_sweep"), "--benchmark_format=json", "--benchmark_repetitions=7",
                                       "--benchmark_min_time=0.02", "--benchmark_filter=/alone$"]])
        rows.append({"name": "w/points/iterations:3", "run_type": "iteration", "error_occurred": True, "error_message": "other results"})
        with self.assertRaisesRegex(SystemExit, "w/points/iterations:3: other results"):
            scaling.bench(sweeps, "/alone$", 7)


class Parts(Folder):
    def test_ratios_join_what_is_timed_often_and_rarely(self):
        answers = {scaling.REPETITIONS: {"w": {"alone": 2}}, 3: {"w": {"run of 1": 5}}}
        with mock.patch.object(scaling, "bench", lambda sweeps, chosen, repetitions: answers[repetitions]):
            self.assertEqual(scaling.ratios(self.sweeps), {"w": {"alone": 2, "run of 1": 5}})

    def test_two_threads_are_as_much_faster_as_a_point_takes_less(self):
        chunks = {f"chunks with {kept}, threads: {count}": ns for kept, count, ns in
                  (("summaries", 1, 30), ("summaries", 2, 20), ("points", 1, 80), ("points", 2, 50))}
        self.answering(lambda command: "")
        with mock.patch.object(scaling, "bench", lambda *_: {"film_5_fields": chunks}), mock.patch.object(scaling, "timed", lambda work: (work(), 1, 0.5, 2)[1:]):
            found = scaling.threads(self.sweeps)
        self.assertEqual(found, {"ns_a_point": chunks, "start": {"seconds": 1, "cpu_seconds": 2, "others": 0.5}, "speedup": {"summaries": 1.5, "points": 1.6}})
        self.assertEqual((draws_of(self.asked[0]), self.asked[0][-2:]), (SMALL, ["--threads", "1"]))

    def test_ranks_are_compared_without_their_start(self):
        self.answering(lambda command: "")
        clock = {"start 1": 1, "start 2": 2, "start 4": 4, "strong 1": 25, "strong 2": 18, "strong 4": 12, "weak 2": 34}
        cpu = {"start 1": 1, "start 2": 3, "start 4": 5, "strong 1": 21, "strong 2": 28, "strong 4": 37, "weak 2": 53}
        works = {}

        def interleaved(given):
            works.update(given)
            return {name: {"seconds": clock[name], "cpu_seconds": cpu[name], "others": 0} for name in given}
        with mock.patch.object(scaling, "interleaved", interleaved):
            found = scaling.ranks(self.sweeps)
        self.assertEqual({key: found[key] for key in found if key != "of"}, {
            "points": LARGE, "speedup": {"2": 24 / 16, "4": 24 / 8}, "weak_efficiency": 24 / 32,
            "cpu_speedup": {"2": 2 * 20 / 25, "4": 4 * 20 / 32}, "weak_cpu_efficiency": 2 * 20 / 50})
        self.assertEqual(found["of"]["strong 4"], {"seconds": 12, "cpu_seconds": 37, "others": 0})
        for name, work in works.items():
            work()
            kind, count = name.split()
            self.assertEqual((self.asked[-1][:4], draws_of(self.asked[-1])),
                             (["mpirun", "--oversubscribe", "-n", count], {"start": SMALL, "strong": LARGE, "weak": 2 * LARGE}[kind]), name)

    def test_memory_is_that_of_each_process_which_the_script_starts(self):
        def ran(command):
            count = int(command[3]) if command[0] == "mpirun" else 1
            at = command.index("--rss-of")
            self.assertEqual(command[at - 2:at], [sys.executable, scaling.__file__])
            for rank in reversed(range(count)):
                pathlib.Path(f"{command[at + 1]}.{rank}").write_text(str(100.5 + rank))
        self.answering(ran)
        for billion, points in ((False, [10**8]), (True, [10**8, 10**9])):
            self.asked.clear()
            with mock.patch.object(scaling, "timed", lambda work: (work(), 3, 0.25, 9)[1:]):
                found = scaling.memory(self.sweeps, billion)
            self.assertEqual(found, {f"{count} points, {name}": {"points": count, "mb_of_rank": sizes, "seconds": 3, "others": 0.25} for count in points
                                     for name, sizes in (("threads 2", {"0": 100.5}), ("ranks 2", {"0": 100.5, "1": 101.5}))})
            self.assertEqual([draws_of(one) for one in self.asked], [count for count in points for _ in range(2)])
            self.assertEqual([one[-2:] == ["--threads", "2"] for one in self.asked], [True, False] * len(points))

    def test_a_process_leaves_its_greatest_memory_under_its_rank_and_its_exit_code(self):
        for environment, rank in (({"OMPI_COMM_WORLD_RANK": "3"}, "3"), ({}, "0")):
            words = ["scaling.py", "--rss-of", str(self.folder / "rss"), sys.executable, "-c", "bytearray(200 << 20); raise SystemExit(5)"]
            with mock.patch.dict(os.environ, environment), mock.patch.object(sys, "argv", words):
                self.assertEqual(scaling.main(), 5)
            size = float((self.folder / f"rss.{rank}").read_text())
            self.assertTrue(200 < size < 300, size)


FOUND = {"processors": 2, "others": 0.4567,
         "ratios": {"film": {"alone": 20.04, "points": 50.1}},
         "threads": {"speedup": {"summaries": 1.876, "points": 1.654}, "start": {"seconds": 1, "others": 0.3}},
         "ranks": {"speedup": {"2": 1.512, "4": 1.734}, "cpu_speedup": {"2": 1.912, "4": 3.634}, "weak_efficiency": 0.811, "weak_cpu_efficiency": 0.944,
                   "of": {"strong 1": {"seconds": 1, "others": 0.7}, "no time": {"others": 0.8}}},
         "memory": {"100 points, ranks 2": {"mb_of_rank": {"0": 99.6, "1": 250.4}, "seconds": 3.14, "others": 0.9}}}


class Output(Folder):
    def printed(self, found):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            scaling.tables(found)
        return said.getvalue().splitlines()

    def test_tables_say_each_number(self):
        self.assertEqual(self.printed(FOUND), [
            "", f"{'film':34}  ns a point   / alone", f"  {'alone':32}        20.0      1.00", f"  {'points':32}        50.1      2.50",
            "", "two threads: 1.88 times one with summaries, 1.65 with points; by the clock, without their waits for others",
            "2 ranks on 2 processors: 1.51 times one by the clock, at most 1.91 by their CPU time",
            "4 ranks on 2 processors: 1.73 times one by the clock, at most 3.63 by their CPU time",
            "weak, 2 ranks with twice the points: 81 % by the clock, at most 94 % by CPU time",
            "other processes used at most 0.46 processors meanwhile", "100 points, ranks 2: 250 MB, 3.1 s"])
        self.assertEqual(self.printed({}), [])

    def test_others_are_those_of_times_of_threads_and_ranks(self):
        self.assertEqual(scaling.greatest_use_by_others(FOUND), 0.7)
        self.assertEqual(scaling.greatest_use_by_others({"memory": FOUND["memory"]}), 0)

    def test_numbers_are_kept_to_five_digits(self):
        self.assertEqual(scaling.rounded({"a": [1.23456789, "text"], "b": {"c": 123456.7}, "d": 1234567}),
                         {"a": [1.2346, "text"], "b": {"c": 123460.0}, "d": 1234567})

    def test_the_environment_is_the_processor_as_the_system_names_it_and_what_the_tools_say_first(self):
        with mock.patch.object(scaling.measure, "said_by", lambda command: f"{command[0]} 12: the best\nmore\n"):
            found = scaling.environment()
        names = [line.partition(":")[2].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
        self.assertEqual(found, {"cpu": names[0] if names else "unknown", "compiler": "g++ 12: the best", "mpi": "mpirun 12: the best"})

    def main(self, *options):
        parts = {name: mock.Mock(return_value={"new": name}) for name in scaling.PARTS}
        with mock.patch.multiple(scaling, **parts, tables=mock.DEFAULT), mock.patch.object(scaling.shutil, "which", lambda _: "/usr/bin/mpirun"), \
                mock.patch.object(scaling, "environment", lambda: {"cpu": "c"}), mock.patch.object(scaling.measure, "commit", lambda: "abc"), \
                mock.patch.object(sys, "argv", ["scaling.py", "build", *options]), contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(scaling.main(), 0)
        return {name for name, one in parts.items() if one.called}

    def test_parts_that_are_not_asked_for_stay_what_they_were(self):
        out = self.folder / "sweep.json"
        self.assertEqual(self.main("--out", str(out)), set(scaling.PARTS))
        whole = json.loads(out.read_text())
        self.assertEqual({name: whole[name] for name in scaling.PARTS}, {name: {"new": name} for name in scaling.PARTS})
        self.assertEqual((whole["commit"], whole["environment"], whole["others"], whole["processors"]), ("abc", {"cpu": "c"}, 0, os.cpu_count()))
        out.write_text(json.dumps({name: {"old": name} for name in scaling.PARTS} | {"stale": 1}))
        self.assertEqual(self.main("--out", str(out), "--only", "ratios,memory"), {"ratios", "memory"})
        kept = json.loads(out.read_text())
        self.assertEqual({name: list(kept[name]) for name in scaling.PARTS}, {"ratios": ["new"], "threads": ["old"], "ranks": ["old"], "memory": ["new"]})
        self.assertNotIn("stale", kept)

    def test_an_unknown_part_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "--only: sped: not among ratios, threads, ranks, memory"):
            self.main("--only", "sped,ranks")

    def test_a_table_is_printed_of_a_file_without_measuring(self):
        path = self.folder / "of.json"
        path.write_text(json.dumps(FOUND))
        with mock.patch.object(sys, "argv", ["scaling.py", "--table", str(path)]), contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(scaling.main(), 0)
        self.assertEqual(said.getvalue().splitlines(), self.printed(FOUND))


if __name__ == "__main__":
    unittest.main()
