# SPDX-License-Identifier: Apache-2.0
"""Runs `tribocheck report`, and lists the files that it has to write.

As a script it is the CTest test program.report_written: it writes one report of all sections for all tests that only read it.
"""

import atexit
import functools
import html.parser
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

from program import Result, run

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
PUBLISHED = ROOT / "reference/published"
SCENES = [surface + model for model in ("", "_gw") for surface in ("rough", "medium", "smooth")]
# In the order of the page.
PAPER_FIGURES = [f"figure_{number:02}" for number in (4, 7, 8, 9, 10, 11, 12)]
SWEEP_FIGURES = ["onset_distribution", "sensitivity_onset_film_maximum_speed"]
LEDGER_FIGURES = ["onset_against_roughness", "share_against_roughness", "readings_by_score"]
CONTACT_FIGURES = ["stribeck_of_machines"]
LINE_FIGURES = ["line_film_errors", "line_film_profile"]
POINT_FIGURES = ["point_film_errors"]
STARVED_FIGURES = ["paper_films", "starved_ratios"]
FIGURES = PAPER_FIGURES + LEDGER_FIGURES + SWEEP_FIGURES + CONTACT_FIGURES + LINE_FIGURES + POINT_FIGURES + STARVED_FIGURES
DATA = sorted([f"data/curve_{scene}.tsv" for scene in SCENES] + [f"data/scenes/{scene}.toml" for scene in SCENES] +
              [f"data/figure_04_{name}.tsv"
               for name in ("flooded", "starved_inlet", "damiens", "guides", "marks")] +
              ["data/ellipse_fits.blocks.tsv", "data/figure_11_ratio.tsv", "data/marks.tsv", "data/comparison.tsv"])
JOBS = ["moment_5_2", "moment_2", "root_wide", "root_one_surface", "curve_200", "points_1e6", "hertz_ellipse"]
COUNTED = ["moment_5_2", "root_wide", "root_one_surface", "hertz_ellipse"]
FITS_FIGURES = ["ellipse_fits"]  # after the figures of work; made without a baseline
WORK_DATA = sorted(f"data/work_precision/{name}.blocks.tsv"
                   for name in JOBS + [films + table for films in ("line_film", "point_film") for table in ("", "_growth", "_exponents")])
WORK_FIGURES = [f"work_{name}" for name in JOBS + [f"{job}_evaluations" for job in COUNTED] +
                ["line_film", "point_film"]] + ["line_film_growth", "point_film_growth"] + FITS_FIGURES
CONTACTS = ["ball_on_flat", "bearing_outer_ring", "gear_flank"]
CONTACT_DATA = [f"data/{kind}{contact}{end}" for kind, end in (("contact_", ".tsv"), ("scenes/", ".toml"))
                for contact in CONTACTS] + ["data/contact_marks.tsv"]
LINE_DATA = ["data/line_film_errors.tsv", "data/line_film_labels.blocks.tsv", "data/line_film_profile.tsv",
             "data/line_film_tracks.blocks.tsv"]
POINT_DATA = ["data/point_film_errors.blocks.tsv"]
STARVED_DATA = ["data/paper_closures.blocks.tsv", "data/paper_films.blocks.tsv", "data/starved_closures.tsv", "data/starved_ratios.blocks.tsv"]
LEDGER_DATA = [f"data/ledger{name}" for name in (".csv", "_law.tsv", "_scores.tsv", "_surfaces.tsv")]
SWEEP_DATA = [f"data/sweep/{figure}.blocks.tsv" for figure in SWEEP_FIGURES]
RESULTS = ["sweep/onset_uncertainty.h5"]
PICTURES = sorted(f"figures/{figure}.{kind}" for figure in FIGURES + WORK_FIGURES
                  for kind in ("svg", "png"))
