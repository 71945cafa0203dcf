# SPDX-License-Identifier: Apache-2.0
"""Compares the numbers of each erratum's two forms with formulas that are written here a second time."""
import json
import math
import unittest

from program import run

ELASTIC, RADIUS, LOAD, VISCOSITY, BARUS, EYRING, BOUNDARY = 107.9e9, 9.5e-3, 50, 0.0202, 2e-8, 2.5e6, 0.13
SMOOTH, ROUGH = {"density": 2e11, "sd": 2.5e-8}, {"density": 5e10, "sd": 1e-7}
SUMMIT, OFFSET = 1e-5, 1.146
OIL = 4  # the inlet's film over the summits' σ
ROUGHNESS = SMOOTH["density"] * SUMMIT * SMOOTH["sd"]
CONSTANT = 2.69 * (1 - 0.61 * math.exp(-0.73))


def moment(order, d, steps=1000):
    """∫ over s from d up, of (s − d)^order φ(s), by the rule of trapezoids in √(s − d)."""
    width = math.sqrt(max(d, 0) + 12 - d) / steps
    total = sum((k * width) ** (2 * order + 1) * math.exp(-(d + (k * width) ** 2) ** 2 / 2) for k in range(1, steps))
    return 2 * width * total / math.sqrt(2 * math.pi)


def hertz_radius(radius=RADIUS):
    return (3 * LOAD * radius / (4 * ELASTIC)) ** (1 / 3)


def film_alone(speed, moduli=(2, 2, 2), constant=CONSTANT, radius=RADIUS):
    """Hamrock and Dowson's central film. `moduli` are those in U, G and W, as multiples of E*."""
    u, g, w = (part * ELASTIC for part in moduli)
    return constant * radius * (VISCOSITY * speed / (u * radius)) ** 0.67 * (BARUS * g) ** 0.53 * (LOAD / (w * radius**2)) ** -0.067


def asperity_share(separation, density, sd, prefactor=1, summit=SUMMIT, offset=OFFSET, radius=RADIUS):
    stiffness = prefactor * 16 * math.sqrt(2) * math.pi / 15 * (density * summit * sd) ** 2 * math.sqrt(sd / summit)
    return math.sqrt(stiffness * ELASTIC * math.pi * hertz_radius(radius) ** 2 / LOAD * moment(2.5, separation - offset))


def flooded_film_parameter(speed, density, sd, prefactor=1, summit=SUMMIT, offset=OFFSET, **film):
    """The flooded film over the summits' σ by bisection: Johnson's rule, Greenwood and Tripp's contact. `prefactor` multiplies its load."""
    def share(separation):
        return asperity_share(separation, density, sd, prefactor, summit, offset, film.get("radius", RADIUS))
    alone = film_alone(speed, **film) / sd
    low, high = 1e-9, 50
    for _ in range(60):
        middle = (low + high) / 2
        part = share(middle)
        if part >= 1 or math.log(middle / alone) + 0.14 * math.log(1 - part) < 0:
            low = middle
        else:
            high = middle
    return high


def slow_share(**changes):
    """The asperities' share on the rough surface at the lowest speed, at the starved film; 1 where they alone would carry more than the load."""
    surface = {**ROUGH, **changes}
    return min(1, asperity_share(OIL * starved(flooded_film_parameter(1e-4, **surface) / OIL), **surface))


def fast_film(speed=1, **changes):
    return flooded_film_parameter(speed, **SMOOTH, **changes) * SMOOTH["sd"]


def real_area(moment_order, power):
    return (math.pi * ROUGHNESS) ** power * moment(moment_order, 1 - OFFSET)


def wolveridge(ratio, gap=2 * math.sqrt(2) / 3):
    """The starved film over the flooded one. `ratio` is the flooded film over the oil film, and `gap` the constant of the gap in the inlet."""
    return 2 / math.pi * math.atan(2.7 * ((1 / ratio - 1) / (2 * gap)) ** (2 / 3))


def starved(flooded, gap=2 * math.sqrt(2) / 3):
    """The starved film over the oil film, from the flooded film over the oil film."""
    return flooded * wolveridge(flooded, gap)


def starved_as_printed():
    """The starved film over the oil film, if this ratio itself is the argument of Wolveridge's function: its fixed point, for any flooded film."""
    low, high = 1e-6, 1 - 1e-6
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if wolveridge(middle) > middle else (low, middle)
    return low


def greatest_film(gap):
    """The greatest film over the summits' σ, found by ternary search."""
    low, high = 0.3, 0.9
    for _ in range(100):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (a, high) if starved(a, gap) < starved(b, gap) else (low, b)
    return OIL * starved(low, gap)


