#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The gates of speed: does a kernel do more work, or take longer, than it did?

  counters      steps of roots, evaluations and skipped work, on each instruction set: no difference allowed
  instructions  callgrind's count of a pass, scalar and AVX2: at most 1 % more. A film law may take at most a fixed
                multiple of the count of Hamrock and Dowson's law. Needs valgrind
  time          the ratio of CPU time to that of a control kernel (std::exp) in the same repetition: red if the
                interval from minimum to median lies above the base's and the median is 10 % up, twice in a row

The base is reference/baselines/performance.json, or with --base another build of the program. The times of the
two builds are then measured in turn. Instructions of another compiler, C library or valgrind, and times of
another compiler, C library or processor, cannot be compared with the baseline. In that case a line says so, and
the gate is not red.

  benchmarks/gates/gate.py build/release/tribocheck_gate_kernels
  benchmarks/gates/gate.py build/release/tribocheck_gate_kernels --base ../before/build/release/tribocheck_gate_kernels
  benchmarks/gates/gate.py build/release/tribocheck_gate_kernels --gates counters

Exit code 0: held; 1: a gate is red; 2: not measured.
"""
import argparse
import json
import pathlib
import sys
import time

import measure
import rules

BASELINE = measure.ROOT / "reference/baselines/performance.json"
GATES = ("counters", "instructions", "time")
ENVIRONMENT_OF = {"counters": (), "instructions": ("compiler", "libc", "valgrind"),
                  "time": ("compiler", "libc", "cpu")}


class Verdict:
    """The findings of a gate, each printed at once."""

    def __init__(self, gate, say=print):
        self.gate = gate
        self.say = say
        self.red = []
        self.compared = 0
        self.why_not = None  # why the gate could not be measured
        self.worst = None    # the greatest ratio to the base

    def see(self, ratio):
        self.worst = ratio if self.worst is None else max(self.worst, ratio)

    def skip(self, why):
        self.why_not = why
        return self

    @property
    def name(self):
        return "not held" if self.why_not else "red" if self.red else "passed"

    def keys(self, base, now):
        """Returns the keys that both sides have, and reports the others."""
        keys, red, notes = rules.comparable(base, now)
        self.red += red
        for line in notes:
            self.say(f"  {line}")
        self.compared = len({rules.workload_of(key) for key in keys})
        if not keys:
            self.red.append("nothing to compare")
        return keys


def hold_counters(base, now, verdict):
    for key in verdict.keys(base, now):
        verdict.red += [f"{key}: {line}" for line in rules.counter_differences(base[key], now[key])]
        for name, count in base[key].items():
            if count:
                verdict.see(now[key].get(name, 0) / count)
    return verdict


def hold_instructions(base, now, verdict):
    verdict.say(f"  {'':28}{'base':>12}{'now':>12}{'change':>10}")
    for key in verdict.keys(base, now):
        ratio = now[key] / base[key]
        verdict.see(ratio)
        note = ""
        if rules.more_instructions(base[key], now[key]):
            note = "  RED"
            verdict.red.append(f"{key}: {100 * (ratio - 1):+.2f} % instructions")
        elif rules.fewer_instructions(base[key], now[key]):
            note = "  fewer: make gate-baseline keeps that"
        verdict.say(f"  {key:28}{base[key]:12}{now[key]:12}{100 * (ratio - 1):+9.2f} %{note}")
    verdict.red += rules.dearer(now)
    return verdict


class NotComparable(Exception):
    """Raised if times cannot be compared. Its text says why."""


def times_of(programs, control=None):
    """The intervals of each program. `control` is the control kernel's time when the baseline was made."""
    found = measure.times(programs)
    if control and not 1 / rules.QUIET <= found.control / control <= rules.QUIET:
        raise NotComparable(f"the control kernel takes {1e6 * found.control:.1f} µs, {1e6 * control:.1f} when the "
                            "baseline was made: the processor is another one of the same name, or other programs "
                            "share it")
    if found.fewest < rules.REPETITIONS:
        raise NotComparable(f"the machine is busy: {found.fewest} quiet repetitions, {rules.REPETITIONS} are needed")
    return found.intervals()


def hold_times(measure_both, verdict):
    """measure_both() returns (base, now), two dicts from key to Interval. It is called again if a workload was slower."""
    slow = []
    for run in ("first run", "second run"):
        base, now = measure_both()
        keys = verdict.keys(base, now)
        verdict.say(f"  {run:28}{'base':>18}{'now':>18}{'change':>10}")
        for key in keys:
            ratio = now[key].median / base[key].median
            if run == "first run":
                verdict.see(ratio)
            note = "  slower" if rules.slower(base[key], now[key]) else ""
            verdict.say(f"  {key:28}{base[key].minimum:9.3f}{base[key].median:9.3f}"
                        f"{now[key].minimum:9.3f}{now[key].median:9.3f}{100 * (ratio - 1):+9.1f} %{note}")
        slow.append({key for key in keys if rules.slower(base[key], now[key])})
        if verdict.red or not slow[0]:
            return verdict
    verdict.red += [f"{key}: slower, twice" for key in sorted(rules.slower_twice(*slow))]
    return verdict


