# SPDX-License-Identifier: Apache-2.0
"""The page's own arithmetic at its limits: verdicts, agreement of two samples, parts below a speed, errors of maps, ranges of formulas
and starved films, on data made up."""
import datetime
import json
import math
import os
import pathlib
import sys
import types
import unittest
from unittest import mock

sys.path[:0] = [str(pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "reports/page" / folder) for folder in ("groups", "render")]
import ellipse_fits  # noqa: E402
import environment  # noqa: E402
import group  # noqa: E402
import ledger  # noqa: E402
import line_films  # noqa: E402
import onset_uncertainty  # noqa: E402
import paper  # noqa: E402
import point_films  # noqa: E402
import starved_films  # noqa: E402
from program import Program  # noqa: E402


class Verdicts(unittest.TestCase):
    def test_on_a_printed_number_change_at_half_its_last_digit_a_tenth_and_the_root_of_ten(self):
        root = math.sqrt(10)
        for sure, beyond, verdict, next_verdict in (
                (1.05, 1.0501, "reproduced", "within 10 %"), (0.95, 0.9499, "reproduced", "within 10 %"),
                (1.0999, 1.1001, "within 10 %", "order only"), (0.9001, 0.8999, "within 10 %", "order only"),
                (0.9999 * root, 1.0001 * root, "order only", "not reproduced"), (1.0001 / root, 0.9999 / root, "order only", "not reproduced"),
                (1e-6 + 1 / root, 0.0, "order only", "not reproduced"), (1e-6 + 1 / root, -1.0, "order only", "not reproduced")):
            for scale in (1, 3e-7, 2e9):
                self.assertEqual(paper.judged(scale * sure, scale, 0.1 * scale), verdict, (sure, scale))
                self.assertEqual(paper.judged(scale * beyond, scale, 0.1 * scale), next_verdict, (beyond, scale))


class EllipseFits(unittest.TestCase):
    @staticmethod
    def integrals(k):
        """K and E of the parameter 1 − 1/k², by the midpoint rule, which converges fast because the integrand is periodic."""
        angles = [math.pi / 2 * (i + 0.5) / 4000 for i in range(4000)]
        roots = [math.hypot(math.cos(angle), math.sin(angle) / k) for angle in angles]
        return [math.pi / 2 * math.fsum(values) / 4000 for values in ([1 / root for root in roots], roots)]

    def test_right_numbers_give_the_ellipse_of_the_program(self):
        for k in (1.0, 2.0, 7.5):
            first, second = self.integrals(k)
            ratio = (k**2 * second - first) / (first - second) if k > 1 else 1.0
            with mock.patch.dict(ellipse_fits.FORMULAS, {"right": lambda *_: (k, first, second)}):
                got = ellipse_fits.ellipse_of({"formula": {"name": "right"}}, ratio)
            question = {"function": "hertz_ellipse", "load": ellipse_fits.LOAD, "effective_modulus": ellipse_fits.MODULUS,
                        "radius_x": ellipse_fits.RADIUS, "radius_y": ellipse_fits.RADIUS * ratio}
            with Program(os.environ["TRIBOCHECK"]) as program:
                right, = program.ask(json.dumps(question))
            for name in ellipse_fits.TOLD:
                self.assertAlmostEqual(got[name] / right[name], 1, delta=1e-13)

    def test_the_first_integral_of_the_fit_by_logarithms_is_that_of_its_axes(self):
        for ratio in (1.5, 20.0, 1e3):
            k, first, _ = ellipse_fits.of_logarithms(ratio, None)
            self.assertAlmostEqual(first / self.integrals(k)[0], 1, delta=1e-14)


