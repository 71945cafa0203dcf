# SPDX-License-Identifier: Apache-2.0
"""Computes a second time the groups of report.json that come from reference/baselines."""
RUN = ("commit", "date", "seconds")


def of(row, *names):
    return {name: row[name] for name in names}


def run_of(row):
    return of(row, *(name for name in RUN if name in row)) | {"environment": of(row["environment"], "cpu", "compiler")}


def judged(rows):
    return {"held": sum(one["held"] for one in rows), "cases": sum(one["cases"] for one in rows),
            "worst_part_of_bound": max(one["worst_part_of_bound"] for one in rows)}


def stress(base):
    names = ("output", "cases", "beyond_contract", "worst_part_of_bound", "held", "worst_ulp", "worst_ulp_per_condition")
    rows = []
    for one in base["outputs"]:
        at = one["worst_ulp_per_condition_at"]
        rows.append(of(one, *names) | {
            "worst_ulp_per_condition_in_balls": one["in_balls"]["worst_ulp_per_condition"], "cases_in_balls": one["in_balls"]["cases"],
            "worst_point": at and {"index": at["index"], "inputs": {name: value for name, (value, _) in at["inputs"].items()}}})
    return run_of(base) | of(base, "points", "seed") | {"outputs": rows} | judged(rows)


def planted_faults(base):
    faults = [of(one, "id", "fault", "file", "check", "said", "caught", "seconds") for one in base["faults"]]
    return run_of(base) | {"catalogue": base["catalogue"], "caught": sum(one["caught"] for one in faults), "faults": faults}


def mutants(base):
    score = base["score"]
    rooms = [of(one, "room", "drawn", "ran", "caught", "hung", "survived", "not_reached", "equivalent", "goal", "low", "high", "score",
                "with_equivalents") for one in score["rooms"]]
    return run_of(base) | of(score, "noticed", "of", "low", "high", "goals_reached", "unnoticed") | {
        "rooms": rooms, "goals_missed": sum((one["score"] or 0) < one["goal"] or one["score"] is None for one in rooms)}


def diagnosis(base):
    solvers = [of(one, "function", "said", "fakes", "named") for one in base["wrong_solvers"]]
    return run_of(base) | {"right_solvers": of(base["right_solvers"], "tries", "accused"), "wrong_solvers": solvers,
                           "with_alternatives": sum("do not tell these apart" in one["said"] for one in solvers),
                           "named": sum(one["named"] for one in solvers)}


def gates(base, performance):
    proofs = []
    for planted, row in [(None, row) for row in base["same_program"]] + [(one, row) for one in base["planted"] for row in one["gates"]]:
        proofs.append(of(row, "gate", "expected", "verdict", "workloads", "proved", "greatest_ratio", *(["why"] if "why" in row else [])) |
                      {"red": len(row["red"])} | ({"planted": of(planted, "id", "work")} if planted else {}))
    time = performance["time"]
    workloads = [{"workload": name, "instructions": performance["instructions"].get(name), "least_time": time.get(name, [None])[0],
                  "median_time": time.get(name, [None])[-1], "band": time[name][1] / time[name][0] - 1 if name in time else None}
                 for name in [*time, *(name for name in performance["instructions"] if name not in time)]]
    return run_of(base) | {
        "proofs": proofs, "proved": sum(one["proved"] for one in proofs),
        "greatest_time_of_the_same_program": [one["greatest_ratio"] for one in base["same_program"] if one["gate"] == "time"][-1],
        "baseline": run_of(performance) | {"workloads": workloads, "widest_band": max(one["band"] or 0 for one in workloads)}}


