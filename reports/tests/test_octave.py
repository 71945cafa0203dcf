# SPDX-License-Identifier: Apache-2.0
"""The functions of the catalogue in Octave, and tribocheck_check(); skipped where Octave or its headers are not installed."""
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import textwrap
import unittest

from conformance import subject, verify
from program import ENVIRONMENT, PROGRAM, TIMEOUT, run

BINDINGS = pathlib.Path(PROGRAM).resolve().parent / "reports/bindings"
FOLDER = BINDINGS / "octave/tribocheck"
MISSING = None if shutil.which("octave-cli") and (FOLDER / "private/library.mex").exists() else "not installed (Debian: octave-dev)"
CATALOGUE = run("functions", "--format", "json").json()["functions"]
FILM = textwrap.dedent("""
    function h = film (u, eta, alpha, F, E, R, k)
      U = eta .* u ./ (2 * E .* R);
      h = 2.69 * R .* U .^ 0.67 .* (2 * alpha .* E) .^ 0.53 .* (F ./ (2 * E .* R .^ 2)) .^ -0.067 .* (1 - 0.61 * exp (-0.73 * k));
    end
    function told (varargin)
      try
        found = feval (varargin{:});
        printf ("%s\\n", regexprep (disp (found), '\\s+', ' '));
      catch problem
        printf ("ERROR %s\\n", problem.message);
      end
    end
    """)


def ran(code, folder=FOLDER, **environment):
    """The output of a script."""
    with tempfile.NamedTemporaryFile("w", suffix=".m") as file:
        file.write(f"addpath ('{folder}');\n" + FILM + textwrap.dedent(code))
        file.flush()
        done = subprocess.run(["octave-cli", "--norc", "--quiet", "--no-history", file.name], capture_output=True, text=True, timeout=TIMEOUT,
                              env=ENVIRONMENT | environment)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def literal(value):
    return f"'{value}'" if isinstance(value, str) else repr(value)


def column(values):
    return f"{{{'; '.join(map(literal, values))}}}" if isinstance(values[0], str) else f"[{'; '.join(map(literal, values))}]"


