# SPDX-License-Identifier: Apache-2.0
"""The section of circles and ellipses: the errors of formulas are computed again, from the printed formulas and the tables of solved films."""
import csv
import math
import statistics
import types
import unittest

import page_contacts
import page_pictures
from report_files import POINT_DATA, POINT_FIGURES, ROOT, WrittenReport, files_below

TABLES = {"barus, incompressible": "point_films.csv", "roelands, compressible": "point_films_compressible.csv"}
MATERIAL = 2 * 20e-9 * 115.4e9  # G of steel and a mineral oil


def powers(constant, speed, material, load):
    """(h/R)(2U)^(-1/2), where h/R = C U^a G^b W^c."""
    def number(m, l):
        twice = (l / MATERIAL)**4
        return constant * (twice / 2)**speed * MATERIAL**material * (m * twice**0.75)**load * twice**-0.5
    return number


def nijenbanning(is_of_rigid, is_of_s, ratio):
    """One of four readings of Nijenbanning, Venner and Moes; d is their D = R_x/R_y."""
    d = 1 / ratio
    q = 1 + 0.006 * math.log(d) + 0.63 * d**(4 / 7)

    def number(m, l):
        rigid, elastic = 145 * (1 + 0.796 * d**(14 / 15))**(-15 / 7) / d * m**-2, 3.18 * q**-0.56 * d**(-1 / 15) * m**(-2 / 15)
        stiff, heavy = 1.29 * (l / (1 + 0.691 * d))**(2 / 3), 1.48 * q**-0.35 * d**(-1 / 24) * m**(-1 / 12) * l**0.75
        s = 1.5 * (1 + math.exp(-1.2 * elastic / (rigid if is_of_rigid else heavy)))
        bent = (elastic**-4 + (1.8 * ratio)**-4)**-0.25
        first = (rigid**(1.5 * s) + bent**(1.5 * s))**(2 / (3 * s)) if is_of_s else (rigid**1.5 + bent**1.5)**(2 * s / 3)
        return (first + (stiff**-8 + heavy**-8)**(-s / 8))**(1 / s)
    return number


def side(factor, decay):
    return 1 - factor * math.exp(-decay)


def formulas(ratio):
    """The printed formulas for contacts of this R_y/R_x."""
    k, radii = page_contacts.elliptic_contact(1, 1, 1, ratio)[0], ratio**(2 / 3)
    return {
        "hamrock_dowson_central": ("central", powers(2.69 * side(0.61, 0.73 * k), 0.67, 0.53, -0.067)),
        "hamrock_dowson_minimum": ("minimum", powers(3.63 * side(1, 0.68 * k), 0.68, 0.49, -0.073)),
        "nijenbanning_venner_moes": ("central", nijenbanning(True, False, ratio)),
        "chittenden_central_431": ("central", powers(4.31 * side(1, 1.23 * radii), 0.68, 0.49, -0.073)),
        "chittenden_central_430": ("central", powers(4.30 * side(1, 1.28 * k), 0.68, 0.49, -0.073)),
        "chittenden_minimum_368": ("minimum", powers(3.68 * side(1, 0.67 * radii), 0.68, 0.49, -0.073)),
        "nijenbanning_three_halves_of_s": ("central", nijenbanning(True, True, ratio)),
        "nijenbanning_ei_over_ep": ("central", nijenbanning(False, False, ratio)),
        "nijenbanning_ei_over_ep_of_s": ("central", nijenbanning(False, True, ratio))}


FORMULAS = formulas(1)  # of circles


def films_of(name, ratio=1):
    """The rows of flooded contacts of one shape, by (M, L); without L = 0, and without L = 12.5, which is not solved at each M."""
    lines = (ROOT / "reference/ehl" / name).read_text().splitlines()
    rows = [row for row in csv.DictReader(line for line in lines if line[0] != "#")
            if float(row["radius_ratio"]) == ratio and row["supply"] == ""]
    return {(float(row["load_number"]), float(row["material_number"])): row for row in rows if row["material_number"] not in ("0", "12.5")}


