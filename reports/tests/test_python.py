# SPDX-License-Identifier: Apache-2.0
"""The package of Python: the functions of the catalogue with arrays of numpy, scenes, solved films, and tribocheck.check().

check() and verify --subject judge some of the fakes and slips, or all of them if TRIBOCHECK_FAKES is set.
"""
import ast
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
import zipfile

from conformance import SUBJECTS, run_python, subject, verify
from program import ENVIRONMENT, PROGRAM, TIMEOUT, run
from test_fakes_named import NAMED, SETS

PACKAGE = pathlib.Path(PROGRAM).resolve().parent / "reports/bindings/python"
PYTHON_ENVIRONMENT = ENVIRONMENT | {"PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"}
SCENES = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"], "reference/scenes")
ROUGH = SCENES.parent / "published/rough.toml"
ALL = "TRIBOCHECK_FAKES" in os.environ
START = "import json, numpy as np, tribocheck\n"
FILM = textwrap.dedent("""
    def film(speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius, ellipticity):
        U = viscosity * speed / (2 * effective_modulus * reduced_radius)
        G = 2 * pressure_viscosity * effective_modulus
        W = load / (2 * effective_modulus * reduced_radius**2)
        return 2.69 * reduced_radius * U**0.67 * G**0.53 * W**-0.067 * (1 - 0.61 * np.exp(-0.73 * ellipticity))
    """)


def started(code, **more):
    return subprocess.Popen([sys.executable, "-c", START + textwrap.dedent(code)], env=PYTHON_ENVIRONMENT, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)


def ran(code):
    """The output of a script."""
    process = started(code)
    out, err = process.communicate(timeout=TIMEOUT)
    assert process.returncode == 0, err[-2000:]
    return out


def raised(expression, start=""):
    """The exception of an expression, as `Kind: text`."""
    return ran(start + f"try:\n    print({expression})\nexcept Exception as error:\n"
                       f"    print(type(error).__mro__[-3].__name__ if isinstance(error, MemoryError) else type(error).__name__, error, sep=': ')")


