#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes mutants by machine, runs the tests that can notice them, and keeps the ledger of how many did.

A sample is drawn by its seed from all places that the tree's texts have. Mutants of C++ stand behind switches in a
generated copy, which is built once; others are written into a copy of the tree one at a time. One run of all tests without a mutant
says which tests reach which mutants, and where a value would change. The ledger is written after each mutant: a run that is
stopped, or ends with its --minutes, goes on with the same command.

  verification/gates/mutants/run.py sample --seed 20261123 --minutes 60
  verification/gates/mutants/run.py score
  verification/gates/mutants/run.py equivalent ID "the reason, in a sentence"
"""
import argparse
import concurrent.futures
import datetime
import json
import math
import pathlib
import queue
import random
import re
import signal
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "verification/gates"), str(ROOT / "verification/gates/faults")]
import places  # noqa: E402
import plant  # noqa: E402
import sample  # noqa: E402
import schemata  # noqa: E402
import tests  # noqa: E402
from plant import scratch  # noqa: E402

LEDGER = ROOT / "reference/baselines/mutants.json"
STRICT = ("formulas", "engine", "judging")  # whose goal is 95 %; of the others it is 90 %
KEPT = ("id", "room", "operator", "file", "line", "original", "replacement", "find", "replace")


def wilson(part, of, z=1.959964):
    """The 95 % interval of a share, by Wilson."""
    if of == 0:
        return 0.0, 1.0
    middle, share = 1 + z * z / of, part / of
    half = z * math.sqrt(share * (1 - share) / of + z * z / (4 * of * of))
    low, high = (share + z * z / (2 * of) - half) / middle, (share + z * z / (2 * of) + half) / middle
    return max(0.0, low), min(1.0, high)


def read_ledger(path):
    return json.loads(path.read_text()) if path.is_file() else {"samples": []}


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_suffix(".new")
    new.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    new.replace(path)


def scores(ledger):
    """Of each room's last sample: what was caught of it. Mutants that were not run yet are left out."""
    last = {}
    for one in ledger["samples"]:
        for room in one["rooms"]:
            last[room] = [row for row in one["mutants"] if row["room"] == room]
    table = []
    for room, rows in last.items():
        count = {verdict: sum(row.get("verdict") == verdict for row in rows)
                 for verdict in ("caught", "hung", "survived", "not reached", "equivalent")}
        ran, caught = sum(count.values()), count["caught"] + count["hung"]
        of = ran - count["equivalent"]
        table.append({"room": room, "drawn": len(rows), "ran": ran, **count, "score": caught / of if of else None,
                      "interval": wilson(caught, of), "with_equivalents": caught / ran if ran else None})
    return table


def noticed(table):
    """Of all rooms of the table together: how many, of how many, and the interval."""
    part, of = sum(row["caught"] + row["hung"] for row in table), sum(row["ran"] - row["equivalent"] for row in table)
    return part, of, *wilson(part, of)


def summary(ledger):
    """What the report shows."""
    table = scores(ledger)
    part, of, low, high = noticed(table)
    strict = [row for row in table if row["room"] in STRICT]
    rooms = [{**{key.replace(" ", "_"): value for key, value in row.items() if key != "interval"}, "low": row["interval"][0],
              "high": row["interval"][1], "goal": 0.95 if row in strict else 0.9} for row in table]
    reached = len(table) == len(sample.ROOMS) and all(row["ran"] == row["drawn"] and (row["score"] or 0) >= row["goal"] for row in rooms) \
        and low >= 0.87 and noticed(strict)[2] >= 0.9
    last = {room: one["seed"] for one in ledger["samples"] for room in one["rooms"]}
    unnoticed = [{**{key: row[key] for key in ("id", "room", "operator", "verdict")}, "place": f"{row['file']}:{row['line']}",
                  "original": shortened(row["original"]), "replacement": shortened(row["replacement"]), "reason": row.get("reason", "")}
                 for one in ledger["samples"] for row in one["mutants"]
                 if last[row["room"]] == one["seed"] and row.get("verdict") in ("survived", "not reached", "equivalent")]
    return {"noticed": part, "of": of, "low": low, "high": high, "goals_reached": reached, "rooms": rooms, "unnoticed": unnoticed}


