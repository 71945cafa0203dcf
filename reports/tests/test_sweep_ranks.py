# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep under mpirun: 1, 2 and 4 ranks on one machine give the bytes of one process."""

import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM
from sweeps import LONG, SweepTest, mpi_environment, mpirun


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
                done = self.with_ranks(ranks, LONG, "--format", "csv", out=f"{ranks}.h5")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(self.bytes_of(f"{ranks}.h5"), self.bytes_of("alone.h5"))
                self.assertEqual(done.stdout, alone.out)
        self.assertEqual(self.names(), ["1.h5", "2.h5", "4.h5", "alone.h5", "sweep.toml"])

    def started(self, ranks):
        path = self.folder.write("sweep.toml", LONG)
        return subprocess.Popen([*mpirun(ranks), PROGRAM, "sweep", path, "-o", self.path("out.h5")],
                                env=mpi_environment(), stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def wait_for_parts(self):
        end = time.monotonic() + 60
        while len(self.parts()) < 4:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.002)

    def assert_resumes_with(self, ranks):
        self.swept(LONG, out="whole.h5")
        deadline = time.monotonic() + 30
        while True:  # a rank that is being ended may hold its lock a moment longer
            done = self.with_ranks(ranks, LONG, "--resume")
            if done.returncode == 0 or time.monotonic() > deadline:
                break
            time.sleep(0.5)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    def test_a_killed_rank_ends_the_run_and_loses_nothing(self):
        process = self.started(2)
        self.wait_for_parts()
        ranks = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)],
                               capture_output=True, text=True).stdout.split()
        os.kill(int(ranks[-1]), signal.SIGKILL)
        self.assertNotEqual(process.wait(timeout=60), 0)
        self.assert_resumes_with(1)

    def test_ranks_go_on_with_what_another_number_of_ranks_left(self):
        process = self.started(4)
        self.wait_for_parts()
        process.kill()  # mpirun itself: its ranks end with it
        process.wait()
        self.assert_resumes_with(2)

    def test_bad_input_is_told_once(self):
        done = self.with_ranks(3, "load = 3\n")
        told = [line for line in done.stderr.splitlines() if line.startswith("tribocheck:")]
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertEqual(len(told), len(set(told)))

    def test_a_rank_that_cannot_write_ends_all_with_one_line(self):
        done = self.with_ranks(2, LONG, out="none/out.h5")
        told = [line for line in done.stderr.splitlines() if line.startswith("tribocheck:")]
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertGreaterEqual(len(told), 1)


if __name__ == "__main__":
    unittest.main()
