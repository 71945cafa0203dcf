# SPDX-License-Identifier: Apache-2.0
"""verify --subject: faults that people's first solvers have, and the messages on them."""

import json
import math
import pathlib
import re
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import PYTHON, subject
from program import ENVIRONMENT, PROGRAM, TIMEOUT, ProgramTest, Result, run

# A solver that answers radius and skips all else. {before} is run first, {each} for each question.
SOLVER = """
import json, sys, time
{before}
for line in sys.stdin:
    question = json.loads(line)
    name, answer = question.get("function"), {{"skip": "no"}}
    if name == "hertz_point":
        cube = 0.75 * question["load"] * question["reduced_radius"] / question["effective_modulus"]
        answer = {{"radius": cube ** (1 / 3)}}
    {each}
    print(json.dumps({{"id": question["id"], **answer}}), flush={flush})
"""


def questions(sample):
    """The number of questions with `sample` of each function and of each of the four kinds of operating points."""
    return sample * (len(run("functions").out.splitlines()) + 4)


def questions_and_again(sample):
    """questions(), and those that are asked again: one in 24 of each kind, and one for each of the two paper scenes in the sample."""
    return questions(sample) + math.ceil(sample / 24) * questions(1) + 2


class Trips(ProgramTest):
    def command(self, before="", each="", flush=True):
        path = self.folder.write("solver.py", SOLVER.format(before=before, each=each, flush=flush))
        return f"{PYTHON} -B {path}"

    def verify(self, command, *arguments):
        environment = {key: value for key, value in ENVIRONMENT.items() if key != "PYTHONUNBUFFERED"}
        sample = [] if {"--sample", "--show"} & set(arguments) else ["--sample", "12"]
        done = subprocess.run([PROGRAM, "verify", "--subject", command, *sample, *arguments],
                              capture_output=True, timeout=TIMEOUT, env=environment)
        return Result(done.returncode, done.stdout.decode(), done.stderr.decode())

    def verdict(self, command, *arguments):
        result = self.verify(command, "--format", "json", *arguments)
        self.assertEqual(re.sub("tribocheck: .* cases will take some .*\n", "", result.err), "")
        return result.json()

    def statuses(self, verdict):
        return {one["quantity"]: one["status"] for one in verdict["quantities"]}


class Silence(Trips):
    def assert_silent(self, command, why, *arguments):
        result = self.verify(command, *arguments)
        self.assertEqual((result.code, result.out), (2, ""))
        self.assertEqual(result.error_lines[0], f"tribocheck: {command} never answered: {why}")
        return result.error_lines[1:]

    def test_a_subject_that_exits_at_once_is_one_line_and_the_end_of_its_stderr(self):
        command = self.command("import argparse\np = argparse.ArgumentParser()\n"
                               "p.add_argument('scene')\np.parse_args()")
        said = self.assert_silent(command, "it exits with code 2")
        self.assertIn("error: the following arguments are required: scene", said[-1])

    def test_a_traceback_is_told_whole(self):
        said = self.assert_silent(self.command("import no_such_module"), "it exits with code 1")
        self.assertEqual(said[0], "tribocheck: the last it wrote to stderr:")
        self.assertEqual(said[1], "  Traceback (most recent call last):")
        self.assertEqual(said[-1], "  ModuleNotFoundError: No module named 'no_such_module'")

    def test_no_more_than_20_lines_of_stderr_are_told(self):
        before = "for i in range(100): print(i, file=sys.stderr)\nsys.exit(3)"
        said = self.assert_silent(self.command(before), "it exits with code 3")
        self.assertEqual(said[1:], [f"  {i}" for i in range(80, 100)])

    def test_a_subject_that_writes_nothing_is_waited_for_as_long_as_a_start_may_take(self):
        self.assert_silent(self.command("time.sleep(100)"), "it gives no answer within 1.5 s",
                           "--case-timeout", "0.3", "--start-timeout", "1.5")

    def test_a_subject_that_may_not_flush_is_told_so_where_it_reads(self):
        hint = "; if it prints answers, it may not flush its output after each line"
        slow = self.command(each="time.sleep(0.4)", flush=False)
        self.assert_silent(slow, "it gives no answer within 2 s" + hint, "--case-timeout", "1", "--start-timeout", "2",
                           "--timeout", "60")
        half = self.command(each="if name == 'hertz_point': print('{\"id\"', end='', flush=True); time.sleep(60)")
        verdict = self.verdict(half, "--case-timeout", "1", "--start-timeout", "1", "--sample", "3")
        reason = next(one["reason"] for one in verdict["quantities"] if one["quantity"] == "hertz_point.radius")
        self.assertIn("no answer within 1 s; half a line has come: it does not flush its output after each line", reason)

    def test_lines_of_stderr_that_repeat_are_told_once(self):
        before = "for i in range(100): print('overflow', file=sys.stderr)\nprint('end', file=sys.stderr)\nsys.exit(3)"
        said = self.assert_silent(self.command(before), "it exits with code 3")
        self.assertEqual(said[1:], ["  overflow", "    and 99 more like it", "  end"])

    def test_answers_without_an_id_are_told(self):
        self.assert_silent(self.command(each="print('{}', flush=True); continue"),
                           "it answers no case; an answer without an id: {}")

    def test_lines_that_are_no_json_are_told(self):
        self.assert_silent(self.command(each="print({'id': question['id']}, flush=True); continue"),
                           "its first line is no JSON at character 2, between `{` and `'id': 'e0000'}`",
                           "--start-timeout", "10")


