# SPDX-License-Identifier: Apache-2.0
"""Numbers as the page and its pictures write them: random values, each limit, and the doubles next to it."""

import math
import os
import pathlib
import random
import sys
import tempfile
import unittest

import page_tables

sys.path.insert(0, str(pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "reports/page/render"))
import drawing  # noqa: E402
import markup  # noqa: E402
import numbers_text  # noqa: E402
import sweep_pictures  # noqa: E402


def beside(value):
    return math.nextafter(value, -math.inf), value, math.nextafter(value, math.inf)


class Numbers(unittest.TestCase):
    def setUp(self):
        draw = random.Random(20261123)
        self.values = [sign * draw.uniform(1, 10) * 10**draw.randint(-12, 12) for _ in range(2000) for sign in (1, -1)]
        for power in range(-9, 10):  # powers at which the number of digits, or the notation, changes
            for times in (1, 9.995, 9.9995, 9.5, 9.95):
                self.values += beside(times * 10.0**power)

    def test_rounded_is_the_nearest_decimal_number(self):
        for value in [*self.values, 0.0, -0.0, math.nan, math.inf, -math.inf, None]:
            for digits in (1, 2, 3, 4, 5, 13):
                self.assertEqual(numbers_text.rounded(value, digits), page_tables.sig(value, digits), (value, digits))

    def test_unrounded_reads_back(self):
        for value in self.values:
            text = numbers_text.unrounded(value)
            self.assertEqual(text, page_tables.whole(value))
            number = text.replace("−", "-").replace("\u202f", "").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
            self.assertEqual(float(number.replace(" × 10", "e")), value)

    def test_grouped_has_three_digits_a_group_from_10000_on(self):
        for count, text in ((0, "0"), (9999, "9999"), (10000, "10\u202f000"), (123456, "123\u202f456"), (1234567, "1\u202f234\u202f567")):
            self.assertEqual(numbers_text.grouped(count), text)

    def test_percent_has_exact_ends_and_is_the_nearest_between_them(self):
        limits = [end for limit in (0.001, 0.0995, 0.995, 0.9995, 0.9996, 1, 1.005, 1.0005, 0.5, 1e-9) for end in beside(limit)]
        for part in [*limits, *(random.Random(1).uniform(0, 1.2) for _ in range(2000)), 0, 5e-324, -0.0004, -0.3, 12.5]:
            for digits in (2, 3):
                text = numbers_text.percent(part, digits)
                self.assertEqual(text, page_tables.percent(part, digits), part)
                self.assertEqual((text == "0 %", text == "100 %"), (part == 0, part == 1), part)
                self.assertEqual(text.startswith("<"), 0 < part < 0.001, part)
        self.assertEqual([numbers_text.percent(one) for one in (None, math.nan, 0.9996, 1.0004)], ["–", "–", "> 99.9 %", "> 100 %"])

    def test_an_interval_has_both_ends_or_one_number(self):
        self.assertEqual(numbers_text.interval([3.664, 1.062], 3), "1.06 to 3.66")
        self.assertEqual(numbers_text.interval([2.001, 1.999], 2), "2.0")


class Texts(unittest.TestCase):
    def test_a_cell_for_gnuplot_keeps_each_sign_but_those_that_end_it(self):
        for sign in map(chr, range(0x300)):
            shown = " " if sign < " " or sign == "\x7f" else "'" if sign == '"' else sign
            self.assertEqual(sweep_pictures.cell(f"a{sign}b"), f"a{shown}b")
        for count in range(38, 43):
            self.assertEqual(sweep_pictures.cell("x" * count), "x" * count if count <= 40 else "x" * 40 + "…")
        self.assertEqual([sweep_pictures.cell(one) for one in ("", " ", "\n")], ["–", "–", "–"])

    def test_a_scene_without_a_film_leaves_the_unit_to_the_others(self):
        def scene(name, film):
            value = {"speed": 1.0, "count": 0 if film is None else 9, "undefined": 9 if film is None else 0, "least": film, "greatest": film,
                     "quantiles": [{"level": level, "value": film} for level in (0.025, 0.5, 0.975)]}
            return {"id": name, "design": "random", "columns": [{"name": "film", "unit": "m", "values": [value, value | {"speed": 2.0}]}]}
        for scenes in ([scene("dry", None), scene("wet", 5e-8)], [scene("wet", 5e-8), scene("dry", None)]):
            self.assertIn("film (nm)", sweep_pictures.curve_band({"scenes": scenes}, "film").blocks)
        self.assertIsNone(sweep_pictures.curve_band({"scenes": [scene("dry", None)]}, "film"))
        with tempfile.TemporaryDirectory() as folder:  # as many scenes as one has
            picture = sweep_pictures.curve_band({"scenes": [scene(f"wet {i}", 5e-8 + i * 1e-9) for i in range(130)]}, "film")
            sweep_pictures.write_blocks(picture, pathlib.Path(folder))
            self.assertEqual(drawing.draw(picture.drawn(), pathlib.Path(folder), pathlib.Path(folder) / "band.svg"), "")

    def test_a_bar_ends_no_cell_of_a_table(self):
        self.assertEqual(markup.escaped("a|b*"), r"a\|b\*")
        self.assertEqual(markup.marked("a|b `c|d*` *e"), r"a\|b `c\|d*` \*e")
        self.assertEqual(markup.code("a|b"), r"`a\|b`")


if __name__ == "__main__":
    unittest.main()
