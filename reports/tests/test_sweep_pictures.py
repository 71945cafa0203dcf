# SPDX-License-Identifier: Apache-2.0
"""Output of tribocheck sweep: tables, CSV, JSON, and pictures, which need gnuplot."""

import math
import os
import pathlib
import shutil
import struct
import unittest
import xml.etree.ElementTree as xml

import svg_plots
from page_pictures import differing, series
from page_tables import quantile
from program import ENVIRONMENT, run
from report_files import ROOT
from sweeps import NORMAL, UNIFORM, SweepTest, opened, sweep
from test_sweep_film import LINES

SPEEDS = "{ from = 1e-4, to = 3, count = 40 }"
LEVELS = (0.001, 0.01, 0.025, 0.05, 0.16, 0.25, 0.5, 0.75, 0.84, 0.95, 0.975, 0.99, 0.999)


def uncertain(id='"smooth"', **settings):
    return sweep({"id": id, "lubricant.viscosity": UNIFORM, "load": NORMAL.replace("0.0202", "50"),
                  "surface.summit_height_sd": '{ printed = "2.5e-8" }'},
                 **{"onset": '["film_maximum", "film_departure"]', "draws": 300,
                    "sensitivity": "true", **settings})


class Summaries(SweepTest):
    def setUp(self):
        super().setUp()
        self.swept(uncertain())
        self.swept(sweep({"lubricant.viscosity": UNIFORM, "speed": SPEEDS}, draws=64),
                   out="curves.h5", name="curves.toml")

    def shown(self, out, form):
        return run("sweep", "show", self.path(out), "--format", form).ended(0, "")

    def rows(self, out):
        return self.shown(out, "csv").rows()

    def assert_number(self, text, expected):
        self.assertEqual(float(text) if text else math.nan, expected) if not math.isnan(expected) \
            else self.assertEqual(text, "")

    def test_csv_has_every_number_of_the_summaries(self):
        for out in ("out.h5", "curves.h5"):
            rows = self.rows(out)
            with opened(self.path(out)) as file:
                speeds = list(file["smooth/speed"]) if "speed" in file["smooth"] else []
                width = 0
                for row in rows:
                    group = file["smooth/summary/" + row["column"].replace(".", "/")]
                    i = int(row["speed_index"])
                    self.assertEqual(row["unit"], group.attrs["unit"])
                    width = max(width, i + 1)
                    if row["speed"]:
                        self.assertEqual(float(row["speed"]), speeds[i])
                    for name in ("count", "undefined", "mean", "sd", "least", "greatest"):
                        self.assert_number(row[name], group[name][i])
                    for place, level in enumerate(LEVELS):
                        for end in ("", "_low", "_high"):
                            self.assert_number(row[f"quantile_{level}{end}"],
                                               group["quantiles" + end][i][place])
                self.assertEqual(width, max(1, len(speeds)))

    def test_csv_and_json_have_the_sensitivities(self):
        scene, = self.shown("out.h5", "json").json()["scenes"]
        columns = {column["name"]: column for column in scene["columns"]}
        with opened(self.path("out.h5")) as file:
            group = file["smooth/sensitivity"]
            variables = [v.decode() if isinstance(v, bytes) else v for v in group.attrs["variables"]]
            for row in self.rows("out.h5"):
                indices = group[row["column"].replace(".", "/")]
                told = columns[row["column"]]["values"][0]["sensitivity"]
                self.assertEqual(told["groups"], indices["groups"][0])
                for kind in ("first_order", "total"):
                    for place, variable in enumerate(variables):
                        value = indices[kind][0][place]
                        self.assert_number(row[f"{kind}:{variable}"], value)
                        self.assertEqual(told["variables"][variable][kind]["value"],
                                         None if math.isnan(value) else value)

    def test_json_has_histograms_whose_counts_are_all_cases(self):
        scene, = self.shown("curves.h5", "json").json()["scenes"]
        self.assertEqual(scene["cases"], 64)
        for column in scene["columns"]:
            self.assertEqual(len(column["values"]), 40)
            for value in column["values"]:
                self.assertEqual(value["count"] + value["undefined"], 64)
                if "histogram" in value:
                    self.assertEqual(sum(value["histogram"]["counts"]), value["count"])

    def test_words_are_counted_as_the_kept_points_have_them(self):
        with opened(self.path("curves.h5")) as file:
            kept = {name: file["smooth/outputs"][name][:] for name in ("regime", "inlet")}
        names = {"regime": ("boundary", "mixed", "elastohydrodynamic", "collapsed"),
                 "inlet": ("flooded", "starved", "collapsed")}
        seen = set()
        for row in self.rows("curves.h5"):
            if row["column"] not in names:
                continue
            values = list(kept[row["column"]][:, int(row["speed_index"])])
            for place, word in enumerate(names[row["column"]]):
                self.assertEqual(int(row["count_" + word]), values.count(place), row)
                seen.update([word] if place in values else [])
        self.assertGreaterEqual(len(seen), 4)

    def test_a_table_has_eleven_speeds_at_most(self):
        lines = self.shown("curves.h5", "table").out.splitlines()
        films = [line.split() for line in lines if line.startswith("film ")]
        self.assertEqual(len(films), 11)
        self.assertEqual([films[0][2], films[-1][2]], ["0.0001", "3"])
        self.assertIn("11 of 40 speeds", lines[0])
        self.assertEqual(films[0][1], "nm")
        parts = [float(cell) for cell in lines[-1].split()[-3:]]
        self.assertLessEqual(abs(sum(parts) - 100), 0.02)


