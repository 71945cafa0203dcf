# SPDX-License-Identifier: Apache-2.0
"""verify --baseline, with a solver that holds some functions and is then broken in one way after another."""

import json
import pathlib
import unittest

import jsonschema

from conformance import PYTHON, SUBJECTS, junit_suite
from program import ProgramTest, run

SCHEMAS = pathlib.Path(SUBJECTS).parents[2] / "reference/schemas"

# A right solver of some functions. {change} is a line of its loop, which may change the answer.
SOLVER = """
import json, math, os, random, signal, struct, sys
sys.path.insert(0, {folder!r})
import subject
HAS = {{"hertz_point", "hertz_line", "hamrock_dowson_central", "gaussian_moment", "effective_modulus"}}
def noisy(answer, size, draw=random):
    return {{name: value * (1 + draw.uniform(-size, size)) if isinstance(value, float) else value
            for name, value in answer.items()}}
def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]
for number, text in enumerate(sys.stdin, 1):
    question = json.loads(text)
    name, given = question.get("function"), question
    answer = json.loads(subject.answer_text(text)) if name in HAS else {{"skip": "not in this solver"}}
    if name is None:
        film = json.loads(subject.answer_text(text)).get("film")
        answer = {{"film": film}}
    {change}
    print(json.dumps({{**answer, "id": question["id"]}}), flush=True)
"""


