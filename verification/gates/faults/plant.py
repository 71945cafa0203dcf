#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants the faults of catalogue.toml one at a time in a scratch copy, and checks that each is caught.

A fault is a patch: `find`, a text that stands exactly once in `file`, and `replace`. It names the check that has
to turn red, which is a CTest test (`analytic.Hertz.…`). With `inventory:` before the name, the test stays green,
and the inventory gate on that test has to turn red. The run is red if a patch no longer applies, a fault does
not build, or a fault survives.

The ledger (--out) has the last verdict on each fault, and the commit in which it was planted. A verdict is dropped if the
patch or the check of its fault has changed since. The ledger is written after each fault, so that a stopped run loses
nothing. --oldest takes the faults that were not planted for the longest time.

  verification/gates/faults/plant.py                     all of them; some three hours on two cores
  verification/gates/faults/plant.py --sample 6          a sample, another one for each commit
  verification/gates/faults/plant.py --oldest 50 --out reference/baselines/planted_faults.json
  verification/gates/faults/plant.py --only E3 --keep    one, and leave its scratch copy
  verification/gates/faults/plant.py --mutants 10        ten of the mutants that their ledger calls caught, instead
"""
import argparse
import concurrent.futures
import contextlib
import datetime
import functools
import hashlib
import json
import os
import pathlib
import platform
import queue
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "verification/gates"))
import inventory  # noqa: E402
import scratch  # noqa: E402
CATALOGUE = pathlib.Path(__file__).with_name("catalogue.toml")
MUTANTS = ROOT / "reference/baselines/mutants.json"
FIELDS = {"id", "fault", "file", "find", "replace", "check"}
INVENTORY = "inventory:"
# Almost every fault of the model makes the engine compile anew. So it is compiled only for AVX2, SSE4 and the plain processor,
# which have four lanes, two and one.
LEFT_OUT = "HWY_SSSE3|HWY_AVX3|HWY_AVX3_DL"
# MOST_SECONDS is the processor time of a sample of mutants, estimated from the times of builds and tests without a mutant. A file
# counts COMPILED_AT_LEAST if a compiler cache gave it, and COMPILED_AT_MOST if it was not built before.
MOST_SECONDS, COMPILED_AT_LEAST, COMPILED_AT_MOST = 300, 5, 60
NO_LAYER = 3  # exit code
# The instruction sets of the kernels, the best one first. The values are what the C library switches off so that no better set runs.
INSTRUCTION_SETS = {"HWY_AVX3": "", "HWY_AVX2": "-AVX512F", "HWY_SSE4": "-AVX512F,-AVX2,-FMA"}
# A check that takes longer than CHECK_SECONDS, and than CHECK_TIMES its time without a fault, has caught the fault. The factor is
# large because a scratch copy is compiled with less optimisation, and another check runs beside it.
CHECK_SECONDS, CHECK_TIMES = 180, 6


class Red(Exception):
    """The fault was not caught, or could not be planted."""


def run(command, **options):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, **options)


def read_catalogue():
    faults = tomllib.loads(CATALOGUE.read_text())["fault"]
    seen = set()
    for fault in faults:
        if set(fault) != FIELDS or fault["id"] in seen:
            sys.exit(f"{CATALOGUE}: {fault.get('id')}: needs the fields {sorted(FIELDS)}, and an id of its own")
        seen.add(fault["id"])
    return faults


def caught_mutants(text):
    """The mutants of a ledger that a check caught, as faults. Those whose check has no known build targets are left out."""
    rows = [row for one in json.loads(text)["samples"] for row in one["mutants"] if row.get("verdict") == "caught"
            and (row["by"].startswith(("program.", "gates.")) or row["by"].count(".") == 2)]
    return [{"id": row["id"], "fault": f"{row['operator']}: {row['original']} → {row['replacement']}", "file": row["file"],
             "find": row["find"], "replace": row["replace"], "check": row["by"]} for row in rows]


def digest(fault):
    """The digest of a fault's patch and check. A verdict holds for one digest."""
    text = json.dumps([fault[field] for field in ("file", "find", "replace", "check")])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def stale(fault):
    """Why the patch does not apply, or None."""
    path = ROOT / fault["file"]
    if not path.is_file():
        return f"{fault['file']} is not there"
    times = path.read_text().count(fault["find"])
    return None if times == 1 else f"its text stands {times} times in {fault['file']}"


