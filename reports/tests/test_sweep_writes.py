# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep in which one write, sync, rename or close fails, also those of HDF5, each in turn. It gives the right
result, or exit code 1 and loses no computed part. TRIBOCHECK_FAILED_WRITES asks for larger sweeps."""

import os
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM
from sweeps import SANITIZED, UNIFORM, SweepTest, preloadable, sweep

LARGER = bool(os.environ.get("TRIBOCHECK_FAILED_WRITES"))
# Each EACH_WRITE-th write fails in a run of its own, since the same few lines of the program do all writes. At each EACH_FULL_DISK-th call
# a run begins in which this call and all later ones fail.
EACH_WRITE, EACH_FULL_DISK = (1, 1) if LARGER else (20, 50) if SANITIZED else (5, 17)
SMALL = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]", "outputs": '["film", "regime"]'},
              onset='["film_maximum"]', draws=2000)
WITH_SENSITIVITY = sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }',
                          "speed": "[0.1, 1.0]", "outputs": '["film", "friction"]'},
                         sensitivity="true", draws=2000)
SUMMARIES = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, keep='"summaries"', draws=3000)


@unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
class FailingWrites(SweepTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.library = preloadable("failing_writes")

    part_chunks = 1  # chunks in a part: a sweep of two chunks has two parts

    def run_with(self, arguments, call=0, on=False):
        environment = dict(ENVIRONMENT, LD_PRELOAD=self.library, FAILING_PATH=self.path("out."),
                           TRIBOCHECK_PART_CHUNKS=str(self.part_chunks),
                           FAILING_CALL=str(call), FAILING_COUNT=self.path("count"))
        # libhdf5 1.10.8 leaks the memory of a file if closing it fails.
        environment["ASAN_OPTIONS"] += ":verify_asan_link_order=0:detect_leaks=0"
        if on:
            environment["FAILING_ON"] = "1"
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60,
                              env=environment)

    def calls(self):
        """The call that failed last, and a letter for each call, as failing_writes.c names them."""
        with open(self.path("count"), encoding="ascii") as file:
            _, failed, kinds = file.read().split()
            return failed, kinds

    def clean(self):
        for name in self.names():
            if name.startswith(("out.", ".out.")):
                os.remove(self.path(name))

    def check_each_call(self, ways, whole):
        """`ways` has pairs of commands: one that is run with a failing call, and one that recovers after it. The first commands of all
        pairs make the same calls. Each call that is no write fails alone; EACH_WRITE and EACH_FULL_DISK tell the other failures. The
        ways take turns at the failures; in larger sweeps each way has all of them."""
        out = "out.h5"
        seen = set()
        for command, _ in ways:
            self.clean()
            calm = self.run_with(command)
            self.assertEqual(calm.returncode, 0, calm.stderr)
            self.assertEqual(self.bytes_of(out), whole)
            seen.add((self.calls()[1], calm.stdout))
        (kinds, told), = seen
        writes = [call for call, kind in enumerate(kinds, 1) if kind == "w"]
        others = [call for call, kind in enumerate(kinds, 1) if kind != "w"]
        self.assertGreater(min(len(writes), len(others)), 5)
        self.assertNotIn("u", kinds, "a file got its name before all its writes were on the disk")
        self.assertIn("r", kinds)
        self.assertEqual(kinds.count("r"), kinds.count("rf"), f"after a rename the folder is not synced: {kinds}")
        tries = failures = 0
        failing = [(False, call) for call in others + writes[::EACH_WRITE]]
        failing += [(True, call) for call in range(1, len(kinds) + 1, EACH_FULL_DISK)]
        for on, call in failing:
            for command, recover in ways if LARGER else [ways[tries % len(ways)]]:
                tries += 1
                with self.subTest(call=call, of=kinds, on=on):
                    self.clean()
                    done = self.run_with(command, call, on)
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    if done.returncode == 0:
                        # These failures do no harm: a leftover is not removed, a file that is on the disk
                        # already is not closed, or HDF5 cannot look whether the file exists.
                        failed = self.calls()[0]
                        if failed == "openat":  # a part is opened and checked before it is removed
                            self.assertIn("needs it no more", done.stderr)
                        else:
                            self.assertIn(failed, ("unlinkat", "close", "open", "open64"))
                        self.assertEqual(self.bytes_of(out), whole)
                        self.assertEqual(done.stdout, told)
                    else:
                        failures += 1
                        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                    if os.path.exists(self.path(out)):
                        self.assertEqual(self.bytes_of(out), whole)
                    elif done.returncode == 1:
                        again = self.run_with(recover)
                        self.assertEqual(again.returncode, 0, again.stderr)
                        self.assertEqual(self.bytes_of(out), whole)
        print(f"{tries} failures of {len(writes)} writes and {len(others)} other calls injected, {failures} told by exit code 1", flush=True)
        self.assertGreater(failures, tries / 2)

    def check_sweep(self, text, *options, joined=False):
        path = self.folder.write("sweep.toml", text)
        self.swept(text, "--force", *options, out="whole.h5")
        command = ["sweep", path, "-o", self.path("out.h5"), "--threads", "1", *options]
        ways = [(command, [*command, "--resume"])]
        if joined:
            ways.append(([*command, "--join"], [*command, "--join"]))
        self.check_each_call(ways, self.bytes_of("whole.h5"))

    def test_a_sweep_that_others_may_join_or_not(self):
        for text in (SMALL, WITH_SENSITIVITY, SUMMARIES) if LARGER else (SMALL,):
            self.check_sweep(text, joined=True)

    def test_a_short_sweep_without_parts(self):
        self.part_chunks = 100
        self.check_sweep(SMALL)

    def test_a_shard(self):
        self.check_sweep(SMALL, "--shard", "1/2")

    def test_a_merge(self):
        self.swept(SMALL, out="whole.h5")
        shards = []
        for part in (1, 2):
            self.swept(SMALL, "--shard", f"{part}/2", out=f"{part}.shard")
            shards.append(self.path(f"{part}.shard"))
        command = ["sweep", "merge", *shards, "-o", self.path("out.h5")]
        self.check_each_call([(command, command)], self.bytes_of("whole.h5"))


if __name__ == "__main__":
    unittest.main()