def friction(law=math.asinh, barus=BARUS, speed=0.1):
    sd = SMOOTH["sd"]
    ratio = OIL * starved(fast_film(speed) / (OIL * sd))
    share, area = asperity_share(ratio, **SMOOTH), math.pi * hertz_radius() ** 2
    real = (math.pi * ROUGHNESS) ** 2 * moment(2, ratio - OFFSET)
    viscosity = VISCOSITY * math.exp(barus * (1 - share) * LOAD / area)
    return BOUNDARY * share + EYRING * law(viscosity * speed / (ratio * sd) / EYRING) * area * (1 - real) / LOAD


# The right share and the right film, with which changed ones are compared.
SHARE, FILM = slow_share(), fast_film()
COMPLIANCE = (1 - 0.3**2) / 210e9
TWO = {
    "E1": (0, COMPLIANCE),
    "E2": (fast_film(moduli=(1, 1, 1)), FILM),
    "E3": (slow_share(prefactor=0.5), SHARE),
    "E4": (slow_share(prefactor=1 / math.pi), SHARE),
    "E5": (0.5, math.exp(-2) / math.sqrt(2 * math.pi) - math.erfc(math.sqrt(2))),
    "E6": (1000, 1),
    "E7": (real_area(1, 1), real_area(2, 2)),
    "E8": (0.82 / 1.4, 0.82 * 1.4),
    "E9": (slow_share(offset=2 * OFFSET), SHARE),
    "E10": (1000 ** (4 / 3 - 3), 1),
    "E11": (starved_as_printed(), starved(0.01)),
    "E13": (greatest_film(2 * math.sqrt(2) / 3), greatest_film(8 * math.sqrt(2) / (3 * math.pi))),
    "E14": (2.69 * (1 - 0.6 * math.exp(-0.73)), CONSTANT),
    "E15": (slow_share(density=VISCOSITY), SHARE),
    "E17": (slow_share(summit=1e-7), SHARE),
    "E18": (hertz_radius(1e-3 * RADIUS) / (1e-3 * RADIUS), hertz_radius() / RADIUS),
    "E19": (friction(law=lambda x: 1 - math.exp(-x)), friction()),
    "E20": (friction(barus=0), friction()),
    "E21": (fast_film(radius=RADIUS / 2), FILM),
    "E23": (fast_film(moduli=(1, 2, 2)), FILM),
    "E24": (fast_film(speed=2), FILM),
    "E25": (fast_film(constant=2.69), FILM),
    "E26": (OFFSET * ROUGHNESS, 1 / (4 * math.pi * math.sqrt(3))),
}
OF_NOTATION = {"E12", "E16", "E22"}


class Errata(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = {row["erratum"]: row for row in json.loads(run("reproduce", "--format", "json").out)["errata"]}

    def test_each_has_the_numbers_that_its_two_forms_give(self):
        self.assertEqual(set(self.rows), set(TWO) | OF_NOTATION)
        for name, numbers in TWO.items():
            for key, expected in zip(("as_printed", "as_corrected"), numbers):
                with self.subTest(erratum=name, which=key, expected=expected, got=self.rows[name][key]):
                    self.assertAlmostEqual(self.rows[name][key], expected, delta=1e-6 * abs(expected))  # the error of the quadrature in this file

    def test_each_names_its_two_forms_and_none_but_these(self):
        for name in TWO:
            quantity, forms = self.rows[name]["computed"].split(": ")
            self.assertEqual(len(forms.split("; ")), 2, name)
            self.assertNotIn(";", quantity)
        forms = {name: row["computed"].partition(": ")[2] for name, row in self.rows.items()}
        self.assertEqual(forms["E23"], "E* in U alone; 2E* throughout")
        self.assertEqual(forms["E13"], "line gap, as printed and kept; circular gap, right")

    def test_each_number_stands_beside_what_decides_it(self):
        decided = {"C4: 0.82": ("E3", "E4", "E9", "E15", "E17"), "1.22: 1.899": ("E14", "E25"), "C2: 1.4": ("E13",),
                   "": ("E2", "E7", "E19", "E20", "E21", "E23", "E24")}
        for said, names in decided.items():
            self.assertEqual({self.rows[name]["against"] for name in names}, {said}, names)
        for name, row in self.rows.items():
            self.assertEqual(row["computed"] == "", name in OF_NOTATION)
            self.assertTrue(row["against"] or name in decided[""] or name in OF_NOTATION, name)


if __name__ == "__main__":
    unittest.main()
