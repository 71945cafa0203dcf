# SPDX-License-Identifier: Apache-2.0
"""The gates of speed and the speed of sweeps."""
from baselines import copied, count, flag, from_baseline, number, number_or_none, part, run_of, text
from group import Group, finding, not_run


def proof(row, program):
    """The verdict of a gate on one program."""
    return (program | copied(row, text, "gate", "expected", "verdict") | copied(row, count, "workloads") |
            copied(row, flag, "proved") | {"greatest_ratio": number_or_none(row["greatest_ratio"]), "red": len(row["red"])} |
            (copied(row, text, "why") if "why" in row else {}))


def proved_gates(baseline):
    same = [proof(row, {}) for row in baseline["same_program"]]
    proofs = same + [proof(row, {"planted": copied(plant, text, "id", "work")})
                     for plant in baseline["planted"] for row in plant["gates"]]
    proved = sum(one["proved"] for one in proofs)
    left_out = [not_run(f"gate `{one['gate']}`", one["why"], "`make gate-proof`") for one in proofs if "why" in one]
    found = finding("gates", "gates", "software", "holds")
    if not proofs or proved < len(proofs):
        found = finding("gates", "gates", "software", "fails",
                        f"{len(proofs) - proved} of {len(proofs)} gates did not say what they had to.")
    times = [one["greatest_ratio"] for one in same if one["gate"] == "time"]
    return Group(run_of(baseline) | {"proved": proved, "greatest_time_of_the_same_program": times[-1] if times else None,
                                     "proofs": proofs}, [found], left_out)


def workload(name, instructions, interval):
    """The row of a workload; None stands for counts and times that were not measured."""
    least, median = (None, None) if interval is None else map(number, interval[:2])
    return {"workload": name, "instructions": None if instructions is None else count(instructions),
            "least_time": least, "median_time": median, "band": None if interval is None else median / least - 1}


def gate_baseline(baseline):
    """Instructions and times of each workload."""
    instructions, times = baseline["instructions"], baseline["time"]
    workloads = [workload(name, instructions.get(name), interval) for name, interval in times.items()]
    workloads += [workload(name, counted, None) for name, counted in instructions.items() if name not in times]
    return run_of(baseline) | {"widest_band": max((0.0, *(one["band"] for one in workloads if one["band"] is not None))),
                               "workloads": workloads}


def gates(asked):
    group = from_baseline(asked.places, "gates.json", proved_gates)
    baseline, left_out = part(asked.places, "performance.json", "the work and time that the gates compare with", gate_baseline)
    return group._replace(data=group.data | {"baseline": baseline}, not_run=group.not_run + left_out)


def sweep_ratios(name, times):
    """The times of a point of a sweep, and their ratios to the time of its scenes and roots alone."""
    alone, summaries, points = (number(times[key]) for key in ("alone", "summaries", "points"))
    return {"sweep": name, "alone_ns": alone, "summaries_ns": summaries, "summaries_times_alone": summaries / alone,
            "points_ns": points, "points_times_alone": points / alone, "drawing_ns": number(times["stage: draw"])}


def targets(ratios, baseline):
    """The targets, the values reached, and whether each target is met."""
    greatest = max((0.0, *(row["summaries_times_alone"] for row in ratios)))
    speedup = number(baseline["threads"]["speedup"]["summaries"])
    memory = max((0.0, *(number(rank) for run in baseline["memory"].values() for rank in run["mb_of_rank"].values())))
    return {"times_alone": {"is": greatest, "at_most": 1.5, "reached": greatest <= 1.5},
            "two_threads": {"is": speedup, "at_least": 1.8, "reached": speedup >= 1.8},
            "mb_of_rank": {"is": memory, "below": 300.0, "reached": memory < 300}}


def sweeps(baseline):
    ratios = [sweep_ratios(name, times) for name, times in baseline["ratios"].items()]
    reached = targets(ratios, baseline)
    missed = sum(not target["reached"] for target in reached.values())
    ranks = baseline["ranks"]
    found = finding("sweep_speed", "sweep-speed", "software", "holds")
    if missed:
        found = finding("sweep_speed", "sweep-speed", "software", "missed", f"{missed} of {len(reached)} speed targets are missed.")
    return Group(run_of(baseline) | copied(baseline, count, "processors") | copied(baseline, number, "others") | {
        "ratios": ratios, "targets": reached,
        "two_ranks": {key: number(ranks[key]["2"]) for key in ("speedup", "cpu_speedup")} |
        copied(ranks, number, "weak_efficiency", "weak_cpu_efficiency"),
        "targets_missed": missed}, [found])


def sweep_speed(asked):
    return from_baseline(asked.places, "sweep.json", sweeps)