@unittest.skipIf(MISSING, MISSING)
class Functions(unittest.TestCase):
    def test_each_certified_case_has_the_bits_of_the_program(self):
        asked = [one for one in map(json.loads, run("verify", "--save-cases", "-").out.splitlines()) if "function" in one]
        answers = run("stream", stdin="".join(json.dumps(one) + "\n" for one in asked)).json_lines()
        code, expected = "", []
        for entry in CATALOGUE:
            mine = [(one, answer) for one, answer in zip(asked, answers, strict=True) if one["function"] == entry["name"]]
            self.assertGreater(len(mine), 3)
            columns = [column([one.get(parameter["name"], parameter.get("default")) for one, _ in mine]) for parameter in entry["parameters"]]
            code += f"found = tribocheck_{entry['name']} ({', '.join(columns)});\n"
            for result in entry["results"]:
                code += f"printf ('%.17g\\n', found{'.' + result['name'] if len(entry['results']) > 1 else ''});\n"
                expected += [math.inf if answer[result["name"]] is None else answer[result["name"]] for _, answer in mine]
        self.assertEqual([float(line) for line in ran(code).split()], expected)

    def test_help_has_units_ranges_words_results_and_the_example(self):
        for entry in CATALOGUE:
            text = (FOLDER / f"tribocheck_{entry['name']}.m").read_text()
            for words in [entry["meaning"][1:], entry["source"], *(one["meaning"] for one in [*entry["parameters"], *entry["results"]])]:
                self.assertIn(words, text)
        text = ran("help tribocheck_hertz_ellipse\nhelp tribocheck_nijenbanning_venner_moes\nhelp tribocheck_check")
        for words in ["tribocheck_hertz_ellipse (load, effective_modulus, radius_x, radius_y)\n", "load                    N       F\n",
                      "a number above 0; usual: 0.001 to 1e+06", "peak_pressure           Pa ",
                      "one of ei_over_ri, ei_over_ep; default 'ei_over_ri'", 'tribocheck_check (@my_film, "hamrock_dowson_central")']:
            self.assertIn(words, text)
        text = ran("help tribocheck")
        for entry in CATALOGUE:
            self.assertRegex(text, rf"tribocheck_{entry['name']} +{re.escape(entry['meaning'])}\n")
        self.assertIn("help tribocheck_check", text)
        self.assertAlmostEqual(float(ran(re.search(r"contact = .*", text)[0] + "\nprintf ('%.17g', contact.radius);")),
                               float(re.search(r"% (\d\S+)", text)[1]), delta=5e-9)
        examples = re.findall(r"^% +(tribocheck_\w+ \(.*\))\nfunction", "".join(path.read_text() for path in FOLDER.glob("*.m")), re.MULTILINE)
        self.assertEqual(len(examples), len(CATALOGUE))
        ran(";\n".join(examples))

    def test_arrays_of_any_kind_and_shape_give_the_same_bits(self):
        self.assertEqual(ran("""
            h = @tribocheck_gaussian_moment;
            d = linspace (-9, 9, 70001);
            whole = h (1.5, d);
            assert (size (whole), size (d));
            assert (arrayfun (@(x) h (1.5, x), d(1:970:end)), whole(1:970:end));
            wide = h ([0.5; 1.5], d);
            assert (wide(2, :), whole);
            assert (size (h (ones (2, 1, 3), ones (1, 4))), [2, 4, 3]);
            assert (h (single (1), single (0.5)), h (1, 0.5));
            assert (h (int8 (2), uint16 ([1; 2])), h (2, [1; 2]));
            assert (h (1, sparse ([0, 3])), h (1, [0, 3]));
            assert (h (1, 1:3), h (1, [1, 2, 3]));
            assert (h (1, eye (2)), h (1, [1, 0; 0, 1]));
            assert (size (h (1, zeros (0, 3))), [0, 3]);
            assert (size (h ([], [])), [0, 0]);
            assert (size (h (ones (2, 1), zeros (2, 0))), [2, 0]);
            words = tribocheck_load_sharing ({"greenwood_tripp", "greenwood_williamson"}, 0.5, 20, 1.1);
            assert (words(2), tribocheck_load_sharing ("greenwood_williamson", 0.5, 20, 1.1));
            assert (tribocheck_barus_viscosity (0.1, 2e-8, 1e12), Inf);
            disp ("same");"""), "same\n")

    def test_wrong_arguments_are_one_sentence_each(self):
        wrong = [("hertz_point', 50, [1e11, -1, 2], 1", "at index 2: effective_modulus: -1 is not allowed; allowed: a number above 0, in Pa"),
                 ("hertz_point', [1, 2; NaN, 1], 1, 1", "at index (2, 1): load: nan is not allowed"),
                 ("hertz_point', [ones(1, 1e5), Inf], 1, 1", "at index 100001: load: inf is not allowed"),
                 ("hertz_point', -1, 1, 1", "load: -1 is not allowed"),
                 ("hertz_point', ones (1, 3), ones (1, 4), 1", "shapes that do not go together: load 1x3, effective_modulus 1x4"),
                 ("hertz_point', zeros (0, 3), ones (2, 3), 1", "shapes that do not go together: load 0x3, effective_modulus 2x3"),
                 ("hertz_point', 1 + 2i, 1, 1", "load is complex double, in place of real numbers"),
                 ("hertz_point', single (2i), 1, 1", "load is complex single, in place of real numbers"),
                 ("hertz_point', sparse (2i), 1, 1", "load is complex double, in place of real numbers"),
                 ("hertz_point', {1}, 1, 1", "load is cell, in place of real numbers"),
                 ("hertz_point', true, 1, 1", "load is logical, in place of real numbers"),
                 ("hertz_point', '1', 1, 1", "load is char, in place of real numbers"),
                 ("hertz_point', struct (), 1, 1", "load is struct, in place of real numbers"),
                 ("hertz_point', @sin, 1, 1", "load is function_handle, in place of real numbers"),
                 ("hertz_point', 1, 1", "reduced_radius is missing"),
                 ("hertz_point', 1, 1, 1, 1", "too many arguments; it takes load, effective_modulus, reduced_radius"),
                 ("reduced_radius', 5e-3, -4e-3, 5e-3, 5e-3", "first_radius_x: "),
                 ("load_sharing', 'tripp', 1, 1, 1", 'asperity: "tripp" is not known; allowed: greenwood_tripp, greenwood_williamson'),
                 ("load_sharing', 0, 1, 1, 1", "asperity is no text, nor a cell of texts"),
                 ("load_sharing', {1}, 1, 1, 1", "asperity is no text, nor a cell of texts")]
        lines = ran("\n".join(f"told ('tribocheck_{one});" for one, _ in wrong)).splitlines()
        for line, (one, words) in zip(lines, wrong, strict=True):
            expected = f"ERROR tribocheck_{one.split(chr(39))[0]}: {words}"
            self.assertEqual(line[:len(expected)], expected, one)

    def test_nothing_leaks(self):
        grown = int(ran("""
            function kib = most ()
              kib = str2double (regexp (fileread ("/proc/self/status"), 'VmHWM:\\s*(\\d+)', 'tokens', 'once'){1});
            end
            x = linspace (1, 2, 10000);
            function once (x)
              tribocheck_hertz_point (x, 1e11, 0.01);
              tribocheck_gaussian_moment ([0.5; 1], x);
              for wrong = {-x, x(1:3), {1}}
                try
                  tribocheck_hertz_point (wrong{1}, x, 1);
                end
              end
            end
            for k = 1:20 once (x); end
            before = most ();
            for k = 1:150 once (x); end
            disp (most () - before)"""))
        self.assertLess(grown, 4000)  # KiB; one array of each round would be 12000