class Uncertainty(unittest.TestCase):
    LEVELS = ((0.025, "low"), (0.5, "median"), (0.975, "high"))

    def compared(self, distances, count=300, draws=100, low=0.804):
        """Quantiles of 1 with intervals of ± 0.196, a standard deviation of 0.1, and others at this distance."""
        columns = {surface: {onset_uncertainty.COMPARED: {
            "count": count, "quantiles": [{"level": level, "value": 1.0, "low": low, "high": 1.196} for level, _ in self.LEVELS]}}
            for surface in ledger.SURFACES}
        drawn = {"draws": draws, "onset_speed": {surface: {end: 1 + distances.get((surface, end), 0) for _, end in self.LEVELS} for surface in ledger.SURFACES}}
        return onset_uncertainty.agreement(columns, drawn)

    def test_a_distance_is_told_in_deviations_of_both_samples_and_as_a_part(self):
        for surface in ledger.SURFACES:
            for _, end in self.LEVELS:
                for distance in (0.5, -0.25):
                    found = self.compared({(surface, end): distance})
                    # Ours has three times as many draws as the other sample, whose variance is thus three times ours.
                    self.assertAlmostEqual(found["in_deviations"], abs(distance) / (0.1 * math.sqrt(1 + 3)), places=12)
                    self.assertAlmostEqual(found["farthest"], abs(distance) / (1 + distance), places=12)
        self.assertEqual((found["ledger_draws"], found["column"]), (100, "onset.film_maximum.speed"))

    def test_they_agree_up_to_the_greatest_number_of_deviations(self):
        limit = 0.2 * onset_uncertainty.MOST_DEVIATIONS
        self.assertTrue(self.compared({("rough", "high"): 0.999 * limit})["agree"])
        self.assertFalse(self.compared({("rough", "high"): 1.001 * limit})["agree"])
        for low in (None, 1.196):  # without an interval nothing is known of them
            with self.assertRaisesRegex(group.Missing, "too few onset speeds"):
                self.compared({}, low=low)

    def test_the_part_below_a_speed_is_linear_within_a_bar(self):
        value = {"count": 10, "histogram": {"edges": [1, 2, 4, 5], "counts": [2, 4, 3]}}
        for speed, part in ((0.5, 0), (1, 0), (1.5, 0.1), (2, 0.2), (3, 0.4), (4, 0.6), (4.5, 0.75), (5, 0.9), (9, 0.9)):
            self.assertAlmostEqual(onset_uncertainty.part_below(value, speed), part, places=12)

    def test_an_end_of_an_interval_that_is_not_bounded_is_infinite(self):
        value = {"quantiles": [{"level": 0.5, "value": 2.0, "low": None, "high": None}, {"level": 0.9, "value": 3.0, "low": 1.0, "high": 4.0}]}
        self.assertEqual(onset_uncertainty.quantile(value, 0.5), (2.0, -math.inf, math.inf))
        self.assertEqual(onset_uncertainty.quantile(value, 0.9), (3.0, 1.0, 4.0))


class Dates(unittest.TestCase):
    def test_a_date_is_a_whole_text_and_a_time_is_one_of_the_calendar(self):
        self.assertEqual(environment.day_of("2026-11-21"), datetime.date(2026, 11, 21))
        for text in ("2026-11-21 or so", "2026-13-01", "unknown"):
            self.assertIsNone(environment.day_of(text), text)
        for seconds, year in (("86400", 1970), ("-9999999999", 1653), ("9999999999", 2286)):
            with mock.patch.dict(os.environ, {"SOURCE_DATE_EPOCH": seconds}):
                self.assertEqual(environment.today().year, year)
        with mock.patch.dict(os.environ, {"SOURCE_DATE_EPOCH": "-99999999999"}):
            self.assertGreater(environment.today().year, 2025)


class Maps(unittest.TestCase):
    def test_the_error_of_a_map_counts_for_the_quantities_of_the_formulas_of_its_liquid_alone(self):
        def films(*checks):
            """Films with these checks, and a map that is 1 everywhere."""
            return types.SimpleNamespace(checks=[types.SimpleNamespace(load=load, material=1.0, film=film) for load, film in checks],
                                         map=lambda loads, materials: [[[1.0] * len(line_films.QUANTITIES)]])
        first, second = line_films.QUANTITIES[:2]
        rest = [1.0] * (len(line_films.QUANTITIES) - 2)
        formulas = [types.SimpleNamespace(quantity=first, is_compressible=False), types.SimpleNamespace(quantity=second, is_compressible=True)]
        heavy, light = line_films.HEAVY_FROM, math.nextafter(line_films.HEAVY_FROM, 0)
        with mock.patch.object(line_films, "FORMULAS", formulas):
            found = line_films.interpolation_data(films((heavy, [0.8, 0.5, *rest]), (light, [1.25, 0.5, *rest])),
                                                  films((heavy, [0.1, 2.0, *rest]), (light, [0.1, 1.6, *rest])))
        none = dict.fromkeys(line_films.QUANTITIES[2:], 0.0)
        self.assertEqual({name: round(error, 12) for name, error in found["greatest"].items()}, {first: 0.25, second: 0.5, **none})
        self.assertEqual({name: round(error, 12) for name, error in found["greatest_light"].items()}, {first: 0.2, second: 0.375, **none})
        self.assertEqual((found["points"], found["heavy_from"]), (4, heavy))