class Prints(Trips):
    def test_prints_to_stdout_are_one_note_and_do_no_harm(self):
        for each in ("print('debug', name)",            # Python's buffer holds the text until the answer
                     "print('asked', line, end='')",    # with the id of the case in it
                     "print(line, end='')"):            # an object with the id of the case
            with self.subTest(each):
                verdict = self.verdict(self.command(each=each))
                self.assertEqual((verdict["overall"], verdict["violation_count"]), ("partial", 0))
                self.assertEqual(self.statuses(verdict)["hertz_point.radius"], "held")
                note, = verdict["notes"]
                self.assertRegex(
                    note, f"^It wrote {questions_and_again(12)} lines to stdout that are no answers; print to stderr")

    def test_many_lines_before_an_answer_are_prints(self):
        verdict = self.verdict(self.command("[print('loading', i) for i in range(500)]"))
        self.assertEqual(verdict["overall"], "partial")
        self.assertIn("It wrote 500 lines", verdict["notes"][0])


class Times(Trips):
    def test_a_slow_start_is_waited_for_and_is_not_said_to_be_without_flush(self):
        verdict = self.verdict(self.command("time.sleep(2)"), "--case-timeout", "0.5")
        self.assertEqual((verdict["overall"], verdict["starts"]), ("partial", 1))
        self.assertFalse(verdict["answers_at_end_of_input"])
        self.assertEqual(verdict["notes"], [])

    def test_imports_at_the_first_question_are_a_slow_start_too(self):
        each = "slept or slept.append(time.sleep(2))"
        verdict = self.verdict(self.command("slept = []", each), "--case-timeout", "0.5", "--sample", "500")
        self.assertEqual((verdict["overall"], verdict["starts"]), ("partial", 1))
        self.assertFalse(verdict["answers_at_end_of_input"])

    def test_who_reads_a_line_ahead_answers_the_last_case_too(self):
        program = """
import subprocess, sys
model = subprocess.Popen([sys.argv[1], "stream"], text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
held = sys.stdin.readline()
while held:
    ahead = sys.stdin.readline()
    print(held, end="", file=model.stdin, flush=True)
    print(model.stdout.readline(), end="", flush=True)
    held = ahead
"""
        path = self.folder.write("ahead.py", program)
        verdict = self.verdict(f"{PYTHON} -B {path} {PROGRAM}", "--case-timeout", "2")
        self.assertEqual((verdict["overall"], verdict["starts"]), ("complete", 1))

    def test_who_does_not_flush_is_told_so(self):
        verdict = self.verdict(self.command(flush=False), "--case-timeout", "1", "--sample", "4")  # fewer bytes than a buffer holds
        self.assertEqual((verdict["overall"], verdict["starts"]), ("partial", 1))
        self.assertTrue(verdict["answers_at_end_of_input"])

    def test_the_allowance_is_in_the_help(self):
        words = " ".join(run("verify", "--help").out.split())
        self.assertRegex(words, r"--start-timeout .* to the first answer \(default: 60")