def sweep_speed(base):
    ratios = [{"sweep": name, "alone_ns": one["alone"], "summaries_ns": one["summaries"], "summaries_times_alone": one["summaries"] / one["alone"],
               "points_ns": one["points"], "points_times_alone": one["points"] / one["alone"], "drawing_ns": one["stage: draw"]}
              for name, one in base["ratios"].items()]
    slowest = max(one["summaries_times_alone"] for one in ratios)
    speedup = base["threads"]["speedup"]["summaries"]
    memory = max(mb for one in base["memory"].values() for mb in one["mb_of_rank"].values())
    targets = {"times_alone": {"is": slowest, "at_most": 1.5, "reached": slowest <= 1.5},
               "two_threads": {"is": speedup, "at_least": 1.8, "reached": speedup >= 1.8},
               "mb_of_rank": {"is": memory, "below": 300, "reached": memory < 300}}
    ranks = base["ranks"]
    return run_of(base) | of(base, "processors", "others") | {
        "ratios": ratios, "targets": targets, "targets_missed": sum(not one["reached"] for one in targets.values()),
        "two_ranks": {"speedup": ranks["speedup"]["2"], "cpu_speedup": ranks["cpu_speedup"]["2"]} | of(ranks, "weak_efficiency", "weak_cpu_efficiency")}


def groups(rows, key):
    found = {}
    for row in rows:
        found.setdefault(row[key], []).append(row)
    return found


def work_precision(base):
    jobs = []
    for job, rows in groups(base["error_against_work"], "job").items():
        ways = {family: min(good, key=lambda row: row["ns"]) for family, all_rows in groups(
            [row for row in rows if row["failures"] == 0 and row["max_ulp"] is not None], "family").items() for good in [all_rows]}
        told = {family: of(row, "family", "name", "ns", "max_ulp", "evaluations") for family, row in ways.items()}
        ours = told.get("tribocheck")
        timed = {family: one | {"times_ours": ours and one["ns"] / ours["ns"]} for family, one in told.items()}
        others = [one for family, one in timed.items() if family != "tribocheck"]
        good = sorted((row for row in rows if ours and row["failures"] == 0 and row["family"] != "tribocheck" and row["max_ulp"] is not None and
                       row["max_ulp"] <= ours["max_ulp"]), key=lambda row: row["ns"])
        jobs.append({"job": job, "ours": ours, "fastest_alternative": min(others, key=lambda one: one["ns"], default=None),
                     "as_exact": of(good[0], "family", "name", "ns", "max_ulp", "evaluations") | {"times_ours": good[0]["ns"] / ours["ns"]} if good else None,
                     "is_counted": any(row["evaluations"] is not None and row["family"] != "tribocheck" for row in rows),
                     "ways": list(timed.values())})
    both = [(job["ours"], job["fastest_alternative"]) for job in jobs if job["ours"] and job["fastest_alternative"]]
    times = [other["times_ours"] for _, other in both]
    same = [job["as_exact"]["times_ours"] for job in jobs if job["as_exact"]]
    return run_of(base) | {
        "environment": of(base["environment"], "cpu", "compiler", "instruction_set"), "jobs": jobs,
        "alternatives": {"jobs": len(both), "less_exact": sum(other["max_ulp"] > ours["max_ulp"] for ours, other in both),
                         "least_times_ours": min(times, default=None), "greatest_times_ours": max(times, default=None),
                         "as_exact": {"jobs": len(same), "least_times_ours": min(same, default=None), "greatest_times_ours": max(same, default=None)}},
        **{films: run_of(base[f"{films}_run"]) | {
            "ways": [of(row, "family", "name", "ns", "steps", "max_relative", "mean_relative", "no_numbers", "judged") for row in base[films]],
            "exponents": [of(row, "solver", "quantity", "exponent", "uncertainty", "from_cells", "to_cells") for row in base[f"{films}_exponents"]],
            "largest": [of(rows[-1], "solver", "cells", "kernel_ns", "step_ns", "bytes")
                        for rows in groups(base[f"{films}_growth"], "solver").values()],
            "threads": [of(row, "threads", "ns") for row in base.get(f"{films}_threads", [])]} for films in ("line_film", "point_film")}}


def promised(bases):
    """Returns each group under its name in report.json. The function `bases` reads reference/baselines/NAME.json."""
    made = {name: globals()[name](bases(name)) for name in ("stress", "mutants", "planted_faults", "diagnosis", "work_precision")}
    return made | {"gates": gates(bases("gates"), bases("performance")), "sweep_speed": sweep_speed(bases("sweep"))}


def before(base):
    return run_of(base) | {"worst_ulp_per_condition": {one["quantity"]: one["worst_ulp_per_condition"] for one in base["quantities"]}}
