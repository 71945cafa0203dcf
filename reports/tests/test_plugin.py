# SPDX-License-Identifier: Apache-2.0
"""tribocheck plugin-host, and solvers that are registered in C++ (verification/conformance)."""
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest

from plugins import (ask_plugin, ask_program, film, hertz, lines, moment, plugin, point, shared, starved)
from program import ENVIRONMENT, PROGRAM, TIMEOUT, ProgramTest, run, start

CLOSURES = ["flooded_inlet", "starved_inlet", "printed_exponents", "damiens"]
ASPERITIES = ["greenwood_tripp", "greenwood_williamson"]

# Some questions of each kind; among them undefined ones, ones out of range, and lines that are no question.
FUNCTIONS = [
    *(moment(d, n) for n in [0, 0.5, 1, 1.5, 2, 2.5] for d in [-1e300, -30, -1.146, 0, 0.3, 7, 36, 50]),
    *(hertz(load) for load in [1e-3, 50, 1e300]),
    *(film(u) for u in [1e-4, 0.1, 3]), film(ellipticity=2), film(viscosity=1e-320, load=1e300),
    *(starved(c, r) for c in CLOSURES for r in [1e-3, 0.5, 1, 30]), starved("damiens", 2, damiens_exponent=1.5),
    *(shared(a, flooded, k) for a in ASPERITIES for flooded in [1e-3, 1, 4] for k in [0, 0.3, 3]),
]
REFUSED = ["", "no JSON", "[1]", "{}", {"id": "m", "function": "no such"}, moment(0, 0.7), moment("a"),
           {"id": 1, "function": "hertz_point"}, point(speed=-1), point(load=None), '{"id": "half']
POINTS = [
    *(point(s, u) for s in ["rough", "medium", "smooth"] for u in [1e-4, 0.01, 0.1, 3]),
    point(speed=3, supply={"inlet_film": 1e-8}),                       # collapsed
    point("smooth", speed=3, supply={"inlet_flow": 1e-8}),
    point(supply=None),
    point(friction=None, outputs=["film", "regime", "inlet"]),
    point(friction={"boundary_coefficient": 0.1, "fluid": "limiting", "viscosity": "roelands",
                    "slide_roll_ratio": 0.2}),
    point(closures={"asperity": "greenwood_williamson", "starvation": "damiens", "damiens_exponent": 2}),
    point(outputs=["summit_count"], load=5e-300),
    point(load=1e300), point(speed=1e300),
]


class OwnModel(unittest.TestCase):
    """Through the C header and through registration the model gives the answers of `stream`, byte for byte."""

    def same(self, asked):
        expected = run("stream", stdin=lines(asked)).ended(0)
        self.assertGreater(len(expected.out.splitlines()), 2)
        for done in [ask_plugin("own_model_plugin", *asked), ask_program("own_model", *asked)]:
            self.assertEqual((done.code, done.err), (0, ""))
            self.assertEqual(done.out.splitlines(), expected.out.splitlines())

    def test_functions(self):
        self.same(FUNCTIONS)

    def test_points(self):
        self.same(POINTS)

    def test_what_is_refused(self):
        self.same(REFUSED)

    def test_mixed_and_more_than_go_together(self):
        self.same([one for i in range(300) for one in [
            POINTS[i % 5], FUNCTIONS[i % len(FUNCTIONS)], REFUSED[i % len(REFUSED)]]])
        self.same([moment(i / 1000) for i in range(3000)])

    def test_a_line_that_is_too_long(self):
        self.same([hertz(), "x" * (1 << 20) + "y", hertz(2), hertz(3)])


class Examples(unittest.TestCase):
    def close(self, found, expected):
        self.assertEqual(found.keys(), expected.keys())
        for key, value in expected.items():
            if isinstance(value, float):
                self.assertAlmostEqual(found[key] / value, 1, delta=1e-12)
            else:
                self.assertEqual(found[key], value)

    def agrees(self, done, asked, offered):
        self.assertEqual((done.code, done.err), (0, ""))
        expected = run("stream", stdin=lines(asked)).json_lines()
        for question, found, value in zip(asked, done.json_lines(), expected, strict=True):
            if question.get("function") in offered:
                self.close(found, value)
            else:
                self.assertEqual(found.keys(), {"id", "skip"})

    ASKED = [moment(-1.146), moment(3, 2), hertz(), film(),
             *(starved(c, 0.6) for c in CLOSURES), *(shared(a) for a in ASPERITIES), point()]

    def test_c(self):
        self.agrees(ask_plugin("c_plugin", *self.ASKED), self.ASKED,
                    {"gaussian_moment", "hertz_point", "hamrock_dowson_central", "starvation_ratio"})

    def test_registration(self):
        asked = [one for one in self.ASKED if one.get("function") != "starvation_ratio"]
        self.agrees(ask_program("cpp_registration", *asked), asked, {"hertz_point", "hamrock_dowson_central"})

    def test_a_case_may_be_skipped(self):
        only, = ask_program("cpp_registration", starved("flooded_inlet", 0.5)).json_lines()
        self.assertEqual(only, {"id": "f", "skip": "only Damiens' closure"})
        far, = ask_plugin("c_plugin", moment(-11)).json_lines()
        self.assertEqual(far.keys(), {"id", "skip"})


