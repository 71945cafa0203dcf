# SPDX-License-Identifier: Apache-2.0
"""The memory of a sweep that keeps only summaries stays flat over a hundred million points, or as many as
TRIBOCHECK_POINTS asks for. The memory of each step is printed."""

import os
import subprocess
import unittest

from program import start, wait_for
from sweeps import SweepTest, opened, sweep

POINTS = int(os.environ.get("TRIBOCHECK_POINTS", 100_000_000))
MOST_MB = 300
SPEED = '{ distribution = "log_uniform", from = 1e-4, to = 3 }'


class LongSweep(SweepTest):
    def test_memory_is_flat(self):
        text = sweep({"speed": SPEED, "outputs": '["film"]'}, draws=POINTS, keep='"summaries"',
                     design='"monte_carlo"')
        # A shard is a part: merging it is the last step of a run.
        computed = self.memory_of("sweep", self.folder.write("long.toml", text), "--shard", "1/1",
                                  "-o", self.path("long.shard"))
        merged = self.memory_of("sweep", "merge", self.path("long.shard"), "-o", self.path("long.h5"))
        self.assertLess(computed, MOST_MB)
        self.assertLess(merged, MOST_MB)
        with opened(self.path("long.h5")) as file:
            self.assertEqual(file["smooth/summary/film/count"][0], POINTS)
        size = os.path.getsize(self.path("long.shard"))
        print(f"{POINTS} points: {computed:.0f} MB, merged in {merged:.0f} MB; {size / 1e6:.1f} MB of parts, "
              f"{size / POINTS:.2g} bytes a point", flush=True)

    def memory_of(self, *arguments):
        process = start(*arguments, stdout=subprocess.DEVNULL)
        code, memory = wait_for(process)
        self.assertEqual(code, 0)
        return memory


if __name__ == "__main__":
    unittest.main()