def shortened(text):
    text = " ".join(text.split())
    return text if len(text) <= 80 else text[:77] + "…"


def write_ledger(path, ledger):
    last = ledger["samples"][-1]
    write(path, {**{key: last[key] for key in ("commit", "date", "environment")}, "score": summary(ledger), "samples": ledger["samples"]})


def print_scores(ledger):
    print(f"{'room':31}{'drawn':>6}{'ran':>5}{'caught':>7}{'hung':>5}{'survived':>9}{'not reached':>12}{'equivalent':>11}"
          f"{'score':>7}  95 % interval   with equivalents as survivors")
    table = [row for row in scores(ledger) if row["ran"]]
    for row in table:
        low, high = row["interval"]
        score = "–" if row["score"] is None else f"{100 * row['score']:.0f} %"
        print(f"{row['room']:31}{row['drawn']:6}{row['ran']:5}{row['caught']:7}{row['hung']:5}{row['survived']:9}{row['not reached']:12}"
              f"{row['equivalent']:11}{score:>7}  {100 * low:.0f} to {100 * high:.0f} %      {100 * row['with_equivalents']:.0f} %")
    for name, rows in (("all rooms", table), (" and ".join(STRICT), [row for row in table if row["room"] in STRICT])):
        part, of, low, high = noticed(rows)
        if of:
            print(f"{name}: {part} of {of} noticed, {100 * part / of:.1f} %, {100 * low:.1f} to {100 * high:.1f} %")