PAGES = ["index.html", "report.json", "report.md", "report.schema.json"]
DATA = sorted(DATA + WORK_DATA + LEDGER_DATA + SWEEP_DATA + CONTACT_DATA + LINE_DATA + POINT_DATA + STARVED_DATA)
# The page has a row for new and changed faults that are not planted yet, and one for drawn mutants that have not run yet. NOT_RUN is
# the number of these rows.
FAULTS, MUTANTS = (json.loads((ROOT / f"reference/baselines/{name}.json").read_text()) for name in ("planted_faults", "mutants"))
NOT_RUN = (len(FAULTS["faults"]) < FAULTS["catalogue"]) + any(one["ran"] < one["drawn"] for one in MUTANTS["score"]["rooms"])
SECTIONS = ["figures", "comparison", "claims", "live", "readings", "requirements", "uncertainty", "misprints", "model",
            "contacts", "film-solved", "film-points", "film-starved", "verification", "worst-inputs", "mutants", "planted-faults", "diagnosis", "work-precision", "skipped-work", "gates", "sweep-speed",
            "references", "environment"]


def report(*arguments, cwd=ROOT, **options):
    return run("report", *arguments, cwd=cwd, **options)


def files_below(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


def told_page(output):
    """The page's path and the number of files, in the last line that the program prints."""
    path, files = re.fullmatch(r"The page: (.+) \((\d+) files in all, .*\)", output.splitlines()[-1]).groups()
    return pathlib.Path(path), int(files)


def table(path):
    """The rows of a TSV, by the names of the columns without units. The last commented line has these names."""
    header, rows = None, []
    for line in path.read_text().splitlines():
        if line.startswith("# "):
            header = [name.split(" [")[0] for name in line[2:].split("\t")]
        elif line:
            rows.append(dict(zip(header, line.split("\t"), strict=True)))
    return rows


class PageReader(html.parser.HTMLParser):
    """Checks that all elements are closed in order, and collects figures, identifiers and links."""
    VOID = {"meta", "img", "br", "link", "wbr", "input"}

    def __init__(self, text):
        super().__init__()
        self.open, self.pictures, self.links, self.problems = [], [], [], []
        self.ids, self.figures, self.headings = [], [], []
        self.feed(text)
        self.close()
        self.problems += [f"<{tag}> is not closed" for tag in self.open]

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in self.VOID:
            self.open.append(tag)
        if tag == "svg":
            self.pictures.append(attributes)
        if tag == "figure":
            self.figures.append(attributes["id"])
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        if tag == "a":
            self.links.append(attributes["href"])
        if "id" in attributes:
            self.ids.append(attributes["id"])

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> closes nothing")


def written_before():
    """The folder of the report of all sections that CTest writes before the tests that read it; None without CTest. Each value of
    GLIBC_TUNABLES, which may switch instruction sets off, has its own folder."""
    folder = os.environ.get("TRIBOCHECK_WRITTEN_REPORT")
    return folder and pathlib.Path(folder + os.environ.get("GLIBC_TUNABLES", ""))


def write(folder, sections=()):
    out = folder / "it's here"  # gnuplot must cope with the quote
    return out, report("--out", out, *(f"--section={one}" for one in sections))


@functools.cache
def written(sections):
    """The folder of a report of these sections, and how the program ended. Made once for all tests of a process."""
    folder = written_before()
    if folder and not sections:
        out, *ended = json.loads((folder / "ended.json").read_text())
        return pathlib.Path(out), Result(*ended)
    own = tempfile.TemporaryDirectory()
    atexit.register(own.cleanup)
    return write(pathlib.Path(own.name), sections)


class WrittenReport(unittest.TestCase):
    """A report for all tests that only read it, and a folder for what they write."""
    sections = ()  # empty: all sections

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out, cls.done = cls.written()
        cls.told = json.loads((cls.out / "report.json").read_text())
        cls.text = (cls.out / "report.md").read_text()

    @classmethod
    def written(cls):
        return written(cls.sections)


def project_copy(folder, *parts):
    """A project of its own: the scripts of the page, and these parts of reference/."""
    project = pathlib.Path(folder) / "project"
    for part in (*(f"reference/{one}" for one in parts), *(f"reports/page/{one}" for one in ("gnuplot", "groups", "render"))):
        shutil.copytree(ROOT / part, project / part)
    return project


if __name__ == "__main__":
    shutil.rmtree(written_before(), ignore_errors=True)
    written_before().mkdir(parents=True)
    place, ended = write(written_before())
    (written_before() / "ended.json").write_text(json.dumps([str(place), ended.code, ended.out, ended.said]))
    sys.exit(ended.code)