class Breaks(ProgramTest):
    def setUp(self):
        super().setUp()
        self.baseline, self.junit = self.folder.path("baseline.json"), self.folder.path("junit.xml")

    def ask(self, change, tolerance="engineering", *more, format="json"):
        """Judges the solver with this change; at most 60 cases of each function are enough to see it."""
        text = SOLVER.format(folder=str(SUBJECTS / "python_stdlib"), change=change)
        command = f"{PYTHON} -B {self.folder.write('solver.py', text)}"
        return run("verify", "--subject", command, "--tolerance", tolerance, "--baseline", self.baseline, "--junit",
                   self.junit, "--sample", "60", "--format", format, *more)

    def worse(self, change, tolerance="engineering"):
        """Returns the texts of what is worse. Asserts that JSON, JUnit and the exit code agree."""
        result = self.ask(change, tolerance)
        document = result.json()
        jsonschema.validate(document, json.loads((SCHEMAS / "verify-subject.schema.json").read_text()))
        worse = document["changes"]["worse"]
        self.assertEqual(result.code, 1 if worse else 0, result.err)
        suite = junit_suite(self.junit)
        red = [case.get("name") for case in suite.iter("testcase") if case.find("failure") is not None]
        self.assertEqual(sorted(red), sorted({one["quantity"] for one in worse}))
        return [one["text"] for one in worse]

    def test_each_break_is_noticed_and_its_quantity_named(self):
        self.ask("pass", "engineering", "--update-baseline")
        jsonschema.validate(json.loads(pathlib.Path(self.baseline).read_text()),
                            json.loads((SCHEMAS / "verify-baseline.schema.json").read_text()))
        self.assertEqual(self.worse("pass"), [])
        for name, change, words in (
                ("a constant", "if name == 'hamrock_dowson_central': answer['value'] *= 2.70 / 2.69",
                 ["hamrock_dowson_central: was held, is FAILED"]),
                ("float32 in one branch", "if name == 'gaussian_moment' and given['order'] == 2.5: "
                 "answer['value'] = single(answer['value'])", ["gaussian_moment: "]),
                ("a function dropped", "if name == 'hertz_line': answer = {'skip': 'gone'}",
                 [f"hertz_line.{one}: was held, is not offered" for one in
                  ("half_width", "mean_pressure", "peak_pressure", "peak_shear")]),
                ("NaN in a corner", "if name == 'gaussian_moment' and given['argument'] > 10: "
                 "answer['value'] = math.nan", ["gaussian_moment: "]),
                ("noise of 1e-9", "answer = noisy(answer, 1e-9)", ["effective_modulus: the worst error was "]),
                ("mm for m", "if name == 'hertz_point': answer['radius'] *= 1e3",
                 ["hertz_point.radius: was held, is FAILED"])):
            with self.subTest(name):
                worse = self.worse(change)
                for one in words:
                    self.assertIn(one, "\n".join(worse))
                allowed = {one.split(":")[0] for one in words}
                if name != "noise of 1e-9":
                    self.assertEqual({one.split(":")[0] for one in worse}, allowed)

    def test_a_crash_is_one_fault_with_its_signal_and_the_line_that_shows_it(self):
        self.ask("pass", "engineering", "--update-baseline")
        crash = "if number == 500 or given['id'] == 'm0000': os.kill(os.getpid(), signal.SIGSEGV)"
        line, = self.worse(crash)
        self.assertRegex(line, r"^subject: at case m0000 \(gaussian_moment\) and at \d more: it is killed by signal 11 "
                         r"\(SIGSEGV, Segmentation fault\).*; lost by this: gaussian_moment(, \S+)*; --show m0000 asks it alone$")
        suite = junit_suite(self.junit)
        skipped = suite.find("testcase[@name='gaussian_moment']/skipped").get("message")
        self.assertIn("lost by the subject's end or silence: ", skipped)
        for format in ("table", "markdown"):
            said = self.ask(crash, format=format).out
            self.assertIn("tribocheck verify --subject '", said)
            self.assertIn("--show m0000\n", said)
            self.assertNotIn("Worst of", said)
        # Without a baseline it is one fault, too.
        alone = run("verify", "--subject", f"{PYTHON} -B {self.folder.path('solver.py')}", "--junit", self.junit)
        self.assertEqual((alone.code, [one.get("name") for one in junit_suite(self.junit).findall("testcase[failure]")]),
                         (1, ["subject"]))
        # An update does not write the crash into the baseline. --force does, and then the same crash is no longer worse.
        kept = self.ask(crash, "engineering", "--update-baseline")
        self.assertIn("baseline kept: subject: at case m", kept.err)
        self.assertEqual(json.loads(pathlib.Path(self.baseline).read_text())["losses"], [])
        forced = self.ask(crash, "engineering", "--update-baseline", "--force")
        self.assertIn("baseline lowered: subject: at case m", forced.err)
        self.assertIn("The baseline was lowered: subject: at case m", "\n".join(forced.json()["notes"]))
        self.assertEqual(self.worse(crash), [])
        self.assertIn("subject: it goes on at ", self.ask("pass").out)

    def test_noise_is_seen_by_its_size_or_as_it_changes(self):
        """Noise that is the same for each question is seen where it exceeds four times the worst error of the baseline."""
        rounded = "answer = {key: float(f'{x:.7e}') if isinstance(x, float) else x for key, x in answer.items()}"
        steady, changing = "random.Random(text)", "random"
        for tolerance, before, size, draw, is_seen in (
                ("engineering", "pass", 1e-9, steady, True), ("engineering", "pass", 1e-13, steady, True),
                ("strict", "pass", 1e-9, changing, True), ("strict", "pass", 1e-13, steady, True),
                ("engineering", rounded, 1e-9, steady, False), ("engineering", rounded, 1e-13, steady, False),
                ("engineering", rounded, 1e-13, changing, True)):
            with self.subTest(f"{tolerance}, {size}, {draw}, after {before}"):
                pathlib.Path(self.baseline).unlink(missing_ok=True)
                self.ask(before, tolerance, "--update-baseline")
                noise = f"if name == 'hertz_point': answer = noisy(answer, {size}, {draw})"
                worse = self.worse(f"{before}\n    {noise}", tolerance)
                self.assertEqual({one.split(".")[0] for one in worse}, {"hertz_point"} if is_seen else set())


if __name__ == "__main__":
    unittest.main()
