# SPDX-License-Identifier: Apache-2.0
"""tribocheck profile: the line of a plug-in, a program and a Python solver on which the time goes."""

import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import ENVIRONMENT, PROGRAM, ProgramTest, run, start

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])

C_PLUGIN = """#include <math.h>
#include <string.h>
#include <tribocheck_plugin.h>
int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
static double quick(double d) { return 1 / (1 + d * d); }
static double slow(double d) {
  double sum = 0;
  for (int i = 0; i < 200; ++i)
    sum += exp(-0.5 * (d + 0.01 * i) * (d + 0.01 * i)); /* the slow line */
  return sum;
}
int tribocheck_function(const char* name, size_t count, const double* const* argument, double* const* result, int* status) {
  const int is_moment = strcmp(name, "gaussian_moment") == 0;
  if (!is_moment && strcmp(name, "barus_viscosity") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    result[0][i] = is_moment ? slow(argument[1][i]) : quick(argument[0][i]);
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
"""

# A line of JSON in, a line out: so little of the protocol is enough.
C_PROGRAM = """#include <math.h>
#include <stdio.h>
#include <string.h>
static double slow(int n) {
  double sum = 0;
  for (int i = 0; i < 2000; ++i) sum += sqrt(i + n) / (1 + i); /* the slow line */
  return sum;
}
int main(void) {
  static char line[1 << 16];
  while (fgets(line, sizeof line, stdin)) {
    char id[64] = "";
    sscanf(strstr(line, "\\"id\\":") + 5, "\\"%63[^\\"]", id);
    if (strstr(line, "\\"gaussian_moment\\"")) printf("{\\"id\\": \\"%s\\", \\"value\\": %.17g}\\n", id, slow(id[1]));
    else printf("{\\"id\\": \\"%s\\", \\"skip\\": \\"no\\"}\\n", id);
    fflush(stdout);
  }
  return 0;
}
"""

# A library that calls back into the solver.
C_CALLBACK = """#include <stdlib.h>
#include <string.h>
#include <tribocheck_plugin.h>
int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
static int compare(const void* a, const void* b) {
  double x = *(const double*)a - *(const double*)b;
  for (int i = 0; i < 50; ++i) x = x * 1.0001 + x / 3; /* the slow line */
  return x > 0 ? 1 : -1;
}
int tribocheck_function(const char* name, size_t count, const double* const* argument, double* const* result, int* status) {
  double list[64];
  if (strcmp(name, "gaussian_moment") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 64; ++k) list[k] = argument[1][i] * ((k * 37) % 64);
    qsort(list, 64, sizeof *list, compare); /* the line that calls */
    result[0][i] = list[0];
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
"""

PYTHON = """import json
import math
import sys

def quick(d):
    return 1 / (1 + d * d)

def slow(d):
    return sum(math.exp(-0.5 * (d + 0.01 * i) ** 2) for i in range(400))

for line in sys.stdin:
    asked = json.loads(line)
    answer = {"id": asked["id"], "skip": "no"}
    if asked.get("function") == "gaussian_moment":
        answer = {"id": asked["id"], "value": slow(asked["argument"]) + quick(asked["argument"])}
    print(json.dumps(answer), flush=True)
"""

# This script stands in for perf, which many systems do not let everybody use. It runs the command, and has four samples: in the
# solver's function slow; in the C library, called by slow; in tribocheck, called by slow; in a library that the solver did not call.
PERF = """#!/bin/sh
case "$1" in
--version) echo 'perf version 6.1.187';;
record) while [ "$1" != -o ]; do shift; done; echo recorded > "$2"; shift 3; exec "$@";;
script) [ "$(cat "$3")" = recorded ] || exit 1
  printf ' %s \\n\\t %s slow (%s)\\n\\t 12 main (%s)\\n\\n' 1000000 ADDRESS SOLVER HOST
  printf ' %s \\n\\t 6ec exp@@GLIBC_2.29 (/usr/lib/x86_64-linux-gnu/libm.so.6)\\n\\t %s slow (%s)\\n\\n' 2000000 ADDRESS SOLVER
  printf ' %s \\n\\t 12 read(a (b)) (%s)\\n\\t %s slow (%s)\\n\\n' 4000000 HOST ADDRESS SOLVER
  printf ' %s \\n\\t 12 [unknown] ([unknown])\\n\\n' 8000000;;
esac
"""


def line_of(text, part):
    return 1 + next(i for i, line in enumerate(text.splitlines()) if part in line)