class Functions(unittest.TestCase):
    def test_each_function_gives_its_example_with_the_bits_of_the_program(self):
        functions = run("functions", "--format", "json").json()["functions"]
        lines = "".join(json.dumps(one["example"]) + "\n" for one in functions)
        expected = {one["name"]: [answer[result["name"]] for result in one["results"]]
                    for one, answer in zip(functions, run("stream", stdin=lines).json_lines(), strict=True)}
        found = json.loads(ran("""
            found = {}
            for name, function in tribocheck.functions.items():
                example = function.__doc__[function.__doc__.index(">>> ") + 4:]
                value = eval(example)
                found[name] = list(value) if isinstance(value, tuple) else [value]
                assert getattr(tribocheck, name) is function and "Source: " in function.__doc__
            print(json.dumps(found))"""))
        self.assertEqual(found, expected)

    def test_results_and_scenes_are_pickled(self):
        self.assertEqual(ran(f"""
            import pickle
            contact, scene = tribocheck.hertz_point(50, 1e11, 0.01), tribocheck.Scene({str(SCENES / "roller.toml")!r})
            assert pickle.loads(pickle.dumps(contact)) == contact
            assert pickle.loads(pickle.dumps(scene)).text == scene.text
            points, film = scene.solve([0.1, 1], ["film", "regime"]), tribocheck.film(scene, speed=1)
            assert pickle.loads(pickle.dumps(points)) == points and pickle.loads(pickle.dumps(film)).central == film.central
            print("same")"""), "same\n")

    def test_help_names_units_ranges_words_and_results(self):
        text = ran("help(tribocheck.hertz_ellipse); help(tribocheck.load_sharing); print(tribocheck.__version__)")
        for words in ["load                    N       F", "a number above 0; usual: 0.001 to 1e+06", "peak_pressure           Pa",
                      "one of greenwood_tripp, greenwood_williamson", ">>> tribocheck.hertz_ellipse(load="]:
            self.assertIn(words, text)

    def test_the_help_of_the_package_lists_all_functions_and_nothing_of_what_python_adds(self):
        text = ran("help(tribocheck)")
        for one in run("functions", "--format", "json").json()["functions"]:
            self.assertRegex(text, rf"(?m)^    +{one['name']} +{re.escape(one['meaning'])}$")
        for words in ("class Scene", "class Points", "check(solver, ", "film(scene: "):
            self.assertIn(words, text)
        self.assertEqual(re.findall(r"_asdict|_make|__match_args__|__dataclass_|SimpleNamespace|__weakref__", text.replace("__weakref__\n", "", 1)), [])
        self.assertLess(text.count("\n"), 400)

    def test_results_have_names(self):
        self.assertEqual(ran("""
            one = tribocheck.hertz_point(50., 1.079e11, 9.5e-3)
            print(one._fields, one.peak_pressure == one[2], type(one).__name__)"""),
                         "('radius', 'mean_pressure', 'peak_pressure', 'approach') True HertzPoint\n")

    def test_numbers_and_arrays_of_any_kind_give_the_same_bits(self):
        self.assertEqual(ran("""
            d = np.linspace(-9, 9, 70001)
            whole = tribocheck.gaussian_moment(1.5, d)
            assert whole.dtype == float and whole.shape == d.shape
            assert all(tribocheck.gaussian_moment(1.5, float(x)) == y for x, y in zip(d[::97], whole[::97]))
            assert (tribocheck.gaussian_moment(1.5, d[::-3]) == whole[::-3]).all()
            wide = tribocheck.gaussian_moment(np.array([[0.5], [1.5]]), d)
            assert wide.shape == (2, d.size) and (wide[1] == whole).all()
            square = d[:60000].reshape(200, 300)
            assert (tribocheck.gaussian_moment(1.5, square.T) == whole[:60000].reshape(200, 300).T).all()
            assert tribocheck.gaussian_moment(1, np.float32(0.5)) == tribocheck.gaussian_moment(1.0, 0.5)
            assert (tribocheck.gaussian_moment(2, [1, 2]) == tribocheck.gaussian_moment(2, np.array([1., 2.]))).all()
            assert type(tribocheck.gaussian_moment(1, np.array(0.5))) is float
            assert tribocheck.gaussian_moment(1, []).shape == (0,)
            words = tribocheck.load_sharing(["greenwood_tripp", "greenwood_williamson"], 0.5, 20, 1.1)
            assert words[1] == tribocheck.load_sharing("greenwood_williamson", 0.5, 20, 1.1) != words[0]
            assert tribocheck.barus_viscosity(0.1, 2e-8, 1e12) == float("inf")
            print("same")"""), "same\n")

    def test_arrays_of_doubles_are_not_copied(self):
        peak = int(ran("""
            import tracemalloc
            d = np.linspace(-9, 9, 10**6)
            tracemalloc.start()
            tribocheck.gaussian_moment(1.5, d)
            print(tracemalloc.get_traced_memory()[1])"""))
        self.assertGreater(peak, 8e6)  # the result
        self.assertLess(peak, 9e6)

    def test_wrong_arguments_are_one_exception_each(self):
        for expression, expected in [
                ("hertz_point(50, np.array([1e11, -1, 2]), 1)", "ValueError: hertz_point at index 1: effective_modulus: -1 is not allowed"),
                ("hertz_point([[1, 2], [np.nan, 1]], 1, 1)", "ValueError: hertz_point at index (1, 0): load: nan is not allowed"),
                ("hertz_point(np.append(np.ones(10**5), np.inf), 1, 1)", "ValueError: hertz_point at index 100000: load: inf is not allowed"),
                ("hertz_point(-1.0, 1, 1)", "ValueError: hertz_point: load: -1 is not allowed; allowed: a number above 0, in N"),
                ("reduced_radius(1, -0.5, 1, 1)", "ValueError: reduced_radius: first_radius_x: "),
                ("hertz_point(np.ones(3), np.ones(4), 1)", "ValueError: hertz_point: shapes that do not go together: load (3,), effective_modulus (4,)"),
                ("hertz_point('1', 1, 1)", "TypeError: hertz_point: load is no number"),
                ("hertz_point(True, 1, 1)", "TypeError: hertz_point: load is no number"),
                ("hertz_point(None, 1, 1)", "TypeError: hertz_point: load is an array of object, not of numbers"),
                ("hertz_point(np.array([1j]), 1, 1)", "TypeError: hertz_point: load is an array of complex128, not of numbers"),
                ("hertz_point(np.array([True]), 1, 1)", "TypeError: hertz_point: load is an array of bool, not of numbers"),
                ("hertz_point(10**400, 1, 1)", "OverflowError: "),
                ("hertz_point(1, 1)", "TypeError: hertz_point() missing 1 required"),
                ("hertz_point(1, 1, 1, radius=1)", "TypeError: hertz_point() got an unexpected keyword argument 'radius'"),
                ("load_sharing('tripp', 1, 1, 1)", "ValueError: load_sharing: asperity: \"tripp\" is not known; allowed: greenwood_tripp"),
                ("load_sharing(0, 1, 1, 1)", "TypeError: load_sharing: asperity is no text"),
                ("gaussian_moment(1, np.broadcast_to(1.0, 1 << 50))", "Exception: Unable to allocate")]:
            with self.subTest(expression=expression):
                self.assertEqual(raised("tribocheck." + expression)[:len(expected)], expected)

    def test_what_is_refused_is_masked_where_asked(self):
        self.assertEqual(ran("""
            found = tribocheck.hertz_point(50., [1e11, -1, np.nan], .01, masked=True)
            print(found.radius.mask.tolist(), found.radius[0] == tribocheck.hertz_point(50., 1e11, .01).radius,
                  tribocheck.gaussian_moment(0.7, 1, masked=True), tribocheck.gaussian_moment(1, [1.], masked=True).mask.tolist())"""),
                         "[False, True, True] True -- [False]\n")

    def test_nothing_leaks(self):
        grown = int(ran("""
            import resource
            x = np.linspace(1, 2, 1000)
            def once():
                tribocheck.hertz_point(x, 1e11, 0.01)
                tribocheck.hertz_point(50, 1e11, 0.01)
                tribocheck.gaussian_moment([[0.5], [1]], x)
                tribocheck.hertz_point(-x, 1e11, 0.01, masked=True)
                for wrong in (-x, "x", x[:3] * 1j, [1, 2]):
                    try: tribocheck.hertz_point(wrong, x, 1)
                    except (TypeError, ValueError): pass
            for _ in range(300): once()
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            for _ in range(3000): once()
            print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)"""))
        self.assertLess(grown, 1000)  # KiB; one array of each round would be 24000

    def test_one_point_takes_under_five_microseconds(self):
        for name, arguments in [("gaussian_moment", "order=1.5, argument=0.3"), ("hertz_point", "load=50., effective_modulus=1e11, reduced_radius=0.01")]:
            least = float(ran(f"""
                import timeit
                print(min(timeit.repeat(lambda: tribocheck.{name}({arguments}), number=2000, repeat=20)) / 2000)"""))
            self.assertLess(least, 5e-6, name)