class PointFilms(unittest.TestCase):
    LOADS, MATERIALS = (5, 10, 20, 50, 100), (2.5, 5, 10)

    def block(self, *beyond):
        """The widest block if only the contacts `beyond` are off by more than a tenth."""
        errors = {(load, material): 0.1 for load in self.LOADS for material in self.MATERIALS}
        return point_films.widest_block(errors | dict.fromkeys(beyond, -0.1001))

    def test_the_widest_block_has_no_contact_beyond(self):
        def told(contacts, *ends):
            return dict(zip(("contacts", "least_load", "greatest_load", "least_material", "greatest_material"), (contacts, *ends), strict=True))
        self.assertEqual(self.block(), told(15, 5, 100, 2.5, 10))
        self.assertEqual(self.block((5, 5)), told(12, 10, 100, 2.5, 10))
        self.assertEqual(self.block((20, 10), (5, 10)), told(10, 5, 100, 2.5, 5))
        self.assertEqual(self.block(*((load, material) for load in self.LOADS for material in (2.5, 10))), told(5, 5, 100, 5, 5))
        self.assertEqual(self.block(*((load, material) for load in self.LOADS for material in self.MATERIALS if (load, material) != (20, 5))),
                         told(1, 20, 20, 5, 5))
        self.assertIsNone(self.block(*((load, material) for load in self.LOADS for material in self.MATERIALS)))


class StarvedFilms(unittest.TestCase):
    @staticmethod
    def points(exponent, top=2.0):
        """Points of the flooded film u^0.67 behind a layer of 1, by Damiens' closure. Friction is least at the speed `top`."""
        made = []
        for step in range(16):
            speed = 3 * 1.3 ** (step - 15)
            flooded = speed ** 0.67
            ratio = starved_films.damiens_ratio(1 / flooded, exponent)
            closures = dict.fromkeys(starved_films.CLOSURES, ratio) | {"flooded_inlet": 0.0 if flooded > 1 else 1 - flooded}
            made.append({"speed": speed, "film": ratio * flooded, "error": 1e-6, "flooded": flooded, "ratio": ratio, "ratio_error": 0.001,
                         "layer": 1.0, "closures": closures, "friction": 0.1 + math.log(speed / top) ** 2})
        return made

    def test_the_speed_of_departure_is_that_of_the_closed_form(self):
        for exponent in (2.0, 2.6, 3.5):
            found = starved_films.surface_of("made", self.points(exponent))
            right = (0.95 ** -exponent - 1) ** (1 / exponent / 0.67)
            self.assertAlmostEqual(found["film_departure"]["speed"] / right, 1, delta=2e-3)
            self.assertLess(found["film_departure"]["low"], found["film_departure"]["speed"])
            self.assertGreater(found["film_departure"]["high"], found["film_departure"]["speed"])

    def test_a_film_that_rises_has_no_maximum_and_one_that_falls_has(self):
        found = starved_films.surface_of("made", self.points(3.0))
        self.assertEqual((found["rises"], found["film_maximum"]), (15, None))
        # u^0.67 (1 − u^0.67) is greatest where u^0.67 is a half.
        at = found["closures"]["flooded_inlet"]
        self.assertAlmostEqual(at["film_maximum"] / 0.5 ** (1 / 0.67), 1, delta=0.02)
        self.assertAlmostEqual(at["collapse"], 1, delta=1e-3)
        self.assertTrue(at["departs_before"])
        self.assertFalse(found["closures"]["damiens"]["departs_before"])

    def test_least_friction_lies_between_the_speeds_and_not_at_an_end(self):
        self.assertAlmostEqual(starved_films.surface_of("made", self.points(3.0, 0.7))["friction_minimum"] / 0.7, 1, delta=1e-3)
        self.assertIsNone(starved_films.surface_of("made", self.points(3.0, 3.0))["friction_minimum"])

    def test_the_exponent_is_that_of_the_ratio(self):
        for supply in (0.25, 0.7, 1.0, 2.0, 4.0):
            for exponent in (1.5, 3.0, 5.0):
                ratio = starved_films.damiens_ratio(supply, exponent)
                self.assertAlmostEqual(starved_films.damiens_exponent(supply, ratio) / exponent, 1, delta=1e-6)
            self.assertIsNone(starved_films.damiens_exponent(supply, min(supply, 1)))
            self.assertIsNone(starved_films.damiens_exponent(supply, 1e-9))


if __name__ == "__main__":
    unittest.main()