class Prepared:
    """The drawn mutants, the built copy, and which test reaches which mutant, in a folder."""

    def __init__(self, folder, seed, sizes, workers, left_out):
        self.folder, self.workers = folder, workers
        self.file = folder / "prepared.json"
        kept = json.loads(self.file.read_text()) if self.file.is_file() else {}
        if kept.get("seed") not in (None, seed):
            sys.exit(f"{folder} holds the copy of seed {kept['seed']}; remove it, or name another folder with --work")
        # The text that the sample is of: the tree may change while it runs.
        self.base = folder / "base"
        self.copy = schemata.Copy(self.base, folder / "tree", folder / "tree/build/release")
        if not kept:
            found = places.all_places(ROOT, ROOT / "build/release")
            for tree in (self.base, self.copy.tree):
                scratch.copy_tree(ROOT, tree)
                schemata.with_history(ROOT, tree)
            self.copy.configure()
            write(folder / "places.json", found)
            kept = {"seed": seed, "commit": plant.commit(), "numbers": {}, "dropped": [], "built": False, "coverage": {}}
        self.kept = kept
        if not kept["built"]:
            found = json.loads((folder / "places.json").read_text())
            kept["population"] = {room: sum(one["room"] == room for one in found) for room in sizes}
            self.build(found, seed, sizes)
        self.mutants = kept["mutants"]
        self.numbers = kept["numbers"]
        self.trees = [tests.Tree(self.base, self.copy, folder / f"tree-{k}") for k in range(workers)]
        if not kept.get("covered"):
            self.cover(left_out)

    def save(self):
        write(self.file, self.kept)

    def build(self, found, seed, sizes):
        """Builds the copy; a mutant whose switch does not compile is dropped, and another one drawn."""
        kept = self.kept
        while True:
            drawn = sample.draw(found, sizes, seed, set(kept["dropped"]))
            for one in drawn:
                kept["numbers"].setdefault(one["id"], len(kept["numbers"]))
            self.copy.write(drawn, kept["numbers"])
            ids = {number: name for name, number in kept["numbers"].items()}
            failing = self.copy.failing()
            now = [ids[number] for number in failing]
            if not failing:
                break
            kept["dropped"] += now
            self.save()
            print(f"{len(now)} mutants do not compile and are drawn anew; {len(kept['dropped'])} so far", flush=True)
        kept["mutants"] = [{**one, **sample.patch(one, (self.base / one["file"]).read_text()), "switched": bool(one.get("edits"))}
                           for one in drawn]
        kept["built"] = True
        self.save()

    def cover(self, left_out):
        """Runs all tests without a mutant; one that is red then ends the run."""
        units = [one for one in tests.all_units(self.copy, self.trees[0]) if not (left_out and re.search(left_out, one["name"]))]
        print(f"{len(units)} parts of tests run without a mutant", flush=True)
        free = queue.SimpleQueue()
        for tree in self.trees:
            free.put(tree)
        files = sorted({one["file"] for one in self.mutants if not one["switched"]})
        size = len(self.numbers) + 1
        red, lock = [], threading.Lock()

        def one(unit):
            if unit["name"] in self.kept["coverage"]:
                return
            tree = free.get()
            try:
                row = tree.cover(unit, size, files)
            finally:
                free.put(tree)
            if row.pop("red"):
                red.append(unit["name"])
                print(f"RED without a mutant: {unit['name']}\n{row['output'][-3000:]}", flush=True)
                return
            row.pop("output")
            with lock:
                self.kept["coverage"][unit["name"]] = {**unit, **row}
                if row["seconds"] > 3:
                    self.save()  # what took long is not run again

        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            list(pool.map(one, units))
        self.save()
        if red:
            sys.exit(f"{len(red)} tests are red without a mutant: {', '.join(red[:5])}. Mend them, or leave them out with --without REGEX, "
                     "and run the same command again.")
        self.kept["covered"] = True
        self.kept["left_out"] = left_out or ""
        self.save()

    def who_can_notice(self, mutant):
        """Tests of a mutant, quick ones first, and how many tests reach it without a changed value."""
        can, reach = [], 0
        for unit in self.kept["coverage"].values():
            if not mutant["switched"]:
                if mutant["file"] in unit["read"]:
                    can.append(unit)
            elif self.numbers[mutant["id"]] in unit["differs"]:
                can.append(unit)
            elif self.numbers[mutant["id"]] in unit["reached"]:
                reach += 1
        return tests.together(sorted(can, key=lambda unit: unit["seconds"])), reach


def verdict_on(prepared, mutant, tree):
    able, reach = prepared.who_can_notice(mutant)
    start = time.monotonic()
    row = {"tests": len(able), "reach_without_change": reach}
    with tree.planted(mutant):
        for unit in able:
            end, check = tree.run(unit, prepared.numbers[mutant["id"]] if mutant["switched"] else None)
            if end != "green":
                return {**row, "verdict": "hung" if end == "hung" else "caught", "by": check, "seconds": round(time.monotonic() - start, 1)}
    return {**row, "verdict": "survived" if able or reach else "not reached", "seconds": round(time.monotonic() - start, 1)}


