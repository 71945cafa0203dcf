#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How fast sweeps are, and how they scale on threads and ranks.

  ratios    time per point, beside the time of preparation and kernels alone, by tribocheck_bench_sweep
  threads   1 and 2
  ranks     strong scaling on 1, 2 and 4, weak on 1 and 2
  memory    greatest resident memory of each rank, at a hundred million points (--billion: at a thousand million too)

All results are printed and written to reference/baselines/sweep.json. Real times are measured in turn. Their
medians are over the repetitions in which other processes used the processors least, and this use is kept too.
Times of threads leave out the waits for other processes. The CPU time of ranks is kept too: it gives an upper
bound of their speed-up without other processes.

  benchmarks/sweep/scaling.py build/release
  benchmarks/sweep/scaling.py build/release --only ratios,memory
  benchmarks/sweep/scaling.py build/release --table reference/baselines/sweep.json
"""
import argparse
import json
import math
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks/gates"))
import measure  # noqa: E402

BASELINE = ROOT / "reference/baselines/sweep.json"
PARTS = ("ratios", "threads", "ranks", "memory")
REPETITIONS = 21  # runs of a contender, interleaved with those of all others
ROUNDS = 7       # timings by the clock
KEPT = 3         # the timings kept: those with the least work of other processes
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

SCENE = """id = "rough"
outputs = ["film"]
load = {load}
speed = {speed}
[surface]
summit_density = {density}
summit_radius = 1e-5
summit_height_sd = {sd}
summit_plane_offset = 1.146
[bodies]
effective_modulus = 107.9e9
reduced_radius = 9.5e-3
[lubricant]
viscosity = {viscosity}
pressure_viscosity = 2e-8
[supply]
inlet_film_ratio = 4
[sweep]
draws = {draws}
keep = "{keep}"
"""
FIVE = {"load": '{ printed = "50" }', "speed": '{ distribution = "log_normal", median = 0.05, log_sd = 0.2 }',
        "density": '{ printed = "5.0e10" }', "sd": '{ distribution = "log_normal", median = 1e-7, log_sd = 0.2 }',
        "viscosity": '{ distribution = "normal", mean = 0.0202, sd = 5e-4 }'}
OF_SPEED = {"load": "50", "speed": '{ distribution = "log_uniform", from = 1e-4, to = 3 }', "density": "5e10",
            "sd": "1e-7", "viscosity": "0.0202"}


def say(text=""):
    print(text, flush=True)


class Sweeps:
    """Runs of the program in a folder of their own."""

    def __init__(self, build, folder):
        self.program = pathlib.Path(build).resolve() / "tribocheck"
        self.bench_program = self.program.with_name("tribocheck_bench_sweep")
        self.folder = pathlib.Path(folder)

    def file(self, fields, draws, keep):
        path = self.folder / f"{keep}_{draws}.toml"
        path.write_text(SCENE.format(draws=draws, keep=keep, **fields))
        return path

    def command(self, sweep, *options, ranks=None):
        out = self.folder / "out.h5"
        start = [] if ranks is None else ["mpirun", "--oversubscribe", "-n", str(ranks)]
        return [*start, self.program, "sweep", sweep, "-o", out, "--force", "--format", "json", *options]

    def run(self, command):
        done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              env=ENVIRONMENT)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, command))}: exit code {done.returncode}: {done.stderr[-500:]}")
        return done.stdout


def busy_seconds():
    """CPU seconds of all processors and processes, since the machine was started."""
    with open("/proc/stat") as file:
        user, nice, system, _, _, irq, softirq, *_ = map(int, file.readline().split()[1:])
    return (user + nice + system + irq + softirq) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def timed(work):
    """Returns (seconds, processors that other processes used meanwhile, CPU seconds of the work itself)."""
    busy, own, start = busy_seconds(), own_seconds(), time.perf_counter()
    work()
    seconds = time.perf_counter() - start
    own = own_seconds() - own
    return seconds, max(0, busy_seconds() - busy - own) / seconds, own


def interleaved(works):
    """Runs the works in turn. Returns the name of each → its times that are kept."""
    runs = {name: [] for name in works}
    for turn in range(ROUNDS):
        for name in works if turn % 2 == 0 else reversed(works):
            runs[name].append(timed(works[name]))
    return {name: quietest(of) for name, of in runs.items()}


def quietest(runs):
    kept = sorted(runs, key=lambda run: run[1])[:KEPT]
    return {"seconds": statistics.median(run[0] for run in kept),
            "cpu_seconds": statistics.median(run[2] for run in kept),
            "others": max(run[1] for run in kept)}


# --- Measurements.

def ratios(sweeps):
    """Workload → contender → ns a point: CPU time, but real time for whole runs."""
    found = bench(sweeps, "/(alone|summaries|points|stage.*)$", REPETITIONS)
    for workload, contenders in bench(sweeps, "/run of", 3).items():
        found[workload] |= contenders
    return found


def bench(sweeps, chosen, repetitions):
    """Medians of the fastest third of the repetitions, which other processes slowed least."""
    found = {}
    for run in json.loads(sweeps.run([sweeps.bench_program, "--benchmark_format=json",
                                      f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.02",
                                      f"--benchmark_filter={chosen}"]))["benchmarks"]:
        if run["run_type"] != "iteration":
            continue
        if run.get("error_occurred"):
            raise SystemExit(f"{run['name']}: {run['error_message']}")
        workload, contender = run["name"].split("/iterations:")[0].split("/", 1)
        nanoseconds = run["real_time" if "threads" in run else "cpu_time"] / run["points"]
        found.setdefault(workload, {}).setdefault(contender, []).append(nanoseconds)
    return {workload: {contender: statistics.median(sorted(times)[:math.ceil(repetitions / 3)])
                       for contender, times in sorted(contenders.items())}
            for workload, contenders in found.items()}


def threads(sweeps):
    """Real times without the threads' waits for other processes, and the time that a process takes to start."""
    chunks = bench(sweeps, "film_5_fields/chunks", REPETITIONS)["film_5_fields"]
    small = sweeps.file(FIVE, 1, "summaries")
    found = interleaved({"start": lambda: sweeps.run(sweeps.command(small, "--threads", "1"))})
    return {"ns_a_point": chunks, "start": found["start"],
            "speedup": {kept: chunks[f"chunks with {kept}, threads: 1"] / chunks[f"chunks with {kept}, threads: 2"]
                        for kept in ("summaries", "points")}}