@unittest.skipIf(MISSING, MISSING)
class Check(unittest.TestCase):
    def judged(self, *expressions, start=""):
        """Returns for each expression what tribocheck_check tells: the verdict in one line, or the error."""
        code = start + "".join(f"told ('tribocheck_check', {one});\ndisp ('----');\n" for one in expressions)
        return ran(code).split("----\n")[:-1]

    def test_a_right_function_holds(self):
        expressions = [
            "@film, 'hamrock_dowson_central'", "struct ('hamrock_dowson_central', @film)",
            "@one_by_one, 'hamrock_dowson_central'", "@branch, 'gaussian_moment', 'sample', 20",
            "@outputs, 'hertz_point'", "@tribocheck_hertz_point, 'hertz_point', 'tolerance', 'strict'",
            "@tribocheck_gaussian_moment, 'gaussian_moment', 'tolerance', 'strict'", "@tribocheck_starvation_ratio, 'starvation_ratio'",
            "@(q) tribocheck_hertz_point (q.load, q.effective_modulus, q.reduced_radius), 'hertz_point', 'arguments', 'struct'",
            "@(E, R, F) tribocheck_hertz_point (F, E, R), 'hertz_point', 'arguments', {'effective_modulus', 'reduced_radius', 'load'}",
            "@(F, a, b, c, d, R) tribocheck_hertz_point (F, tribocheck_effective_modulus (a, b, c, d), R), 'hertz_point', 'modulus', 'bodies', "
            "'arguments', {'load', 'first_modulus', 'first_poisson_ratio', 'second_modulus', 'second_poisson_ratio', 'reduced_radius'}",
            "@(u, eta, varargin) 1e9 * film (u, eta / 1000, varargin{:}), 'hamrock_dowson_central', 'units', struct ('viscosity', 'mPa s', 'value', 'nm')",
            "@(u, eta, alpha, F, E, R, k) film (u, eta, alpha, F, E / 2, R, k), 'hamrock_dowson_central', 'modulus', \"E'\""]
        start = textwrap.dedent("""
            function h = one_by_one (u, eta, alpha, F, E, R, k)
              h = film (u * eta / eta * R / R, eta, alpha, F, E, R, k);
            end
            function m = branch (order, d)
              m = tribocheck_gaussian_moment (order, d);
              if (d < 0) m = m + 0; else m = m * numel (d); endif
            end
            function [a, mean_pressure, peak] = outputs (varargin)
              c = tribocheck_hertz_point (varargin{:});
              a = c.radius; mean_pressure = c.mean_pressure; peak = c.peak_pressure;
            end
            """)
        for expression, text in zip(expressions, self.judged(*expressions, start=start), strict=True):
            with self.subTest(expression=expression):
                count = "3 of 4" if "outputs" in expression else r"(\d+) of \1"
                self.assertRegex(text, rf"{count} quantities held")
                self.assertNotIn("ERROR", text)

    def test_a_fake_is_told_with_its_worst_case_and_the_cause_that_verify_names(self):
        film, modulus, line = "hamrock_dowson_central", "effective_modulus", "hertz_line"
        point, ellipse = "hertz_point", "hertz_ellipse"
        fakes = {"none": (film, "@film"), "film_half_radius": (film, "@(u, eta, alpha, F, E, R, k) film (u, eta, alpha, F, E, R / 2, k)"),
                 "film_speed_sum": (film, "@(u, varargin) film (2 * u, varargin{:})"),
                 "bodies_modulus_doubled": (modulus, "@(varargin) 2 * tribocheck_effective_modulus (varargin{:})"),
                 "bodies_modulus_without_poisson": (modulus, "@(E, m, F, n) tribocheck_effective_modulus (E, 0, F, 0)"),
                 "bodies_modulus_one_poisson": (modulus, "@(E, m, F, n) tribocheck_effective_modulus (E, m, F, m)"),
                 "bodies_modulus_of_first": (modulus, "@(E, m, F, n) E ./ (1 - m .^ 2)"),
                 "hertz_modulus_doubled": (point, "@(F, E, R) tribocheck_hertz_point (F, 2 * E, R)"),
                 "hertz_half_radius": (point, "@(F, E, R) tribocheck_hertz_point (F, E, R / 2)"),
                 "hertz_radius_in_mm": (point, "@(F, E, R) tribocheck_hertz_point (F, E, 1000 * R)"),
                 "ellipse_modulus_doubled": (ellipse, "@(F, E, x, y) tribocheck_hertz_ellipse (F, 2 * E, x, y)"),
                 "ellipse_as_circle": (ellipse, "@(F, E, x, y) tribocheck_hertz_ellipse (F, E, 2 ./ (1 ./ x + 1 ./ y), 2 ./ (1 ./ x + 1 ./ y))"),
                 "line_modulus_doubled": (line, "@(w, E, R) tribocheck_hertz_line (w, 2 * E, R)"),
                 "line_load_per_millimetre": (line, "@(w, E, R) tribocheck_hertz_line (w / 1000, E, R)")}
        found = self.judged(*(f"{one}, '{function}'" for function, one in fakes.values()))
        for (mistake, (function, _)), text in zip(fakes.items(), found, strict=True):
            with self.subTest(mistake=mistake):
                expected = verify("--subject", subject("fakes/fake.py", "--mistake", mistake, "--only", function))
                self.assertEqual(text.startswith("ERROR"), expected.code != 0 and mistake != "none")
                causes = [one["text"] for one in expected.json()["diagnoses"]]
                self.assertEqual(re.findall(r"Diagnosis: (.*)", text), causes)
                self.assertEqual(f"Worst of {function}" in text, mistake != "none")

    def test_answers_that_are_none_are_told(self):
        answers = {"NaN": "got null, expected", "'x'": 'got "x", expected', "1 + 2i": 'got "1+2i", expected', "error ('no root')": "got nothing (no root)",
                   "[1, 2, 3]": "value is double of the size [1 3], in place of a number", "{1}": "value is cell of the size [1 1]",
                   "struct ('colour', 1)": 'has a field "colour", which is no result of it', "[]": "Not offered: pull_off_force (it gives [])",
                   "Inf": 'got "Infinity", expected'}
        for answer, text in zip(answers, self.judged(*(f"@(varargin) {one}, 'pull_off_force'" for one in answers)), strict=True):
            with self.subTest(answer=answer):
                self.assertTrue(text.startswith("ERROR"), text)
                self.assertIn(answers[answer], text)
        text, = self.judged("@(varargin) 1, 'hertz_point'")
        self.assertIn("it gives double, in place of a struct with radius, mean_pressure, peak_pressure, approach", text)

    def test_operating_points_are_structs(self):
        text, = self.judged("struct ('operating_point', @(q) struct ('film', NaN, 'regime', 'mixed', 'friction', q.load)), 'sample', 9")
        for words in ["operating_point.film ", "got null, expected", "operating_point.regime ", "operating_point.friction "]:
            self.assertIn(words, text)

    def test_what_keeps_something_between_calls_is_told(self):
        text, = self.judged("@keeping, 'pull_off_force'", start="function f = keeping (varargin)\n  persistent calls = 0;\n  calls += 1;\n  f = tribocheck_pull_off_force (varargin{:}) * (1 + calls);\nend\n")
        self.assertIn("Asked the same again", text)

    def test_a_bad_question_is_one_sentence(self):
        questions = {"@sin, 'hertz'": 'no function is called "hertz"', "@sin": "a function is wanted, and its name in the catalogue",
                     "3, 'hertz_point'": "a function is wanted, and its name in the catalogue",
                     "@sin, 'hertz_point', 'colour', 1": "argument 3 is no option; allowed: tolerance, ", "@sin, 'hertz_point', 'sample'": "sample has no value",
                     "@sin, 'hertz_point', 'tolerance', 'loose'": 'tolerance: "loose" is no file that can be read; allowed: engineering', "@sin, 'hertz_point', 'tolerance', 3": "tolerance: 3 is not allowed; allowed: a text",
                     "@sin, 'hertz_point', 'units', struct ('load', 'mm')": 'units: "mm" is no unit of load; allowed: N, or another',
                     "@sin, 'hertz_point', 'units', struct ('force', 'N')": 'units: "force" is no argument or result of hertz_point; allowed: ',
                     "@sin, 'hertz_point', 'units', 'mN'": 'units: a struct is wanted',
                     "@sin, 'hertz_point', 'modulus', 'bodies'": 'effective_modulus is no argument of the question; "arguments" has the names'}
        for expression, text in zip(questions, self.judged(*questions), strict=True):
            self.assertRegex(text, r"\AERROR tribocheck_check: [^\n]+\n\Z")
            self.assertIn(questions[expression], text)