class Profile(ProgramTest):
    def profile(self, *words, code=0, **more):
        done = run("profile", *words, "--seconds", "0.2", **more)
        self.assertEqual(done.code, code, done.err)
        return done

    def document(self, *words, **more):
        done = self.profile(*words, "--format", "json", **more)
        self.assertEqual(done.err, "")
        return done.json()

    def compiled(self, source, *options, name="solver"):
        self.source = self.folder.write("solver.c", source)
        path = self.folder.path(name)
        subprocess.run(["cc", *options, "-I", ROOT / "verification/conformance", self.source, "-o", path, "-lm"], check=True)
        return path

    def plugin(self, *options):
        return self.compiled(C_PLUGIN, "-O1", "-shared", "-fPIC", *options, name="libsolver.so")

    def python(self, text=PYTHON):
        return "python3 " + self.folder.write("my_solver.py", text)

    def refused(self, *words, said, **more):
        done = self.profile(*words, code=2, **more)
        self.assertEqual((done.out, len(done.error_lines)), ("", 1), done.err)
        self.assertIn(said, done.err)

    def test_a_plugin_has_its_slow_line_on_top(self):
        library = self.plugin("-g")
        one = self.document("--plugin", library)
        top = one["lines"][0]
        self.assertEqual((top["file"], top["line"]), (self.source, line_of(C_PLUGIN, "the slow line")))
        self.assertGreater(top["share"], 0.8)
        self.assertEqual(one["functions"], ["gaussian_moment", "barus_viscosity"])
        self.assertTrue(one["tool"].startswith("callgrind "))
        self.assertGreaterEqual(one["answers"], 40)
        self.assertEqual({line["file"] for line in one["lines"]} - {self.source, library}, set())
        self.assertAlmostEqual(sum(line["cost"] for line in one["lines"]), one["total"], delta=1e-6 * one["total"])

    def test_a_table_shows_the_line_itself_and_says_what_measured(self):
        out = self.profile("--plugin", self.plugin("-g"), "--function", "gaussian_moment").out
        self.assertRegex(out.splitlines()[2], rf"solver\.c:{line_of(C_PLUGIN, 'the slow line')} .* sum \+= exp")
        self.assertRegex(out, r"measured by callgrind [\d.]+ in [\d\u202f ]+ answers of gaussian_moment\n")
        self.assertNotIn("barus", out)

    def test_one_function_alone(self):
        one = self.document("--plugin", self.plugin("-g"), "--function", "barus_viscosity")
        self.assertEqual(one["functions"], ["barus_viscosity"])
        slow = line_of(C_PLUGIN, "the slow line")
        self.assertNotIn(slow, [line["line"] for line in one["lines"]])

    def test_what_a_library_calls_back_is_at_its_own_line_and_counted_once(self):
        one = self.document("--plugin", self.compiled(C_CALLBACK, "-O1", "-g", "-shared", "-fPIC", name="libsolver.so"))
        shares = {line["line"]: line["share"] for line in one["lines"]}
        self.assertEqual(one["lines"][0]["line"], line_of(C_CALLBACK, "the slow line"))
        self.assertGreater(one["lines"][0]["share"], 0.7)
        self.assertGreater(shares[line_of(C_CALLBACK, "the line that calls")], 0.005)
        self.assertAlmostEqual(sum(line["share"] for line in one["lines"]), 1, delta=1e-3)  # the document has the first 20 lines

    def test_without_line_numbers_it_names_functions_and_says_how_to_get_them(self):
        library = self.plugin("-fno-inline")
        one = self.document("--plugin", library)
        self.assertEqual((one["lines"][0]["function"], one["lines"][0]["line"], one["lines"][0]["file"]), ("slow", None, library))
        self.assertIn("build it with -g", self.profile("--plugin", library).out)

    def test_a_compiled_program(self):
        program = self.compiled(C_PROGRAM, "-O1", "-g")
        for command in (program, f"SOME=thing {program} an_argument", f"exec env {program}", f"env SOME=thing {program}"):
            one = self.document("--subject", command)
            self.assertEqual((one["lines"][0]["file"], one["lines"][0]["line"]), (self.source, line_of(C_PROGRAM, "the slow line")))
            self.assertGreater(one["lines"][0]["share"], 0.5)

    def test_a_python_solver_has_its_slow_function_on_top(self):
        command = self.python()
        one = self.document("--subject", command)
        lines = {line["function"]: line for line in one["lines"]}
        self.assertEqual(one["unit"], "s")
        self.assertIn(one["lines"][0]["function"], ("<genexpr>", "slow"))
        self.assertIn(one["lines"][0]["line"], (line_of(PYTHON, "def slow"), line_of(PYTHON, "sum(math")))
        self.assertGreater(lines["slow"]["share"] + lines["<genexpr>"]["share"], 0.8)
        self.assertLess(lines["quick"]["share"], 0.1)
        self.assertEqual({line["file"] for line in one["lines"]}, {command.split()[1]})
        self.assertEqual(lines["slow"]["calls"], one["answers"])
        longer = run("profile", "--subject", command, "--seconds", "1", "--format", "json").json()  # five times as long
        self.assertGreater(longer["answers"], one["answers"])

    def test_a_python_module_and_options_of_python(self):
        self.python()
        for command in ("python3 -B -m my_solver", "python3 -W ignore -B my_solver.py", "LANG=C python3 -B my_solver.py"):
            done = self.profile("--subject", command, "--format", "json", cwd=self.folder.name)
            self.assertIn(done.json()["lines"][0]["function"], ("<genexpr>", "slow"), command)

    def test_a_script_that_is_executable(self):
        path = pathlib.Path(self.folder.write("solver", "#!/usr/bin/env python3\n" + PYTHON))
        path.chmod(0o755)
        self.assertEqual(self.document("--subject", str(path))["tool"], "cProfile")

    def test_a_solver_that_answers_at_the_end_of_its_input(self):
        text = PYTHON.replace("for line in sys.stdin:", "for line in sys.stdin.readlines():").replace(", flush=True", "")
        one = self.document("--subject", self.python(text), "--start-timeout", "20", "--function", "gaussian_moment",
                            environment={"PYTHONUNBUFFERED": ""})
        self.assertIn(one["lines"][0]["function"], ("<genexpr>", "slow"))

    def test_the_file_of_the_tool_is_kept_where_it_is_asked(self):
        kept = self.folder.path("kept")
        before = set(pathlib.Path(tempfile.gettempdir()).glob("tribocheck-??????"))
        one = self.document("--plugin", self.plugin("-g"), "--out", kept)
        self.assertEqual(one["raw_file"], os.path.join(kept, "callgrind.out"))
        self.assertIn("events: Ir", pathlib.Path(one["raw_file"]).read_text(encoding="utf-8"))
        done = self.profile("--subject", self.python(), "--out", kept)
        self.assertIn("profile.pstats: for python3 -m pstats", done.out)
        self.assertIsNone(self.document("--subject", self.python())["raw_file"])
        self.assertEqual(set(pathlib.Path(tempfile.gettempdir()).glob("tribocheck-??????")), before)

    def test_a_picture_of_the_shares(self):
        library = self.plugin("-g")
        for name in ("shares.svg", "shares.png"):
            picture = pathlib.Path(self.folder.path(name))
            done = self.profile("--plugin", library, "--picture", picture)
            self.assertEqual(done.err, f"tribocheck: drew {picture}\n")
            self.assertGreater(picture.stat().st_size, 3000)
        self.assertIn(f"solver.c:{line_of(C_PLUGIN, 'the slow line')}", pathlib.Path(self.folder.path("shares.svg")).read_text(encoding="utf-8"))
        self.refused("--plugin", library, "--picture", "a.gif", said="ends in .png or .svg")

    def test_what_cannot_be_measured_is_one_line(self):
        python = self.python()
        library = self.plugin("-g")
        self.refused(said="--plugin LIB")
        self.refused("--plugin", "no.so", said="there is no file no.so")
        self.refused("--subject", "no_such_program", said="no program no_such_program")
        self.refused("--subject", python + " | cat", said="only the shell can read this")
        self.refused("--subject", "octave-cli --version" if shutil.which("octave-cli") else "sh solver", said="the work of")
        self.refused("--subject", "python3 -c 'pass'", said="a script or a module")
        for command in ("env", "env A=1", "A=1", "exec"):
            self.refused("--subject", command, said="it names no program")
        self.refused("--subject", "env -i ./solver", said="-i stands in place of a program; allowed in front of one: env")
        versioned = pathlib.Path(self.folder.path("lua5.4"))
        versioned.symlink_to("/bin/true")
        self.refused("--subject", f"{versioned} solver.lua", said="the work of lua5.4 would be shown")
        self.refused("--plugin", library, "--function", "gausian_moment", said="did you mean gaussian_moment?")
        self.refused("--plugin", library, "--function", "hertz_point", said="does not offer hertz_point")
        self.refused("--subject", self.python(PYTHON.replace('"gaussian_moment"', '"no"')), said="offers nothing")

    def test_a_function_that_is_offered_in_part_is_measured_in_that_part(self):
        text = PYTHON.replace('== "gaussian_moment":', '== "gaussian_moment" and asked["order"] == 2.5:')
        profile = self.document("--subject", self.python(text), "--function", "gaussian_moment")
        self.assertEqual(profile["functions"], ["gaussian_moment"])
        self.assertIn(profile["lines"][0]["function"], ("<genexpr>", "slow"))

    def test_a_missing_valgrind_is_one_line(self):
        library = self.plugin("-g")
        nothing = {"PATH": self.folder.name}
        self.refused("--plugin", library, environment=nothing, said="apt-get install valgrind")
        self.refused("--plugin", library, "--tool", "perf", environment=nothing, said="apt-get install linux-perf")
        self.refused("--subject", self.python(), "--tool", "perf", said="--tool: perf measures what is compiled")
        self.refused("--plugin", library, "--tool", "gprof", said="--tool")

    def with_perf(self, library, text=PERF):
        """A PATH without valgrind, but with the stand-in for perf, whose samples are in the library's function slow."""
        symbols = subprocess.run(["nm", library], capture_output=True, text=True, check=True).stdout
        address = next(line.split()[0] for line in symbols.splitlines() if line.endswith(" slow"))
        for old, new in (("ADDRESS", address), ("SOLVER", library), ("HOST", os.path.realpath(PROGRAM))):
            text = text.replace(old, new)
        folder = pathlib.Path(self.folder.path("tools"))
        folder.mkdir(exist_ok=True)
        (folder / "perf").write_text(text, encoding="utf-8")
        (folder / "perf").chmod(0o755)
        for tool in ("cat", "addr2line"):
            if not (folder / tool).exists():
                (folder / tool).symlink_to(shutil.which(tool))
        return {"PATH": str(folder)}

    def test_perf_has_the_time_of_lines_with_that_of_the_libraries_which_they_call(self):
        library = self.plugin("-g", "-fno-inline")
        place = self.with_perf(library)
        for words in ([], ["--tool", "perf"]):  # valgrind is missing, or perf is asked for
            environment = place if not words else {"PATH": place["PATH"] + ":" + os.environ["PATH"]}
            one = self.document("--plugin", library, *words, environment=environment)
            self.assertEqual((one["tool"], one["unit"]), ("perf 6.1.187", "s"))
            line, = one["lines"]
            self.assertEqual((line["file"], line["function"], line["line"]), (self.source, "slow", line_of(C_PLUGIN, "double slow")))
            self.assertEqual(line["calls"], None)
            self.assertAlmostEqual(line["cost"], 0.003, delta=1e-12)
        out = self.profile("--plugin", library, "--tool", "perf", "--out", self.folder.path("kept"), environment=environment).out
        self.assertIn("the time of libraries belongs to the line that calls them", out)
        self.assertIn("perf.data: for perf report -i", out)

    def test_a_recording_that_perf_cannot_read_is_told(self):
        library = self.plugin("-g", "-fno-inline")
        for text, said in ((PERF.replace("recorded ]", "else ]"), "perf cannot read it"),
                           (PERF.replace("printf", ": printf"), "it has no samples of perf"),
                           (PERF.replace("1000000 ADDRESS SOLVER", "1000000 ADDRESS /no/solver"), "cannot read /no/solver")):
            done = self.profile("--plugin", library, "--tool", "perf", code=2, environment=self.with_perf(library, text))
            self.assertEqual((done.out, done.error_lines[-1].count(said)), ("", 1), done.err)

    def test_a_solver_that_fails_is_told_with_its_last_words(self):
        text = PYTHON.replace("    print(", "    if 'count' not in globals(): count = 0\n    count += 1\n    if count > 50: raise SystemError('no more')\n    print(")
        done = self.profile("--subject", self.python(text), "--function", "gaussian_moment", code=1)
        self.assertEqual(done.out, "")
        self.assertIn("under cProfile exits with code 1 before its input ends", done.error_lines[0])
        self.assertIn("no more", done.err)

    def test_ctrl_c_ends_it_with_all_that_it_has_started(self):
        library = self.plugin("-g")
        before = set(pathlib.Path(tempfile.gettempdir()).glob("tribocheck-??????"))
        with start("profile", "--plugin", library, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            end = time.monotonic() + 60
            folders = set()
            while not folders and time.monotonic() < end:
                folders = set(pathlib.Path(tempfile.gettempdir()).glob("tribocheck-??????")) - before
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(20), 128 + signal.SIGINT)
        self.assertEqual([folder for folder in folders if folder.exists()], [])
        running = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout
        self.assertNotIn(library, running)


if __name__ == "__main__":
    unittest.main()