def ranks(sweeps):
    draws = 1 << 22
    strong = sweeps.file(FIVE, draws, "summaries")
    double = sweeps.file(FIVE, 2 * draws, "summaries")
    small = sweeps.file(FIVE, 1, "summaries")
    works = {}
    for count in (1, 2, 4):
        works[f"start {count}"] = lambda count=count: sweeps.run(sweeps.command(small, ranks=count))
        works[f"strong {count}"] = lambda count=count: sweeps.run(sweeps.command(strong, ranks=count))
    works["weak 2"] = lambda: sweeps.run(sweeps.command(double, ranks=2))
    found = interleaved(works)

    def net(name):
        return found[name]["seconds"] - found[f"start {name.split()[1]}"]["seconds"]
    def net_cpu(name):
        return found[name]["cpu_seconds"] - found[f"start {name.split()[1]}"]["cpu_seconds"]
    return {"points": draws, "of": found,
            "cpu_speedup": {count: int(count) * net_cpu("strong 1") / net_cpu(f"strong {count}")
                            for count in ("2", "4")},
            "weak_cpu_efficiency": 2 * net_cpu("strong 1") / net_cpu("weak 2"),
            "speedup": {count: net("strong 1") / net(f"strong {count}") for count in ("2", "4")},
            "weak_efficiency": net("strong 1") / net("weak 2")}


def memory(sweeps, billion):
    """MB of each process, with 2 threads and with 2 ranks. This script starts each rank and waits for it."""
    found = {}
    for draws in (10**8, *((10**9,) if billion else ())):
        sweep = sweeps.file(OF_SPEED, draws, "summaries")
        for name, count, options in (("threads 2", None, ["--threads", "2"]), ("ranks 2", 2, [])):
            prefix = sweeps.folder / "rss"
            command = sweeps.command(sweep, *options, ranks=count)
            at = command.index(sweeps.program)
            seconds, others, _ = timed(lambda: sweeps.run(
                [*command[:at], sys.executable, __file__, "--rss-of", prefix, *command[at:]]))
            sizes = {path.suffix[1:]: float(path.read_text()) for path in sweeps.folder.glob("rss.*")}
            for path in sweeps.folder.glob("rss.*"):
                path.unlink()
            found[f"{draws} points, {name}"] = {"points": draws, "mb_of_rank": dict(sorted(sizes.items())),
                                                "seconds": seconds, "others": others}
    return found


