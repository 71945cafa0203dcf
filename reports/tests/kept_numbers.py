# SPDX-License-Identifier: Apache-2.0
"""Keeps all numbers of some sweeps, to the last bit, with their numbers_version. A newer program goes on with the parts
of an older one if both have the same numbers_version, so that then no bit of an answer may differ.

  make numbers      runs this script, after numbers_version was raised: it writes reference/baselines/numbers.json

The numbers of machines with and without fused multiply-add differ, and both are kept.
"""

import json
import math
import pathlib
import re
import sys

from program import ENVIRONMENT
from sweeps import NORMAL, ONE_LINE, UNIFORM, SweepTest, opened, sweep

KEPT = pathlib.Path(__file__).resolve().parents[2] / "reference/baselines/numbers.json"
ELLIPSE = {"bodies.reduced_radius": None, "bodies.radius_x": "9.5e-3", "bodies.radius_y": "[0.019, 0.06]"}
LINE = {"bodies.reduced_radius": None, "bodies.radius_x": "0.01", "bodies.length": "0.01", "load": "[200, 5000]"}
ROLLER = {**dict.fromkeys(ONE_LINE), **LINE, "bodies.effective_modulus": "1.1e11", "lubricant.viscosity": "[0.01, 0.3]",
          "lubricant.pressure_viscosity": "[4e-9, 1.5e-8]", "speed": "0.5"}
OUTPUTS = {"outputs": json.dumps(["film_flooded", "film", "asperity_load_share", "real_area_ratio", "summit_count", "friction",
                                  "regime", "inlet"])}
SWEEPS = {
    "closures": sweep({**OUTPUTS, "speed": "[1e-4, 0.01, 0.3, 3]", "surface.summit_height_sd": "[2.5e-8, 1e-7]",
                       "closures.asperity": '["greenwood_tripp", "greenwood_williamson"]',
                       "closures.starvation": '["flooded_inlet", "starved_inlet", "printed_exponents", "damiens"]'}),
    "ellipses": sweep({**OUTPUTS, **ELLIPSE, "speed": "[0.01, 1]", "friction.fluid": '["eyring", "limiting"]',
                       "friction.slide_roll_ratio": "0.1",
                       "closures.film": '["hamrock_dowson_central", "hamrock_dowson_minimum", "hamrock_dowson_soft_central",'
                                        ' "hamrock_dowson_soft_minimum"]'}),
    "lines": sweep({**OUTPUTS, **LINE, "speed": "[0.01, 1]",
                    "closures.film": '["dowson_higginson_minimum", "dowson_toyoda_central", "pan_hamrock_minimum", "pan_hamrock_central"]'}),
    "limits": sweep({**OUTPUTS, "speed": "[0.1, 1]", "closures.film": '["nijenbanning_venner_moes", "solved"]'}),
    "line_limits": sweep({**OUTPUTS, **LINE, "speed": "[0.1, 1]", "closures.film": '["moes_line", "ertel_grubin", "solved"]'}),
    "solved_inlets": sweep({**OUTPUTS, "speed": "[0.2, 0.6, 2]", "surface.summit_height_sd": "[2.5e-8, 1e-7]",
                            "closures.film": '"solved"', "closures.starvation": '"solved"'}, onset='["film_departure", "friction_minimum"]'),
    "onsets": sweep({"lubricant.viscosity": NORMAL, "load": '{ printed = "50" }', "speed": "{ from = 1e-3, to = 3, count = 9 }"},
                    onset='["film_maximum", "film_departure", "friction_minimum", "asperity_minimum"]', draws=64, sensitivity="true"),
    "square": sweep({"outputs": '["film", "friction"]', "lubricant.viscosity": UNIFORM, "speed": "0.1",
                     "load": '{ distribution = "log_normal", median = 50, log_sd = 0.2 }'}, draws=50, design='"latin_hypercube"', seed=7),
    "chance": sweep({"outputs": '["film", "friction"]', "lubricant.viscosity": NORMAL, "speed": "0.1",
                     "load": '{ distribution = "normal", mean = 50, sd = 5 }'}, draws=50, design='"monte_carlo"',
                    correlated='["load", "lubricant.viscosity"]', correlation="[[1, -0.6], [-0.6, 1]]"),
    "films": sweep(ROLLER, solved_film="true"),
    "films_roelands": sweep({**ROLLER, "load": "2000", "friction.viscosity": '"roelands"'}, solved_film="true"),
}


def told(value):
    """A value for JSON: NaN becomes null, and bytes become text."""
    if isinstance(value, bytes):
        return value.decode()
    value = value.item() if hasattr(value, "item") else value
    return None if isinstance(value, float) and math.isnan(value) else value


def numbers_of(path):
    """All numbers of a result's cases and Sobol indices, by the paths of their datasets. Histograms and quantiles follow from the cases."""
    found = {}
    with opened(path) as file:
        def keep(name, one):
            if hasattr(one, "shape") and one.dtype.names is None and re.search(r"/(inputs|outputs|sensitivity)/", name):
                found[name] = [told(value) for value in one[()].ravel()]
        file.visititems(keep)
    return found


class Solver(SweepTest):
    def kept(self):
        """The version of numbers, the processor's arithmetic, and the numbers of each sweep."""
        self.swept(SWEEPS["square"], "--shard", "1/1", out="shard.h5")
        with opened(self.path("shard.h5")) as file:
            version, arithmetic = int(file.attrs["numbers"]), str(told(file.attrs["arithmetic"]))
        sweeps = {}
        for name, text in SWEEPS.items():
            self.swept(text, "--force")
            sweeps[name] = numbers_of(self.path("out.h5"))
        return version, arithmetic, sweeps


def main():
    kept = {}
    for off in ("", "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA"):
        ENVIRONMENT["GLIBC_TUNABLES"] = off
        solver = Solver()
        solver.setUp()
        version, arithmetic, sweeps = solver.kept()
        solver.doCleanups()
        kept[arithmetic] = sweeps
    if sorted(kept) != ["FMA", "no FMA"]:
        sys.exit("numbers: this processor has no fused multiply-add; run it on one that has")
    old = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {"numbers_version": None, "arithmetic": {}}
    changed = [name for kind, sweeps in old["arithmetic"].items() for name, numbers in sweeps.items()
               if kept[kind].get(name, numbers) != numbers]
    if changed and old["numbers_version"] == version:
        sys.exit(f"numbers: answers of {', '.join(sorted(set(changed)))} have changed, and numbers_version (model/sweep/plan.hpp) is still {version}; raise it first")
    text = json.dumps({"numbers_version": version, "arithmetic": kept}, indent=1)
    KEPT.write_text(re.sub(r",\n {5,}", ", ", re.sub(r"\[\n +", "[", re.sub(r"\n +\]", "]", text))) + "\n", encoding="utf-8")
    print(f"{KEPT.name}: the numbers of {len(SWEEPS)} sweeps, with and without fused multiply-add, under numbers_version {version}")


if __name__ == "__main__":
    main()