class Pictures(SweepTest):
    def drawn(self, *texts):
        """Names of the pictures, without endings."""
        files = [self.folder.write(f"{i}.toml", text) for i, text in enumerate(texts)]
        result = run("sweep", *files, "-o", self.path("out.h5"), "--pictures", self.path("drawn")).ended(0)
        self.assertTrue(all(line.startswith("tribocheck: drew ") for line in result.error_lines),
                        result.err)
        names = os.listdir(self.path("drawn"))
        pictures = sorted({name.rsplit(".", 1)[0] for name in names if name.endswith(".svg")})
        for name in pictures:
            svg = xml.parse(self.path(f"drawn/{name}.svg")).getroot()
            self.assertTrue(svg.tag.endswith("svg"))
            self.assertEqual(list(svg_plots.looks(self.path(f"drawn/{name}.svg"))), [])
            png = pathlib.Path(self.path(f"drawn/{name}.png")).read_bytes()
            self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(struct.unpack(">I", png[16:20])[0], 1920)
            self.assertEqual(png[-8:-4], b"IEND")
            self.assertIn(f"{name}.blocks.tsv", names)
        return pictures

    def blocks(self, name):
        """Rows of each block, under the names in its commented line where there is one."""
        text = pathlib.Path(self.path(f"drawn/{name}.blocks.tsv")).read_text()
        blocks = []
        for block in text.split("\n\n\n"):
            lines = [line for line in block.splitlines() if line]
            head = lines.pop(0)[2:].split("\t") if lines[0].startswith("# ") else None
            rows = [line.split("\t") for line in lines]
            blocks.append([dict(zip(head, row)) for row in rows] if head else rows)
        return blocks

    def svg_text(self, name):
        return "".join(xml.parse(self.path(f"drawn/{name}.svg")).getroot().itertext())

    def test_onsets_and_their_sensitivities(self):
        pictures = self.drawn(uncertain(), uncertain('"other one"', seed=2))
        self.assertIn("onset_distribution", pictures)
        self.assertIn("sensitivity_onset_film_maximum_speed", pictures)
        self.assertNotIn("film_map", pictures)
        lanes = self.blocks("onset_distribution")[1]
        self.assertEqual(len(lanes), 4)
        with opened(self.path("out.h5")) as file:
            for lane in lanes:
                group = file[lane["scene"]]["summary/onset/" + lane["criterion"].replace(" ", "_")]
                self.assertEqual(float(lane["median"]), group["speed/quantiles"][0][6])
        text = self.svg_text("onset_distribution")
        for word in ("smooth", "other one", "film maximum", "film departure", "(m/s)"):
            self.assertIn(word, text)

    def test_bars_over_the_logarithm_stand_on_a_logarithmic_axis(self):
        wide = '{ distribution = "log_uniform", from = 1e-4, to = 0.5 }'
        for spread, least_ticks in ((NORMAL, 5), (UNIFORM, 4), (wide, 3)):
            self.drawn(sweep({"lubricant.viscosity": spread}, onset='["film_maximum"]', draws=512, seed=3))
            os.remove(self.path("out.h5"))
            (plot, *_), _ = svg_plots.read(self.path("drawn/onset_distribution.svg"))
            labels = plot.labels["x"]
            self.assertGreaterEqual(len(labels), least_ticks, labels)
            self.assertLess(svg_plots.Axis(labels, True).far, 0.05)
            self.assertGreater(svg_plots.Axis(labels, False).far, 1)
            places = sorted(labels.items(), key=lambda tick: tick[1])
            for (left, at), (right, to) in zip(places, places[1:]):  # an SVG's letters are some 8 px wide
                self.assertGreater(to - at, 8 * (len(left) + len(right)) / 2, (left, right))

    def test_a_long_name_of_a_scene_is_whole_and_above_its_lanes(self):
        names = ["onset with tolerances of manufacture", "short"]
        self.drawn(*(sweep({"id": f'"{name}"', "lubricant.viscosity": UNIFORM}, onset='["film_maximum"]', draws=64) for name in names))
        places = {text: x for text, x, _ in svg_plots.texts(self.path("drawn/onset_distribution.svg"))}
        self.assertLess(places[names[0]], 20)
        self.assertGreater(places[names[1]], 100)

    def test_a_few_values_of_a_grid_are_shown_as_points(self):
        few, many = '["40 °C", "60 °C", "80 °C", "100 °C"]', '{ from = "40 °C", to = "100 °C", count = 13, spacing = "lin" }'
        oil = {"lubricant.viscosity": None, "lubricant.iso_vg": "68", "lubricant.viscosity_index": "95", "lubricant.density": "870"}
        for values, points in ((few, 4 + 1), (many, 0)):  # one point more is in the legend
            self.assertEqual(self.drawn(sweep({**oil, "lubricant.temperature": values, "speed": "0.1", "outputs": '["film"]'})),
                             ["film_curves"])
            os.remove(self.path("out.h5"))
            (plot,), _ = svg_plots.read(self.path("drawn/film_curves.svg"))
            self.assertEqual(len({point for one in plot.series for point in one.points}), points)
            self.assertIn("temperature (°C)", self.svg_text("film_curves"))
            _, _, curve = self.blocks("film_curves")
            self.assertEqual([round(float(curve[place]["field"]), 9) for place in (0, -1)], [40, 100])

    def test_indices_of_what_is_often_undefined_are_not_given(self):
        # Λ is below 3 in some cases. There friction is undefined, because the summits are not given.
        rough = {name: None for name in ("surface.summit_density", "surface.summit_radius", "surface.summit_height_sd",
                                         "surface.summit_plane_offset", "supply.inlet_film_ratio")}
        text = sweep({**rough, "accept": '["rough_as_smooth"]', "surface.rms_roughness": '{ distribution = "log_normal", median = 1e-8, log_sd = "30 %" }',
                      "lubricant.viscosity": UNIFORM, "speed": "0.1", "outputs": '["film", "friction"]'}, draws=256, sensitivity="true")
        self.assertEqual(self.drawn(text), ["sensitivity_film"])
        shown = run("sweep", "show", self.path("out.h5"))
        self.assertRegex(shown.out, r"; no indices of friction: \d+ of 256 groups of cases have it, and these are no random choice of the draws \(99 % are needed\)\n")
        self.assertNotIn("friction, total", shown.out)
        self.assertIn("film, total", shown.out)
        scene, = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"]
        film, friction = (column["values"][0] for column in scene["columns"])
        self.assertTrue(0 < friction["undefined"] < 512)
        self.assertTrue(0 < friction["sensitivity"]["groups"] < 256 == film["sensitivity"]["groups"])
        for kind in ("first_order", "total"):
            for end in ("value", "low", "high"):
                self.assertEqual({one[kind][end] for one in friction["sensitivity"]["variables"].values()}, {None})
                self.assertNotIn(None, {one[kind][end] for one in film["sensitivity"]["variables"].values()})
        self.assertNotIn("groups have it", self.svg_text("sensitivity_film"))

    def test_a_scene_has_one_colour_in_all_pictures(self):
        changes = {"lubricant.viscosity": UNIFORM, "speed": SPEEDS,
                   "outputs": '["film", "friction"]'}
        settings = {"onset": '["film_maximum"]', "draws": 64, "sensitivity": "true"}
        pictures = self.drawn(*(sweep({"id": f'"{id}"', **changes}, **settings)
                                for id in ("a", "rough", "b", "c", "d", "e")))
        self.assertIn("curve_band_film", pictures)
        seen = {}
        for name, block in (("onset_distribution", 2), ("curve_band_film", 1),
                            ("curve_band_friction", 1), ("sensitivity_onset_film_maximum_speed", 3)):
            for row in self.blocks(name)[block]:
                self.assertEqual(seen.setdefault(row["scene"], row["colour"]), row["colour"])
        self.assertEqual((len(seen), len(set(seen.values()))), (6, 6))
        self.assertEqual(int(seen["rough"]), 0xD86400)

    def test_cases_without_a_value_are_counted_in_the_legend(self):
        changes = {"lubricant.viscosity": UNIFORM, "speed": SPEEDS, "outputs": '["film", "friction"]'}
        self.drawn(sweep(changes, draws=64))
        scene, = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"]
        friction = next(column for column in scene["columns"] if column["name"] == "friction")
        missing = {value["speed"]: value["undefined"] for value in friction["values"] if value["undefined"]}
        self.assertEqual(max(missing.values()), 64)
        told, = self.blocks("curve_band_friction")[1]
        self.assertRegex(told["legend"], r"^smooth: no film and no value in up to 100 % of the cases, from [\d.]+ m/s on$")
        self.assertAlmostEqual(float(told["legend"].split()[-3]) / min(missing), 1, delta=6e-3)
        self.assertIn(told["legend"], self.svg_text("curve_band_friction"))
        self.assertEqual(self.blocks("curve_band_film")[1][0]["legend"], "smooth")  # its film is 0 there, not missing

    def test_bands_are_drawn_at_the_quantiles(self):
        changes = {"lubricant.viscosity": UNIFORM, "speed": SPEEDS, "outputs": '["film", "friction"]'}
        self.drawn(*(sweep({"id": f'"{id}"', **changes, **more}, draws=64) for id, more in
                     (("rough", {}), ("other", {"surface.summit_height_sd": "5e-8"}))))
        scenes = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"]
        for name, factor, label in (("film", 1e9, "film (nm)"), ("friction", 1, "friction (–)")):
            values = [next(column for column in scene["columns"] if column["name"] == name)["values"] for scene in scenes]
            bands = [{level: [(one["speed"], factor * quantile(one, level)) for one in of if one["undefined"] <= one["count"]]
                      for level in (0.025, 0.5, 0.975)} for of in values]
            colours = (0xD86400, 0x003468)
            wanted = [series("", colour, band[0.025] + band[0.975], True) for band, colour in zip(bands, colours)]
            wanted += [series("", colour, band[level]) for band, colour in zip(bands, colours) for level in (0.025, 0.975)]
            wanted += [series(None, colour, band[0.5]) for band, colour in zip(bands, colours)]
            path = self.path(f"drawn/curve_band_{name}.svg")
            (plot,), axes = svg_plots.read(path)
            across, up = svg_plots.Axis(plot.labels["x"], True), svg_plots.Axis(plot.labels["y"], False)
            self.assertLess(max(across.far, up.far), 0.05)
            self.assertEqual(list(differing(plot, plot.box(axes), across, up, wanted, False)), [])
            self.assertIn(label, self.svg_text(f"curve_band_{name}"))
            for scene, one in zip(scenes, plot.series[-2:], strict=True):
                self.assertEqual(one.title.split(":")[0], scene["id"])

    def test_each_value_of_a_grid_has_a_band_and_a_lane_of_its_own(self):
        drawn = {"lubricant.viscosity": UNIFORM, "load": "[20, 50, 200]", "speed": SPEEDS, "outputs": '["film"]'}
        self.drawn(sweep(drawn, draws=64, onset='["film_maximum"]'))
        scene, = run("sweep", "show", self.path("out.h5"), "--format", "json").json()["scenes"]
        _, names, *curves = self.blocks("curve_band_film")
        self.assertEqual([row["legend"] for row in names], ["load 20 N", "load 50 N", "load 200 N"])
        for cell, curve in zip(scene["cells"], curves, strict=True):
            film = next(column for column in cell["columns"] if column["name"] == "film")
            for value, row in zip(film["values"], curve, strict=True):
                for level in (0.025, 0.5, 0.975):
                    self.assertTrue(math.isclose(float(row[f"quantile_{level}"]), 1e9 * quantile(value, level), rel_tol=1e-12))
        lanes = self.blocks("onset_distribution")[1]
        self.assertEqual([row["scene"] for row in lanes], ["load 200 N", "load 50 N", "load 20 N"])
        self.assertEqual(len({row["median"] for row in lanes}), 3)
        self.assertNotIn("sets of grid values", self.svg_text("curve_band_film") + self.svg_text("onset_distribution"))

    def test_a_band_over_too_many_values_of_a_grid_says_so(self):
        drawn = {"lubricant.viscosity": UNIFORM, "speed": SPEEDS, "outputs": '["film"]'}
        self.drawn(sweep(drawn | {"load": "{ from = 20, to = 200, count = 9 }"}, draws=32, onset='["film_maximum"]'))
        for name in ("curve_band_film", "onset_distribution"):
            self.assertIn(", over all 9 sets of grid values, which widen it", self.svg_text(name))
        self.assertEqual(len(self.blocks("curve_band_film")[1]), 1)

    def test_a_film_map_has_each_film_of_the_grid(self):
        grid = "{ from = 1e-8, to = 1e-7, count = 12 }"
        self.drawn(sweep({"surface.summit_height_sd": grid, "speed": SPEEDS}))
        axes, rows, *_ = self.blocks("film_map")
        cases = run("sweep", "show", self.path("out.h5"), "--format", "csv", "--cases").rows()
        films = sorted(tuple(factor * float(case[name]) for name, factor in (
            ("surface.summit_height_sd [m]", 1e9), ("speed [m/s]", 1), ("film [m]", 1e9))) for case in cases)
        drawn = sorted((float(row["field"]), float(row["speed"]), float(row["film_nm"])) for row in rows)
        self.assertEqual(len(drawn), len(films))
        for mine, other in zip(drawn, films):
            for a, b in zip(mine, other):
                self.assertTrue(math.isnan(a) and b == 0 or abs(a / b - 1) < 1e-9, (mine, other))
        shown = [film for _, _, film in drawn if not math.isnan(film)]
        ends = {"low": 1e-4, "high": 3, "bottom": 10, "top": 100, "least": min(shown), "greatest": max(shown)}
        for name, value in ends.items():
            self.assertAlmostEqual(float(axes[0][name]) / value, 1, delta=1e-9)

    def test_film_map_of_one_grid(self):
        grid = "{ from = 1e-8, to = 1e-7, count = 12 }"
        pictures = self.drawn(sweep({"surface.summit_height_sd": grid, "speed": SPEEDS}))
        self.assertEqual(pictures, ["film_map"])
        axes, film, ridge, *_ = self.blocks("film_map")
        self.assertEqual(len(film), 12 * 40)
        self.assertIn("summit height sd (nm)", self.svg_text("film_map"))
        found = [row for row in ridge if list(row.values())[0] != "NaN"]
        self.assertGreater(len(found), 5)
        for row in found[::3]:
            speed, field = map(float, row.values())
            case = sweep({"surface.summit_height_sd": repr(field * 1e-9)}).replace("[sweep]\n", "")
            onset = run("onset", self.folder.write("case.toml", case), "--format", "json").json()["onsets"]
            told = next(one for one in onset if one["criterion"] == "film_maximum")
            self.assertLess(abs(math.log(speed / told["speed"])), 0.05)  # a fifth of a step of the grid

    def test_a_film_map_marks_where_the_film_is_a_floor(self):
        grid = "{ from = 2e-8, to = 2e-7, count = 10 }"
        self.drawn(sweep({"surface.summit_height_sd": grid, "speed": SPEEDS, "surface.summit_density": "1e11"}))
        _, film, _, floor = self.blocks("film_map")
        rows = [tuple(map(float, row.values())) for row in floor]
        ends = [end for end, field in rows if not math.isnan(end)]
        self.assertTrue(3 <= len(ends) < 10 and ends == sorted(ends), rows)  # rougher surfaces have a longer plateau
        self.assertRegex(self.svg_text("film_map"), r"left of black, \d+ %: a floor, asperities carry the load")
        with opened(self.path("out.h5")) as file:
            share = file["smooth/outputs/asperity_load_share"][:]
            speeds = file["smooth/speed"][:]
        for (end, _), shares in zip(rows, share):
            if math.isnan(end):
                self.assertLess(shares[0], 0.999)
            else:
                self.assertGreater(shares[speeds <= end].min(), 0.99)

    def cases(self):
        return run("sweep", "show", self.path("out.h5"), "--format", "csv", "--cases").rows()

    def assert_map(self, name, x, y, column, cases):
        """The map has the film (nm) of each case at its two fields; `x` and `y` are their columns."""
        _, rows, *_ = self.blocks(name)
        wanted = sorted((float(case[x]), float(case[y]), 1e9 * float(case[column])) for case in cases)
        drawn = sorted((float(row["speed"]), float(row["field"]), float(row["film_nm"])) for row in rows)
        self.assertEqual(len(drawn), len(wanted))
        for mine, other in zip(drawn, wanted):
            for a, b in zip(mine, other):
                self.assertTrue(math.isclose(a, b, rel_tol=1e-9), (mine, other))

    def test_a_grid_of_two_fields_is_a_map_at_each_speed(self):
        pictures = self.drawn(sweep({"load": "[20, 50, 100, 200]", "lubricant.viscosity": "[0.01, 0.02, 0.04]", "speed": "[0.01, 0.1]",
                                     "outputs": '["film"]'}))
        self.assertEqual(pictures, ["film_map", "film_map_speed_2"])
        for name, speed in (("film_map", 0.01), ("film_map_speed_2", 0.1)):
            self.assert_map(name, "lubricant.viscosity [Pa·s]", "load [N]", "film [m]",
                            [case for case in self.cases() if float(case["speed [m/s]"]) == speed])
            self.assertIn(f"3 × 4 points at {speed:g}", self.svg_text(name))
        for words in ("load (N)", "viscosity (Pa·s)", "film h* (nm)"):
            self.assertIn(words, self.svg_text("film_map"))

    def test_a_grid_of_solved_films_is_drawn(self):
        lines = pathlib.Path(self.folder.write("lines.toml", LINES.replace("[500, 5000]", "[500, 2000, 5000]").replace(
            "[0.5, 2]", "0.5").replace("[2e-9, 1.5e-8]", "[2e-9, 8e-9, 1.5e-8]") + "[sweep]\nsolved_film = true\n")).read_text()
        self.assertEqual(self.drawn(lines), ["film_map_central", "film_map_minimum"])
        for name in ("central", "minimum"):
            self.assert_map(f"film_map_{name}", "lubricant.pressure_viscosity [1/Pa]", "load [N]", f"solved_film.{name} [m]", self.cases())
            self.assertIn(f"solved {name} film (nm)", self.svg_text(f"film_map_{name}"))

    def test_too_few_values_for_a_map_are_curves(self):
        pictures = self.drawn(sweep({"load": "[20, 50, 100]", "lubricant.viscosity": "[0.01, 0.02]", "speed": "0.1", "outputs": '["film"]'}))
        self.assertEqual(pictures, ["film_curves"])
        _, names, *curves = self.blocks("film_curves")
        told = {row["legend"]: [tuple(map(float, point.values())) for point in curve] for row, curve in zip(names, curves, strict=True)}
        wanted = {}
        for case in self.cases():
            name = f"film h* at 0.100 m/s, viscosity {float(case['lubricant.viscosity [Pa·s]']):.4f} Pa·s"
            wanted.setdefault(name, []).append((float(case["load [N]"]), 1e9 * float(case["film [m]"])))
        self.assertEqual(set(told), set(wanted))
        for name, points in wanted.items():
            for (at, film), drawn in zip(sorted(points), told[name], strict=True):
                self.assertTrue(math.isclose(drawn[0], at) and math.isclose(drawn[-1], film, rel_tol=1e-9), (name, drawn, at, film))

    def test_names_with_any_signs(self):
        id = "'''a_b{c}^2 @ \"q\" & <x> \\\\ ~ %s %d '''"
        pictures = self.drawn(uncertain(id, draws=100))
        self.assertIn("onset_distribution", pictures)
        self.assertIn("a_b{c}^2 @", self.svg_text("onset_distribution"))

    def test_onsets_that_never_are(self):
        text = sweep({"lubricant.viscosity": UNIFORM, "supply.inlet_film_ratio": None},
                     onset='["film_maximum"]', draws=20)
        self.assertEqual(self.drawn_quietly(text), [])

    def drawn_quietly(self, text):
        self.sweep(text, "--pictures", self.path("drawn")).ended(0)
        folder = self.path("drawn")
        return sorted(os.listdir(folder)) if os.path.isdir(folder) else []

    def test_without_gnuplot_one_line_says_so(self):
        self.swept(uncertain(draws=64))
        os.mkdir(self.path("empty"))
        told = self.shown_with_path(self.path("empty"))
        self.assertEqual((told.code, len(told.error_lines)), (1, 1), told.err)
        self.assertIn("gnuplot was not found", told.err)

    def test_a_script_that_fails_is_told(self):
        self.swept(uncertain(draws=64))
        installed = pathlib.Path(self.path("installed"))
        shutil.copytree(ROOT / "reports/page", installed / "reports/page")
        (installed / "reference/published").mkdir(parents=True)
        (installed / "reports/page/render/sweep_pictures.py").unlink()
        told = run("sweep", "show", self.path("out.h5"), "--pictures", self.path("drawn"), cwd=installed).ended(1)
        self.assertEqual(told.error_lines[-1], "tribocheck: sweep_pictures.py failed: see above")
        self.assertEqual(os.listdir(self.path("drawn")), [])

    def test_a_gnuplot_that_fails_is_quoted_and_leaves_no_picture(self):
        self.swept(uncertain(draws=64))
        os.mkdir(self.path("bin"))
        fake = self.folder.write("bin/gnuplot", "#!/bin/sh\necho no such terminal >&2\nexit 3\n")
        os.chmod(fake, 0o755)
        self.assertIn("no such terminal", self.shown_with_path(self.path("bin") + ":" + os.environ.get("PATH", "")).ended(1).err)
        self.assertFalse([name for name in os.listdir(self.path("drawn")) if "svg" in name])

    def shown_with_path(self, path):
        before = ENVIRONMENT.get("PATH")
        ENVIRONMENT["PATH"] = path
        try:
            return run("sweep", "show", self.path("out.h5"), "--pictures", self.path("drawn"))
        finally:
            ENVIRONMENT["PATH"] = before

    def test_a_folder_that_cannot_be_made_is_told(self):
        self.swept(uncertain(draws=64))
        told = run("sweep", "show", self.path("out.h5"), "--pictures", "/proc/none")
        self.assertEqual((told.code, len(told.error_lines)), (1, 1), told.err)
        self.assertIn("cannot write /proc/none", told.err)


if __name__ == "__main__":
    unittest.main()