@unittest.skipIf(MISSING, MISSING)
class Readme(unittest.TestCase):
    def test_the_example_prints_what_it_says(self):
        readme = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"], "reports/bindings/README.md").read_text()
        example = re.search(r"```octave\n(.*?)```", readme, re.DOTALL)[1].replace("@my_film", "@film")
        found = ran(example)
        for expected in re.findall(r"% (\S+)$", example, re.MULTILINE):
            self.assertRegex(found, rf"(?m)(^|= ){expected}$")
        self.assertIn("COMPLETE: 1 of 1", found)


@unittest.skipIf(MISSING, MISSING)
class Installed(unittest.TestCase):
    def test_its_folder_is_whole_and_its_library_is_that_of_its_prefix(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", BINDINGS.parents[1], "--component", "octave", "--prefix", prefix], check=True, capture_output=True,
                           timeout=TIMEOUT)
            mex, = pathlib.Path(prefix).glob("**/octave/site/oct/*/tribocheck/private/library.mex")
            needed = subprocess.run(["readelf", "-d", mex], capture_output=True, text=True, check=True).stdout
            path, = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", needed)
            place = os.path.relpath(os.path.normpath(path.replace("$ORIGIN", str(mex.parent))), prefix)
            self.assertRegex(place, r"^lib(/x86_64-linux-gnu)?$")
            self.assertEqual(re.findall(r"NEEDED.*\[(.*)\]", needed), ["libtribocheck.so.0", "libc.so.6"])
            self.assertEqual(ran("tribocheck_check (@film, 'hamrock_dowson_central');\ndisp (which ('tribocheck_hertz_point'))", mex.parents[1],
                                 LD_LIBRARY_PATH=str(BINDINGS)), f"{mex.parents[1]}/tribocheck_hertz_point.m\n")


if __name__ == "__main__":
    unittest.main()