MEMBER = re.compile(r"(?:\.|->|::)([A-Za-z_]\w*)")


def lost_member(fault, members):
    """A member that the patch brings in but no text of the tree has any more, so that the patch cannot be built. None if there is none."""
    brought = set(MEMBER.findall(fault["replace"])) - set(MEMBER.findall(fault["find"]))
    return min(brought - members, default=None)


def members_of_the_tree():
    files = run(["git", "ls-files", "*.cpp", "*.hpp", "*.h", "*.c", "*.py"], cwd=ROOT).stdout.split()
    return {name for file in files if (path := ROOT / file).is_file() for name in MEMBER.findall(path.read_text(errors="replace"))}


def runs_on(text, place, instruction_set):
    """Whether the text at the place is compiled for the instruction set, by the lines #if, #elif and #else before it."""
    def holds(condition):
        if not re.search("HWY_TARGET [!=]=|HWY_NATIVE_FMA", condition):
            return True
        terms = [term.strip() for term in condition.split("||")]
        return any(term in (f"HWY_TARGET == {instruction_set}", "HWY_NATIVE_FMA" if instruction_set != "HWY_SSE4" else "")
                   or re.fullmatch(rf"HWY_TARGET != (?!{instruction_set}$)\w+", term) for term in terms)

    open_ones = []  # for each open #if: was an earlier branch taken, and is this one?
    for line in text[:place].splitlines():
        word, _, rest = line.removeprefix("#").partition(" ") if line.startswith("#") else ("", "", "")
        if word in ("if", "ifdef", "ifndef"):
            open_ones.append((False, holds(rest)))
        elif word in ("elif", "else"):
            before = any(open_ones.pop())
            open_ones.append((before, not before and holds(rest)))
        elif word == "endif":
            open_ones.pop()
    return all(is_taken for _, is_taken in open_ones)


@functools.cache
def instruction_sets_here():
    """The instruction sets of this machine, the best one first."""
    flags = next((line.split() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("flags")), [])
    needs = {"HWY_AVX3": {"avx512f", "avx2", "fma"}, "HWY_AVX2": {"avx2", "fma"}, "HWY_SSE4": set()}
    return [one for one in INSTRUCTION_SETS if needs[one] <= set(flags)]


def instruction_set_for(fault):
    """The best instruction set of this machine that runs the text of the fault, or None if no set of it does."""
    text = (ROOT / fault["file"]).read_text()
    if not fault["file"].endswith("-inl.hpp"):
        return instruction_sets_here()[0]
    # The text `find` may begin before a line of the preprocessor. The place of the change itself counts.
    begin = text.index(fault["find"]) + len(os.path.commonprefix([fault["find"], fault["replace"]]))
    return next((one for one in instruction_sets_here() if runs_on(text, begin, one)), None)


def test_of(check):
    return check.removeprefix(INVENTORY)


def targets_of(check):
    """The build targets that a check needs. There are none if it runs only Python."""
    if test_of(check).startswith("program."):
        return ["tribocheck", "verification/conformance/subjects/all"]  # a test is red without the plug-ins
    if test_of(check).startswith("gates."):
        return ["tribocheck_gate_kernels"] if test_of(check) == "gates.work_counters" else []
    if test_of(check) == "stress.model_against_long_double":
        return ["model_stress"]  # a program of its own, not a test of GoogleTest
    # concern.Suite.Test, with Prefix/ and /parameter where there are parameters or types
    _, suites, test = test_of(check).split(".")
    suite = "|".join(re.escape(part) for part in suites.split("/"))
    pattern = re.compile(rf"TEST(?:_[FP])?\(\s*(?:{suite}),\s*{re.escape(re.split('[/<]', test)[0])}\)")
    for name, text in sources_of_tests(ROOT):
        if pattern.search(text):
            return [name]
    sys.exit(f"{check}: no source has this test")


@functools.cache
def sources_of_tests(root):
    files = sorted(root.glob("verification/**/*_test.cpp")) + sorted(root.glob("benchmarks/tests/*_test.cpp"))
    return [(file.stem, file.read_text()) for file in files]


def green_checks(junit):
    """The checks that passed in a CTest run of the tree without faults."""
    return {name for name, _, ended in inventory.endings(junit) if ended == "OK"}


