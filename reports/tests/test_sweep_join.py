# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep --join: processes that help each other on one output, with locks and on a file system that has
none, give the bytes of one process. TRIBOCHECK_HELPERS asks for another number than eight."""

import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM
from sweeps import LONG, SweepTest, preloadable

HELPERS = int(os.environ.get("TRIBOCHECK_HELPERS", 8))
OTHER = LONG.replace("draws = 150000", "draws = 150001")


class Join(SweepTest):
    def setUp(self):
        super().setUp()
        self.told = self.swept(LONG, "--format", "csv", out="whole.h5").out
        self.whole = self.bytes_of("whole.h5")

    def started(self, *options, **environment):
        process = subprocess.Popen(
            [PROGRAM, "sweep", self.path("sweep.toml"), "-o", self.path("out.h5"), "--format", "csv", "--threads", "1",
             *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=dict(ENVIRONMENT, **environment))
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for_parts(self):
        end = time.monotonic() + 60
        while len(self.parts()) < 3 and time.monotonic() < end:
            time.sleep(0.002)

    def assert_whole(self, process):
        out, said = process.communicate(timeout=100)
        self.assertEqual((process.returncode, out), (0, self.told), said)
        self.assertEqual(self.bytes_of("out.h5"), self.whole)

    def assert_nothing_beside(self):
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_many_processes_of_many_hosts_with_locks_and_without(self):
        library = preloadable("own_host")
        draw = random.Random(13)
        for locks in ({}, {"NO_LOCKS": "1"}):
            with self.subTest(locks=locks):
                processes = []
                for i in range(HELPERS):
                    host = {"LD_PRELOAD": library, "HOST_NAME": f"host{i}", **locks}
                    host["ASAN_OPTIONS"] = ENVIRONMENT["ASAN_OPTIONS"] + ":verify_asan_link_order=0"
                    processes.append(self.started("--join", **host))
                    time.sleep(draw.uniform(0, 0.05))
                for process in processes:
                    self.assert_whole(process)
                self.assert_nothing_beside()
                os.remove(self.path("out.h5"))

    def test_a_helper_ends_what_its_owner_has_begun(self):
        owner = self.started()
        self.wait_for_parts()
        owner.send_signal(signal.SIGSTOP)
        helper = self.started("--join")
        time.sleep(0.3)
        owner.kill()
        owner.wait()
        self.assert_whole(helper)
        self.assert_nothing_beside()

    def test_an_owner_takes_what_helpers_have_computed_and_left(self):
        owner = self.started()
        self.wait_for_parts()
        helper = self.started("--join")
        time.sleep(0.1)
        helper.kill()
        helper.wait()
        self.assert_whole(owner)
        self.assert_nothing_beside()

    def test_a_stopped_helper_leaves_the_others_alone(self):
        owner = self.started()
        self.wait_for_parts()
        owner.send_signal(signal.SIGSTOP)
        helper = self.started("--join")
        time.sleep(0.3)
        helper.send_signal(signal.SIGINT)
        _, said = helper.communicate(timeout=60)
        self.assertEqual((helper.returncode, len(said.splitlines())), (130, 1), said)
        self.assertIn("stopped: parts that are computed are kept", said)
        owner.send_signal(signal.SIGCONT)
        self.assert_whole(owner)
        self.assert_nothing_beside()

    def test_who_computes_another_sweep_is_refused(self):
        owner = self.started()
        self.wait_for_parts()
        owner.send_signal(signal.SIGSTOP)
        self.assert_refused(self.sweep(OTHER, "--join", name="other.toml"), "out.h5.part-", "another sweep")
        os.remove(self.path("other.toml"))
        owner.send_signal(signal.SIGCONT)
        self.assert_whole(owner)
        self.assert_refused(self.sweep(OTHER, "--join", name="other.toml"), "out.h5", "another sweep")

    def test_alone_it_begins_and_goes_on(self):
        first = self.started("--join")
        self.wait_for_parts()
        first.kill()
        first.wait()
        for said in ("going on", ""):  # then the result is there
            again = self.sweep(LONG, "--join", "--format", "csv")
            self.assertEqual((again.code, again.out), (0, self.told), again.err)
            self.assertIn(said, again.err)
        self.assertEqual(self.bytes_of("out.h5"), self.whole)
        self.assert_nothing_beside()


if __name__ == "__main__":
    unittest.main()
