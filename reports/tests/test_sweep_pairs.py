# SPDX-License-Identifier: Apache-2.0
"""Two processes of tribocheck sweep on one output, each started anew, with --resume, with --force or as a
merge, at random moments: the right result or a refusal. TRIBOCHECK_PAIRS asks for more pairs than twenty."""

import os
import random
import subprocess
import time
import unittest

from program import start
from sweeps import UNIFORM, SweepTest, sweep

PAIRS = int(os.environ.get("TRIBOCHECK_PAIRS", 20))
SWEEPS = {name: sweep({"lubricant.viscosity": UNIFORM, "load": load, "speed": "[0.1, 1.0]"}, draws=40000)
          for name, load in (("a", '{ printed = "50" }'), ("b", '{ printed = "60" }'))}
KINDS = ("start", "--resume", "--force", "merge")
STATES = ("nothing", "parts of a", "result of a", "result of b")


class Pairs(SweepTest):
    def setUp(self):
        super().setUp()
        self.whole, self.told, self.longest = {}, {}, 0
        for name, text in SWEEPS.items():
            begin = time.monotonic()
            told = self.swept(text, "--format", "csv", name=f"{name}.toml", out=f"{name}.whole")
            self.longest = max(self.longest, time.monotonic() - begin)
            self.whole[name], self.told[name] = self.bytes_of(f"{name}.whole"), told.out.encode()
            for part in (1, 2):
                self.swept(text, "--shard", f"{part}/2", name=f"{name}.toml", out=f"{name}.{part}")
        self.part = self.bytes_of("a.1")

    def prepare(self, state):
        for name in self.names():
            if name.startswith("out.h5"):
                os.remove(self.path(name))
        if state == "parts of a":
            self.put("out.h5.part-0-98", self.part)
        elif state != "nothing":
            self.put("out.h5", self.whole[state[-1]])

    def started(self, kind, name):
        arguments = [self.path(f"{name}.toml")] + ([kind] if kind.startswith("-") else [])
        if kind == "merge":
            arguments = ["merge", self.path(f"{name}.1"), self.path(f"{name}.2"), "--force"]
        return start("sweep", *arguments, "-o", self.path("out.h5"), "--format", "csv",
                     stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def check(self, state, ended):
        """ended: the sweep, exit code, stdout and stderr of each process."""
        for name, code, out, error in ended:
            self.assertIn(code, (0, 2), error)
            if code == 0:
                self.assertEqual(out, self.told[name])
            else:
                self.assertEqual((out, len(error.splitlines())), (b"", 1), error)
        left = [name for name in self.names() if name.startswith("out.h5")]
        done = [name for name, code, *_ in ended if code == 0]
        if done:
            self.assertEqual(left, ["out.h5"])
            self.assertIn(self.bytes_of("out.h5"), [self.whole[name] for name in done])
        elif state.startswith("parts"):
            self.assertEqual(left, ["out.h5.part-0-98"])
            self.assertEqual(self.bytes_of("out.h5.part-0-98"), self.part)
        else:  # both processes refused to replace a result
            self.assertEqual(left, ["out.h5"])
            self.assertEqual(self.bytes_of("out.h5"), self.whole[state[-1]])

    def test_of_two_processes_each_gives_its_own_result_or_is_refused(self):
        draw = random.Random(11)
        pairs = [(first, second) for first in KINDS for second in KINDS]
        both = one = 0
        for i in range(PAIRS):
            kinds, state = pairs[i % len(pairs)], draw.choice(STATES)
            names = [draw.choice("ab") for _ in kinds]
            wait = draw.uniform(0, 1.2 * self.longest)
            with self.subTest(kinds=kinds, names=names, state=state, wait=wait):
                self.prepare(state)
                first = self.started(kinds[0], names[0])
                time.sleep(wait)
                second = self.started(kinds[1], names[1])
                said = [process.communicate(timeout=120) for process in (first, second)]
                ended = [(name, process.returncode, *texts)
                         for name, process, texts in zip(names, (first, second), said)]
                self.check(state, ended)
                good = sum(process.returncode == 0 for process in (first, second))
                both, one = both + (good == 2), one + (good == 1)
        print(f"{PAIRS} pairs: {both} both gave a result, {one} one of them, "
              f"{PAIRS - both - one} none", flush=True)
        self.assertGreater(one, 0)


if __name__ == "__main__":
    unittest.main()