class Statuses(unittest.TestCase):
    def ask(self, *asked):
        return ask_plugin("every_status", *asked).ended(0, "").json_lines()

    def test_each_status_is_an_answer(self):
        answers = self.ask(*(moment(status) for status in [0, 1, 2, 3, 7, 100, -1]))
        self.assertEqual(answers[0], {"id": "f", "value": 9.5})
        self.assertEqual(answers[1].keys(), {"id", "skip"})
        self.assertEqual(answers[2]["value"], None)
        self.assertEqual(answers[2]["undefined"].keys(), {"value"})
        for answer, word in zip(answers[3:], ["failed", "7", "no status", "NaN"], strict=True):
            self.assertIn(word, answer["error"]["message"])

    def test_neighbours_come_as_one_array(self):
        together = self.ask(*[moment(0)] * 5, hertz(), *[moment(0)] * 2)
        self.assertEqual([one.get("value") for one in together], [7.5] * 5 + [None] + [4.5] * 2)
        one = {"speed": 1, "load": 3, "outputs": ["film"]}
        scenes = [*[point(**one)] * 3, point(**{**one, "load": 2}), point(**one), point("smooth", **one)]
        films = [answer["film"] for answer in self.ask(*scenes)]
        self.assertEqual(films, [3, 3, 3, 1, 1, 1])

    def test_points_offer_what_they_have(self):
        answer, = self.ask(point(load=3))
        self.assertEqual(answer, {"id": "rough", "film": 0.1, "friction": None, "regime": "mixed",
                                  "inlet": "starved",
                                  "undefined": {"friction": "outside the range of double precision"}})
        collapsed, = self.ask(point(load=4, outputs=["friction"]))
        self.assertEqual(collapsed["undefined"], {"friction": "the film has collapsed: nothing balances the load"})
        none, = self.ask(point(load=1, outputs=["regime", "summit_count"]))
        self.assertEqual(none.keys(), {"id"})

    def test_codes_that_mean_nothing(self):
        for load in [5, 9]:
            answer, = self.ask(point(load=load))
            self.assertIn("code", answer["error"]["message"])


class Process(unittest.TestCase):
    def test_what_a_plugin_prints_is_no_answer(self):
        done = ask_plugin("talkative", moment(0), hertz(), moment(1)).ended(0)
        self.assertEqual([one.get("value") for one in done.json_lines()], [1, None, 1])
        for word in ["greeting", "2.5 at 0", "past the library", "2.5 at 1"]:
            self.assertIn(word, done.err)

    def test_prints_with_stderr_closed_are_lost(self):
        command = f"'{PROGRAM}' plugin-host '{plugin('talkative')}' 2>&-"
        done = subprocess.run(["bash", "-c", command], input=lines([moment(0)]).encode(),
                              capture_output=True, timeout=TIMEOUT, env=ENVIRONMENT)
        self.assertEqual((done.returncode, done.stdout), (0, b'{"id": "f", "value": 1}\n'))

    def test_answers_before_a_crash_are_out(self):
        done = ask_plugin("crashing", hertz(), point(), "no JSON", hertz(), moment(0), hertz())
        self.assertEqual(done.code, -signal.SIGABRT)
        answers = done.json_lines()
        self.assertEqual([list(one)[1] for one in answers], ["radius", "skip", "error", "radius"])
        self.assertEqual(answers[0], {"id": "h", "radius": 1})

    def test_an_exception_is_of_its_own_case(self):
        done = ask_plugin("throwing", hertz(1), hertz(13), hertz(2)).ended(0, "")
        self.assertEqual([list(one)[1] for one in done.json_lines()], ["radius", "error", "radius"])
        self.assertEqual(done.json_lines()[1]["error"]["message"], "bad luck")

    def test_who_waits_for_an_answer_gets_it(self):
        for command in [[PROGRAM, "plugin-host", plugin("c_plugin")],
                        [os.path.join(os.path.dirname(plugin("x")), "cpp_registration")]]:
            with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                  env=ENVIRONMENT) as process:
                for load in [1, 2]:
                    process.stdin.write(lines([hertz(load)]).encode())
                    process.stdin.flush()
                    self.assertIn("radius", json.loads(process.stdout.readline()))
                process.stdin.close()
                self.assertEqual(process.wait(TIMEOUT), 0)

    def test_the_reader_may_go_away(self):
        process = start("plugin-host", plugin("c_plugin"), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE)
        process.stdout.close()
        process.stdin.write(lines([hertz()] * 10).encode())
        process.stdin.close()
        self.assertEqual((process.wait(TIMEOUT), process.stderr.read()), (0, b""))
        process.stderr.close()


class Refusals(ProgramTest):
    def assert_not_loaded(self, path, *words):
        self.assert_refused(run("plugin-host", path, stdin=lines([hertz()])), str(path), *words)

    def test_a_file_that_is_not_there(self):
        self.assert_not_loaded("no_such.so", "No such file")

    def test_a_text_a_folder_and_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            text = pathlib.Path(folder) / "text.so"
            text.write_text("int main;\n" * 100)
            self.assert_not_loaded(text, "cannot be loaded")
            self.assert_not_loaded(folder, "cannot be loaded")
        self.assert_not_loaded("/dev/null", "cannot be loaded")

    def test_versions(self):
        self.assert_not_loaded(plugin("wrong_version"), "version 4", "version 3")
        self.assert_not_loaded(plugin("no_version"), "tribocheck_plugin_version")

    def test_no_library_is_named(self):
        done = run("plugin-host")
        self.assertEqual((done.code, done.out), (2, ""))
        self.assertIn("LIBRARY", done.err)


if __name__ == "__main__":
    unittest.main()