def seconds_of(junit):
    return {test.get("name"): float(test.get("time")) for test in inventory.ElementTree.parse(junit).iter("testcase")}


class Built:
    """A built tree: which of its files a change compiles again, and how long they took."""

    def __init__(self, build):
        self.build = build
        lines = [line.split("\t") for line in (build / ".ninja_log").read_text().splitlines() if not line.startswith("#")]
        self.took = {output: (int(end) - int(start)) / 1000 for start, end, _, output, *_ in lines}
        # A compiler cache may have written the names of sources relative to the build folder.
        self.reads = {block.split(":")[0]: {os.path.normpath(build / name) for name in block.split("\n    ")[1:]}
                      for block in self.ask("deps").split("\n\n")}

    @functools.cache
    def needed(self, *targets):
        return [one for one in self.ask("inputs", *targets).split("\n") if one.endswith((".o", ".gch"))]

    def ask(self, *tool):
        done = run(["ninja", "-C", self.build, "-t", *tool])
        if done.returncode != 0:
            sys.exit(f"--mutants needs a built tree: {done.stdout[-300:]}")
        return done.stdout

    def seconds(self, file, targets):
        """Seconds to compile the sources of the targets that read the file. If it is in the precompiled header, all tests are compiled."""
        needed = self.needed(*targets)
        again = {one for one in needed if str(file) in self.reads.get(one, ())}
        if any(one.endswith(".gch") for one in again):
            again |= {one for one in needed if one.startswith("verification/tests/CMakeFiles/")}
        return sum(max(self.took.get(one, COMPILED_AT_MOST), COMPILED_AT_LEAST) for one in again)


def whole_test(check):
    """The CTest test that runs a check, in a build in which each program of GoogleTest is one test."""
    whole = check.startswith(("program.", "gates.", "stress.model_"))
    return check if whole else f"{check.split('.')[0]}.{targets_of(check)[0]}"


class Scratch:
    """A copy of the tree with a build of its own."""

    def __init__(self, folder):
        self.tree = folder / "tree"
        self.build = folder / "build"
        scratch.copy_tree(ROOT, self.tree)
        done = run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DTRIBOCHECK_BUILD_TESTS=ON",
                    "-DCMAKE_CXX_FLAGS=-O1", f"-DTRIBOCHECK_TARGETS_LEFT_OUT={LEFT_OUT}",
                    "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12",
                    "-DTRIBOCHECK_TEST_BY_TEST=ON"])
        if done.returncode != 0:
            sys.exit(done.stdout)

    def try_fault(self, fault, took=0):
        """Plants a fault, and returns the verdict of its check. `took` has the seconds of the check without a fault. Raises Red if the
        fault was not caught."""
        path = self.tree / fault["file"]
        whole = path.read_text()
        path.write_text(whole.replace(fault["find"], fault["replace"]))
        try:
            self.make(targets_of(fault["check"]))
            return self.look(fault["check"], max(CHECK_SECONDS, CHECK_TIMES * took))
        finally:
            path.write_text(whole)

    def make(self, targets):
        if not targets:
            return
        done = run(["cmake", "--build", self.build, "-j1", "--target", *targets])
        if done.returncode != 0:
            first = next((line for line in done.stdout.splitlines() if "error" in line), done.stdout[-300:])
            raise Red(f"does not build: {first}")

    def look(self, check, seconds=CHECK_SECONDS):
        test = test_of(check)
        only = f"^{re.escape(test)}$"
        junit = self.build / "fault.xml"
        command = ["ctest", "--test-dir", self.build, "-R", only + "|" + only[:-1] + "  #", "--timeout", f"{seconds:.0f}",
                   "--output-junit", junit, "--test-output-size-passed", "1000000"]
        done = run(command)
        if "No tests were found" in done.stdout:
            raise Red(f"{test} is not there to run")
        if not check.startswith(INVENTORY):
            if done.returncode == 0:
                raise Red("survived")
            return "timed out" if "***Timeout" in done.stdout else "failed"
        if done.returncode != 0:
            raise Red(f"{test} itself failed: then it should be named, without {INVENTORY}")
        gate = run([sys.executable, self.tree / "verification/gates/inventory.py", junit, "--only", only])
        if gate.returncode != 1:
            raise Red("survived")
        return gate.stdout.splitlines()[0]


