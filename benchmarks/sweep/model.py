# SPDX-License-Identifier: Apache-2.0
"""Predicts sweeps on more ranks than are here, from the measured constants of sweep.json.

  T(P) = start + max(computing, journals) + writing
    computing  ⌈C/P⌉ chunks on the rank that has the most of the C, each with the way to rank 0 and back once
               a lease; all of it times the use of rank 0 where that is above 1
    journals   all their bytes at the speed of one file system
    writing    the result, by rank 0 alone: of summaries by the chunk, of points by the point

The start is that of one rank here: the time in which a cluster starts processes comes on top.
"""
import math

LEASE = 0.25  # s: ranks_mpi.cpp
BEGIN, END = "<!-- by scaling.py -->", "<!-- end -->"
RANKS = (1, 10, 100, 1000, 10000)


def constants(found):
    times = found["ratios"]["film_5_fields"]
    start = found["threads"]["start"]["seconds"]
    of = {}
    for keep, files in found["files"].items():
        net = max(files["write"]["seconds"] - start, 1e-6)
        of[keep] = {"point_seconds": 1e-9 * times[keep],
                    "journal_bytes_a_point": files["journal_bytes"] / files["points"],
                    "journal_bytes_a_chunk": files["journal_bytes"] / files["chunks"],
                    "write_seconds_a_point": net / files["points"],
                    "write_seconds_a_chunk": net / files["chunks"]}
    return {"start": start, "answer_seconds": found["messages"]["8"]["cpu_seconds_an_answer"],
            "trip_seconds": found["messages"]["2"]["seconds_there_and_back"],
            "disk_bytes_a_second": found["disk_bytes_a_second"], "of": of}


def time_of(known, keep, points, chunks, ranks):
    of = known["of"][keep]
    chunk_seconds = points / chunks * of["point_seconds"]
    between_requests = max(LEASE, chunk_seconds) if ranks > 1 else math.inf
    use_of_first = ranks / between_requests * known["answer_seconds"]
    computing = (math.ceil(chunks / ranks) * chunk_seconds * max(1, use_of_first)
                 * (1 + known["trip_seconds"] / between_requests))
    # The bytes of a summary hardly depend on how many points it is of.
    size = (points * of["journal_bytes_a_point"] if keep == "points" else chunks * of["journal_bytes_a_chunk"])
    journals = size / known["disk_bytes_a_second"]
    writing = points * of["write_seconds_a_point"] if keep == "points" else chunks * of["write_seconds_a_chunk"]
    parts = {"start": known["start"], "computing": computing, "journals": journals, "writing": writing}
    total = parts["start"] + max(computing, journals) + writing
    return {"ranks": ranks, "seconds": total, "computing": computing, "journals": journals, "writing": writing,
            "use_of_first": use_of_first, "most": max(parts, key=parts.get)}


def of(found):
    known = constants(found)
    rows = []
    for keep, sizes in found["chunks"].items():
        for points, chunks in sizes.items():
            times = [time_of(known, keep, int(points), chunks, ranks) for ranks in RANKS]
            alone = times[0]["seconds"]
            rows.append({"keep": keep, "points": int(points), "chunks": chunks,
                         "times": [time | {"efficiency": alone / (time["seconds"] * time["ranks"])}
                                   for time in times]})
    points = known["of"]["points"]
    return {"constants": known, "rows": rows,
            "ranks_that_fill_rank_0": LEASE / known["answer_seconds"],
            "ranks_whose_journals_fill_the_disk":
                known["disk_bytes_a_second"] * points["point_seconds"] / points["journal_bytes_a_point"],
            "ranks_that_compute_as_long_as_points_are_written":
                points["point_seconds"] / points["write_seconds_a_point"]}


def text(made):
    lines = [f"Rank 0 is busy with requests from {made['ranks_that_fill_rank_0']:,.0f} ranks on; journals of points "
             f"fill this disk ({1e-9 * made['constants']['disk_bytes_a_second']:.2g} GB/s) from "
             f"{made['ranks_whose_journals_fill_the_disk']:.0f} ranks on; writing points takes as long as "
             f"computing them on {made['ranks_that_compute_as_long_as_points_are_written']:.0f} ranks.", "",
             "| keep | points | chunks | " + " | ".join(f"P = {ranks:,}" for ranks in RANKS) + " |",
             "|---|---|---|" + "---|" * len(RANKS)]
    for row in made["rows"]:
        cells = [f"{duration(time['seconds'])}, {100 * time['efficiency']:.0f} %, {time['most']}"
                 for time in row["times"]]
        lines.append(f"| {row['keep']} | {row['points']:.0e} | {row['chunks']:,} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def page_text(found):
    known = found["model"]["constants"]
    of = known["of"]
    return f"""{BEGIN}
Measured on {found['date']}, {found['environment']['cpu']}, {found['processors']} processors; five fields drawn, the film at
one speed. Two threads: {found['threads']['speedup']['summaries']:.2f} times one with summaries,
{found['threads']['speedup']['points']:.2f} with points. Others used up to {found['others']:.2f} processors meanwhile; by their CPU
time ranks would reach without any:

| ranks | times one, by the clock | by CPU time |
|---|---|---|
| 2 | {found['ranks']['speedup']['2']:.2f} | {found['ranks']['cpu_speedup']['2']:.2f} |
| 4, oversubscribed: each has half a processor | {found['ranks']['speedup']['4']:.2f} | {found['ranks']['cpu_speedup']['4'] / 2:.2f} |
| 2, with twice the points: efficiency | {100 * found['ranks']['weak_efficiency']:.0f} % | {100 * found['ranks']['weak_cpu_efficiency']:.0f} % |

| constant | summaries | points |
|---|---|---|
| a point computed, ns | {1e9 * of['summaries']['point_seconds']:.3g} | {1e9 * of['points']['point_seconds']:.3g} |
| bytes of journal | {of['summaries']['journal_bytes_a_chunk']:.3g} a chunk | {of['points']['journal_bytes_a_point']:.3g} a point |
| result written | {1e3 * of['summaries']['write_seconds_a_chunk']:.2g} ms a chunk | {1e9 * of['points']['write_seconds_a_point']:.3g} ns a point |
| rank 0, a request | {1e6 * known['answer_seconds']:.2g} µs of CPU | likewise |
| there and back | {1e6 * known['trip_seconds']:.3g} µs | likewise |
| disk | {1e-9 * known['disk_bytes_a_second']:.2g} GB/s | likewise |

{text(found['model'])}
{END}"""


def page_block(page):
    """The part of a page that page_text() replaces."""
    return page[page.index(BEGIN):page.index(END) + len(END)]


def duration(seconds):
    for unit, size in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.2g} s"
