# SPDX-License-Identifier: Apache-2.0
"""The section of solved films: the errors of formulas, the map of these errors, and the profile of a contact."""

import csv
import json
import math
import re
import shutil
import unittest

from program import folder_until
from report_files import LINE_DATA, LINE_FIGURES, ROOT, WrittenReport, files_below, project_copy, report, table

TABLES = {"barus": ROOT / "reference/ehl/line_films.csv", "compressible": ROOT / "reference/ehl/line_films_compressible.csv"}
U = 1e-11  # the speed number of the page


def solved_films(liquid):
    rows = csv.DictReader(line for line in TABLES[liquid].read_text().splitlines() if not line.startswith("#"))
    return {(float(row["load_number"]), float(row["material_number"])): row for row in rows
            if row.get("role", "table") == "table"}


def liquid_of(name):
    return "compressible" if name.startswith("pan_hamrock") else "barus"


def number(constant, speed, material, load, m, l, u):
    """(h/R)(2U)^(-1/2), where h/R = C U^a G^b W^c."""
    root = math.sqrt(2 * u)
    return constant * u**speed * (l / math.sqrt(root))**material * (m * root)**load / root


# The laws in the order of the map's columns. The first column, Moes, is left out, as it is no product of powers.
LAWS = {"ertel_grubin": ("at_greatest_pressure", 1.95, 8 / 11, 8 / 11, -1 / 11),
        "dowson_higginson_minimum": ("minimum", 2.65, 0.70, 0.54, -0.13),
        "dowson_toyoda_central": ("central", 3.06, 0.69, 0.56, -0.10),
        "pan_hamrock_minimum": ("minimum", 1.714, 0.694, 0.568, -0.128),
        "pan_hamrock_central": ("central", 2.922, 0.692, 0.470, -0.166)}


def error(name, m, l, film):
    quantity, *law = LAWS[name]
    return number(*law, m, l, float(film.get("speed_number", U))) / float(film[quantity]) - 1