def is_compiled(fault):
    return fault["file"].endswith("pp")


def targets_above(fault):
    """The targets of a check in the built tree, which has benchmarks: the program starts one of them."""
    is_benchmark = fault["check"].startswith("program.") and fault["file"].startswith("benchmarks/")
    return targets_of(fault["check"]) + ["tribocheck_bench"] * is_benchmark


class Above:
    """The built tree with a layer above it, which is an overlay. A mutant changes only the layer, and only files that read the changed
    text are built again. The tree stays as it is. Only commands that are started through this class see the layer."""
    MOUNT = 'mount -t overlay overlay -o "lowerdir=$1,upperdir=$2/upper,workdir=$2/work" "$1" && cd "$1" && shift 2 && exec "$@"'

    def __init__(self, folder):
        self.folder = folder
        self.switched_off = ""

    def inside(self, *command):
        tunables = {"GLIBC_TUNABLES": f"glibc.cpu.hwcaps={self.switched_off}"} if self.switched_off else {}
        return run(["unshare", "--map-root-user", "--mount", "sh", "-c", self.MOUNT, "sh", ROOT, self.folder, *command],
                   env={**os.environ, "GTEST_FAIL_FAST": "1", **tunables})

    def can_be(self):
        """Whether this machine allows such a layer, which needs namespaces and overlays."""
        for name in ("upper", "work"):
            (self.folder / name).mkdir(parents=True)
        try:
            return self.inside("true").returncode == 0
        finally:
            shutil.rmtree(self.folder)

    @contextlib.contextmanager
    def planted(self, fault):
        """Holds the mutant in the layer. Commands use the best instruction set that runs the mutant's text. There has to be one."""
        self.switched_off = INSTRUCTION_SETS[instruction_set_for(fault)]
        path = self.folder / "upper" / fault["file"]
        path.parent.mkdir(parents=True)
        (self.folder / "work").mkdir()
        try:
            path.write_text((ROOT / fault["file"]).read_text().replace(fault["find"], fault["replace"]))
            shutil.copymode(ROOT / fault["file"], path)
            yield
        finally:
            shutil.rmtree(self.folder)

    def make(self, targets):
        return self.inside("ninja", "-C", "build/release", "-j1", *targets)

    def look(self, test, seconds=CHECK_SECONDS):
        """How the test ended (green, red or hung), and what it said."""
        done = self.inside("ctest", "--test-dir", "build/release", "-R", f"^{re.escape(test)}$", "--timeout", f"{seconds:.0f}",
                           "--output-on-failure")
        if "No tests were found" in done.stdout:
            raise Red(f"{test} is not there to run")
        if not re.search(r" tests failed out of [12]\b", done.stdout):  # a fixture of the test may run, too
            sys.exit(f"a mutant above the built tree needs `unshare` and overlays: {done.stdout[-300:]}")
        return "green" if done.returncode == 0 else "hung" if "***Timeout" in done.stdout else "red", done.stdout

    def try_fault(self, fault):
        """The verdict of the check. Raises Red if the mutant was not caught."""
        with self.planted(fault):
            if is_compiled(fault) and self.make(targets_above(fault)).returncode != 0:
                raise Red("does not build")
            end, _ = self.look(whole_test(fault["check"]))
        if end == "green":
            raise Red("survived")
        return {"hung": "timed out", "red": "failed"}[end]


def plant_above(faults, count, seed, folder, seconds, workers, built):
    """Plants up to `count` mutants, in an order that depends on the seed, and returns a row for each. A mutant that would take more
    than twice its equal share of the time that is left is passed over."""
    order = iter(random.Random(seed).sample(faults, len(faults)))
    lock, rows, left, taken = threading.Lock(), [], MOST_SECONDS, 0

    def next_within():
        nonlocal left, taken
        for fault in order if taken < count else ():
            takes = seconds.get(whole_test(fault["check"]), CHECK_SECONDS)
            most = min(left, 2 * left / (count - taken))
            if takes <= most and is_compiled(fault):
                takes += built.seconds(ROOT / fault["file"], targets_above(fault))
            if takes <= most:
                taken, left = taken + 1, left - takes
                return fault
        return None

    def one(_):
        while True:
            with lock:
                fault = next_within()
            if fault is None:
                return
            start = time.monotonic()
            row = {key: fault[key] for key in ("id", "fault", "file", "check")}
            try:
                row |= {"caught": True, "said": Above(folder / fault["id"]).try_fault(fault)}
            except Red as red:
                row |= {"caught": False, "said": str(red)}
            row["seconds"] = round(time.monotonic() - start, 1)
            with lock:
                tell(row)
                rows.append(row)

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        list(pool.map(one, range(workers)))
    return rows


