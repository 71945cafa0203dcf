# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep --join: processes that help each other on one output, with locks and on a file system that has
none, give the bytes of one process. TRIBOCHECK_HELPERS asks for another number than eight, TRIBOCHECK_TRIES for more
tries than five."""

import collections
import os
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM
from sweeps import DAYS, LONG, MINI, SweepTest, preloadable

HELPERS = int(os.environ.get("TRIBOCHECK_HELPERS", 8))
TRIES = int(os.environ.get("TRIBOCHECK_TRIES", 5))
OTHER = LONG.replace("draws = 150000", "draws = 150001")


class Join(SweepTest):
    def setUp(self):
        super().setUp()
        self.told = self.swept(LONG, "--format", "csv", out="whole.h5").out
        self.whole = self.bytes_of("whole.h5")

    def started(self, *options, name="sweep.toml", **environment):
        process = subprocess.Popen(
            [PROGRAM, "sweep", self.path(name), "-o", self.path("out.h5"), "--threads", "1",
             *(options if "--shard" in options else ("--format", "csv", *options))], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=dict(ENVIRONMENT, **environment))
        return self.ended_at_last(process)

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

    def test_several_processes_on_one_output_are_refused_or_end_in_the_same_bytes(self):
        whole = self.whole_mini()
        self.folder.write("sweep.toml", MINI)
        draw = random.Random(29)
        ends = collections.Counter()
        for attempt in range(TRIES):
            processes = []
            for _ in range(draw.randrange(2, 5)):
                option = draw.choice(["--threads", "--resume", "--join", "--join", "--force"])
                processes.append((option, self.started(*([option] if option != "--threads" else []))))
                time.sleep(draw.choice([0, 0.01, 0.05]))
            with self.subTest(attempt=attempt):
                for option, process in processes:
                    _, said = process.communicate(timeout=60)
                    ends[option, process.returncode] += 1
                    self.assertIn(process.returncode, (0,) if option == "--join" else (0, 2), said)
                self.assertEqual(self.bytes_of("out.h5"), whole)
                self.assert_nothing_beside()
            os.remove(self.path("out.h5"))
        print(f"{TRIES} tries; option, exit code: processes {dict(ends)}", flush=True)

    def test_a_helper_ends_what_its_owner_has_begun(self):
        owner = self.stopped(self.started())
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
        owner = self.stopped(self.started())
        helper = self.started("--join")
        self.wait_for_handler(helper, signal.SIGINT)
        time.sleep(0.3)
        helper.send_signal(signal.SIGINT)
        _, said = helper.communicate(timeout=60)
        self.assertEqual((helper.returncode, len(said.splitlines())), (130, 1), said)
        self.assertIn("stopped: parts that are computed are kept", said)
        owner.send_signal(signal.SIGCONT)
        self.assert_whole(owner)
        self.assert_nothing_beside()

    def test_who_computes_another_sweep_is_refused(self):
        owner = self.stopped(self.started())
        self.assert_refused(self.sweep(OTHER, "--join", name="other.toml"), "out.h5", "another sweep")
        os.remove(self.path("other.toml"))
        owner.send_signal(signal.SIGCONT)
        self.assert_whole(owner)
        self.assert_refused(self.sweep(OTHER, "--join", name="other.toml"), "out.h5", "another sweep")

    def test_who_computes_another_sweep_is_refused_before_there_is_a_part(self):
        self.folder.write("days.toml", DAYS)
        for more in ({}, {"LD_PRELOAD": preloadable("own_host"), "NO_LOCKS": "1"} if shutil.which("cc") else {}):
            owner = self.started(*(["--join"] if more else []), name="days.toml", **more)
            self.wait_until(lambda: "out.h5.lock" in self.names() and os.path.getsize(self.path("out.h5.lock")) > 0)
            for text, options in ((OTHER, []), (DAYS, ["--shard", "1/2"])):
                helper = self.started("--join", *options, name=os.path.basename(self.folder.write("other.toml", text)),
                                      **more)
                out, said = helper.communicate(timeout=20)
                self.assertEqual((helper.returncode, out, len(said.splitlines())), (2, "", 1), said)
                self.assertIn("another s", said)  # "another sweep" or "another shard"
            owner.kill()
            owner.wait()
            self.assertEqual(self.parts(), [])
            for name in self.names():
                if "out.h5" in name:
                    os.remove(self.path(name))

    def test_what_a_killed_owner_has_not_given_its_name_is_removed_by_the_next(self):
        for kill in range(20):
            owner = self.started("--join")
            self.wait_until(lambda: owner.poll() is not None or self.results_begun())
            owner.send_signal(signal.SIGSTOP)
            begun = self.results_begun()
            if begun:  # a helper leaves the owner's file alone
                helper = self.started("--join")
                time.sleep(0.3)
                self.assertEqual(self.results_begun(), begun)
                owner.kill()
                self.assert_whole(helper)
            owner.kill()
            owner.wait()
            self.assert_nothing_beside()
            os.remove(self.path("out.h5"))
            if begun:
                return
        self.fail("no owner was met while it wrote its result")

    def results_begun(self):
        return [name for name in self.names() if re.fullmatch(r"\.out\.h5\.\d+-\d+", name)]

    def test_alone_it_begins_and_goes_on(self):
        first = self.started("--join")
        self.wait_for_parts()
        first.kill()
        first.wait()
        for said in ("going on", ""):  # at the second time the result is there
            again = self.sweep(LONG, "--join", "--format", "csv")
            self.assertEqual((again.code, again.out), (0, self.told), again.err)
            self.assertIn(said, again.err)
        self.assertEqual(self.bytes_of("out.h5"), self.whole)
        self.assert_nothing_beside()


if __name__ == "__main__":
    unittest.main()
