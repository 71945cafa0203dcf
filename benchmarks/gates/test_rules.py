# SPDX-License-Identifier: Apache-2.0
"""Tests when a gate is red: rules.py, and the parts of gate.py that need no program. test_gate.py tests gate.py with a program."""
import math
import statistics
import unittest

import gate
import rules
from rules import Interval, Repetition

QUIETLY = {"say": lambda line: None}


def verdict(name):
    return gate.Verdict(name, **QUIETLY)


class Counters(unittest.TestCase):
    BASE = {"root AVX2": {"root_steps": 100, "roots_by_newton": 0}}

    def held(self, now, base=None):
        return gate.hold_counters(base or self.BASE, now, verdict("counters"))

    def test_the_same_passes(self):
        self.assertEqual(self.held(dict(self.BASE)).name, "passed")

    def test_one_more_or_fewer_is_red(self):
        for steps in (99, 101):
            held = self.held({"root AVX2": {"root_steps": steps, "roots_by_newton": 0}})
            self.assertEqual(held.red, [f"root AVX2: root_steps {steps}, not 100"])

    def test_a_counter_come_or_gone_is_red(self):
        self.assertEqual(self.held({"root AVX2": {"root_steps": 100}}).name, "red")
        self.assertEqual(self.held({"root AVX2": self.BASE["root AVX2"] | {"more": 1}}).name, "red")

    def test_a_workload_on_one_side_is_red(self):
        self.assertIn("curve: no baseline", self.held(self.BASE | {"curve AVX2": {}}).red)
        self.assertIn("root: in the baseline, but not measured", self.held({}).red)

    def test_an_instruction_set_on_one_side_is_not(self):
        more = {"root AVX3": {"root_steps": 7}}
        self.assertEqual(self.held(self.BASE | more).name, "passed")
        held = self.held(dict(self.BASE), self.BASE | more)
        self.assertEqual((held.name, held.compared), ("passed", 1))

    def test_a_workload_without_a_common_instruction_set_is_told(self):
        base = self.BASE | {"curve FMA": {"root_steps": 3}}
        _, red, notes = rules.comparable(base, self.BASE | {"curve no FMA": {"root_steps": 3}})
        self.assertEqual(red, [])
        self.assertEqual(notes, ["curve FMA: not measured here", "curve no FMA: no baseline for this instruction set"])

    def test_nothing_in_common_is_red(self):
        self.assertEqual(self.held({"root AVX3": {"root_steps": 100}}).red, ["nothing to compare"])


class Limits(unittest.TestCase):
    """Tests each limit of rules.py with the last number that passes and the first number that does not."""

    def test_what_passes_up_to_a_limit_does_not_beyond_it(self):
        def quiet(control):
            return rules.quiet([Repetition(2.0, 1.0, control)], 1.0) == []

        def is_dearer(workload, other):
            return lambda times: list(rules.dearer({f"{other} AVX2": 1.0, f"{workload} AVX2": times})) != []

        for name, limit, is_red in (
                ("instructions", 101000.0, lambda now: rules.more_instructions(100000, now)),
                ("control before or after", 1.15, quiet),
                ("time", 1.10, lambda median: rules.slower(Interval(0.9, 1.0), Interval(1.05, median))),
                ("interval", 1.0, lambda least: rules.slower(Interval(0.9, 1.0), Interval(least, 1.2))),
                *((workload, limit, is_dearer(workload, other)) for workload, (other, limit) in rules.MOST_TIMES.items())):
            with self.subTest(name=name):
                self.assertFalse(is_red(limit))
                self.assertTrue(is_red(math.nextafter(limit, 2 * limit)))
        # The first one lacks its other workload, and the second one is not in MOST_TIMES.
        for now in ({"points_solved_film AVX2": 9.0}, {"curve no FMA": 9.0}):
            self.assertEqual(list(rules.dearer(now)), [])
        self.assertFalse(rules.fewer_instructions(100000, 99000))
        self.assertTrue(rules.fewer_instructions(100000, math.nextafter(99000, 0)))

    def test_an_interval_is_from_the_least_to_the_median_of_its_ratios(self):
        for count in (9, 10, 11):
            ratios = [((7 * i) % count + 1) / 4 for i in range(count)]
            held = rules.interval([Repetition(3 * ratio, 2.5, 3.5) for ratio in ratios])
            self.assertEqual(held, Interval(0.25, statistics.median(ratios)))


