# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep under mpirun: 1, 2 and 4 ranks on one machine give the bytes of one process. TRIBOCHECK_KILLS
asks for more kills than three."""

import collections
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM
from sweeps import LONG, MINI, SweepTest, mpi_environment, mpirun, preloadable

KILLS = int(os.environ.get("TRIBOCHECK_KILLS", 3))


class Ranks(SweepTest):
    def with_ranks(self, ranks, text, *options, out="out.h5"):
        path = self.folder.write("sweep.toml", text)
        return subprocess.run([*mpirun(ranks), PROGRAM, "sweep", path, "-o", self.path(out),
                               *options], capture_output=True, text=True, timeout=120,
                              env=mpi_environment())

    def test_any_number_of_ranks_gives_the_same_bytes_and_tells_them_once(self):
        alone = self.swept(LONG, "--format", "csv", out="alone.h5")
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks):
                done = self.with_ranks(ranks, LONG, "--format", "csv", "--threads", "4096", out=f"{ranks}.h5")
                self.assertEqual((done.returncode, done.stderr.count("--threads 4096")), (0, 1), done.stderr)
                self.assertEqual(self.bytes_of(f"{ranks}.h5"), self.bytes_of("alone.h5"))
                self.assertEqual(done.stdout, alone.out)
        self.assertEqual(self.names(), ["1.h5", "2.h5", "4.h5", "alone.h5", "sweep.toml"])

    def started(self, ranks):
        path = self.folder.write("sweep.toml", LONG)
        return subprocess.Popen([*mpirun(ranks), PROGRAM, "sweep", path, "-o", self.path("out.h5")],
                                env=mpi_environment(), stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def assert_resumes_with(self, ranks):
        self.swept(LONG, out="whole.h5")
        deadline = time.monotonic() + 30
        while True:  # a rank that ends may hold its lock for a moment
            done = self.with_ranks(ranks, LONG, "--resume")
            if done.returncode == 0 or time.monotonic() > deadline:
                break
            time.sleep(0.5)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    def test_a_killed_rank_ends_the_run_and_loses_nothing(self):
        process = self.started(2)
        self.wait_for_parts(4)
        ranks = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)],
                               capture_output=True, text=True).stdout.split()
        os.kill(int(ranks[-1]), signal.SIGKILL)
        self.assertNotEqual(process.wait(timeout=60), 0)
        self.assert_resumes_with(1)

    def test_ranks_go_on_with_what_another_number_of_ranks_left(self):
        process = self.started(4)
        self.wait_for_parts(4)
        process.kill()  # mpirun itself: its ranks end with it
        process.wait()
        self.assert_resumes_with(2)

    def test_killed_at_random_moments_and_resumed_it_ends_in_the_same_bytes(self):
        path = self.folder.write("sweep.toml", MINI)

        def begin(*options):
            return [subprocess.Popen([*mpirun(2), PROGRAM, "sweep", path, "-o", self.path("out.h5"), *options],
                                     env=mpi_environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)]

        def pick(process, draw):
            """A rank, or mpirun itself where none has started."""
            ranks = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True)
            return int(draw.choice(ranks.stdout.split() or [process.pid]))

        def end():
            self.swept(MINI, "--resume")
        self.check_kills(KILLS, begin, end, pick)

    def with_rank_one(self, text, environment, first=False):
        """Starts two ranks. Only the second one, or with `first` only the first one, has the variables of `environment`."""
        path = self.folder.write("sweep.toml", text)
        settings = ["env", *(f"{name}={value}" for name, value in environment.items())]
        command = [PROGRAM, "sweep", path, "-o", self.path("out.h5"), "--format", "csv"]
        ranks = [settings + command, command] if first else [command, settings + command]
        process = subprocess.Popen([*mpirun(1), *ranks[0], ":", "-n", "1", *ranks[1]], env=mpi_environment(),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        return self.ended_at_last(process)

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_a_rank_that_fails_tells_it_at_once_and_the_others_end_the_sweep(self):
        told = self.swept(LONG, "--format", "csv", out="whole.h5").out
        process = self.with_rank_one(LONG, {"LD_PRELOAD": preloadable("failing_writes"), "FAILING_PATH": self.path("out."),
                                            "FAILING_CALL": "1", "FAILING_ON": "1"})
        line = process.stderr.readline()
        self.assertIn("cannot write", line)
        self.assertNotIn("out.h5", self.names())  # while the other rank computes
        out, said = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (1, told), said)
        self.assertNotIn("tribocheck:", said)
        self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    def check_failures(self, environments, first):
        """One rank may fail, and the other one goes on or ends. An exit code of 1 comes with a line, and after --resume the result has
        the bytes of an undisturbed run."""
        whole = self.whole_mini()
        ends = collections.Counter()
        for environment in environments:
            process = self.with_rank_one(MINI, environment, first)
            _, said = process.communicate(timeout=60)
            with self.subTest(environment=environment, said=said):
                self.assertIn(process.returncode, (0, 1))
                if process.returncode == 1:
                    self.assertIn("tribocheck: ", said)
                ends[process.returncode, "out.h5" in self.names()] += 1
                self.swept(MINI, "--resume")
                self.assertEqual(self.bytes_of("out.h5"), whole)
                self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])
            os.remove(self.path("out.h5"))
        print(f"(exit code, result there): runs {dict(ends)}", flush=True)

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_wherever_one_call_of_the_first_rank_fails_nothing_is_lost(self):
        calls = random.Random(3).sample(range(4, 60), min(KILLS, 40))
        self.check_failures(({"LD_PRELOAD": preloadable("failing_writes"), "FAILING_PATH": self.path("out."),
                              "FAILING_CALL": str(call)} for call in calls), first=True)

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_wherever_a_rank_has_no_memory_the_others_end_and_nothing_is_lost(self):
        numbers = [1, *random.Random(4).sample(range(2, 150), min(KILLS, 40))]
        for first in (False, True):
            self.check_failures(({"LD_PRELOAD": preloadable("failing_new"), "FAILING_NEW": str(number)}
                                 for number in numbers), first)
            os.remove(self.path("whole.h5"))

    def test_bad_input_is_told_once(self):
        done = self.with_ranks(3, "load = 3\n")
        told = [line for line in done.stderr.splitlines() if line.startswith("tribocheck:")]
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertGreater(len(told), 0)
        self.assertEqual(len(told), len(set(told)))

    def test_a_rank_that_cannot_write_ends_all_and_says_so(self):
        done = self.with_ranks(2, LONG, out="none/out.h5")
        told = [line for line in done.stderr.splitlines() if line.startswith("tribocheck:")]
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertGreaterEqual(len(told), 1)


if __name__ == "__main__":
    unittest.main()
