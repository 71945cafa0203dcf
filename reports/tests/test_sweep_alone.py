# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep without MPI refuses to be one of several ranks, as each of them would do the whole work."""

import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM
from sweeps import SweepTest, sweep


class Alone(SweepTest):
    def test_as_one_of_several_ranks_it_refuses(self):
        path = self.folder.write("sweep.toml", sweep({"load": "[1, 2]", "speed": "1"}))
        done = subprocess.run([PROGRAM, "sweep", path, "-o", self.path("out.h5")], text=True,
                              capture_output=True, timeout=60,
                              env=dict(ENVIRONMENT, OMPI_COMM_WORLD_SIZE="2"))
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("without MPI", done.stderr)
        self.assertEqual(self.names(), ["sweep.toml"])

    def test_as_the_only_rank_it_runs(self):
        path = self.folder.write("sweep.toml", sweep({"load": "[1, 2]", "speed": "1"}))
        done = subprocess.run([PROGRAM, "sweep", path, "-o", self.path("out.h5")], text=True,
                              capture_output=True, timeout=60,
                              env=dict(ENVIRONMENT, OMPI_COMM_WORLD_SIZE="1"))
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