def tell(row):
    verdict = "caught" if row["caught"] else "RED"
    print(f"{verdict:8}  {row['seconds']:5.1f} s  {row['id']:28}  {row['check']}  ({row['said']})", flush=True)


def environment():
    cpu = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")),
               platform.machine())
    compiler = run(["c++", "--version"]).stdout.splitlines()[0]
    return {"cpu": cpu, "cores": os.cpu_count(), "compiler": compiler, "system": platform.platform()}


def commit():
    head = run(["git", "rev-parse", "HEAD"], cwd=ROOT).stdout.strip()
    changed = run(["git", "status", "--porcelain"], cwd=ROOT).stdout.strip()
    return head + (" and changes" if changed else "")


class Ledger:
    """The last verdict on each fault, in a file. Without a file no verdict is kept."""

    def __init__(self, path, catalogue):
        self.path = path
        self.digests = {fault["id"]: digest(fault) for fault in catalogue}
        self.environment = environment()
        self.rows = {}
        if path is not None and path.is_file():
            kept = json.loads(path.read_text())["faults"]
            self.rows = {row["id"]: row for row in kept if row["digest"] == self.digests.get(row["id"])}

    def oldest(self, faults, count):
        """The faults that were planted longest ago; those that were never planted come first."""
        return sorted(faults, key=lambda fault: self.rows.get(fault["id"], {"date": ""})["date"])[:count]

    def add(self, row, commit_now):
        if self.path is None:
            return
        now = datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")
        self.rows[row["id"]] = {**row, "digest": self.digests[row["id"]], "commit": commit_now, "date": now}
        rows = [self.rows[one] for one in self.digests if one in self.rows]
        first = min(rows, key=lambda one: one["date"])
        # The machine of this run; rows of earlier runs may be from other machines.
        ledger = {"commit": first["commit"], "date": first["date"][:10], "environment": self.environment,
                  "catalogue": len(self.digests), "faults": rows}
        self.path.parent.mkdir(parents=True, exist_ok=True)
        written = self.path.with_suffix(".new")
        written.write_text(json.dumps(ledger, indent=1, ensure_ascii=False) + "\n")
        written.replace(self.path)