def take_sample(arguments):
    started = time.monotonic()
    sizes = {room: arguments.twice.count(room) * size + size for room, size in sample.ROOMS.items() if not arguments.rooms or room in arguments.rooms}
    prepared = Prepared(arguments.work.resolve(), arguments.seed, sizes, arguments.workers, arguments.without)
    ledger = read_ledger(arguments.out)
    mine = next((one for one in ledger["samples"] if one["seed"] == arguments.seed), None)
    if mine is None:
        mine = {"seed": arguments.seed, "commit": prepared.kept["commit"], "date": datetime.date.today().isoformat(),
                "environment": plant.environment(), "rooms": prepared.kept["population"], "not_compiled": len(prepared.kept["dropped"]),
                "tests_left_out": prepared.kept["left_out"], "mutants": [{key: one[key] for key in KEPT} for one in prepared.mutants]}
        ledger["samples"].append(mine)
    rows = {row["id"]: row for row in mine["mutants"]}
    waiting = [one for one in prepared.mutants if "verdict" not in rows[one["id"]]]
    random.Random(arguments.seed).shuffle(waiting)
    free, lock = queue.SimpleQueue(), threading.Lock()
    for tree in prepared.trees:
        free.put(tree)

    def one(mutant):
        if arguments.minutes and time.monotonic() - started > 60 * arguments.minutes:
            return
        tree = free.get()
        try:
            row = verdict_on(prepared, mutant, tree)
        finally:
            free.put(tree)
        with lock:
            rows[mutant["id"]].update(row)
            write_ledger(arguments.out, ledger)
            if arguments.survivors and row["verdict"] in ("survived", "not reached"):
                with open(arguments.survivors, "a") as out:
                    able = " ".join(unit["name"] for unit in prepared.who_can_notice(mutant)[0][:12])
                    print(mutant["room"], f"{mutant['file']}:{mutant['line']}", mutant["operator"], json.dumps(mutant["original"]),
                          json.dumps(mutant["replacement"]), row["verdict"], able, mutant["id"], sep="\t", file=out)
        print(f"{row['verdict']:12}{row['seconds']:7.1f} s  {mutant['id']}  {mutant['file']}:{mutant['line']}  {mutant['operator']}  {row.get('by', '')}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(arguments.workers) as pool:
        list(pool.map(one, waiting))
    print_scores(ledger)
    left = sum("verdict" not in row for row in mine["mutants"])
    if left:
        print(f"{left} mutants wait; the same command goes on with them")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=LEDGER, metavar="FILE", help="the ledger")
    commands = parser.add_subparsers(dest="command", required=True)
    take = commands.add_parser("sample", help="draw a sample, or go on with it")
    take.add_argument("--seed", type=int, default=int(datetime.date.today().strftime("%Y%m%d")), help="default: today's date")
    take.add_argument("--rooms", action="append", metavar="ROOM", choices=sample.ROOMS, help="this room; may be given again")
    take.add_argument("--twice", action="append", metavar="ROOM", choices=sample.ROOMS, default=[], help="a sample twice as large of it")
    take.add_argument("--minutes", type=float, help="begin no mutant after so long")
    take.add_argument("--workers", type=int, default=2)
    take.add_argument("--work", type=pathlib.Path, default=ROOT / "build/mutants", help="folder of the generated copy")
    take.add_argument("--without", metavar="REGEX", help="leave these tests out; the ledger says so")
    take.add_argument("--survivors", type=pathlib.Path, metavar="FILE", help="add each survivor to this table too")
    commands.add_parser("score", help="what was caught in each room's last sample")
    equivalent = commands.add_parser("equivalent", help="tell a survivor that changes nothing, with the reason")
    equivalent.add_argument("id")
    equivalent.add_argument("reason")
    arguments = parser.parse_args()
    if arguments.command == "sample":
        for one in (signal.SIGINT, signal.SIGTERM):
            signal.signal(one, tests.stop)
        return take_sample(arguments)
    ledger = read_ledger(arguments.out)
    if arguments.command == "score":
        print_scores(ledger)
        return 0
    rows = [row for one in ledger["samples"] for row in one["mutants"] if row["id"] == arguments.id]
    if not rows or any(row.get("verdict") not in ("survived", "not reached", "equivalent") for row in rows) or len(arguments.reason) < 20:
        print(f"run.py: {arguments.id} is no survivor of the ledger, or the reason is no sentence", file=sys.stderr)
        return 2
    for row in rows:
        row.update(verdict="equivalent", reason=arguments.reason)
    write_ledger(arguments.out, ledger)
    return 0


if __name__ == "__main__":
    sys.exit(main())
