# SPDX-License-Identifier: Apache-2.0
"""verify asks some cases a second time. It tells which answers change, and judges the worse of the two."""

import json
import re
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from conformance import SUBJECTS, altered
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


# A solver with the right radius. Its last bit differs at the last place of an array.
PLUGIN = """#include <math.h>
#include <string.h>
#include "tribocheck_plugin.h"
int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
int tribocheck_function(const char* name, size_t count, const double* const* in, double* const* out, int* status) {
  if (strcmp(name, "hertz_point") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    const double radius = cbrt(0.75 * in[0][i] * in[2][i] / in[1][i]);
    out[0][i] = i + 1 == count ? nextafter(radius, 1) : radius;
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
"""


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
        row, = self.again('answer["radius"] *= 1 + 1e-13', "--junit", junit).ended(0).json()["unsteady"]
        self.assertEqual((row["quantity"], row["asked_again"], row["changed"]), ("hertz_point.radius", 2, 2))
        self.assertAlmostEqual(row["relative_difference"], 1e-13, delta=1e-15)
        self.assertAlmostEqual(row["second"] / row["first"] - 1, 1e-13, delta=1e-15)
        self.assertRegex(row["first_place"], f"^as question [0-9]+ of its process, after [a-z][0-9]+$")
        self.assertRegex(row["second_place"], f"^as question [0-9]+ of its process, after [a-z][0-9]+$")
        words = (f"hertz_point.radius changes in 2 of 2 cases; in {row['case']} most: {row['first']} m, then "
                 f"{row['second']} m, 1e-13 of it apart")
        for style in ("table", "markdown"):
            self.assertIn(words, run("verify", "--subject", altered(self.folder, AGAIN.format(
                change='answer["radius"] *= 1 + 1e-13')), "--sample", "40", "--format", style).out.replace("\\_", "_"))
        suite = ElementTree.parse(junit).getroot()
        self.assertIn(words, suite.find("system-out").text)
        self.assertEqual(suite.get("failures"), "0")

    def test_the_place_in_an_array_is_told(self):
        source, library = self.folder.write("solver.c", PLUGIN), self.folder.path("libsolver.so")
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-I", SUBJECTS.parent, source, "-o", library, "-lm"], check=True)
        row, = run("verify", "--plugin", library, "--sample", "40", "--format", "json").json()["unsteady"]
        told = run("verify", "--plugin", library, "--sample", "40").out
        # How many questions are asked together is not the same in each run.
        place = "at place [0-9]+ of an array of [0-9]+"
        for places in ((row["first_place"], row["second_place"]), re.search(rf"; asked ({place}), then ({place})$", told, re.MULTILINE).groups()):
            for one in places:
                self.assertRegex(one, f"^{place}$")
            ends = [one.split()[2] == one.split()[-1] for one in places]
            self.assertEqual(sorted(ends), [False, True], places)  # the last place alone is rounded otherwise

    def test_the_worse_answer_is_judged(self):
        for change, reason in (('answer["radius"] *= 1.01', "off by 0.01"), ('answer["radius"] = math.nan', "no number"),
                               ('answer = {"id": case, "error": "no root"}', "when it is asked again: no root"),
                               ("os._exit(3)", "when it is asked again: it exits with code 3")):
            result = self.again(change).ended(1)
            verdict = {one["quantity"]: one for one in result.json()["quantities"]}["hertz_point.radius"]
            self.assertEqual(verdict["status"], "FAILED")
            self.assertIn(reason, verdict["reason"])
            self.assertIn("hertz_point.radius", [one["quantity"] for one in result.json()["unsteady"]])

    def test_a_case_that_is_skipped_the_second_time_is_told(self):
        row = self.again('answer = {"id": case, "skip": "no more"}').ended(0).json()["unsteady"][0]
        self.assertEqual((row["second"], row["reason"], row["relative_difference"]), (None, "no more", None))

    def test_a_cache_with_a_wrong_key_is_found(self):
        result = self.asked(CACHE)
        self.assertIn("effective_modulus", [one["quantity"] for one in result.json()["unsteady"]])

    def test_with_a_baseline_one_that_was_steady_is_red(self):
        path = self.folder.path("base.json")
        # The answers have errors of 1e-10, so that a later change is less than four times the worst error.
        coarse = """if name == "hertz_point":
        answer["radius"] *= 1 + 1e-10
        answer["approach"] *= 1 + 1e-10"""
        noise = 'answer["radius"] *= 1 + 1e-14'
        gate = ["--baseline", path]

        def changing(change, *options):
            return self.asked(coarse + "\n    " + AGAIN.format(change=change), *options)

        def row(quantity="hertz_point.radius"):
            with open(path) as file:
                return json.load(file)["quantities"][quantity]
        self.assertEqual(self.asked(coarse, *gate, "--update-baseline").code, 0)
        self.assertNotIn("unsteady", row())
        # A change of the last bit, as by another order of operations, is told, but is no loss. It excuses no greater change later.
        last_bit = 'answer["radius"] = math.nextafter(answer["radius"], 1)'
        for more in ([], ["--update-baseline"], ["--update-baseline", "--force"]):
            rounded = changing(last_bit, *gate, *more)
            self.assertEqual((rounded.code, rounded.json()["changes"]["worse"]), (0, []))
            self.assertEqual([one["quantity"] for one in rounded.json()["unsteady"]], ["hertz_point.radius"])
            self.assertNotIn("unsteady", row())
        for more in ([], ["--update-baseline"]):
            worse, = changing(noise, *gate, *more).ended(1).json()["changes"]["worse"]
            self.assertEqual((worse["quantity"], worse["text"]),
                             ("hertz_point.radius", "hertz_point.radius: its answers were the same each time, and change "
                                                    "now when they are asked again"))
        self.assertEqual(changing(noise, *gate, "--update-baseline", "--force").code, 0)
        for quantity in ("hertz_point.radius", "hertz_point.approach"):  # both are of one function
            self.assertTrue(row(quantity)["unsteady"])
        self.assertNotIn("unsteady", row("effective_modulus"))
        self.assertEqual(changing(noise.replace("radius", "approach"), *gate).code, 0)
        self.assertEqual(self.asked(coarse, *gate, "--update-baseline").code, 0)
        self.assertTrue(row()["unsteady"])  # one steady run does not prove that it is steady
        self.assertEqual(self.asked(coarse, *gate, "--update-baseline", "--force").code, 0)
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
    """A cache whose key lacks an input. Asking the same case again does not show this mistake."""

    # Each function keeps its answers by all inputs except the one at `place` in the order of names; not moments, on which others rest.
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