class Answers(Trips):
    def test_nan_and_infinity_fail_their_own_field_alone(self):
        for token in ("nan", "inf", "-inf"):
            each = f"answer.update(approach=float('{token}')) if 'radius' in answer else None"
            statuses = self.statuses(self.verdict(self.command(each=each)))
            self.assertEqual((statuses["hertz_point.radius"], statuses["hertz_point.approach"]),
                             ("held", "FAILED"), token)

    def test_a_misspelt_field_gets_a_hint(self):
        each = "answer = {'raduis': 1} if 'radius' in answer else answer"
        self.assertEqual(self.verdict(self.command(each=each))["notes"], [
            'Each of 12 answers of hertz_point has a field "raduis", which is no result of it; '
            'did you mean radius?'])
        each = "answer = {'film': 1} if name == 'hamrock_dowson_central' else answer"
        note, = self.verdict(self.command(each=each))["notes"]
        self.assertIn("its result is called value", note)
        each = "answer = {**answer, 'iterations': 1} if 'radius' in answer else answer"
        self.assertEqual(self.verdict(self.command(each=each))["notes"], [])

    def test_a_line_that_is_no_json_is_quoted_where_it_stops_to_be(self):
        wrong = """if name == "load_sharing":
        print('{"id": "%s", "value": 1.2.3}' % question["id"], flush=True)
        continue"""
        verdict = self.verdict(self.command(each=wrong))
        reason = next(one["reason"] for one in verdict["quantities"] if one["quantity"] == "load_sharing")
        self.assertEqual(reason, "r0000: no JSON at character 29, between "
                                 '`{"id": "r0000", "value": 1.2` and `.3}`')
        self.assertEqual(self.statuses(verdict)["hertz_point.radius"], "held")

    def test_the_error_of_a_case_is_told_with_the_end_of_stderr(self):
        each = "answer = {'error': 'no root'} if name == 'load_sharing' else answer"
        before = "print('Traceback', file=sys.stderr)\nprint('ValueError: no root', file=sys.stderr)"
        junit = self.folder.path("junit.xml")
        result = self.verify(self.command(before, each), "--format", "markdown", "--junit", junit).ended(1)
        self.assertIn("  Traceback\n  ValueError: no root\n", result.out)
        said = ElementTree.parse(junit).find(".//system-err").text
        self.assertEqual(said, "Traceback\nValueError: no root")


