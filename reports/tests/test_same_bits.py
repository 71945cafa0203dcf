# SPDX-License-Identifier: Apache-2.0
"""All commands give the same bits for the same points, on each kind of processor with fused multiply-add
and on any number of threads. Numbers are written so that they read back exactly."""

import json
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, scene
from sweeps import NORMAL, UNIFORM, SweepTest, sweep

# GLIBC_TUNABLES switches these instruction sets off for each kind of processor. Kinds without fused
# multiply-add give other bits, and are left out.
HWCAPS = "glibc.cpu.hwcaps="
KINDS = {"all": "", "no AVX-512": "-AVX512F"}
NUMBERS = ("film_flooded", "film", "separation", "film_parameter", "asperity_load_share",
           "fluid_load_share", "real_area_ratio", "summit_count", "friction")


def asked(kind, *arguments, stdin=""):
    environment = dict(ENVIRONMENT)
    if KINDS[kind]:
        # One setting lists all sets, also those that are already off: of several settings only the last counts.
        already = environment.get("GLIBC_TUNABLES", "")
        off = already.removeprefix(HWCAPS).split(",") if already.startswith(HWCAPS) else []
        environment["GLIBC_TUNABLES"] = HWCAPS + ",".join([*off, KINDS[kind]])
    done = subprocess.run([PROGRAM, *arguments], input=stdin.encode(), capture_output=True,
                          timeout=120, env=environment)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode()


def scenes():
    for surface in ("rough", "smooth"):
        for closure in ("flooded_inlet", "starved_inlet", "printed_exponents", "damiens"):
            yield scene(surface, id=f"{surface}-{closure}", closures={"starvation": closure})


class SameBits(SweepTest):
    def test_solve_curve_and_stream_give_the_same_points_on_each_kind(self):
        trees = {tree["id"]: tree for tree in scenes()}
        files = [self.folder.write(f"{name}.toml", tree) for name, tree in trees.items()]
        first = None
        for kind in KINDS:
            solved = json.loads(asked(kind, "solve", *files, "--format", "json"))["points"]
            curve = json.loads(asked(kind, "curve", *files, "--format", "json"))["points"]
            self.assertEqual(solved, curve, kind)
            lines = ""
            for point in solved:
                lines += json.dumps(dict(trees[point["id"]], speed=point["speed"])) + "\n"
            streamed = [json.loads(line)
                        for line in asked(kind, "stream", stdin=lines).splitlines()]
            self.assertEqual(len(streamed), len(solved))
            for one, other in zip(streamed, solved):
                for name in NUMBERS:
                    self.assertEqual(one[name], other[name], (kind, one["id"], name))
            first = first or solved
            self.assertEqual(solved, first, kind)
        self.assertGreater(len(first), 100)

    def test_a_sweep_gives_the_same_bytes_on_each_kind_and_number_of_threads(self):
        text = sweep({"lubricant.viscosity": UNIFORM, "load": NORMAL.replace("0.0202", "50"),
                      "speed": "[0.001, 0.02, 0.4]", "closures.asperity":
                      '["greenwood_tripp", "greenwood_williamson"]'},
                     draws=300, onset='["film_maximum"]')
        path = self.folder.write("sweep.toml", text)
        first = None
        for kind in KINDS:
            for threads in ("1", "2"):
                asked(kind, "sweep", path, "-o", self.path("out.h5"), "--force", "--threads", threads)
                got = self.bytes_of("out.h5")
                first = first or got
                self.assertEqual(got, first, (kind, threads))


if __name__ == "__main__":
    unittest.main()