def plant(faults, workers, folder, tell, seconds):
    """A row for each fault, in the order of the catalogue. `seconds` has what each test took without a fault."""
    scratches = queue.SimpleQueue()
    for i in range(workers):
        scratches.put(folder / str(i))
    ready = {}

    def one(fault):
        place = scratches.get()
        start = time.monotonic()
        row = {key: fault[key] for key in ("id", "fault", "file", "check")}
        try:
            if place not in ready:
                ready[place] = Scratch(place)
                start = time.monotonic()
            took = seconds.get(whole_test(test_of(fault["check"])), 0)
            row |= {"caught": True, "said": ready[place].try_fault(fault, took)}
        except Red as red:
            row |= {"caught": False, "said": str(red)}
        finally:
            scratches.put(place)
        row["seconds"] = round(time.monotonic() - start, 1)
        tell(row)
        return row

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        return list(pool.map(one, faults))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, metavar="N", help="N of them, chosen by the seed")
    parser.add_argument("--oldest", type=int, metavar="N",
                        help="N of them, whose verdict in the ledger is missing or oldest")
    parser.add_argument("--mutants", type=int, metavar="N", help="N mutants that reference/baselines/mutants.json calls caught, "
                        "chosen by the seed, in place of the catalogue; those that do not apply any more are passed over")
    parser.add_argument("--seed", help="any text; the commit's hash if not given")
    parser.add_argument("--only", metavar="ID", action="append", help="this fault; may be given again")
    parser.add_argument("--green", type=pathlib.Path, default=ROOT / "build/release/ctest.xml", metavar="FILE",
                        help="JUnit file of a CTest run without faults, in which every check named has to have "
                             "passed (default: what `make test` left)")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--out", type=pathlib.Path, metavar="FILE", help="keep the ledger there, as JSON")
    parser.add_argument("--keep", action="store_true", help="leave the scratch copies, and say where")
    arguments = parser.parse_args()

    if arguments.mutants is not None and not MUTANTS.is_file():
        print(f"plant.py: --mutants: {MUTANTS} is not there; `make mutants` writes it", file=sys.stderr)
        return 2
    catalogue = faults = read_catalogue() if arguments.mutants is None else caught_mutants(MUTANTS.read_text())
    try:
        green = green_checks(arguments.green)
    except (OSError, inventory.ElementTree.ParseError) as error:
        print(f"plant.py: --green: {error}; `make test` writes it", file=sys.stderr)
        return 2
    red = [f"{fault['id']}: {why}" for fault in faults if (why := stale(fault))]
    red += [f"{fault['id']}: {test_of(fault['check'])} did not pass without the fault, says {arguments.green}"
            for fault in faults if test_of(fault["check"]) not in green]
    if arguments.mutants is not None:  # a mutant whose text has changed says nothing about today's tests
        members = members_of_the_tree()
        gone = {line.split(":")[0] for line in red} | {fault["id"] for fault in faults if lost_member(fault, members)}
        faults = [fault for fault in faults if fault["id"] not in gone and instruction_set_for(fault) is not None]
        print(f"{len(catalogue) - len(faults)} of {len(catalogue)} caught mutants do not apply to today's text, their check is not there, "
              "or this machine has no instruction set that runs them")
        red = [] if len(faults) >= arguments.mutants else [f"{len(faults)} mutants apply, {arguments.mutants} are wanted: "
                                                           "draw a new sample (make mutants)"]
    for fault in faults:
        targets_of(fault["check"])
    if arguments.only:
        faults = [fault for fault in faults if fault["id"] in arguments.only]
        if len(faults) != len(set(arguments.only)):
            print("plant.py: --only: no such id in the catalogue", file=sys.stderr)
            return 2
    faults = [fault for fault in faults if not stale(fault)]
    if arguments.sample is not None:
        seed = arguments.seed or commit()
        faults = random.Random(seed).sample(faults, min(arguments.sample, len(faults)))
        print(f"{len(faults)} of {len(catalogue)} faults, seed {seed}")
    try:
        ledger = Ledger(arguments.out, catalogue)
    except (OSError, ValueError, KeyError) as error:
        print(f"plant.py: --out: {arguments.out}: this is no ledger: {error!r}", file=sys.stderr)
        return 2
    if arguments.oldest is not None:
        faults = ledger.oldest(faults, arguments.oldest)
    for line in red:
        print(f"RED       {line}")

    started = time.monotonic()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="tribocheck-faults-"))

    head, one_at_a_time = commit(), threading.Lock()

    def keep(row):
        with one_at_a_time:
            ledger.add(row, head)
        tell(row)

    try:
        if arguments.mutants is not None and not Above(folder / "probe").can_be():
            print("plant.py: --mutants: this machine allows no layer above the built tree (unshare, mount -t overlay); "
                  "faults of the catalogue can be planted, with --sample", file=sys.stderr)
            return NO_LAYER
        if arguments.mutants is None:
            rows = plant(faults, arguments.workers, folder, keep, seconds_of(arguments.green))
        else:
            rows = plant_above(faults, arguments.mutants, arguments.seed or head, folder, seconds_of(arguments.green),
                               arguments.workers, Built(ROOT / "build/release"))
            if len(rows) < arguments.mutants:
                red.append(f"{len(rows)} mutants were planted, {arguments.mutants} are wanted")
                print(f"RED       {red[-1]}")
    finally:
        if arguments.keep:
            print(f"scratch copies: {folder}")
        else:
            shutil.rmtree(folder, ignore_errors=True)
    seconds, used = round(time.monotonic() - started), resource.getrusage(resource.RUSAGE_CHILDREN)
    survived = sum(not row["caught"] for row in rows)
    print(f"{len(rows)} faults planted, {len(rows) - survived} caught, in {seconds} s and {used.ru_utime + used.ru_stime:.0f} s of processors; "
          f"{len(red)} cannot be planted")
    return 1 if survived or red else 0


if __name__ == "__main__":
    sys.exit(main())