class PointFilms(WrittenReport):
    sections = ("film-points",)

    def test_files(self):
        self.assertEqual(self.done.code, 0, self.done.err)
        pictures = [f"figures/{figure}.{kind}" for figure in POINT_FIGURES for kind in ("svg", "png")]
        self.assertEqual(sorted(name for name in files_below(self.out) if "/" in name), sorted(POINT_DATA + pictures))

    def test_errors_are_those_of_the_printed_formulas_against_the_tables(self):
        found = {one["name"]: one for one in self.told["point_films"]["formulas"]}
        blocks = dict(page_pictures.blocks(self.out / POINT_DATA[0]))
        self.assertEqual((list(found), list(blocks)), (list(FORMULAS), list(FORMULAS)))
        for name, (quantity, number) in FORMULAS.items():
            drawn = {(row["liquid"], float(row["load number M"]), float(row["material number L"])): float(row["error"]) for row in blocks[name]}
            self.assertEqual(found[name]["quantity"], quantity)
            for (liquid, file), told in zip(TABLES.items(), found[name]["liquids"], strict=True):
                errors = {place: number(*place) / float(row[quantity]) - 1 for place, row in films_of(file).items()}
                with self.subTest(name, liquid=liquid):
                    worst = max(errors, key=lambda place: abs(errors[place]))
                    self.assertEqual((told["worst"]["load_number"], told["worst"]["material_number"]), worst)
                    self.assertAlmostEqual(told["worst"]["error"], errors[worst], 9)
                    self.assertAlmostEqual(told["median"], statistics.median(errors.values()), 9)
                    self.assertAlmostEqual(told["median_size"], statistics.median(map(abs, errors.values())), 9)
                    self.assertEqual(told["contacts_within"], sum(abs(error) <= 0.1 for error in errors.values()))
                    for (load, material), error in errors.items():
                        self.assertAlmostEqual(drawn[liquid.split(",")[0].title(), load, material] / (100 * error), 1, delta=6e-4)
            self.assertEqual(len(drawn), sum(len(films_of(file)) for file in TABLES.values()))

    def test_ellipses_are_those_of_the_printed_formulas_too(self):
        shapes = self.told["point_films"]["ellipses"]
        self.assertEqual([shape["radius_ratio"] for shape in shapes], [0.25, 0.5, 2, 4, 8])
        for shape in shapes:
            films = films_of("point_films.csv", shape["radius_ratio"])
            self.assertEqual([shape["loads"], shape["materials"]], [sorted({place[i] for place in films}) for i in (0, 1)])
            printed = formulas(shape["radius_ratio"])
            self.assertEqual([one["name"] for one in shape["formulas"]], list(printed))
            for one in shape["formulas"]:
                quantity, number = printed[one["name"]]
                errors = [number(*place) / float(row[quantity]) - 1 for place, row in films.items()]
                with self.subTest(one["name"], radius_ratio=shape["radius_ratio"]):
                    self.assertAlmostEqual(one["least"], min(errors), 7)
                    self.assertAlmostEqual(one["greatest"], max(errors), 7)

    def test_liquids_are_those_of_the_tables(self):
        for told, (liquid, file) in zip(self.told["point_films"]["liquids"], TABLES.items(), strict=True):
            films = films_of(file)
            self.assertEqual((told["liquid"], told["contacts"]), (liquid, len(films)))
            self.assertEqual([told["loads"], told["materials"]], [sorted({place[i] for place in films}) for i in (0, 1)])
            for quantity in ("central", "minimum"):
                self.assertEqual(told["greatest_error"][quantity], max(float(row[f"{quantity}_error"]) / float(row[quantity]) for row in films.values()))

    def test_the_picture_draws_its_cells(self):
        picture, data = self.out / "figures/point_film_errors.svg", types.SimpleNamespace(out=self.out, report=self.told)
        self.assertEqual(page_pictures.differences(picture, "point_film_errors", data), [])
        # A wrong number and a wrong colour are found.
        text = picture.read_text()
        for good, wrong in ((">+118<", ">+117<"), ("fill = 'rgb(251, 223, 177)'", "fill = 'rgb(177, 223, 251)'")):
            self.assertIn(good, text)
            changed = self.out.parent / "changed.svg"
            changed.write_text(text.replace(good, wrong, 1))
            self.assertNotEqual(page_pictures.differences(changed, "point_film_errors", data), [], wrong)


if __name__ == "__main__":
    unittest.main()