class Times(unittest.TestCase):
    def test_faster_is_not_slower(self):
        self.assertFalse(rules.slower(Interval(1.1, 1.2), Interval(0.5, 0.6)))

    def test_an_interval_needs_nine_repetitions(self):
        nine = [Repetition(2.0, 1.0, 1.0)] * 8 + [Repetition(3.0, 0.5, 1.5)]
        self.assertEqual(rules.interval(nine), Interval(2.0, 2.0))
        with self.assertRaises(ValueError):
            rules.interval(nine[:8])

    def test_only_quiet_repetitions_count(self):
        quiet = Repetition(2.0, 1.0, 1.1)
        disturbed = [Repetition(2.0, 1.0, 1.2), Repetition(2.0, 1.9, 1.0)]
        runs = [{"root AVX2": [quiet, *disturbed]}, {"root AVX2": [Repetition(2.0, 1.0, 1.0)]}]
        self.assertEqual(rules.best_control(runs), 1.0)
        self.assertEqual(rules.quiet([quiet, *disturbed], 1.0), [quiet])

    def held(self, *now):
        """The verdict after runs with these intervals, in this order, and the number of runs that were not made."""
        runs = [({"root AVX2": Interval(1.0, 1.02)}, {"root AVX2": one}) for one in now]
        return gate.hold_times(lambda: runs.pop(0), verdict("time")), len(runs)

    def test_slower_once_passes(self):
        held, left = self.held(Interval(1.2, 1.3), Interval(1.0, 1.03))
        self.assertEqual((held.name, left), ("passed", 0))

    def test_slower_twice_is_red(self):
        held, _ = self.held(Interval(1.2, 1.3), Interval(1.2, 1.3))
        self.assertEqual(held.red, ["root AVX2: slower, twice"])

    def test_no_second_run_where_nothing_was_slower(self):
        held, left = self.held(Interval(1.0, 1.03), Interval(1.2, 1.3))
        self.assertEqual((held.name, left), ("passed", 1))

    def test_another_workload_the_second_time_passes(self):
        self.assertEqual(rules.slower_twice({"a AVX2"}, {"b AVX2"}), set())


class Comparable(unittest.TestCase):
    HERE = {"compiler": "g++ 12.2.0", "libc": "glibc 2.36", "cpu": "one", "valgrind": "valgrind-3.19.0",
            "instruction_sets": ["FMA", "AVX2"]}

    def differences(self, name, **changes):
        return rules.environment_differences(self.HERE, self.HERE | changes, gate.ENVIRONMENT_OF[name])

    def test_another_processor_matters_to_times_alone(self):
        self.assertEqual(self.differences("time", cpu="two"), ["cpu two, the baseline's one"])
        self.assertEqual(self.differences("instructions", cpu="two"), [])

    def test_another_compiler_or_libc_matters_to_both(self):
        for change in ({"compiler": "g++ 13"}, {"libc": "glibc 2.38"}):
            self.assertEqual(len(self.differences("time", **change)), 1)
            self.assertEqual(len(self.differences("instructions", **change)), 1)

    def test_counters_are_compared_everywhere(self):
        self.assertEqual(self.differences("counters", compiler="g++ 13", cpu="two"), [])

    def test_times_that_cannot_be_compared_are_not_red(self):
        held = verdict("time").skip("not comparable: cpu two, the baseline's one")
        self.assertEqual((held.name, held.red), ("not held", []))

    def test_another_speed_of_the_control_kernel_is_not_comparable(self):
        class Found:
            fewest = 9

            def intervals(self):
                return [{}]
        real, gate.measure.times = gate.measure.times, lambda programs: Found()
        try:
            for end, beyond in ((rules.QUIET, 2), (1 / rules.QUIET, 0)):
                Found.control = end
                self.assertEqual(gate.times_of(["p"], 1.0), [{}])
                Found.control = math.nextafter(end, beyond)
                with self.assertRaises(gate.NotComparable):
                    gate.times_of(["p"], 1.0)
            Found.control, Found.fewest = 1.0, 8
            with self.assertRaises(gate.NotComparable):
                gate.times_of(["p"])
        finally:
            gate.measure.times = real


if __name__ == "__main__":
    unittest.main()
