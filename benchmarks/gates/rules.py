# SPDX-License-Identifier: Apache-2.0
"""Decides when a gate is red. All functions here are pure: measure.py measures, and gate.py prints.

Measurements are a dict. Its keys are strings: the workload, a blank, and the instruction set ("FMA" and "no FMA" for scalar workloads).
"""
import statistics
import typing

INSTRUCTION_TOLERANCE = 0.01  # relative change of callgrind's counts, which repeat to 0.004 %
TIME_RATIO = 1.10             # a time is red only if its median is more than this many times the base's
REPETITIONS = 9               # the least number of quiet repetitions for a time
QUIET = 1.15                  # a repetition is quiet if the control kernel takes at most this many times its best time
# Workload → (other workload, limit). Both solve the same points with different film laws, and the first may take at most `limit` times
# the instructions of the other.
MOST_TIMES = {"points_solved_film": ("points_hamrock_dowson", 1.5),
              "points_nijenbanning_venner_moes": ("points_hamrock_dowson", 3)}


def workload_of(key):
    return key.split(" ", 1)[0]


def comparable(base, now):
    """Returns the keys in both measurements, red findings on other keys, and remarks on other keys.

    A workload has to be in both. Instruction sets depend on the machine, and may differ."""
    base_workloads, workloads = set(map(workload_of, base)), set(map(workload_of, now))
    red = [f"{name}: no baseline" for name in sorted(workloads - base_workloads)]
    red += [f"{name}: in the baseline, but not measured" for name in sorted(base_workloads - workloads)]
    both = base_workloads & workloads
    notes = [f"{key}: not measured here" for key in base if key not in now and workload_of(key) in both]
    notes += [f"{key}: no baseline for this instruction set" for key in now
              if key not in base and workload_of(key) in both]
    return [key for key in now if key in base], red, notes


def counter_differences(base, now):
    """A line for each count that differs: any difference is red, in either direction."""
    for name in sorted(base.keys() | now.keys()):
        if base.get(name) != now.get(name):
            yield f"{name} {now.get(name, 'not counted')}, not {base.get(name, 'counted')}"


def more_instructions(base, now):
    return now > base * (1 + INSTRUCTION_TOLERANCE)


def fewer_instructions(base, now):
    """Fewer instructions are not red, but the baseline should be renewed: with the old one the gain may be lost unnoticed."""
    return now < base * (1 - INSTRUCTION_TOLERANCE)


def dearer(now):
    """A line for each workload of MOST_TIMES that takes more instructions than its limit allows. Where the other workload was not
    measured, comparable() says so."""
    for key, count in now.items():
        workload, _, instruction_set = key.partition(" ")
        other, limit = MOST_TIMES.get(workload, (None, 0))
        of_other = now.get(f"{other} {instruction_set}")
        if of_other is not None and count > limit * of_other:
            yield f"{key}: {count / of_other:.2f} times the instructions of {other}, more than {limit}"


class Repetition(typing.NamedTuple):
    """CPU seconds of one pass of the workload, and of one pass of the control kernel before it and one after it."""
    seconds: float
    before: float
    after: float


class Interval(typing.NamedTuple):
    """The least and the median ratio of a workload's time to the control kernel's time in the same repetition."""
    minimum: float
    median: float


def best_control(runs):
    """The control kernel's best time in all runs. `runs` has for each program a dict from key to repetitions."""
    return min(min(one.before, one.after) for run in runs for repetitions in run.values() for one in repetitions)


def quiet(repetitions, best):
    """The repetitions that no other process disturbed. Others are left out, because a process on the same core slows some kernels more
    than the control kernel, so that the ratio of their times changes, too."""
    return [one for one in repetitions if max(one.before, one.after) <= QUIET * best]


def interval(repetitions):
    if len(repetitions) < REPETITIONS:
        raise ValueError(f"{len(repetitions)} repetitions, {REPETITIONS} are the least")
    ratios = [2 * one.seconds / (one.before + one.after) for one in repetitions]
    return Interval(min(ratios), statistics.median(ratios))


def slower(base, now):
    """Whether the interval of `now` lies wholly above that of `base`, and the ratio of the medians is above TIME_RATIO."""
    return now.minimum > base.median and now.median > TIME_RATIO * base.median


def slower_twice(first, second):
    """The red keys after two runs: those that were slower in both."""
    return first & second


def environment_differences(base, now, fields):
    return [f"{field} {now.get(field)}, the baseline's {base.get(field)}"
            for field in fields if base.get(field) != now.get(field)]
