# SPDX-License-Identifier: Apache-2.0
"""verify asks a sample of the cases again: answers that change are told, and judged by the worse one."""

import json
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import altered
from program import ProgramTest, run

# The second answer to a case is changed.
AGAIN = """asked = globals().setdefault("asked", set())
    if case in asked and name == "hertz_point":
        {change}
    asked.add(case)"""
# A cache with a key that lacks an input.
CACHE = """cache = globals().setdefault("cache", {})
    if name == "effective_modulus":
        key = round(math.log10(question["first_modulus"]))
        answer["value"] = cache.setdefault(key, answer["value"]) if case in cache.setdefault("seen", set()) else answer["value"]
        cache["seen"].add(case)
        cache[key] = answer["value"]"""


class Unsteady(ProgramTest):
    def asked(self, change, *options):
        return run("verify", "--subject", altered(self.folder, change), "--sample", "40", "--format", "json", *options)

    def again(self, change, *options):
        return self.asked(AGAIN.format(change=change), *options)

    def test_one_that_is_steady_has_no_line(self):
        result = self.asked("pass")
        self.assertEqual((result.code, result.json()["unsteady"]), (0, []))
        self.assertNotIn("again", run("verify", "--subject", altered(self.folder, "pass"), "--sample", "40").out)

    def test_the_last_bits_are_told_everywhere_and_are_not_red(self):
        junit = self.folder.path("junit.xml")
        result = self.again('answer["radius"] *= 1 + 1e-13', "--junit", junit)
        self.assertEqual(result.code, 0, result.out)
        row, = result.json()["unsteady"]
        self.assertEqual((row["quantity"], row["asked_again"], row["changed"]), ("hertz_point.radius", 2, 2))
        self.assertAlmostEqual(row["relative_difference"], 1e-13, delta=1e-15)
        self.assertAlmostEqual(row["second"] / row["first"] - 1, 1e-13, delta=1e-15)
        words = (f"hertz_point.radius changes in 2 of 2 cases; in {row['case']} most: {row['first']} m, then "
                 f"{row['second']} m, 1e-13 of it apart")
        for style in ("table", "markdown"):
            self.assertIn(words, run("verify", "--subject", altered(self.folder, AGAIN.format(
                change='answer["radius"] *= 1 + 1e-13')), "--sample", "40", "--format", style).out.replace("\\_", "_"))
        suite = ElementTree.parse(junit).getroot()
        self.assertIn(words, suite.find("system-out").text)
        self.assertEqual(suite.get("failures"), "0")

    def test_the_worse_answer_is_judged(self):
        for change, reason in (('answer["radius"] *= 1.01', "off by 0.01"), ('answer["radius"] = math.nan', "no number"),
                               ('answer = {"id": case, "error": "no root"}', "when it is asked again: no root"),
                               ("os._exit(3)", "when it is asked again: it exits with code 3")):
            result = self.again(change)
            self.assertEqual(result.code, 1, change)
            verdict = {one["quantity"]: one for one in result.json()["quantities"]}["hertz_point.radius"]
            self.assertEqual(verdict["status"], "FAILED")
            self.assertIn(reason, verdict["reason"])
            self.assertIn("hertz_point.radius", [one["quantity"] for one in result.json()["unsteady"]])

    def test_a_case_that_is_skipped_the_second_time_is_told(self):
        result = self.again('answer = {"id": case, "skip": "no more"}')
        self.assertEqual(result.code, 0)
        row = result.json()["unsteady"][0]
        self.assertEqual((row["second"], row["reason"], row["relative_difference"]), (None, "no more", None))

    def test_a_cache_with_a_wrong_key_is_found(self):
        result = self.asked(CACHE)
        self.assertIn("effective_modulus", [one["quantity"] for one in result.json()["unsteady"]])

    def test_with_a_baseline_one_that_was_steady_is_red(self):
        path = self.folder.path("base.json")
        noise = 'answer["radius"] = math.nextafter(answer["radius"], 1)'
        gate = ["--baseline", path]

        def row(quantity="hertz_point.radius"):
            with open(path) as file:
                return json.load(file)["quantities"][quantity]
        self.assertEqual(self.asked("pass", *gate, "--update-baseline").code, 0)
        self.assertNotIn("unsteady", row())
        for more in ([], ["--update-baseline"]):
            red = self.again(noise, *gate, *more)
            self.assertEqual(red.code, 1)
            worse, = red.json()["changes"]["worse"]
            self.assertEqual((worse["quantity"], worse["text"]),
                             ("hertz_point.radius", "hertz_point.radius: its answers were the same each time, and change "
                                                    "now when they are asked again"))
        self.assertEqual(self.again(noise, *gate, "--update-baseline", "--force").code, 0)
        for quantity in ("hertz_point.radius", "hertz_point.approach"):  # of one function
            self.assertTrue(row(quantity)["unsteady"])
        self.assertNotIn("unsteady", row("effective_modulus"))
        self.assertEqual(self.again(noise.replace("radius", "approach"), *gate).code, 0)
        self.assertEqual(self.asked("pass", *gate, "--update-baseline").code, 0)
        self.assertTrue(row()["unsteady"])  # one run proves nothing
        self.assertEqual(self.asked("pass", *gate, "--update-baseline", "--force").code, 0)
        self.assertNotIn("unsteady", row())

    def test_a_baseline_of_before_does_not_know_what_was_steady(self):
        path = self.folder.path("base.json")
        self.asked("pass", "--baseline", path, "--update-baseline")
        with open(path) as file:
            old = json.load(file)
        with open(path, "w") as file:
            json.dump({name: value for name, value in old.items() if name not in ("version", "commit", "date", "losses")}
                      | {"schema": 2}, file)
        self.assertEqual(self.again('answer["radius"] = math.nextafter(answer["radius"], 1)', "--baseline", path).code, 0)

    def test_showing_a_case_asks_it_once(self):
        command = altered(self.folder, 'print("asked", file=open("asked.txt", "a"))')
        run("verify", "--subject", command, "--show", "h0000", cwd=self.folder.name)
        with open(self.folder.path("asked.txt")) as file:
            self.assertEqual(file.read(), "asked\n")

    def test_each_function_is_in_the_sample_and_it_is_small(self):
        command = altered(self.folder, 'print(case, file=open("asked.txt", "a"))')
        run("verify", "--subject", command, cwd=self.folder.name)
        with open(self.folder.path("asked.txt")) as file:
            asked = file.read().split()
        lines = run("verify", "--save-cases", "-").json_lines()
        function = {one["id"]: one.get("function", one["id"].partition("@")[0] if "@" in one["id"] else "point")
                    for one in lines}
        first, again = asked[:len(lines)], asked[len(lines):]
        self.assertEqual(first, [one["id"] for one in lines])
        self.assertEqual(again, sorted(again, key=first.index, reverse=True))
        self.assertEqual({function[one] for one in again}, set(function.values()))
        self.assertLess(len(again), 0.052 * len(lines))


