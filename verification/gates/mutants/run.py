#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes mutants by machine, runs the tests that can notice them, and keeps a ledger of the verdicts.

The seed chooses a sample of all places in the tree's texts. Mutants of C++ stand behind switches in a generated copy, which is
built once; others are written into a copy of the tree for each test. One run of all tests without a mutant says which tests reach
which mutants, and where a value would change. Quick tests run on each mutant alone, and then the tests that noticed most other mutants
of its file and room. Mutants that survive these wait: each of the other tests runs on all waiting mutants together and, if it turns
red, on halves of them. The ledger is written after each mutant. The same command continues a run that was stopped or reached its --minutes.

  verification/gates/mutants/run.py sample --seed 20261123 --minutes 60
  verification/gates/mutants/run.py alone ID ID --minutes 10     run tests on these mutants in a layer over today's build, without a copy
  verification/gates/mutants/run.py score
  verification/gates/mutants/run.py equivalent ID "the reason, in a sentence"
  verification/gates/mutants/run.py held ID concern.Suite.Test   the check that a survivor was given since
"""
import argparse
import collections
import concurrent.futures
import contextlib
import datetime
import json
import pathlib
import queue
import random
import re
import signal
import sys
import tempfile
import threading
import time

import scipy.stats

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "verification/gates"), str(ROOT / "verification/gates/faults")]
import places  # noqa: E402
import plant  # noqa: E402
import sample  # noqa: E402
import schemata  # noqa: E402
import tests  # noqa: E402
from plant import scratch  # noqa: E402

LEDGER = ROOT / "reference/baselines/mutants.json"
NOTICED = {"red": "caught", "hung": "hung"}
STRICT = ("formulas", "engine", "judging")  # rooms with the goal 95 %; the others have 90 %
LIKELY, LIKELY_SECONDS = 4, 60  # a mutant alone meets so many tests that noticed others of its room, each of so many seconds at most
KEPT = ("id", "room", "operator", "file", "line", "original", "replacement", "find", "replace")


def wilson(part, of):
    """The 95 % interval of a share, by Wilson."""
    return tuple(scipy.stats.binomtest(part, of).proportion_ci(method="wilson")) if of else (0.0, 1.0)


def read_ledger(path):
    return json.loads(path.read_text()) if path.is_file() else {"samples": []}


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_suffix(".new")
    new.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    new.replace(path)


def scores(ledger):
    """The score of each room in its last sample. A room has no score before all its mutants ran, because those that survive run longest."""
    last = {}
    for one in ledger["samples"]:
        for room in one["rooms"]:
            last[room] = [row for row in one["mutants"] if row["room"] == room]
    table = []
    for room, rows in last.items():
        count = {verdict: sum(row.get("verdict") == verdict for row in rows)
                 for verdict in ("caught", "hung", "survived", "not reached", "equivalent")}
        ran, caught = sum(count.values()), count["caught"] + count["hung"]
        of = ran - count["equivalent"] if ran == len(rows) else 0
        table.append({"room": room, "drawn": len(rows), "ran": ran, **count, "score": caught / of if of else None,
                      "interval": wilson(caught, of), "with_equivalents": caught / ran if of else None})
    return table


def noticed(table):
    """The numbers of noticed mutants and of all but equivalent ones, and the interval of their share, over the rooms that ran to their end."""
    table = [row for row in table if row["ran"] == row["drawn"]]
    part, of = sum(row["caught"] + row["hung"] for row in table), sum(row["ran"] - row["equivalent"] for row in table)
    return part, of, *wilson(part, of)


def summary(ledger):
    """The scores of the rooms and of all together, the goals, and the mutants that no test noticed, for the report."""
    table = scores(ledger)
    part, of, low, high = noticed(table)
    strict = [row for row in table if row["room"] in STRICT]
    rooms = [{**{key.replace(" ", "_"): value for key, value in row.items() if key != "interval"}, "low": row["interval"][0],
              "high": row["interval"][1], "goal": 0.95 if row in strict else 0.9} for row in table]
    reached = len(table) == len(sample.ROOMS) and all(row["ran"] == row["drawn"] and (row["score"] or 0) >= row["goal"] for row in rooms) \
        and low >= 0.87 and noticed(strict)[2] >= 0.9
    last = {room: one["seed"] for one in ledger["samples"] for room in one["rooms"]}
    unnoticed = [{**{key: row[key] for key in ("id", "room", "operator", "verdict")}, "place": f"{row['file']}:{row['line']}",
                  "original": shortened(row["original"]), "replacement": shortened(row["replacement"]), "reason": row.get("reason", ""), "since": row.get("since", "")}
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
              f"{row['equivalent']:11}{score:>7}" + ("" if row["score"] is None else f"  {100 * low:.0f} to {100 * high:.0f} %      {100 * row['with_equivalents']:.0f} %"))
    for name, rows in (("all rooms", table), (" and ".join(STRICT), [row for row in table if row["room"] in STRICT])):
        part, of, low, high = noticed(rows)
        if of:
            print(f"{name}: {part} of {of} noticed, {100 * part / of:.1f} %, {100 * low:.1f} to {100 * high:.1f} %")


class Prepared:
    """A folder with the drawn mutants, the built copy, and the tests that reach each mutant."""

    def __init__(self, folder, seed, sizes, workers, left_out):
        self.folder, self.workers, self.lock = folder, workers, threading.Lock()
        self.file = folder / "prepared.json"
        kept = json.loads(self.file.read_text()) if self.file.is_file() else {}
        if kept.get("seed") not in (None, seed):
            sys.exit(f"{folder} holds the copy of seed {kept['seed']}; remove it, or name another folder with --work")
        # The texts that the sample was drawn from are kept, because the tree may change while the sample runs.
        self.base = folder / "base"
        self.copy = schemata.Copy(self.base, folder / "tree", folder / "tree/build/release")
        if not kept:
            found = places.all_places(ROOT, ROOT / "build/release", sizes)
            for tree in (self.base, self.copy.tree):
                scratch.copy_tree(ROOT, tree)
                schemata.with_history(ROOT, tree)
            self.copy.configure()
            write(folder / "places.json", found)
            kept = {"seed": seed, "commit": plant.commit(), "numbers": {}, "dropped": [], "built": False, "coverage": {}}
        self.kept = kept
        self.save()  # so that a run that is stopped while it builds goes on with the same texts
        if not kept["built"]:
            found = json.loads((folder / "places.json").read_text())
            kept["population"] = {room: sum(one["room"] == room for one in found) for room in sizes}
            self.build(found, seed, sizes, self.copy.targets(left_out) if left_out else [])
        self.mutants = kept["mutants"]
        self.numbers = kept["numbers"]
        self.trees = [tests.Tree(self.base, self.copy, folder / f"tree-{k}") for k in range(workers)]
        if not kept.get("covered"):
            self.cover(left_out)

    def save(self):
        write(self.file, self.kept)

    def build(self, found, seed, sizes, targets):
        """Builds these targets of the copy, or all if none are named. Mutants whose switch does not compile are replaced by others."""
        kept = self.kept
        while True:
            drawn = sample.draw(found, sizes, seed, set(kept["dropped"]))
            for one in drawn:
                kept["numbers"].setdefault(one["id"], len(kept["numbers"]))
            self.copy.write(drawn, kept["numbers"])
            ids = {number: name for name, number in kept["numbers"].items()}
            failing = self.copy.failing(*targets)
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
        """Runs all tests without a mutant. If any is red, the program ends after the last one."""
        units = tests.all_units(self.copy, self.trees[0], left_out)
        print(f"{len(units)} parts of tests run without a mutant", flush=True)
        free = queue.SimpleQueue()
        for tree in self.trees:
            free.put(tree)
        files = sorted({one["file"] for one in self.mutants if not one["switched"]})
        size = len(self.numbers) + 1
        red = []

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
            with self.lock:
                self.kept["coverage"][unit["name"]] = {**unit, **row}
                if row["seconds"] > 3:
                    self.save()  # so that long steps are not run again

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
        """Parts of tests that can notice the mutant, and the number of those that reach it without a changed value."""
        if not mutant["switched"]:
            return [unit for unit in self.kept["coverage"].values() if mutant["file"] in unit["read"]], 0
        number = self.numbers[mutant["id"]]
        return ([unit for unit in self.kept["coverage"].values() if number in unit["differs"]],
                sum(number in unit["reached"] for unit in self.kept["coverage"].values()))


class Verdicts:
    """The verdicts on the mutants of one sample."""

    def __init__(self, prepared, seed, path, over):
        self.prepared, self.path, self.over = prepared, path, over
        self.ledger, self.lock = read_ledger(path), threading.Lock()
        # Rooms that are drawn later with the same seed have an entry of their own.
        mine = next((one for one in self.ledger["samples"] if one["seed"] == seed and set(one["rooms"]) == set(prepared.kept["population"])), None)
        if mine is None:
            kept = prepared.kept
            mine = {"seed": seed, "commit": kept["commit"], "date": datetime.date.today().isoformat(),
                    "environment": plant.environment(), "rooms": kept["population"], "not_compiled": len(kept["dropped"]),
                    "tests_left_out": kept["left_out"], "mutants": [{key: one[key] for key in KEPT} for one in prepared.mutants]}
            self.ledger["samples"].append(mine)
        self.mine = mine
        self.rows = {row["id"]: row for row in mine["mutants"]}
        self.free = queue.SimpleQueue()
        for tree in prepared.trees:
            self.free.put(tree)

    def waiting(self):
        return [one for one in self.prepared.mutants if "verdict" not in self.rows[one["id"]]]

    @contextlib.contextmanager
    def a_tree(self):
        tree = self.free.get()
        try:
            yield tree
        finally:
            self.free.put(tree)

    def say(self, mutant, verdict, seconds, by=None):
        able, reach = self.prepared.who_can_notice(mutant)
        row = {"tests": len(able), "reach_without_change": reach, "verdict": verdict, **({"by": by} if by else {}), "seconds": round(seconds, 1)}
        with self.lock:
            self.rows[mutant["id"]].pop("outlived", None)
            self.rows[mutant["id"]].update(row)
            write_ledger(self.path, self.ledger)
        print(f"{verdict:12}{seconds:7.1f} s  {mutant['id']}  {mutant['file']}:{mutant['line']}  {mutant['operator']}  {by or ''}", flush=True)

    def note_outlived(self, mutant, names):
        with self.lock:
            self.rows[mutant["id"]]["outlived"] = names
            write_ledger(self.path, self.ledger)

    def note_met(self, unit):
        with self.lock:
            self.mine.setdefault("met", []).append(unit["name"])
            write_ledger(self.path, self.ledger)

    def run(self, unit, mutants, tree):
        """How a part of the tests ends with all these mutants, the check at which it ended, and the part cut down to that test."""
        with tree.planted(mutants):
            return tree.run(unit, [self.prepared.numbers[one["id"]] for one in mutants if one["switched"]])

    def meet_quick_tests(self, mutant, patience):
        """Runs the quickest tests on one mutant, `patience` seconds together at most. The mutant waits if slower tests are left."""
        if self.over():
            return
        able, reach = self.prepared.who_can_notice(mutant)
        start, planned, outlived = time.monotonic(), 0, []
        with self.a_tree() as tree:
            for unit in tests.together(able):
                planned += unit["seconds"]
                if planned > patience:
                    self.note_outlived(mutant, outlived)
                    return
                end, check, _ = self.run(unit, [mutant], tree)
                if end != "green":
                    self.say(mutant, NOTICED[end], time.monotonic() - start, check)
                    return
                outlived.append(unit["name"])
        self.say(mutant, "survived" if able or reach else "not reached", time.monotonic() - start)

    def most_likely(self, mutant):
        """At most LIKELY tests that have not met this mutant, and noticed most others of its file, then of its room, in all samples."""
        test_of = {tests.check_named(unit["test"], unit.get("case")): unit["test"] for unit in self.prepared.kept["coverage"].values()}
        hits = {key: collections.Counter(test_of.get(row.get("by")) for one in self.ledger["samples"] for row in one["mutants"]
                                         if row[key] == mutant[key]) for key in ("file", "room")}
        outlived = self.rows[mutant["id"]]["outlived"]
        able = [unit for unit in tests.together(self.prepared.who_can_notice(mutant)[0])
                if unit["name"] not in outlived and unit["seconds"] <= LIKELY_SECONDS and hits["room"][unit["test"]]]
        return sorted(able, key=lambda unit: (-hits["file"][unit["test"]], -hits["room"][unit["test"]], unit["seconds"]))[:LIKELY]

    def meet_likely_tests(self, mutant):
        start = time.monotonic()
        if self.over():
            return
        for unit in self.most_likely(mutant):
            if self.over():
                return
            with self.a_tree() as tree:
                end, check, _ = self.run(unit, [mutant], tree)
            if end != "green":
                self.say(mutant, NOTICED[end], time.monotonic() - start, check)
                return
            self.note_outlived(mutant, [*self.rows[mutant["id"]]["outlived"], unit["name"]])

    def wait_for_others(self, workers):
        """Runs each other test on all mutants together that wait for it. Mutants that no test notices survive."""
        waiting, awaited = self.waiting(), {}
        for mutant in waiting:
            outlived = self.rows[mutant["id"]]["outlived"]
            for unit in self.prepared.who_can_notice(mutant)[0]:
                if (unit["test"] if "case" in unit else unit["name"]) not in outlived:
                    awaited.setdefault(unit["name"], []).append(mutant)
        units = sorted((self.prepared.kept["coverage"][name] for name in awaited), key=lambda unit: unit["seconds"])
        print(f"{len(waiting)} mutants outlived the quick tests, and wait for {len(units)} others", flush=True)

        def meet(unit):
            if self.over() or unit["name"] in self.mine.get("met", []):
                return
            start = time.monotonic()
            with self.a_tree() as tree:
                for mutant, end, check in self.noticed_by(unit, awaited[unit["name"]], tree):
                    if "verdict" not in self.rows[mutant["id"]]:
                        self.say(mutant, NOTICED[end], time.monotonic() - start, check)
            self.note_met(unit)

        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            list(pool.map(meet, units))
        if not self.over():
            self.mine.pop("met", None)
            for mutant in self.waiting():
                self.say(mutant, "survived", 0)

    def noticed_by(self, unit, mutants, tree):
        """The mutants among these that the part notices, each with its end and its check. Mutants that mask each other survive here, so that
        the score may be too low, but not too high."""
        found = []
        while mutants := [one for one in mutants if "verdict" not in self.rows[one["id"]] and one not in [row[0] for row in found]]:
            end, check, part = self.run(unit, mutants, tree)
            if end == "green":
                break
            # The red test runs on each half alone, and on each half of a red half. A mutant that does not turn it red alone waits on.
            now = self.halved(part or unit, mutants, tree, (end, check) if part is None else None)
            found += now
            if not now:
                found += self.halved(unit, mutants, tree, (end, check))
                break
        return found

    def halved(self, unit, mutants, tree, known=None):
        """The mutants that turn the part red alone. `known` is the end and the check of the part with all of them, if it has run."""
        end, check = known or self.run(unit, mutants, tree)[:2]
        if end == "green":
            return []
        if len(mutants) == 1:
            return [(mutants[0], end, check)]
        half = len(mutants) // 2
        return self.halved(unit, mutants[:half], tree) + self.halved(unit, mutants[half:], tree)


def take_sample(arguments):
    started = time.monotonic()
    sizes = {room: arguments.twice.count(room) * size + size for room, size in sample.ROOMS.items() if not arguments.rooms or room in arguments.rooms}
    prepared = Prepared(arguments.work.resolve(), arguments.seed, sizes, arguments.workers, arguments.without)
    verdicts = Verdicts(prepared, arguments.seed, arguments.out,
                        lambda: bool(arguments.minutes) and time.monotonic() - started > 60 * arguments.minutes)
    quick = [one for one in verdicts.waiting() if "outlived" not in verdicts.rows[one["id"]]]
    random.Random(arguments.seed).shuffle(quick)
    with concurrent.futures.ThreadPoolExecutor(arguments.workers) as pool:
        list(pool.map(lambda mutant: verdicts.meet_quick_tests(mutant, arguments.patience), quick))
        list(pool.map(verdicts.meet_likely_tests, verdicts.waiting()))
    if not verdicts.over():
        verdicts.wait_for_others(arguments.workers)
    print_scores(verdicts.ledger)
    if left := len(verdicts.waiting()):
        print(f"{left} mutants wait; the same command goes on with them")
    return 0


# The tests that can read texts that are not compiled, by the text's folder; the longest folder that fits counts.
READERS = {"reports/field": r"program\.test_field", "reports/page": r"program\.test_(report|page|sweep_pictures)", "benchmarks/gates": r"gates\.", "": r"program\."}


def readers_of(row, built, names):
    """The tests of CTest whose program reads the text of the mutant, each with the targets that it needs."""
    found = {}
    for name in names:
        target = "tribocheck" if name.startswith("program.") else name.split(".")[1]
        if not plant.is_compiled(row):
            folder = max((one for one in READERS if row["file"].startswith(one)), key=len)
            if re.match(READERS[folder], name):
                found[name] = []
        elif name.startswith("program.") or target.endswith("_test"):
            targets = ["tribocheck", "verification/conformance/subjects/all"] if name.startswith("program.") else [target]
            if built.seconds(plant.ROOT / row["file"], targets[:1]):
                found[name] = targets
    return found


def meet_alone(row, built, seconds, folder, minutes):
    """The verdict on one mutant of the ledger from tests in a layer over the build. Tests that share a word with the file's name come
    first; in both groups the quickest come first, compiling included. Tests that the mutant has outlived are left out. The result is
    None if the next test would take longer than the time that is left."""
    readers = {name: targets for name, targets in readers_of(row, built, seconds).items() if name not in row.get("outlived", ())}
    words = set(pathlib.Path(row["file"]).stem.replace("-", "_").split("_")) - {"test"}
    takes = {name: seconds[name] + (built.seconds(plant.ROOT / row["file"], targets) if targets else 0) for name, targets in readers.items()}
    above, started, outlived = plant.Above(folder), time.monotonic(), []
    with above.planted(row):
        for name in sorted(readers, key=lambda name: (not words & set(re.split(r"[._]", name)), takes[name])):
            left = 60 * minutes - (time.monotonic() - started)
            if takes[name] > left:
                row["outlived"] = row.get("outlived", []) + outlived
                return None
            if readers[name] and (made := above.make(readers[name])).returncode != 0:
                if "static assertion failed" not in made.stdout:
                    sys.exit(f"{row['id']} does not compile: {made.stdout[-500:]}")
                return {"verdict": "caught", "by": "static_assert"}
            end, said = above.look(name, min(max(10 * seconds[name], tests.LEAST_SECONDS), 300))
            if end != "green":
                unit = {"test": name, **({"cases": []} if name.endswith("_test") and not name.startswith(("program.", "gates.")) else {})}
                return {"verdict": NOTICED[end], "by": tests.check_of(unit, said)}
            outlived.append(name)
    return {"verdict": "survived" if readers or row.get("outlived") else "not reached"}


def take_alone(arguments):
    ledger = read_ledger(arguments.out)
    rows = [row for one in ledger["samples"] for row in one["mutants"] if row["id"] in arguments.ids]
    if len(rows) != len(arguments.ids) or any(row.get("verdict", "not reached") != "not reached" for row in rows):
        print("run.py: alone: these have to be mutants of the ledger that wait or were not reached", file=sys.stderr)
        return 2
    built, seconds = plant.Built(ROOT / "build/release"), plant.seconds_of(arguments.green)
    for row in rows:
        started = time.monotonic()
        why = plant.stale(row)
        if why or plant.instruction_set_for(row) is None:
            why = why or "this machine has no instruction set that runs its text"
            print(f"{row['id']}: {why}")
            continue
        with tempfile.TemporaryDirectory(prefix="tribocheck-mutant-") as folder:
            found = meet_alone(row, built, seconds, pathlib.Path(folder) / "layer", arguments.minutes)
        if found is not None:
            row.pop("outlived", None)
            row.update(found, commit=plant.commit(), seconds=round(time.monotonic() - started, 1))
        write_ledger(arguments.out, ledger)
        print(f"{'waits' if found is None else found['verdict']:12}{time.monotonic() - started:7.1f} s  {row['id']}  {row['file']}:{row['line']}  "
              f"{row['operator']}  {(found or {}).get('by', '')}", flush=True)
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
    take.add_argument("--patience", type=float, default=20, metavar="SECONDS", help="for the tests that meet each mutant alone (default 20)")
    alone = commands.add_parser("alone", help="run tests on mutants in a layer over today's build, one mutant after another")
    alone.add_argument("ids", nargs="+", metavar="ID")
    alone.add_argument("--minutes", type=float, default=5, help="for each, by the clock (default 5)")
    alone.add_argument("--green", type=pathlib.Path, default=ROOT / "build/release/ctest.xml", metavar="FILE",
                       help="JUnit file of a CTest run, which says how long each test takes (default: what `make test` left)")
    commands.add_parser("score", help="what was caught in each room's last sample")
    equivalent = commands.add_parser("equivalent", help="mark a survivor as one that changes nothing, with the reason")
    equivalent.add_argument("id")
    equivalent.add_argument("reason")
    held = commands.add_parser("held", help="name the check, written later, that notices a mutant which no test had noticed; the verdict stays")
    held.add_argument("id")
    held.add_argument("check")
    arguments = parser.parse_args()
    if arguments.command == "sample":
        for one in (signal.SIGINT, signal.SIGTERM, signal.SIGQUIT):
            signal.signal(one, tests.stop)
        # A run under nohup goes on. The tests do not inherit this handler, but would inherit SIG_IGN, which nohup sets.
        signal.signal(signal.SIGHUP, lambda *_: None)
        return take_sample(arguments)
    if arguments.command == "alone":
        return take_alone(arguments)
    ledger = read_ledger(arguments.out)
    if arguments.command == "score":
        print_scores(ledger)
        return 0
    rows = [row for one in ledger["samples"] for row in one["mutants"] if row["id"] == arguments.id]
    is_held = arguments.command == "held"
    # A mutant that waits can be marked equivalent, too: no test can notice a change without effect.
    allowed = ("survived", "not reached", "equivalent", *(() if is_held else (None,)))
    if not rows or any(row.get("verdict") not in allowed for row in rows) or not is_held and len(arguments.reason) < 20:
        print(f"run.py: {arguments.id} is no survivor of the ledger, or the reason is shorter than 20 characters", file=sys.stderr)
        return 2
    for row in rows:
        if is_held:
            row["since"] = arguments.check
        else:
            row.pop("outlived", None)
            row.update(verdict="equivalent", reason=arguments.reason)
    write_ledger(arguments.out, ledger)
    return 0


if __name__ == "__main__":
    sys.exit(main())
