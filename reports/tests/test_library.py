# SPDX-License-Identifier: Apache-2.0
"""libtribocheck.so: the functions of the catalogue by columns, and verdicts, as the program gives them."""
import contextlib
import ctypes
import json
import locale
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
from unittest import mock

from program import ENVIRONMENT, PROGRAM, TIMEOUT, run
from subjects import answers_of, python

BINDINGS = pathlib.Path(PROGRAM).resolve().parent / "reports/bindings"
ROOT = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"])
LIBRARY = ctypes.CDLL(str(BINDINGS / "libtribocheck.so"))
CATALOGUE = {one["name"]: one for one in run("functions", "--format", "json").json()["functions"]}
DONE, FAILED = 0, 3
POINTS = ["operating_point", "operating_point_of_other_film", "operating_point_of_ellipse", "operating_point_of_line"]


@contextlib.contextmanager
def decimal_comma():
    """A locale with a decimal comma, as a host may set it."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "comma.def"
        source.write_text('comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
        made = subprocess.run(["localedef", "-c", "-i", source, f"{folder}/comma"], capture_output=True, text=True)
        assert os.path.isdir(f"{folder}/comma"), made.stderr  # otherwise it warns of all that is left out
        with mock.patch.dict(os.environ, LOCPATH=folder):
            locale.setlocale(locale.LC_NUMERIC, "comma")
        try:
            yield
            assert locale.localeconv()["decimal_point"] == ","
        finally:
            locale.setlocale(locale.LC_NUMERIC, "C")


def text_of(call, *arguments):
    """Returns the code of a call and the text that it writes."""
    room = ctypes.create_string_buffer(1 << 23)
    length = ctypes.c_size_t()
    code = call(*arguments, room, ctypes.c_size_t(len(room)), ctypes.byref(length))
    assert length.value == len(room.value)
    return code, room.value.decode()


def columns(numbers, count):
    made = [(ctypes.c_double * count)(*column) for column in numbers]
    return made, (ctypes.POINTER(ctypes.c_double) * len(made))(*made)


def call(name, points):
    """The results of each point, and its status."""
    function, count = CATALOGUE[name], len(points)
    _, argument = columns(zip(*points), count)
    results, result = columns([[0] * count for _ in function["results"]], count)
    status = (ctypes.c_int * count)(*[-1] * count)
    told = LIBRARY.tribocheck_call(name.encode(), ctypes.c_size_t(count), argument, None, result, status)
    assert told == (2 if FAILED in status else 1)
    return list(zip(*results)), list(status)


def arguments_of(question):
    parameters = CATALOGUE[question["function"]]["parameters"]
    given = [question.get(one["name"], one.get("default")) for one in parameters]
    return [one["words"].index(value) if "words" in one else value for one, value in zip(parameters, given)]


class Functions(unittest.TestCase):
    def test_the_catalogue_is_that_of_the_program(self):
        self.assertEqual(json.loads(text_of(LIBRARY.tribocheck_describe)[1]),
                         run("functions", "--format", "json").json())

    def test_each_certified_case_has_the_bits_of_the_program(self):
        asked = [json.loads(line) for line in run("verify", "--save-cases", "-").out.splitlines()]
        asked = [one for one in asked if "function" in one]
        self.assertEqual({one["function"] for one in asked}, set(CATALOGUE))
        answers = run("stream", stdin="".join(json.dumps(one) + "\n" for one in asked)).json_lines()
        for name, function in CATALOGUE.items():
            mine = [(one, answer) for one, answer in zip(asked, answers, strict=True) if one["function"] == name]
            results, statuses = call(name, [arguments_of(one) for one, _ in mine])
            for (question, answer), numbers, status in zip(mine, results, statuses, strict=True):
                expected = [answer[one["name"]] for one in function["results"]]
                expected = [math.inf if value is None else value for value in expected]
                self.assertEqual((list(numbers), status), (expected, DONE), question)

    def test_arguments_out_of_range_are_refused_and_no_neighbour_of_theirs(self):
        for name, function in CATALOGUE.items():
            right = arguments_of(function["example"])
            expected, = call(name, [right])[0]
            for place, parameter in enumerate(function["parameters"]):
                wrong = [math.nan, math.inf, -math.inf]
                if "words" in parameter:
                    wrong += [-1, len(parameter["words"]), 0.5]
                elif parameter["allowed"] == "a number above 0":
                    wrong += [-1, 0]
                for value in wrong:
                    spoilt = [*right[:place], value, *right[place + 1:]]
                    results, statuses = call(name, [right] * 700 + [spoilt] + [right])
                    self.assertEqual(statuses, [DONE] * 700 + [FAILED] + [DONE], (name, spoilt))
                    self.assertTrue(all(map(math.isnan, results[700])), (name, spoilt))
                    self.assertEqual({*results[:700], results[701]}, {expected}, (name, spoilt))
                    code, why = text_of(LIBRARY.tribocheck_fault, name.encode(), (ctypes.c_double * 10)(*spoilt))
                    self.assertEqual((code, why.split(":")[0]), (2, parameter["name"]))
                    self.assertIn("allowed: ", why)
            self.assertEqual(text_of(LIBRARY.tribocheck_fault, name.encode(), (ctypes.c_double * 10)(*right)), (0, ""))

    def test_arguments_that_are_illegal_together_are_refused(self):
        apart = [5e-3, -4e-3, 5e-3, 5e-3]  # a ball in a groove that is narrower than the ball
        self.assertEqual(call("reduced_radius", [apart])[1], [FAILED])
        code, why = text_of(LIBRARY.tribocheck_fault, b"reduced_radius", (ctypes.c_double * 10)(*apart))
        self.assertEqual((code, why.split(":")[0]), (2, "first_radius_x"))

    def test_an_unknown_function_is_no_function(self):
        self.assertEqual(LIBRARY.tribocheck_call(b"hertz", ctypes.c_size_t(0), None, None, None, None), 0)
        self.assertEqual(text_of(LIBRARY.tribocheck_fault, b"hertz", None), (2, 'no function is called "hertz"'))

    def test_numbers_with_units(self):
        for place in (contextlib.nullcontext, decimal_comma):
            for text, unit, expected in [("20.2 mPa s", "Pa·s", 0.0202), ("46 kN", "N", 46e3), ("60.5 °C", "K", 333.65),
                                         ("1.5 GPa", "Pa", 1.5e9), ("4.5 km/h", "m/s", 1.25), ("1 nm", "m", 1e-9),
                                         ("1e-310 m", "m", 1e-310), ("1e400 m", "m", None), ("3 kg", "m", None), ("", "m", None)]:
                number = ctypes.c_double(-1)
                with place():
                    code = LIBRARY.tribocheck_number(text.encode(), unit.encode(), ctypes.byref(number))
                self.assertEqual((code, number.value), (2, -1) if expected is None else (0, expected), text)


class Verdicts(unittest.TestCase):
    def request(self, **members):
        return json.dumps(members).encode()

    def judged(self, mistake, only, **members):
        functions = POINTS if only == POINTS[0] else [only]
        request = self.request(functions=functions, subject="it", **members)
        code, questions = text_of(LIBRARY.tribocheck_cases, request)
        self.assertEqual(code, 0, questions)
        asked = [json.loads(line) for line in questions.splitlines()]
        answers = answers_of(python("fakes/fake.py", "--mistake", mistake), asked)
        return text_of(LIBRARY.tribocheck_judge, request, "".join(json.dumps(one) + "\n" for one in answers).encode())

    def test_the_verdict_and_the_cause_are_those_of_the_program(self):
        command = " ".join(map(str, python("fakes/fake.py", "--mistake", "{}", "--only", "{}")))
        for mistake, only in [("none", "hertz_ellipse"), ("film_half_radius", "hamrock_dowson_central"),
                              ("moment_simpson_201_points", "gaussian_moment"), ("sharing_none", "load_sharing"),
                              ("friction_roelands_log10", "operating_point")]:
            with self.subTest(mistake=mistake):
                whole = run("verify", "--subject", command.format(mistake, only), "--format", "json")
                expected = whole.json()
                code, text = self.judged(mistake, only, format="json")
                found = json.loads(text)
                self.assertEqual(code, whole.code)
                self.assertEqual(found["diagnoses"], expected["diagnoses"])
                asked = [one for one in expected["quantities"] if one["status"] != "not offered"]
                self.assertEqual([one for one in found["quantities"] if one["status"] != "not offered"], asked)
                self.assertEqual(found["examples"], expected["examples"])
                self.assertEqual(found["overall"] == "failed", mistake != "none")
        with decimal_comma():
            self.assertEqual(self.judged(mistake, only, format="json"), (code, text))

    def test_the_same_question_gets_the_same_answer_or_a_note(self):
        request = self.request(functions=["pull_off_force"])
        lines = text_of(LIBRARY.tribocheck_cases, request)[1].splitlines()
        again = [line for line in lines if lines.count(line) == 2]
        self.assertGreater(len(again), 2)
        answers = [{"id": json.loads(line)["id"], "value": place} for place, line in enumerate(lines)]
        text = text_of(LIBRARY.tribocheck_judge, request, "\n".join(map(json.dumps, answers)).encode())[1]
        self.assertIn(f"pull_off_force changes in {len(again) // 2} of {len(again) // 2} cases", text)

    def test_a_bad_request_is_refused_in_one_line(self):
        for request, words in [("[]", "no JSON object"), ('{"functions": ["x"]}', 'called "x"'),
                               ('{"functions": 3}', "functions: 3"), ('{"colour": 1}', "colour"),
                               ('{"tolerance": "loose"}', "loose"), ('{"modulus": "E"}', "allowed: E*, E', bodies"),
                               ('{"reference": "/nowhere"}', "/nowhere")]:
            code, why = text_of(LIBRARY.tribocheck_cases, request.encode())
            self.assertEqual((code, why.count("\n")), (2, 0), why)
            self.assertIn(words, why)

    def test_answers_that_are_none_are_refused_in_one_line(self):
        request = self.request(functions=["pull_off_force"])
        ids = [json.loads(line).get("id") for line in text_of(LIBRARY.tribocheck_cases, request)[1].splitlines()]
        once, twice = (next(one for one in ids if ids.count(one) == times) for times in (1, 2))
        one, other = (json.dumps({"id": which, "value": 1}) for which in (once, twice))
        for answers, words in [("{", "line 1"), ('{"value": 1}', "without an id"), ('{"id": "?"}', "not asked"),
                               (f"{one}\n\n{one}", "line 3 of the answers: a second answer"),
                               (f"{other}\n{other}\n{other}", "line 3 of the answers: a third answer")]:
            code, why = text_of(LIBRARY.tribocheck_judge, request, answers.encode())
            self.assertEqual((code, why.count("\n")), (2, 0), why)
            self.assertIn(words, why)

    def test_what_has_no_answer_fails(self):
        code, text = text_of(LIBRARY.tribocheck_judge, self.request(functions=["pull_off_force"]), b"")
        self.assertEqual(code, 1)
        self.assertIn("nothing (no answer)", text)


def scene_text(path):
    return (ROOT / "reference" / path).read_bytes()


def about(text):
    code, told = text_of(LIBRARY.tribocheck_describe_scene, text)
    assert code == 0, told
    return json.loads(told)


def points(call, names, count, *before):
    """Returns the columns of points by name, or the text of the fault if the call is refused."""
    made, result = columns([[-1] * count for _ in names], count)
    code, text = text_of(call, *before, ctypes.c_size_t(len(names)), (ctypes.c_char_p * len(names))(*map(str.encode, names)), result)
    assert (code == 0) == (text == ""), text
    return text or dict(zip(names, map(list, made), strict=True))


class Scenes(unittest.TestCase):
    """Operating points, curves, onsets and films are those of the program."""

    SCENES = ["published/rough.toml", "published/smooth.toml", "scenes/ball_on_flat.toml", "scenes/roller.toml",
              "scenes/bearing_outer_ring.toml", "scenes/gear_flank.toml"]
    WIDE = b"speed = {from = 1e-7, to = 400, count = 700}\noutputs = [\"inlet\", \"fluid_load_share\", \"friction\", \"regime\"%s]\n"

    def same(self, command, text, own):
        """Asserts that the outputs that the scene asks for are those of the program, and returns the program's rows."""
        asked = {one["name"]: one["words"] for one in own["outputs"] if one["asked"]}
        rows = run(command, "-", "--format", "json", stdin=text.decode()).json()["points"]
        count = own["speeds"]
        before = [text, ctypes.c_size_t(count)] + ([None] if command == "solve" else [])
        found = points(getattr(LIBRARY, f"tribocheck_{command}"), ["speed", *asked], count, *before)
        self.assertEqual(len(rows), count)
        for name, column in found.items():
            told = [row[name] for row in rows]
            if words := asked.get(name):
                column = [None if math.isnan(code) else words[int(code)] for code in column]
            self.assertEqual([None if value != value else value for value in column], told, (command, name))
        return rows

    def test_points_and_curves_have_the_bits_of_the_program(self):
        regimes = set()
        for name in self.SCENES:
            text = scene_text(name)
            with self.subTest(name=name):
                own = about(text)
                self.same("solve", text, own)
                if own["speeds"] > 1:
                    self.same("curve", text, own)
                with decimal_comma():
                    self.same("solve", text, about(text))
        plain = re.sub(rb"(?m)^(speed|outputs) *=.*\n", b"", scene_text("published/rough.toml"))
        for law, more in [(b"flooded_inlet", b""), (b"flooded_inlet", b', "minimum_film"'), (b"damiens", b"")]:
            text = self.WIDE % more + re.sub(rb"(?m)^starvation *=.*$", b'starvation = "' + law + b'"', plain)
            for command in ("solve", "curve"):
                regimes |= {row["regime"] for row in self.same(command, text, about(text))}
        self.assertEqual(regimes, {"mixed", "elastohydrodynamic", "collapsed"})

    def test_points_of_unknown_summits_and_between_solved_films_have_the_bits_of_the_program(self):
        scene = re.sub(rb"(?ms)^(speed|accept) *=.*?\n|^\[surface\].*?\n\n", b"", scene_text("scenes/ball_on_flat.toml"))
        names = b'"film", "real_area_ratio", "summit_count", "friction", "regime", "inlet", "peak_pressure", "minimum_film", "lambda_ratio"'
        for closures in (b"", b'[closures]\nfilm = "solved"\n'):
            text = (b"speed = {from = 1e-9, to = 400, count = 700}\noutputs = [%s]\n" % names + scene
                    + b"[surface]\nrms_roughness = 1e-7\n" + closures)
            rows = self.same("solve", text, about(text))
            for name in ("friction", "regime") + (("film", "minimum_film", "inlet") if closures else ()):
                self.assertIn(None, [row[name] for row in rows], name)
            self.assertNotIn(None, [row["peak_pressure"] for row in rows])

    def test_points_at_other_speeds_and_of_other_outputs_are_those_of_such_a_scene(self):
        text = scene_text("published/rough.toml")
        speeds = [0.3, 1e-6, 1e300, 2.5]
        names = ["peak_pressure", "film", "speed", "film", "regime"]
        found = points(LIBRARY.tribocheck_solve, names, 4, text, ctypes.c_size_t(4), (ctypes.c_double * 4)(*speeds))
        changed = (f"outputs = {json.dumps(sorted(set(names) - {'speed'}))}\nspeed = {json.dumps(speeds)}\n".encode()
                   + re.sub(rb"(?m)^(speed|outputs) *=.*\n", b"", text))
        expected = self.same("solve", changed, about(changed))
        for name in ("peak_pressure", "film", "speed"):
            self.assertEqual([None if value != value else value for value in found[name]], [row[name] for row in expected])

    def test_onsets_are_the_document_of_the_program(self):
        for name in self.SCENES[:4]:
            for departure in (0.05, 0.3):
                path = ROOT / "reference" / name
                self.assertEqual(text_of(LIBRARY.tribocheck_onset, scene_text(name), ctypes.c_double(departure)),
                                 (0, run("onset", path, "--format", "json", "--departure", str(departure)).out), name)

    def test_films_are_the_document_of_the_program(self):
        for name, request, options in [
                ("roller", {"speed": 0.5}, ["--speed", "0.5"]),
                ("roller", {"speed": 2, "tolerance": 1e-3, "viscosity": "barus", "density": "dowson_higginson", "profile": True},
                 ["--speed", "2", "--tolerance", "1e-3", "--viscosity", "barus", "--density", "dowson_higginson", "--profile"]),
                ("ball_on_flat", {"speed": 1, "tolerance": 1e-2}, ["--speed", "1", "--tolerance", "1e-2"])]:
            whole = run("film", ROOT / f"reference/scenes/{name}.toml", "--format", "json", *options)
            told = text_of(LIBRARY.tribocheck_film, scene_text(f"scenes/{name}.toml"), json.dumps(request).encode(), None, None)
            self.assertEqual(told, (whole.code, whole.out), request)

    def test_a_film_stops_where_its_watch_says_so(self):
        steps = []
        watch = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_int, ctypes.c_int)(lambda user, cells, step: steps.append(step) or len(steps) == 3)
        told = text_of(LIBRARY.tribocheck_film, scene_text("scenes/roller.toml"), b'{"speed": 1}', watch, None)
        self.assertEqual((told, len(steps)), ((2, "stopped"), 3))

    def test_a_film_that_is_refused_says_why_as_the_program_does(self):
        text = scene_text("scenes/ball_on_flat.toml")
        whole = run("film", "-", "--format", "json", "--speed", "1e-7", stdin=text.decode()).ended(1)
        self.assertEqual(text_of(LIBRARY.tribocheck_film, text, b'{"speed": 1e-7}', None, None), (1, whole.out))

    def test_a_scene_tells_its_outputs_warnings_and_what_has_no_effect(self):
        text = scene_text("published/rough.toml")
        own = about(text)
        self.assertEqual({one["name"] for one in own["outputs"] if one["asked"]},
                         {name for name in run("solve", "-", "--format", "json", stdin=text.decode()).json()["points"][0]} - {"id", "speed"})
        self.assertEqual([one["words"] for one in own["outputs"] if one["name"] == "inlet"], [["flooded", "starved", "collapsed"]])
        hot = re.sub(rb"(?m)^viscosity *=.*$", b"viscosity = 20.2", text)
        warned = run("solve", "-", "--format", "json", stdin=hot.decode()).json()["warnings"]
        self.assertEqual(about(hot)["warnings"], warned)
        self.assertIn("perhaps mPa·s was meant", str(warned))

    def test_all_faults_of_a_scene_are_those_that_the_program_tells(self):
        text = re.sub(rb"(?m)^(load|viscosity) *=.*$", rb"\1 = -3", scene_text("published/rough.toml"))
        expected = run("solve", "-", stdin=text.decode()).err
        code, told = text_of(LIBRARY.tribocheck_describe_scene, text)
        self.assertEqual((code, told.count("\n")), (2, 1))
        self.assertEqual(re.sub("(?m)^scene:", "tribocheck: -:", told) + "\n", expected)

    def test_faults_are_one_line_and_leave_the_columns_alone(self):
        text, one = scene_text("published/rough.toml"), (ctypes.c_double * 3)(1, 2, -3)
        count = ctypes.c_size_t(3)
        films = [LIBRARY.tribocheck_film, text]
        for told, words in [
                (text_of(LIBRARY.tribocheck_describe_scene, b"{")[1], "scene:1:2: not JSON"),
                (text_of(LIBRARY.tribocheck_describe_scene, b"x" * (1 << 20) + b"y")[1], "too large; allowed: at most 1048576 bytes"),
                (points(LIBRARY.tribocheck_solve, ["film"], 3, text, count, one), "speeds[2]: -3 is not allowed; allowed: a number above 0, in m/s"),
                (points(LIBRARY.tribocheck_solve, ["film"], 3, text, count, None), "count: 3 is not allowed; allowed: 200"),
                (points(LIBRARY.tribocheck_solve, ["fim"], 3, text, count, one), 'outputs[0]: "fim" is not known; allowed: '),
                (points(LIBRARY.tribocheck_curve, ["film"], 1, b"speed = 1\n" + re.sub(rb"(?m)^speed *=.*\n", b"", text), ctypes.c_size_t(1)),
                 "speed: 1 alone is no curve"),
                (text_of(LIBRARY.tribocheck_onset, text, ctypes.c_double(1))[1], "departure: 1 is not allowed; allowed: a number above 0 and below 1"),
                (text_of(*films, b'{"speed": 0}', None, None)[1], "speed: 0 is not allowed; allowed: a number above 0, in m/s"),
                (text_of(*films, b'{"speed": "1"}', None, None)[1], 'speed: "1" is not allowed'),
                (text_of(*films, b'{"tolerance": 1}', None, None)[1], "tolerance: 1 is not allowed; allowed: a number from 1e-6 to 1e-2"),
                (text_of(*films, b'{"viscosity": "x"}', None, None)[1], 'viscosity: "x" is not known; allowed: barus, roelands'),
                (text_of(*films, b'{"flooded": 1}', None, None)[1], "flooded: 1 is not allowed; allowed: true or false"),
                (text_of(LIBRARY.tribocheck_film, scene_text("scenes/roller.toml"), b'{"flooded": true}', None, None)[1],
                 "flooded: it leaves out the [supply] of circles and ellipses, and no scene here has one"),
                (text_of(*films, b'{"threads": 1}', None, None)[1], "threads")]:
            with self.subTest(words=words):
                self.assertIsInstance(told, str)
                self.assertIn(words, told)
                self.assertNotIn("\n", told)