class KeptAnswers(ProgramTest):
    """A cache whose key lacks an input, which the second ask of a case does not show."""

    # Each function but moments, on which others rest, keeps its answers without the input of this place among their names.
    FORGETS = """cache = globals().setdefault("cache", {{}})
    inputs = [key for key, value in sorted(question.items()) if isinstance(value, (int, float))]
    is_whole = not case.endswith("d")  # in the others an input is left out, so that places are not the same
    lost = inputs[{place}] if is_whole and {place} < len(inputs) and name != "gaussian_moment" else None
    key = json.dumps([value for value in sorted(question.items()) if value[0] not in ("id", lost)])
    answer = dict(cache.setdefault(key, answer), id=case)"""

    def test_each_number_that_is_forgotten_is_named(self):
        functions = run("functions", "--format", "json").json()["functions"]
        numbers = {one["name"]: sorted(parameter["name"] for parameter in one["parameters"] if "physical" in parameter)
                   for one in functions if one["name"] != "gaussian_moment"}
        for place in range(max(map(len, numbers.values()))):
            command = altered(self.folder, self.FORGETS.format(place=place))
            told = {one["quantity"].partition(".")[0]: one["text"]
                    for one in run("verify", "--subject", command, "--format", "json").json()["diagnoses"]}
            for function, names in numbers.items():
                if place < len(names) and len(names) > 1:
                    self.assertIn(f"looks for them without {names[place]}.", told.get(function, ""), function)

    def test_no_cache_is_named_where_another_answer_is_wrong_too(self):
        kept = self.FORGETS.format(place=0)
        for change, is_named in ((kept, True), (kept + '\n    if case == "h0000": answer["radius"] *= 1.01', False)):
            result = run("verify", "--subject", altered(self.folder, change), "--format", "json")
            text, = (one["text"] for one in result.json()["diagnoses"] if one["quantity"] == "hertz_point.radius")
            self.assertEqual("looks for them without" in text, is_named, text)


if __name__ == "__main__":
    unittest.main()
