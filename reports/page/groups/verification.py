# SPDX-License-Identifier: Apache-2.0
"""Certified values, random points, planted faults and wrong solvers: each failure breaks a promise. Random changes only have goals."""
from baselines import copied, count, flag, from_baseline, number, number_or_none, part, run_of, text, texts
from group import Group, finding, not_run, promise


def held_quantity(answer):
    """A quantity of the answer of `verify`."""
    return (copied(answer, text, "quantity") | copied(answer, count, "cases") |
            copied(answer, number_or_none, "worst_ulp", "worst_ulp_per_condition", "allowed_ulp", "allowed_ulp_per_condition",
                   "worst_part_of_bound") | copied(answer, text, "worst_row") | {"held": flag(answer["passed"])})


def accuracy_before(baseline):
    """The worst error of each quantity when the baseline was made."""
    return run_of(baseline) | {"worst_ulp_per_condition": {text(row["quantity"]): number(row["worst_ulp_per_condition"])
                                                           for row in baseline["quantities"]}}


def worst_point(at):
    """The point at which an output is worst; None where every case was exact."""
    if at is None:
        return None
    return copied(at, count, "index") | {"inputs": {name: number(value[0]) for name, value in at["inputs"].items()}}


def stressed_output(output):
    return (copied(output, text, "output") | copied(output, count, "cases", "beyond_contract") |
            copied(output, number, "worst_part_of_bound") | copied(output, flag, "held") |
            copied(output, number_or_none, "worst_ulp", "worst_ulp_per_condition") |
            {"worst_ulp_per_condition_in_balls": number_or_none(output["in_balls"]["worst_ulp_per_condition"]),
             "cases_in_balls": count(output["in_balls"]["cases"]),
             "worst_point": worst_point(output["worst_ulp_per_condition_at"])})


def judged(rows):
    """How many of the rows are held, and the worst of them."""
    return {"held": sum(row["held"] for row in rows), "cases": sum(row["cases"] for row in rows),
            "worst_part_of_bound": max((row["worst_part_of_bound"] or 0.0 for row in rows), default=0.0)}


def stressed(baseline):
    outputs = [stressed_output(one) for one in baseline["outputs"]]
    data = run_of(baseline) | copied(baseline, count, "points", "seed") | {"outputs": outputs} | judged(outputs)
    return Group(data, [promise("random_inputs", "worst-inputs", data["held"], len(outputs))])


def planted(baseline):
    faults = [copied(one, text, "id", "fault", "file", "check", "said") | copied(one, flag, "caught") |
              copied(one, number, "seconds") for one in baseline["faults"]]
    caught, catalogue = sum(fault["caught"] for fault in faults), count(baseline["catalogue"])
    left_out = [not_run("planted faults", f"{len(faults)} of the {catalogue} in the catalogue were planted", "`make faults`")]
    return Group(run_of(baseline) | {"catalogue": catalogue, "caught": caught, "faults": faults},
                 [promise("planted_faults", "planted-faults", caught, len(faults))],
                 left_out if catalogue > len(faults) else [])


def room_of_mutants(row):
    return (copied(row, text, "room") | copied(row, count, "drawn", "ran", "caught", "hung", "survived", "not_reached", "equivalent") |
            copied(row, number, "goal", "low", "high") | copied(row, number_or_none, "score", "with_equivalents"))


def noticed(baseline):
    """How many random changes the tests notice, by the last sample of each part of the project."""
    score = baseline["score"]
    data = copied(score, count, "noticed", "of") | copied(score, number, "low", "high") | copied(score, flag, "goals_reached")
    data |= {"rooms": [room_of_mutants(row) for row in score["rooms"]],
             "unnoticed": [copied(row, text, "id", "room", "operator", "place", "original", "replacement", "verdict", "reason", "since")
                           for row in score["unnoticed"]]}
    data["goals_missed"] = sum(row["score"] is None or row["score"] < row["goal"] for row in data["rooms"])
    waiting = sum(row["drawn"] - row["ran"] for row in data["rooms"])
    left_out = [not_run("random changes", f"{waiting} of those that were drawn wait for slow tests", "`make mutants`")]
    found = finding("mutants", "mutants", "software", "holds")
    if not data["goals_reached"]:
        found = finding("mutants", "mutants", "software", "missed", f"{data['goals_missed']} of {len(data['rooms'])} goals are missed" + (f"; {waiting} changes wait for slow tests." if waiting else "."))
    return Group(run_of(baseline) | data, [found], left_out if waiting else [])


def diagnosed(baseline):
    """The answers of `verify --subject` on wrong solvers, and whether it accused right solvers."""
    solvers = [copied(one, text, "function", "said") | copied(one, texts, "fakes") | copied(one, flag, "named")
               for one in baseline["wrong_solvers"]]
    named = sum(solver["named"] for solver in solvers)
    right = copied(baseline["right_solvers"], count, "tries") | copied(baseline["right_solvers"], flag, "accused")
    open_ends = sum("The numbers do not tell these apart." in solver["said"] for solver in solvers)
    return Group(run_of(baseline) | {"right_solvers": right, "named": named, "with_alternatives": open_ends, "wrong_solvers": solvers},
                 [promise("diagnosis", "diagnosis", 0 if right["accused"] else named, len(solvers))])


def certified(asked):
    answers = asked.program.answer("verify", "--reference", asked.places.reference / "exact")
    quantities = [held_quantity(one) for one in answers["quantities"]]
    before, left_out = part(asked.places, "accuracy.json", "accuracy of an earlier version, to compare with", accuracy_before)
    data = {"quantities": quantities} | judged(quantities)
    return Group(data | {"before": before}, [promise("certified_values", "verification", data["held"], len(quantities))], left_out)


def stress(asked):
    return from_baseline(asked.places, "stress.json", stressed)


def planted_faults(asked):
    return from_baseline(asked.places, "planted_faults.json", planted)


def diagnosis(asked):
    return from_baseline(asked.places, "diagnosis.json", diagnosed)


def mutants(asked):
    return from_baseline(asked.places, "mutants.json", noticed)