def hold_gate(gate, program, base_program, baseline, say=print):
    """The verdict of one gate. The base is base_program, or the baseline if base_program is None."""
    verdict = Verdict(gate, say)
    if gate == "instructions" and measure.valgrind_version() is None:
        return verdict.skip("valgrind is not installed")
    if gate == "instructions" and not measure.has_instruction_set(program, measure.VALGRIND_SET):
        return verdict.skip(f"this machine has no {measure.VALGRIND_SET}")
    if base_program is None:
        if not baseline.get(gate):
            return verdict.skip("the baseline has no such rows: make gate-baseline")
        different = rules.environment_differences(
            baseline["environment"], measure.environment(program), ENVIRONMENT_OF[gate])
        if different:
            return verdict.skip("not comparable: " + "; ".join(different))
    if gate == "counters":
        base = measure.counters(base_program) if base_program else baseline[gate]
        return hold_counters(base, measure.counters(program), verdict)
    if gate == "instructions":
        base = measure.instructions(base_program) if base_program else baseline[gate]
        return hold_instructions(base, measure.instructions(program), verdict)

    def measure_both():
        if base_program:
            return times_of([base_program, program])
        base = {key: rules.Interval(*value) for key, value in baseline[gate].items()}
        return base, times_of([program], baseline["control_seconds"])[0]
    try:
        return hold_times(measure_both, verdict)
    except NotComparable as why:
        return verdict.skip(f"not comparable: {why}")


def hold(gates, program, base_program, baseline, say=print):
    """A dict from each of these gates to its verdict."""
    verdicts = {}
    for gate in gates:
        started = time.monotonic()
        say(f"{gate}")
        verdict = verdicts[gate] = hold_gate(gate, program, base_program, baseline, say)
        for line in verdict.red:
            say(f"  RED {line}")
        seconds = time.monotonic() - started
        say(f"  {verdict.name}: {verdict.why_not or f'{verdict.compared} workloads'}; {seconds:.1f} s")
    return verdicts


def update(program, path):
    """Writes the baseline, with one line for each row, so that a diff can be read."""
    instructions = {}
    if measure.valgrind_version() is not None and measure.has_instruction_set(program, measure.VALGRIND_SET):
        instructions = measure.instructions(program)
    found = measure.times([program])
    rounded = {key: [float(f"{part:.4g}") for part in value] for key, value in found.intervals()[0].items()}
    sections = {"counters": measure.counters(program), "instructions": instructions, "time": rounded}
    head = {"commit": measure.commit(), "date": measure.today(), "environment": measure.environment(program),
            "control_seconds": found.control}
    parts = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in head.items()]
    for name, section in sections.items():
        lines = ",\n".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in section.items())
        parts.append(f'"{name}": {{\n{lines}\n}}')
    path.write_text("{\n" + ",\n".join(parts) + "\n}\n")
    print(f"{path}: {', '.join(f'{len(section)} rows of {name}' for name, section in sections.items())}")


def check_base(program):
    """Raises Unmeasured if this file is no tribocheck_gate_kernels. A library, such as a user's solver, crashes when it is started."""
    try:
        why = None if "compiler" in measure.environment(program) else "it does not tell its compiler"
    except (measure.Unmeasured, ValueError) as error:
        why = str(error).strip()
    if why is not None:
        raise measure.Unmeasured(f"--base: {program} is no tribocheck_gate_kernels, which holds this project's own kernels ({why}); "
                                 "for a library of yours: tribocheck bench --plugin YOURS --plugin BEFORE")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="a built tribocheck_gate_kernels")
    parser.add_argument("--base", type=pathlib.Path, metavar="PROGRAM", help="hold it against this build")
    parser.add_argument("--baseline", type=pathlib.Path, default=BASELINE, metavar="FILE")
    parser.add_argument("--gates", nargs="+", choices=GATES, default=GATES, metavar="GATE",
                        help="these alone: " + ", ".join(GATES))
    parser.add_argument("--update", action="store_true", help="write the baseline instead")
    arguments = parser.parse_args()
    try:
        if arguments.base:
            check_base(arguments.base)
        if arguments.update:
            update(arguments.program, arguments.baseline)
            return 0
        baseline = {} if arguments.base else json.loads(arguments.baseline.read_text())
        verdicts = hold(arguments.gates, arguments.program, arguments.base, baseline)
    except (OSError, ValueError, measure.Unmeasured) as error:
        print(f"gate.py: {error}", file=sys.stderr)
        return 2
    # The inventory reads this count, which must not depend on the machine's instruction sets.
    print(f"Ran {sum(verdict.compared for verdict in verdicts.values())} cases")
    return 1 if any(verdict.red for verdict in verdicts.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