class Evidence(Trips):
    SMALL = subject("small_python/my_solver.py")

    def asked(self):
        result = run("verify", "--save-cases", "-").ended(0, "")
        return {line["id"]: line for line in result.json_lines()}

    def test_the_worst_case_of_each_failed_quantity_is_shown_in_every_format(self):
        junit = self.folder.path("junit.xml")
        verdict = self.verdict(self.SMALL, "--junit", junit)
        example, = verdict["examples"]
        worst = next(one for one in verdict["quantities"] if one["status"] == "FAILED")
        self.assertEqual((example["quantity"], example["case"]), (worst["quantity"], worst["worst_case"]))
        self.assertEqual(example["request"], self.asked()[example["case"]])
        self.assertEqual(example["unit"], "m")
        self.assertAlmostEqual(example["got"] / example["expected"], 0.725, delta=1e-3)
        self.assertAlmostEqual(abs(example["got"] - example["expected"]) / example["allowed_error"]
                               / example["part_of_bound"], 1, delta=1e-9)
        failure = ElementTree.parse(junit).find(".//failure")
        for text in (self.verify(self.SMALL).out, self.verify(self.SMALL, "--format", "markdown").out,
                     failure.text):
            request = next(line for line in text.splitlines() if line.strip().startswith('{"'))
            self.assertEqual(json.loads(request), example["request"])
            for word in (example["case"], f"got {example['got']} m, expected {example['expected']} m",
                         "R/2 in place of R"):
                self.assertIn(word, text)

    def test_a_case_is_shown_with_what_was_asked_expected_and_answered(self):
        film, = [one for one in self.asked().values() if one["id"] == "f0003"]
        result = self.verify(self.SMALL, "--show", "f0003", "--show", "h0000").ended(1, "")
        lines = result.out.splitlines()
        self.assertEqual(json.loads(lines[0].removeprefix("asked:")), film)
        self.assertEqual(list(json.loads(lines[1].removeprefix("answered:"))), ["id", "value"])
        self.assertRegex(lines[2], "^  hamrock_dowson_central: got .* m, expected .* m, give or take .*: "
                                   ".* times as far off as is allowed$")
        self.assertIn("  hertz_point.radius: got ", result.out)
        self.assertIn(" of the error that is allowed", result.out)
        held, skipped = self.verify(self.SMALL, "--show", "h0000"), self.verify(self.SMALL, "--show", "h0000", "--show", "r0000")
        self.assertEqual((held.code, skipped.code), (0, 0))
        self.assertIn("all of it holds where each case is asked alone", held.err)
        self.assertEqual(skipped.err, "")  # what is skipped holds nothing

    def test_a_case_that_has_no_answer_is_shown_with_the_reason(self):
        result = self.verify(self.command(each="raise ValueError('no root')"), "--show", "r0000").ended(1)
        self.assertIn("answered: it exits with code 1", result.out)
        self.assertIn("got nothing (it exits with code 1), expected", result.out)
        self.assertEqual(result.error_lines[-1], "  ValueError: no root")

    def test_a_case_is_shown_without_a_subject_too(self):
        result = run("verify", "--show", "h0000").ended(0)
        self.assertEqual(json.loads(result.out.splitlines()[0]), self.asked()["h0000"])
        self.assertRegex(result.out, "hertz_point.radius: expected .* m, give or take ")

    def test_a_case_that_is_not_there_is_bad_input(self):
        result = run("verify", "--show", "z0000")
        self.assertEqual((result.code, result.out), (2, ""))
        self.assertIn("--show: no case is called z0000; --save-cases - lists all", result.err)

    def test_the_cases_are_saved_as_lines_for_any_program(self):
        path = self.folder.path("cases.jsonl")
        self.assertEqual(run("verify", "--save-cases", path, "--sample", "5").code, 0)
        text = pathlib.Path(path).read_text()
        answers = run("stream", stdin=text).ended(0)
        self.assertEqual([json.loads(line)["id"] for line in text.splitlines()],
                         [one["id"] for one in answers.json_lines()])
        self.assertEqual(len(text.splitlines()), questions(5))
        both = self.verify(self.SMALL, "--save-cases", path)  # and then the verdict
        self.assertEqual(both.code, 1)
        self.assertEqual(len(pathlib.Path(path).read_text().splitlines()), questions(12))
        refused = self.verify(self.SMALL, "--save-cases", "-")
        self.assertEqual((refused.code, refused.out), (2, ""))

    def test_a_function_that_is_required_is_all_of_its_quantities(self):
        result = self.verify(self.SMALL, "--require", "hertz_point")
        self.assertEqual(result.err, "")
        missing = self.verify(self.command(), "--require", "hertz_point").ended(1)
        self.assertEqual(missing.error_lines, [
            f"tribocheck: required, but not offered: hertz_point.{name}"
            for name in ("mean_pressure", "peak_pressure", "approach")])
        self.assertEqual(self.verify(self.SMALL, "--require", "hertz").code, 2)


if __name__ == "__main__":
    unittest.main()