class Scenes(unittest.TestCase):
    START = f"scene = tribocheck.Scene({str(ROUGH)!r})\n"

    def test_points_and_curves_have_the_bits_of_the_program(self):
        for command in ("solve", "curve"):
            rows = run(command, ROUGH, "--format", "json").json()["points"]
            found = json.loads(ran(self.START + f"print(json.dumps({{name: np.where(column == column, column, None).tolist() "
                                                f"for name, column in dict(scene.{command}()).items()}}))"))
            self.assertEqual(found, {name: [row[name] for row in rows] for name in found})
            self.assertEqual({"id", *found}, {*rows[0]} - {"undefined"})

    def test_a_path_a_text_a_dict_and_a_path_object_are_the_same_scene(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            import pathlib, tomllib
            path = pathlib.Path(%r)
            tree = tomllib.loads(path.read_text())
            tree["load"] = np.float64(tree["load"])
            expected = scene.solve(0.5).film
            for source in (path, path.read_text(), tree, json.dumps(tree, default=float), tree | {"surface": dict(tree["surface"])}):
                assert tribocheck.Scene(source).solve(0.5).film == expected and tribocheck.Scene(source).id == "rough"
            del tree["id"]
            print(tribocheck.Scene(tree).id, tribocheck.Scene(tree), scene.warnings)""" % str(ROUGH))),
                         "scene <tribocheck.Scene 'scene', 200 speeds> []\n")

    def test_speeds_of_any_shape_and_outputs_by_name(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            u = np.logspace(-3, 0, 90001)
            whole = scene.solve(u, ["film", "inlet"])
            assert [*whole] == ["speed", "film", "inlet"] and (whole.speed == u).all() and len(u) == whole.film.size
            assert (scene.solve(u[::-3], ["film"]).film == whole.film[::-3]).all()
            square = scene.solve(u[:90000].reshape(300, 300).T, ["film", "inlet"])
            assert (square.film == whole.film[:90000].reshape(300, 300).T).all() and square.inlet.shape == (300, 300)
            one = scene.solve(float(u[7]), ["film", "inlet", "peak_pressure"])
            assert one.film == whole.film[7] and one.inlet == whole.inlet[7] and isinstance(one.film, float) and isinstance(one.inlet, str)
            assert scene.solve(1, ["film"]).film == scene.solve(np.float32(1), ["film"]).film == scene.solve([1], ["film"]).film[0]
            assert scene.solve([], ["film"]).film.shape == (0,)
            print(sorted(set(whole.inlet)))""")), "['flooded', 'starved']\n")

    def test_words_take_a_byte_a_point_until_they_are_read(self):
        peak = int(ran(self.START + textwrap.dedent("""
            import tracemalloc
            u = np.full(10**6, 0.5)
            tracemalloc.start()
            found = scene.solve(u, ["film", "regime"])
            print(tracemalloc.get_traced_memory()[1])""")))
        self.assertGreater(peak, 9e6)  # the film's doubles, and a byte for each word
        self.assertLess(peak, 1e7)

    def test_points_are_the_same_where_their_columns_are(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            def found(*speeds, outputs=("film", "friction", "regime")):
                return scene.solve(speeds, outputs)
            one = found(1e-3, 1, 1e308)
            assert one == found(1e-3, 1, 1e308) and np.isnan(one.friction[2])
            assert one != found(1e-3, 1, 1e307) and one != found(1e-3, 1) and one != found(1e-3, 1, 1e308, outputs=["film"]) and one != 3
            other = found(1e-3, 1, 1e308)
            other.regime[0] = "collapsed"
            print(one == other, "film" in one, "inlet" in one, [*dict(one)], repr(scene.solve(1.0, ["regime"])))""")),
            "False True False ['speed', 'film', 'friction', 'regime'] Points(speed=1.0, regime='mixed')\n")

    def test_what_is_undefined_is_nan_and_a_word_without_it_empty(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            dry = tribocheck.Scene("outputs = ['film', 'friction', 'regime', 'inlet']\\n" + scene.text.replace("inlet_film_ratio = 4", "inlet_flow = 1e-12"))
            found = dry.solve([1e-3, 300.0, 1e308])
            thick = tribocheck.Scene(scene.text.replace("viscosity = 0.0202", "viscosity = 1e308").replace("[supply]", "").replace("inlet_film_ratio = 4", ""))
            print(found.friction, found.regime, found.inlet, thick.solve([1, 1e308]).inlet)""")),
            "[nan nan nan] ['collapsed' 'collapsed' 'collapsed'] ['collapsed' 'collapsed' 'collapsed'] ['flooded' '']\n")

    def test_onsets_are_those_of_the_program_and_say_why_there_is_none(self):
        found = json.loads(ran(self.START + 'print(json.dumps(scene.onset(departure=0.2)))'))
        expected = run("onset", ROUGH, "--departure", "0.2", "--format", "json").json()["onsets"]
        self.assertEqual(found, {row["criterion"]: [row["speed"], row["film"], row["film_parameter"], ""] for row in expected})
        none = ran(self.START + 'print(tribocheck.Scene(scene.text.replace("[supply]", "").replace("inlet_film_ratio = 4", "")).onset()["film_maximum"])')
        self.assertRegex(none, r"^Onset\(speed=nan, film=nan, film_parameter=nan, reason='.*flooded.*'\)")

    def test_wrong_speeds_outputs_and_scenes_are_one_exception_each(self):
        for expression, expected in [
                ("scene.solve([1, np.nan])", "ValueError: speeds at index 1: nan is not allowed; allowed: a number above 0, in m/s"),
                ("scene.solve([[1, 2], [3, -4]])", "ValueError: speeds at index (1, 1): -4.0 is not allowed"),
                ("scene.solve(0)", "ValueError: speeds: 0.0 is not allowed"), ("scene.solve(np.append(np.ones(10**5), np.inf))", "ValueError: speeds at index 100000: inf"),
                ("scene.solve('1')", "TypeError: speeds is an array of <U1, not of numbers"), ("scene.solve(True)", "TypeError: speeds is an array of bool"),
                ("scene.solve([1j])", "TypeError: speeds is an array of complex128"), ("scene.solve(10**400)", "TypeError: speeds is an array of object"),
                ("scene.solve(np.broadcast_to(1.0, 1 << 50))", "Exception: Unable to allocate"),
                ("scene.solve(1, ['colour'])", 'ValueError: scene: outputs[0]: "colour" is not known; allowed: '),
                ("scene.solve(1, 'film')", "TypeError: outputs: a list of names, as ['film']"), ("scene.solve(1).colour", "AttributeError: no output colour was computed; there are: speed, film_flooded"),
                ("scene.onset(departure=1)", "ValueError: departure: 1 is not allowed; allowed: "),
                ("scene.onset(departure='5 %')", "TypeError: departure: '5 %' is no number; allowed: a number above 0 and below 1"),
                ("setattr(scene, 'load', 60)", "AttributeError: 'Scene' object has no attribute 'load'"),
                ("tribocheck.Scene('nowhere.toml')", "FileNotFoundError: "), ("tribocheck.Scene(3)", "TypeError: a scene is a path, a text or a dict, not int"),
                ("tribocheck.Scene(scene.text.replace('load = 50', 'load = -3'))", "ValueError: scene: load: -3 is not allowed; allowed: a number above 0, in N"),
                ("tribocheck.Scene({'load': object()})", "TypeError: a scene has no object"), ("tribocheck.Scene('a\\0\\n')", "ValueError: a scene has no sign 0")]:
            with self.subTest(expression=expression):
                self.assertEqual(raised(expression, self.START)[:len(expected)], expected)

    def test_all_faults_of_a_scene_are_told_as_by_the_program(self):
        nameless = ROUGH.read_text().replace('id = "rough"\n', "")
        for text, count in [(re.sub("(load|viscosity) = [0-9.]+", r"\1 = -3", nameless), 3), (nameless.replace("[supply]", "[supply"), 1)]:
            with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
                file.write(text)
                file.flush()
                expected = run("solve", file.name).err
                found = raised(f"tribocheck.Scene({file.name!r})").removeprefix("ValueError: ")
            self.assertEqual(found.count("\n"), count)
            self.assertEqual(re.sub("(?m)^", "tribocheck: ", found.rstrip("\n")) + "\n", expected)

    def test_a_scene_without_an_id_keeps_its_text_and_has_the_name_of_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "nameless.toml")
            path.write_text((SCENES / "roller.toml").read_text().replace("id =", "# id ="))
            self.assertEqual(ran(f"""
                scene = tribocheck.Scene({str(path)!r})
                assert scene.text == open({str(path)!r}).read()
                film = tribocheck.film(scene, speed=1, tolerance=1e-2)
                print(scene.id, film.id, str(film).splitlines()[0])"""), "nameless nameless nameless at 1 m/s, solved\n")

    def test_a_long_call_ends_by_ctrl_c(self):
        for code in ("tribocheck.hertz_ellipse(50., 1e11, np.linspace(1, 2, 2 * 10**7), 1.5)",  # some twenty seconds
                     "while True: scene.solve(np.logspace(-4, 1, 4 * 10**7))",
                     f"while True: tribocheck.film({str(SCENES / 'ball_on_flat.toml')!r}, speed=1)"):
            with self.subTest(code=code):
                process = started(self.START + f"print('begins', flush=True)\n{code}")
                self.assertEqual(process.stdout.readline(), "begins\n")
                time.sleep(1)
                process.send_signal(signal.SIGINT)
                begin = time.monotonic()
                _, err = process.communicate(timeout=TIMEOUT)
                self.assertEqual(err.splitlines()[-1], "KeyboardInterrupt")
                self.assertLess(time.monotonic() - begin, 10)

    def test_threads_call_at_once(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            import threading
            u, d, roller = np.logspace(-4, 0, 10**5), np.linspace(-9, 9, 10**6), %r
            points, moments, film = scene.solve(u), tribocheck.gaussian_moment(2.5, d), tribocheck.film(roller, speed=1).central
            same = []
            def work():
                same.append(all(scene.solve(u) == points and (tribocheck.gaussian_moment(2.5, d) == moments).all() for _ in range(5))
                            and tribocheck.film(roller, speed=1).central == film)
            threads = [threading.Thread(target=work) for _ in range(4)]
            for one in threads: one.start()
            for one in threads: one.join()
            print(same)""" % str(SCENES / "roller.toml"))), "[True, True, True, True]\n")

    def test_a_curve_is_drawn_by_matplotlib_alone(self):
        self.assertEqual(ran(self.START + textwrap.dedent("""
            import sys, types
            assert "matplotlib" not in sys.modules
            class Axes:
                def __getattr__(self, name):
                    return lambda *given: print(name, *(np.shape(one) or one for one in given))
            curve = scene.curve(["film", "regime"])
            curve.plot([Axes()])
            sys.modules["matplotlib"] = None
            try: curve.plot()
            except ImportError as error: print(error)
            try: scene.curve(["regime"]).plot()
            except ValueError as error: print(error)""")),
                         "semilogx (200,) (200,)\nset_ylabel film [m]\nset_xlabel speed [m/s]\n"
                         "Curve.plot() needs matplotlib, which is not installed: python3-matplotlib on Debian, or `pip install matplotlib`\n"
                         "nothing to draw; the curve has: speed, regime\n")


class Films(unittest.TestCase):
    def test_a_film_has_the_numbers_of_the_program_with_errors_and_units(self):
        options = ["--viscosity", "barus", "--density", "dowson_higginson", "--tolerance", "1e-3"]
        expected, = run("film", SCENES / "roller.toml", "--speed", "0.5", *options, "--profile", "--format", "json").json()["films"]
        found, central, text, dirs = json.loads(ran(f"""
            film = tribocheck.film({str(SCENES / "roller.toml")!r}, 0.5, 1e-3, viscosity="barus", density="dowson_higginson")
            assert film.central.value == float(film.central) and film.central.unit == "m"
            films = [[one.value, one.error] for one in (film.central, film.minimum, film.at_greatest_pressure, film.friction)]
            try: 2 * film.central
            except TypeError: pass
            else: raise AssertionError("a number with an error is no tuple")
            print(json.dumps([[*films, film.profile.film.tolist(), film.tolerance, film.formulas],
                              str(film.central), str(film), dir(film)]))
            assert str(tribocheck.Measured(0.0, 1e-9, "m")) == "0.00 ± 1.0e-09 m", tribocheck.Measured(0.0, 1e-9, "m")"""))
        self.assertEqual(found[:4], [[expected[name][key] for key in ("value", "error")] for name in
                                                          ("central_film", "minimum_film", "film_at_greatest_pressure", "friction")])
        self.assertEqual(found[4:], [expected["profile"]["film"], expected["tolerance"], expected["formulas"]])
        self.assertRegex(central, r"^\d\.\d+e-08 ± \d\.\de-\d\d m$")
        self.assertIn(f"\n  central               {central}\n", text)
        self.assertIn("spike_place", dirs)

    def test_what_is_undefined_is_nan_with_its_reason(self):
        self.assertRegex(ran(f"film = tribocheck.film({str(SCENES / 'ball_on_flat.toml')!r}, 1, 1e-2)\nprint(film.spike_pressure, film.undefined['spike_pressure'])"),
                         r"^nan Pa not given for circles and ellipses")

    def test_wrong_arguments_are_one_exception_each(self):
        for arguments, expected in [
                ("", "ValueError: speed: the scene has 200 speeds; allowed: one number above 0, in m/s"), ("speed=-1", "ValueError: speed: -1 is not allowed; allowed: a number above 0, in m/s"),
                ("speed=np.nan", "ValueError: speed: nan is not allowed"), ("speed='1'", "TypeError: speed: '1' is no number"), ("speed=[1]", "TypeError: speed: [1] is no number"),
                ("1, 1", "ValueError: tolerance: 1 is not allowed; allowed: a number from 1e-6 to 1e-2"), ("1, viscosity='x'", 'ValueError: viscosity: "x" is not known; allowed: barus, roelands'),
                ("1, density=3", "ValueError: density: 3 is not allowed; allowed: a text"), ("1, flooded=1", "ValueError: flooded: 1 is not allowed; allowed: true or false"), ("1e-7", "RuntimeError: rough: not solved: the layer of liquid at the"),
                ("1, colour=1", "TypeError: film() got an unexpected keyword argument 'colour'")]:
            with self.subTest(arguments=arguments):
                self.assertEqual(raised(f"tribocheck.film({str(ROUGH)!r}, {arguments})")[:len(expected)], expected)


class Stubs(unittest.TestCase):
    def test_each_name_of_the_package_has_a_type_and_each_function_its_arguments(self):
        def names(path):
            return {alias.asname for node in ast.parse(path.read_text()).body if isinstance(node, ast.ImportFrom) for alias in node.names}

        package = PACKAGE / "tribocheck"
        self.assertTrue((package / "py.typed").exists())
        told = json.loads(ran("""
            import inspect
            print(json.dumps([tribocheck.__all__, {name: [*inspect.signature(one).parameters] for name, one in tribocheck.functions.items()}]))"""))
        self.assertLess({*told[0], *told[1], "Measured", "Onset", "HertzPoint"}, names(package / "__init__.pyi"))
        defined = [node for node in ast.parse((package / "_functions.pyi").read_text()).body if isinstance(node, ast.FunctionDef)]
        self.assertEqual(len(defined), 2 * len(told[1]))
        for node in defined:
            self.assertEqual([one.arg for one in node.args.args + node.args.kwonlyargs], told[1][node.name])


class Readme(unittest.TestCase):
    def test_the_examples_print_what_they_say(self):
        text = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"], "reports/bindings/README.md").read_text()
        examples = [block for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL) if "print" in block]
        self.assertEqual(len(examples), 2)
        for example in examples:
            expected = re.findall(r"(?m)^print.*?# (.+?)(?: Pa)?$", example)
            self.assertEqual(ran(f"import os\nos.chdir({ENVIRONMENT['TRIBOCHECK_ROOT']!r})\n" + example).splitlines(), expected)


    def test_the_examples_of_the_help_print_what_they_say(self):
        root = pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"])
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "scene.toml").write_text(re.search(r"```toml\n(id = .*?)```", (root / "README.md").read_text(), re.DOTALL)[1])
            pathlib.Path(folder, "reference").symlink_to(root / "reference")
            told = ran(f"""
                import doctest, os
                os.chdir({folder!r})
                runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
                given = {{"tribocheck": tribocheck, "numpy": np, "scene": tribocheck.Scene("scene.toml")}}
                for module, recurse in ((tribocheck, False), (tribocheck._scenes, True)):
                    for examples in doctest.DocTestFinder(recurse=recurse).find(module, extraglobs=given):
                        runner.run(examples)
                print(runner.summarize())""")
        self.assertRegex(told, r"^TestResults\(failed=0, attempted=1\d\)\n$")


class Check(unittest.TestCase):
    def judged(self, expression, start=""):
        return ran(textwrap.dedent(start) + FILM + f"try:\n    print(tribocheck.check({expression}))\nexcept AssertionError as error:\n    print('WRONG', error)")

    def test_a_right_function_holds(self):
        for expression in ["film, 'hamrock_dowson_central'", "{'hamrock_dowson_central': film}",
                           "lambda **given: film(**{'ellipticity': 1} | given), 'hamrock_dowson_central'",
                           "lambda h, E, R: tribocheck.hertz_point(h, E, R), 'hertz_point', arguments={'load': 'h', 'effective_modulus': 'E', 'reduced_radius': 'R'}",
                           "tribocheck.gaussian_moment, 'gaussian_moment', 'strict'", "film, 'hamrock_dowson_central', sample=np.int64(9)",
                           "tribocheck.load_sharing, 'load_sharing'",
                           "lambda order, argument: math.fsum([tribocheck.gaussian_moment(order, argument)]), 'gaussian_moment'",
                           "lambda speed, **given: film(speed, **{'ellipticity': 1} | given | {'viscosity': 1e-3 * given['viscosity']}) * 1e9, "
                           "'hamrock_dowson_central', units={'viscosity': 'mPa s', 'value': 'nm'}",
                           "lambda effective_modulus, **given: film(effective_modulus=effective_modulus / 2, **{'ellipticity': 1} | given), "
                           "'hamrock_dowson_central', modulus=\"E'\""]:
            with self.subTest(expression=expression):
                self.assertRegex(self.judged(expression, "import math\n"), r"\nCOMPLETE: \d+ of \d+ quantities held")

    def test_a_wrong_function_is_told_with_its_worst_case_and_cause(self):
        text = self.judged("lambda **given: film(**{'ellipticity': 1} | given | {'speed': 2 * given['speed']}), 'hamrock_dowson_central', name='mine'")
        self.assertTrue(text.startswith("WRONG"), text)
        for words in ["Worst of hamrock_dowson_central, in case f", "the sum of the surface speeds in place of their mean", "\nFAILED: 0 of 1 quantities held"]:
            self.assertIn(words, text)

    def test_answers_that_are_none_are_told(self):
        for answer, words in [("float('nan')", 'got "NaN", expected'), ("'x'", 'got "x", expected'), ("1j", 'got "1j", expected'),
                              ("{'colour': 1}", 'has a field "colour", which is no result of it'), ("1 / 0", "ZeroDivisionError: division by zero"),
                              ("None", "Not offered: pull_off_force (it gives None, as a function without `return` does)."), ("[1, 2, 3]", "a result has the shape (3,), not (1,)")]:
            with self.subTest(answer=answer):
                text = self.judged(f"lambda **given: {answer}, 'pull_off_force'")
                self.assertIn(words, text)
                self.assertTrue(text.startswith("WRONG"), text)

    def test_several_results_come_in_any_shape(self):
        for made in ["tuple(found)", "list(found)", "found._asdict()", "np.array(found)", "types.SimpleNamespace(**found._asdict())"]:
            with self.subTest(made=made):
                text = self.judged("mine, 'hertz_point'", f"import types\ndef mine(**given):\n    found = tribocheck.hertz_point(**given)\n    return {made}\n")
                self.assertIn("COMPLETE: 4 of 4", text)
        self.assertIn("1 of 4 quantities held", self.judged("lambda **given: {'radius': tribocheck.hertz_point(**given).radius}, 'hertz_point'"))

    def test_arguments_of_other_names_are_told_how_they_are_given(self):
        for arguments in ("work_of_adhesion, R", "radius, **rest"):
            found = self.judged(f"lambda {arguments}: 1 / 0, 'pull_off_force'")
            self.assertRegex(found, r"(got an unexpected|missing 1 required).*; check\(…, arguments=\{name in the catalogue: its own name\}\)")
        self.assertNotIn("arguments=", self.judged("lambda **given: len(3), 'pull_off_force'"))

    def test_questions_that_are_not_offered_are_skipped(self):
        start = """
            def mine(asperity, **given):
                if asperity == "greenwood_williamson":
                    raise NotImplementedError("only one")
                return tribocheck.load_sharing(asperity, **given)
            """
        text = self.judged("mine, 'load_sharing'", start)
        self.assertIn("held in part", text)
        self.assertFalse(text.startswith("WRONG"), text)

    def test_what_keeps_something_between_calls_is_told(self):
        text = self.judged("mine, 'pull_off_force'", "calls = []\ndef mine(**given):\n    calls.append(1)\n    return tribocheck.pull_off_force(**given) * (1 + len(calls) / 10)\n")
        self.assertIn("Asked the same again", text)

    def test_a_bad_question_is_a_value_error(self):
        for expression, words in [("check(abs, 'hertz')", 'ValueError: no function is called "hertz"; `tribocheck functions` lists all'), ("check(abs)", "TypeError: check() needs the name"),
                                  ("check(abs, 'hertz_point', 'loose')", 'ValueError: tolerance: "loose" is no file that can be read; allowed: engineering, strict, or the path'),
                                  ("check(abs, 'hertz_point', __import__('pathlib').Path('nowhere'))", 'ValueError: tolerance: "nowhere" is no file'),
                                  ("check(abs, 'hertz_point', '/tmp')", 'ValueError: tolerance: "/tmp" is no file that can be read'),
                                  ("check(abs, 'hertz_point', units={'load': 'mm'})", 'ValueError: units: "mm" is no unit of load; allowed: N, or another unit'),
                                  ("check(abs, 'hertz_point', units={'force': 'N'})", 'ValueError: units: "force" is no argument or result of hertz_point; allowed: load, '),
                                  ("check({'hertz_point': abs}, arguments={'force': 'F'})", 'ValueError: arguments: "force" is no argument or result of hertz_point'),
                                  ("check(abs, 'hertz_point', units='mN')", "TypeError: units: 'mN' is no dict"), ("check({})", "TypeError: check(): {} is no function"),
                                  ("check({'hertz_point': abs}, 'hertz_line')", "TypeError: check(): a dict has the names of its functions"),
                                  ("check(abs, 'hertz_point', sample=-1)", "ValueError: sample: -1 is not allowed; allowed: 0, or a whole number above it"),
                                  ("check(abs, 'hertz_point', sample=1.5)", "ValueError: sample: 1.5 is not allowed"),
                                  ("check(abs, 'hertz_point', tolerance=3)", "ValueError: tolerance: 3 is not allowed; allowed: a text")]:
            self.assertIn(words, raised("tribocheck." + expression))


class Fakes(unittest.TestCase):
    def same(self, folder, names, command):
        done = subprocess.run([sys.executable, "-B", "python_fakes.py", folder, *names], env=PYTHON_ENVIRONMENT, capture_output=True, text=True,
                              timeout=TIMEOUT * len(names))
        found = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([one[0] for one in found], names, done.stderr)
        for name, diagnoses, holds in found:
            with self.subTest(name=name):
                expected = verify("--subject", command(name))
                self.assertEqual(holds, expected.code == 0)
                self.assertEqual(diagnoses, [one["text"] for one in expected.json()["diagnoses"]])

    def test_fakes_have_the_causes_that_verify_names(self):
        names = ["none", *NAMED, *(fakes for _, fakes in SETS)] if ALL else ["none", *list(NAMED)[::40]]
        self.same("fakes", names, lambda name: subject("fakes/fake.py", "--mistake", name))

    def test_slips_have_the_causes_that_verify_names(self):
        names = run_python("-c", f"import sys; sys.path.insert(0, {str(SUBJECTS / 'slips')!r}); import solver; print(*solver.SLIPS)").split()
        self.same("slips", names if ALL else names[::50], lambda name: subject("slips/solver.py", "--slip", name))


class Wheel(unittest.TestCase):
    """The package as it is installed from a wheel, away from the tree."""

    def test_it_judges_and_has_its_library_and_tables_and_the_plug_in_of_pytest(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-m", "build", "--no-isolation", "--wheel", "--outdir", folder,
                            pathlib.Path(ENVIRONMENT["TRIBOCHECK_ROOT"], "reports/bindings/python")], check=True, capture_output=True, timeout=TIMEOUT,
                           env=ENVIRONMENT | {"TRIBOCHECK_BUILD": str(PACKAGE.parents[2])})
            wheel, = pathlib.Path(folder).glob("tribocheck-*-cp311-cp311-linux_x86_64.whl")
            with zipfile.ZipFile(wheel) as archive:
                self.assertLess({f"tribocheck/{name}" for name in ("__init__.pyi", "_functions.pyi", "_scenes.py", "py.typed")}, {*archive.namelist()})
                archive.extractall(f"{folder}/site")
            pathlib.Path(folder, "test_mine.py").write_text(START + FILM + textwrap.dedent("""
                def test_film():
                    tribocheck.check(film, "hamrock_dowson_central")
                    print(*(line for line in open("/proc/self/maps") if "libtribocheck" in line))

                def test_circle():
                    tribocheck.check(lambda **given: 2 * tribocheck.hertz_point(**given).radius, "hertz_point")
                """))
            environment = ENVIRONMENT | {"PYTHONPATH": f"{folder}/site", "PYTHONDONTWRITEBYTECODE": "1"}
            for plug_in, more in [([], {}), (["-p", "tribocheck.pytest_plugin"], {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"})]:
                done = subprocess.run([sys.executable, "-m", "pytest", "-qs", "-p", "no:cacheprovider", *plug_in, "--tribocheck"], cwd=folder,
                                      capture_output=True, text=True, timeout=TIMEOUT, env=environment | more)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                table = done.stdout[done.stdout.index(" tribocheck "):]
                self.assertRegex(table, r"hamrock_dowson_central +COMPLETE: 1 of 1 quantities held")
                self.assertRegex(table, r"hertz_point +FAILED: 0 of")
                self.assertIn("1 failed, 1 passed", done.stdout)
                self.assertEqual(set(re.findall(r"\S*libtribocheck\S*", done.stdout)), {f"{folder}/site/tribocheck/libtribocheck.so.0"})


if __name__ == "__main__":
    unittest.main()
