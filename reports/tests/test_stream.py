# SPDX-License-Identifier: Apache-2.0
"""stream answers each line of any input at once, in order."""

import select
import subprocess
import unittest

from program import PROGRAM, TIMEOUT, Literal, json_value, run, scene, start, strict_json

MIB = 1 << 20


def point(**changes):
    return scene(**{"speed": 0.1, **changes})


def answers(*lines):
    text = "".join((line if isinstance(line, str) else json_value(line)) + "\n" for line in lines)
    result = run("stream", stdin=text)
    return result, result.json_lines()


class Answers(unittest.TestCase):
    def assert_error(self, line, identity, field, *words):
        with self.subTest(line=line if isinstance(line, dict) else line[:80]):
            result, (answer,) = answers(line)
            self.assertEqual((result.code, result.err), (0, ""))
            self.assertEqual(list(answer), ["id", "error"])
            self.assertEqual(answer["id"], identity)
            self.assertEqual(list(answer["error"]), ["field", "message"])
            self.assertEqual(answer["error"]["field"], field)
            for word in words:
                self.assertIn(word, answer["error"]["message"])

    def test_table_1(self):
        expected = {"rough": (0.765412364174454, 3.88840686142501e-10),
                    "medium": (0.642288015366864, 3.65851178220415e-10),
                    "smooth": (0.537872259415982, 3.51904815844975e-10)}
        _, found = answers(*[scene(surface, speed=1e-4) for surface in expected])
        for answer, (share, film) in zip(found, expected.values(), strict=True):
            self.assertAlmostEqual(answer["asperity_load_share"] / share, 1, delta=1e-14)
            self.assertAlmostEqual(answer["film"] / film, 1, delta=1e-14)

    def test_answers_come_in_order(self):
        lines = [point(id=f"p{i}", speed=1e-4 * (1 + i % 97)) if i % 3 else f"junk {i}"
                 for i in range(2000)]
        _, found = answers(*lines)
        self.assertEqual([answer["id"] for answer in found],
                         [f"p{i}" if i % 3 else None for i in range(2000)])

    def test_an_answer_does_not_depend_on_its_place(self):
        lines = [json_value(point(id="x", speed=1e-3 * (1 + i))) for i in range(50)]
        _, forward = answers(*lines)
        _, backward = answers(*reversed(lines))
        self.assertEqual(forward, backward[::-1])

    def test_outputs(self):
        _, (answer,) = answers(point(outputs=["regime", "film"]))
        self.assertEqual(list(answer), ["id", "film", "regime"])

    def test_undefined(self):
        _, (answer,) = answers(scene("smooth", speed=3, outputs=["friction", "inlet"]))
        self.assertEqual(answer, {"id": "smooth", "friction": None, "inlet": "collapsed",
                                  "undefined": {"friction": "the film has collapsed: nothing balances the load"}})

    def test_without_an_id(self):
        _, (answer,) = answers(point(id=None, outputs=["film"]))
        self.assertEqual((list(answer), answer["id"]), (["id", "film"], None))

    def test_an_id_that_is_a_number_comes_back_as_a_number(self):
        function = '"function": "gaussian_moment", "order": 2, "argument": 0'
        for text in ("7", "0", "-3", "100000000", "9007199254740991", "0.1", "1e-300", "2.5e8"):
            texts = [json_value(point(id="@", outputs=["film"])), '{"id": "@", %s}' % function,
                     json_value(point(id="@", load=-5)), '{"id": "@", %s, "more": 1}' % function]
            _, found = answers(*(line.replace('"@"', text) for line in texts))
            self.assertEqual([answer["id"] for answer in found], [float(text)] * 4, text)
            self.assertEqual([type(answer["id"]) for answer in found],
                             [int if float(text).is_integer() else float] * 4, text)
            self.assertEqual(["error" in answer for answer in found], [False, False, True, True])
        for text in ("9007199254740992", "-9007199254740993", "1e400", "1e-400", "null", "[1]"):
            self.assert_error(json_value(point(id="@")).replace('"@"', text), None, "id", "a text, or a number")
            self.assert_error('{"id": %s, %s}' % (text, function), None, "id", "a text, or a number")

    def test_errors_in_a_scene(self):
        self.assert_error(point(load=-5), "rough", "load", "-5 is not allowed")
        self.assert_error(point(load=None), "rough", "load", "missing")
        self.assert_error(point(load=Literal("1e400")), "rough", "load", "1e400")
        self.assert_error(point(laod=1), "rough", "laod", "did you mean load?")
        self.assert_error(point(id=True), None, "id", "a text, or a number")
        self.assert_error(point(speed=[1]), "rough", "speed")
        self.assert_error(scene(), "rough", "speed")
        self.assert_error(json_value(point()).replace('"load"', '"load": 1, "load"'), "rough", "load",
                          "given twice")

    def test_what_is_not_json(self):
        for line in ["x", "{", "[1]", "5", '"text"', "null", "{}{}", "\x00", "{'a': 1}",
                     "[" * 200000, '{"a":' * 100000]:
            self.assert_error(line, None, "")

    def test_bytes_that_are_not_text(self):
        done = subprocess.run([PROGRAM, "stream"], input=b'{"id": "\xff"}\n\xfe\xff\n',
                              capture_output=True, timeout=TIMEOUT)
        found = [strict_json(line) for line in done.stdout.decode().splitlines()]
        self.assertEqual([answer["id"] for answer in found], [None, None])

    def test_the_stream_goes_on(self):
        result, found = answers(point(id="a"), "junk", point(id="b", load=0), point(id="c"))
        self.assertEqual(result.code, 0)
        self.assertEqual([(a["id"], "error" in a) for a in found],
                         [("a", False), (None, True), ("b", True), ("c", False)])

    def test_each_limit_is_told_of_the_first_scene_that_passes_it(self):
        odd, more = point(load=1e8, outputs=["film"]), point(load=1e8, speed=600, outputs=["film"])
        result, found = answers(*[odd] * 100, *[more] * 100, point(load=1e9, accept=["load_range"], outputs=["film"]))
        self.assertEqual((result.code, len(found)), (0, 201))
        first, then = result.said.splitlines()
        self.assertIn("warning: line 1: outside of the model's limits: ", first)
        self.assertIn("load 1e+8 N (1e-9 N to 1e+7 N", first)
        self.assertIn("warning: line 101: outside of the model's limits: ", then)
        self.assertIn("speed 600 m/s (1e-9 m/s to 500 m/s; perhaps mm/s was meant)", then)
        self.assertNotIn("load 1", then)