class LineFilms(WrittenReport):
    sections = ("film-solved",)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.told = cls.told["line_films"]

    def test_files(self):
        self.assertEqual(self.done.code, 0, self.done.err)
        pictures = [f"figures/{figure}.{kind}" for figure in LINE_FIGURES for kind in ("svg", "png")]
        self.assertEqual(sorted(name for name in files_below(self.out) if "/" in name), sorted(LINE_DATA + pictures))

    def test_errors_are_those_of_the_formulas_against_the_table(self):
        formulas = {one["name"]: one for one in self.told["formulas"]}
        self.assertEqual(set(formulas), {"moes_line", *LAWS})
        for name in LAWS:
            films = solved_films(liquid_of(name))
            errors = sorted((error(name, m, l, film), m, l) for (m, l), film in films.items() if l > 0)
            one = formulas[name]
            with self.subTest(name):
                self.assertEqual(one["points"], len(errors))
                for key, expected in (("least", errors[0]), ("greatest", errors[-1])):
                    found = one[key]
                    self.assertAlmostEqual(found["error"], expected[0], 7)  # a speed number has six digits
                    self.assertEqual((found["load_number"], found["material_number"]), expected[1:])
                middle = [errors[(len(errors) - 1) // 2][0], errors[len(errors) // 2][0]]  # for an odd number of errors twice the same one
                self.assertAlmostEqual(one["median"], sum(middle) / 2, 7)
                cells = re.search(rf"(?m)^\| `{name}` \|(.*)", self.text)[1].split("|")
                printed = [float(cell.split("%")[0].replace("−", "-")) for cell in cells[2:5]]
                self.assertEqual(printed, [float(f"{100 * error:.1e}") for error in  # two digits
                                           (one["least"]["error"], one["median"], one["greatest"]["error"])])

    def test_the_regime_of_elastic_bodies_and_a_thickening_liquid_has_its_own_extremes(self):
        for one in self.told["formulas"]:
            films = solved_films(liquid_of(one["name"]))
            def of_regimes(m, l):
                elastic = 1.311 * l**0.75 / m**0.125
                return elastic, max(3 / m, 2.621 / m**0.2, min(1.287 * l**(2 / 3), elastic))
            home = [(m, l) for m, l in films if l > 0 and len(set(of_regimes(m, l))) == 1]
            found = one["elastic_viscous"]
            self.assertEqual(found["points"], len(home))
            self.assertNotIn((1, 5), home)  # rigid
            self.assertNotIn((200, 0.1), home)  # the pressure does not thicken the liquid
            self.assertIn((200, 20), home)
            for key in ("least", "greatest"):
                self.assertIn((found[key]["load_number"], found[key]["material_number"]), home)
            if one["name"] in LAWS:
                errors = [error(one["name"], *place, films[place]) for place in home]
                self.assertAlmostEqual(found["least"]["error"], min(errors), 7)
                self.assertAlmostEqual(found["greatest"]["error"], max(errors), 7)

    def test_the_map_meets_the_table_at_its_corners(self):
        rows = table(self.out / "data/line_film_errors.tsv")
        self.assertGreater(len(rows), 2500)
        corners = {(m, l): row for row in rows for m in (1, 200) for l in (1, 20)
                   if math.isclose(float(row["load number M"]), m) and math.isclose(float(row["material number L"]), l)}
        self.assertEqual(len(corners), 4)
        for (m, l), row in corners.items():
            for name in LAWS:
                with self.subTest(name, place=(m, l)):
                    self.assertAlmostEqual(float(row[name]), 100 * error(name, m, l, solved_films(liquid_of(name))[m, l]), 2)

    def test_the_map_is_as_exact_as_the_page_tells(self):
        between = self.told["interpolation"]
        for quantity, most, most_light in (("central", 0.01, 0.03), ("minimum", 0.002, 0.003),
                                           ("at_greatest_pressure", 0.002, 0.003)):
            self.assertLess(between["greatest"][quantity], most)
            self.assertLess(between["greatest_light"][quantity], most_light)
        self.assertLess(self.told["solved"]["greatest"]["error"], 2e-4)
        # For the compressible liquid, formulas are compared only with the central and the minimum film.
        for row in solved_films("compressible").values():
            for name in ("central", "minimum"):
                self.assertLess(float(row[name + "_error"]), 5e-4 * float(row[name]), row)

    def test_contours_have_labels_with_their_sign(self):
        blocks = (self.out / "data/line_film_labels.blocks.tsv").read_text().split("\n\n\n")
        self.assertEqual(len(blocks), 6)
        for block in blocks:
            rows = [line.split("\t") for line in block.splitlines() if line.count("\t") == 3 and line[0] != "#"]
            self.assertGreaterEqual(len(rows), 3)
            for m, l, level, text in rows:
                self.assertTrue(1 < float(m) < 200 and 1 < float(l) < 20)
                sign = "+" if float(level) > 0 else "−" if float(level) < 0 else ""
                self.assertEqual(text, f'"{sign}{abs(float(level)):g} %"')

    def test_the_pictures_name_what_they_show(self):
        texts = {name: (self.out / f"figures/{name}.svg").read_text() for name in LINE_FIGURES}
        for words in ("load number M (–)", "material number L (–)", "Moes: at the greatest pressure", "−10 %", "gear_flank",
                      "error of the formula"):
            self.assertIn(words, texts["line_film_errors"])
        for words in ("film h (µm)", "x/b (–)", "dry contact of Hertz"):
            self.assertIn(words, texts["line_film_profile"])

    def test_the_profile_carries_the_load_and_has_a_constriction(self):
        rows = table(self.out / "data/line_film_profile.tsv")
        x, p, hertz, film = ([float(row[name]) for row in rows] for name in ("x/b", "p/p0", "Hertz' p/p0", "film"))
        load = sum((b - a) * (p[i] + p[i + 1]) / 2 for i, (a, b) in enumerate(zip(x, x[1:])))
        self.assertAlmostEqual(load, math.pi / 2, delta=0.03)  # a part of the load is carried before x = −3
        self.assertLessEqual(max(hertz), 1)
        profile = self.told["profile"]
        self.assertAlmostEqual(1e-6 * min(film) / profile["minimum"]["value"], 1, delta=0.005)
        self.assertLess(profile["minimum"]["value"], 0.9 * profile["central"]["value"])
        self.assertLess(profile["central"]["error"] / profile["central"]["value"], 2e-4)

    def test_the_papers_contacts_are_points(self):
        self.assertEqual([one["name"] for one in self.told["scenes"]], ["gear_flank", "roller"])
        self.assertIn("The paper's scenes are contacts at points", self.text)


class OtherFiles(unittest.TestCase):
    def setUp(self):
        self.project = project_copy(folder_until(self.addCleanup), "published", "scenes", "ehl")

    def told(self, *arguments):
        report("--section", "film-solved", *arguments, cwd=self.project).ended(0)
        return json.loads((self.project / "reports/out/report.json").read_text())["line_films"]

    def test_a_line_contact_of_the_user_is_on_the_map(self):
        scenes = self.project / "mine"
        shutil.copytree(ROOT / "reference/published", scenes)
        text = (ROOT / "reference/scenes/gear_flank.toml").read_text()
        (scenes / "own.toml").write_text(re.sub(r"(?m)^load = \S+", "load = 2e3", text).replace("gear_flank", "own"))
        found = {one["name"]: one for one in self.told("--scenes", scenes)["scenes"]}
        self.assertTrue(found["own"]["is_of_report"] and found["own"]["is_on_map"])
        tracks = (self.project / "reports/out/data/line_film_tracks.blocks.tsv").read_text()
        self.assertEqual(re.findall(r'^"(\w+)"$', tracks, re.MULTILINE), ["gear_flank", "roller", "own"])
        self.assertIn(">own<", (self.project / "reports/out/figures/line_film_errors.svg").read_text())
        self.assertNotIn("The paper's scenes are contacts at points", (self.project / "reports/out/report.md").read_text())

    def test_without_a_table_the_page_says_so(self):
        for path in TABLES.values():
            (self.project / "reference/ehl" / path.name).rename(self.project / "away.csv")
            self.assertIn(path.name, self.told()["missing"]["why"])
            (self.project / "away.csv").rename(self.project / "reference/ehl" / path.name)


if __name__ == "__main__":
    unittest.main()
