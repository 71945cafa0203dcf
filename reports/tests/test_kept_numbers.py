# SPDX-License-Identifier: Apache-2.0
"""Parts carry a version of numbers, so that a newer program goes on with older parts: under the same version every
answer has the same bits."""

import json
import math
import unittest

import kept_numbers


def difference(expected, got):
    """The difference in words: both numbers as decimal and hexfloat, and the units in the last place between them."""
    if not all(isinstance(one, float) for one in (expected, got)):
        return f"expected {expected}, got {got}"
    return (f"expected {expected!r} ({expected.hex()}), got {got!r} ({got.hex()}), "
            f"{abs(got - expected)/math.ulp(expected):.3g} ulp")


class KeptNumbers(kept_numbers.Solver):
    def test_no_answer_changes_a_bit_under_the_same_version_of_numbers(self):
        kept = json.loads(kept_numbers.KEPT.read_text(encoding="utf-8"))
        version, arithmetic, sweeps = self.kept()
        self.assertEqual(version, kept["numbers_version"], "numbers_version has changed: run make numbers to keep its answers")
        self.assertEqual(sorted(kept["arithmetic"]), ["FMA", "no FMA"])
        self.assertEqual(sorted(sweeps), sorted(kept["arithmetic"][arithmetic]))
        for name, expected in kept["arithmetic"][arithmetic].items():
            self.assertEqual(sorted(sweeps[name]), sorted(expected), name)
            for dataset, numbers in expected.items():
                got = sweeps[name][dataset]
                self.assertEqual(len(got), len(numbers), (name, dataset))
                changed = [f"{place}: {difference(one, other)}"
                           for place, (one, other) in enumerate(zip(numbers, got)) if one != other]
                self.assertFalse(changed[:3], f"{name}, {dataset}: {len(changed)} of {len(numbers)} numbers changed; "
                                              "if that is meant, raise numbers_version in model/sweep/plan.hpp, then make numbers")


if __name__ == "__main__":
    unittest.main()