class InC(unittest.TestCase):
    """A program in C99 that compiles without warnings, and needs only the headers and the library."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.user = pathlib.Path(cls.folder.name, "library_user")
        cls.compile("library_user.c", cls.user)

    @staticmethod
    def compile(source, program):
        subprocess.run(["cc", "-std=c99", "-D_GNU_SOURCE", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{ROOT}/reports/bindings",
                        f"-I{ROOT}/verification/conformance", source, "-o", program, f"-L{BINDINGS}", f"-Wl,-rpath,{BINDINGS}", "-ltribocheck",
                        "-lm", "-pthread"], check=True, timeout=TIMEOUT)

    def ask(self, *words):
        return subprocess.run([self.user, *words], capture_output=True, text=True, timeout=TIMEOUT)

    def test_points(self):
        lines = "".join(json.dumps({"function": "gaussian_moment", "order": 1.5, "argument": d}) + "\n" for d in (-3, 0.25, 30))
        expected = [f"0 {one['value']:.17g}" for one in run("stream", stdin=lines).json_lines()]
        self.assertEqual(self.ask("moments", "1.5", "-3", "0.25", "30", "nan").stdout.splitlines()[:3], expected)
        self.assertRegex(self.ask("moments", "1.7", "0").stdout, r"^3 -?nan$")

    def test_a_verdict(self):
        right, wrong = self.ask("judge", "right"), self.ask("judge", "wrong")
        self.assertEqual((right.returncode, wrong.returncode), (0, 1), right.stdout + wrong.stdout)
        self.assertIn("Diagnosis: ", wrong.stdout)
        self.assertRegex(wrong.stdout, "2E\\*|E′")

    def test_the_example_of_the_readme_prints_what_it_says(self):
        example = re.search(r"```c\n(.*?)```", (ROOT / "reports/bindings/README.md").read_text(), re.DOTALL)[1]
        path = pathlib.Path(self.folder.name, "moments")
        path.with_suffix(".c").write_text(example)
        self.compile(path.with_suffix(".c"), path)
        expected = re.search(r"printf.*/\* (.*) \*/", example)[1]
        self.assertEqual(subprocess.run([path], capture_output=True, text=True, timeout=TIMEOUT).stdout, expected + "\n")

    def test_threads(self):
        done = self.ask("threads", ROOT / "reference/published/rough.toml")
        self.assertEqual((done.returncode, done.stdout), (0, "0 of 160 rounds differ\n"))

    def test_texts(self):
        self.assertEqual(self.ask("texts").stdout, "0 failures\n")

    def test_no_memory_is_lost_or_used_wrongly(self):
        for words in [("moments", "2.5", "1", "nan"), ("judge", "wrong"), ("texts",)]:
            done = subprocess.run(["valgrind", "-q", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect,possible",
                                   "--error-exitcode=9", self.user, *words], capture_output=True, text=True, timeout=TIMEOUT)
            self.assertEqual(done.stderr, "", words)
            self.assertNotEqual(done.returncode, 9, words)


class Built(unittest.TestCase):
    def test_it_needs_no_library_under_the_gpl_and_shows_its_functions_alone(self):
        needed = subprocess.run(["ldd", BINDINGS / "libtribocheck.so"], capture_output=True, text=True, check=True).stdout
        self.assertNotRegex(needed, "gsl|cblas|fftw|gmp|mpfr|hdf5|mpi")
        self.assertIn("libtribocheck.so.0", subprocess.run(["readelf", "-d", BINDINGS / "libtribocheck.so"], capture_output=True, text=True,
                                                           check=True).stdout)
        shown = subprocess.run(["nm", "-D", "--defined-only", BINDINGS / "libtribocheck.so"], capture_output=True, text=True,
                               check=True).stdout
        declared = set(re.findall(r"\b(tribocheck_\w+)\(", (ROOT / "reports/bindings/tribocheck.h").read_text()))
        names = {line.split()[-1] for line in shown.splitlines()} - {"TRIBOCHECK_0"}
        self.assertEqual(names, {f"{name}@@TRIBOCHECK_0" for name in declared})


if __name__ == "__main__":
    unittest.main()