class Lines(unittest.TestCase):
    def test_line_ends(self):
        line = json_value(point(outputs=["film"]))
        expected = run("stream", stdin=line + "\n").out
        self.assertEqual(run("stream", stdin=line).out, expected)
        self.assertEqual(run("stream", stdin=f"{line}\r\n{line}\r\n").out, 2 * expected)
        self.assertEqual(run("stream", stdin=f"\n \r\n{line}\n\n\t\n{line}\n").out, 2 * expected)

    def test_nothing(self):
        result = run("stream")
        self.assertEqual((result.code, result.out, result.err), (0, "", ""))

    def test_the_longest_line(self):
        line = json_value(point(outputs=["film"]))
        blanks = " " * (MIB - len(line))
        result, found = answers(line, line + blanks, line + blanks + "\r", line + blanks + " ", line,
                                "x" * (3 * MIB), line)
        self.assertEqual(result.code, 0)
        self.assertEqual(["error" in answer for answer in found],
                         [False, False, False, True, False, True, False])
        self.assertEqual(found[3], {"id": None, "error": {"field": "",
                                                          "message": "the line is over 1 MiB"}})

    def test_a_long_line_at_the_end(self):
        for length in [MIB, MIB + 1, MIB + 2, MIB + 65536, MIB + 65538, 2 * MIB, 5 * MIB]:
            result = run("stream", stdin="x" * length)
            self.assertEqual((result.code, len(result.out.splitlines())), (0, 1))


class CoProcess(unittest.TestCase):
    """A user writes a line, waits for its answer, and only then writes the next line."""

    def setUp(self):
        self.process = start("stream", stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.addCleanup(self.stop)

    def stop(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.assertEqual(self.process.wait(TIMEOUT), 0)

    def write(self, text):
        self.process.stdin.write(text.encode())

    def read_answer(self):
        text = b""
        while not text.endswith(b"\n"):
            ready, _, _ = select.select([self.process.stdout], [], [], TIMEOUT)
            self.assertTrue(ready, "no answer")
            text += self.process.stdout.read(65536)
        return [strict_json(line) for line in text.decode().splitlines()]

    def test_each_answer_comes_before_the_next_question(self):
        for i in range(20):
            self.write(json_value(point(id=f"q{i}")) + "\n")
            self.assertEqual([a["id"] for a in self.read_answer()], [f"q{i}"])

    def test_a_line_in_pieces_does_not_hold_up_the_one_before(self):
        second = json_value(point(id="second"))
        self.write(json_value(point(id="first")) + "\n" + second[:40])
        self.assertEqual([a["id"] for a in self.read_answer()], ["first"])
        self.write(second[40:])
        self.write("\n")
        self.assertEqual([a["id"] for a in self.read_answer()], ["second"])

    def test_an_error_is_answered_at_once_too(self):
        self.write("junk\n")
        self.assertEqual([a["id"] for a in self.read_answer()], [None])


if __name__ == "__main__":
    unittest.main()