def run_and_note_memory(prefix, command):
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
    pathlib.Path(f"{prefix}.{rank}").write_text(str(usage.ru_maxrss / 1024))
    return os.waitstatus_to_exitcode(status)


# --- Output.

def tables(found):
    for workload, times in found.get("ratios", {}).items():
        say(f"\n{workload:34}{'ns a point':>12}{'/ alone':>10}")
        for contender, ns in times.items():
            say(f"  {contender:32}{ns:12.1f}{ns / times['alone']:10.2f}")
    if "threads" in found:
        of = found["threads"]["speedup"]
        say(f"\ntwo threads: {of['summaries']:.2f} times one with summaries, {of['points']:.2f} with points; by the "
            "clock, without their waits for others")
    if "ranks" in found:
        of = found["ranks"]
        for count in ("2", "4"):
            say(f"{count} ranks on {found['processors']} processors: {of['speedup'][count]:.2f} times one by the clock, "
                f"at most {of['cpu_speedup'][count]:.2f} by their CPU time")
        say(f"weak, 2 ranks with twice the points: {100 * of['weak_efficiency']:.0f} % by the clock, at most "
            f"{100 * of['weak_cpu_efficiency']:.0f} % by CPU time")
    if "others" in found:
        say(f"other processes used at most {found['others']:.2f} processors meanwhile")
    for name, of in found.get("memory", {}).items():
        say(f"{name}: {max(of['mb_of_rank'].values()):.0f} MB, {of['seconds']:.1f} s")


def greatest_use_by_others(found):
    uses = []

    def look(value):
        if isinstance(value, dict):
            uses.extend([value["others"]] if "others" in value and "seconds" in value else [])
            for one in value.values():
                look(one)
    look({part: found[part] for part in ("threads", "ranks") if part in found})
    return max(uses, default=0.0)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", default=ROOT / "build/release")
    parser.add_argument("--only", default=",".join(PARTS), help="parts, with commas; the others stay what they were")
    parser.add_argument("--billion", action="store_true", help="memory at a thousand million points too: minutes")
    parser.add_argument("--out", type=pathlib.Path, default=BASELINE)
    parser.add_argument("--table", type=pathlib.Path, help="only print what such a file holds")
    return parser.parse_args()


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "--rss-of":
        return run_and_note_memory(sys.argv[2], sys.argv[3:])
    wanted = arguments()
    if wanted.table:
        tables(json.loads(wanted.table.read_text()))
        return 0
    only = wanted.only.split(",")
    if unknown := set(only) - set(PARTS):
        raise SystemExit(f"--only: {', '.join(sorted(unknown))}: not among {', '.join(PARTS)}")
    if shutil.which("mpirun") is None:
        raise SystemExit("mpirun is missing: install openmpi-bin")
    before = json.loads(wanted.out.read_text()) if wanted.out.exists() and set(only) != set(PARTS) else {}
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        sweeps = Sweeps(wanted.build, folder)
        found = {"commit": measure.commit(), "date": measure.today(), "environment": environment(),
                 "seconds": 0.0, "processors": os.cpu_count()}
        parts = {"ratios": ratios, "threads": threads, "ranks": ranks,
                 "memory": lambda of: memory(of, wanted.billion)}
        for part in PARTS:
            if part in only:
                print(f"{part} …", file=sys.stderr, flush=True)
                found[part] = parts[part](sweeps)
            elif part in before:
                found[part] = before[part]
    found["others"] = greatest_use_by_others(found)
    found["seconds"] = round(time.perf_counter() - start, 1)
    found = rounded(found)
    wanted.out.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")
    tables(found)
    return 0


def rounded(value):
    if isinstance(value, float):
        return float(f"{value:.5g}")
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return value


def environment():
    with open("/proc/cpuinfo") as file:
        cpu = next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "unknown")
    return {"cpu": cpu, "compiler": measure.said_by(["g++", "--version"]).splitlines()[0],
            "mpi": measure.said_by(["mpirun", "--version"]).splitlines()[0]}


if __name__ == "__main__":
    sys.exit(main())
