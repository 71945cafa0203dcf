# SPDX-License-Identifier: Apache-2.0
"""tribocheck curve: its picture, and measured points beside the model. Needs gnuplot, as the program does."""
import math
import os
import pathlib
import re
import statistics
import struct
import unittest

import svg_plots
from program import ProgramTest, quiet_scene, run, with_field, without_field

HEAD = "speed [m/s],film [nm],friction\n"
OFF_CURVE = "measured: outside, other or without a film"
PANELS = {"friction": ("friction coefficient μ (–)", 1), "film": ("film h* (nm)", 1e9), "asperity_load_share": ("asperity load share A (–)", 1)}


class CurveTest(ProgramTest):
    def write(self, tree, name="scene.toml"):
        return self.folder.write(name, tree)

    def solved(self, tree, speeds):
        result = run("solve", self.write({**tree, "speed": speeds}, "at.toml"), "--format", "json")
        return result.json()["points"]


class Data(CurveTest):
    def compared(self, text, tree=None, *arguments):
        result = run("curve", self.write(tree or quiet_scene("smooth")), "--data", self.folder.write("measured.csv", text), *arguments)
        self.assertEqual((result.code, result.err), (0, ""))
        return result

    def refused(self, text, *expected, tree=None):
        path = self.folder.write("measured.csv", text)
        result = run("curve", self.write(tree or quiet_scene("smooth")), "--data", path)
        self.assertEqual((result.code, result.out), (2, ""))
        self.assertEqual(len(result.error_lines), len(expected), result.err)
        for line, words in zip(result.error_lines, expected):
            self.assertTrue(line.startswith(f"tribocheck: {path}: {words}"), (line, words))
            self.assertIn("; allowed: ", line)

    def test_each_number_stands_beside_the_one_of_solve_at_its_speed(self):
        """This holds also at 5 m/s, a speed that the curve does not have, and where the film has collapsed."""
        tree = quiet_scene("smooth")
        told = self.compared(HEAD + "0.012,7.4,0.049\n0.1,,0.046\n\n# no film here\n5,30,\n0.2,20,\n0.3,0,0.06\n", tree, "--format", "json").json()
        wanted = [(2, "film", 0.012, 7.4e-9), (2, "friction", 0.012, 0.049), (3, "friction", 0.1, 0.046), (6, "film", 5, 30e-9),
                  (7, "film", 0.2, 20e-9), (8, "film", 0.3, 0), (8, "friction", 0.3, 0.06)]
        self.assertEqual([(one["line"], one["quantity"], one["speed"], one["measured"]) for one in told["points"]], wanted)
        solved = self.solved(tree, [speed for _, _, speed, _ in wanted])
        deviations = {"film": [], "friction": []}
        for one, point in zip(told["points"], solved, strict=True):
            self.assertEqual(one["computed"], point[one["quantity"]])
            if one["measured"] == 0:
                self.assertIsNone(one["deviation_percent"])
                continue
            deviations[one["quantity"]].append(100 * (point[one["quantity"]] - one["measured"]) / one["measured"])
            self.assertAlmostEqual(one["deviation_percent"], deviations[one["quantity"]][-1], delta=1e-9)
        for summary, (name, values) in zip(told["quantities"], deviations.items(), strict=True):
            self.assertEqual((summary["quantity"], summary["compared"]), (name, len(values)))
            for word, number in (("median", statistics.median(values)), ("least", min(values)), ("greatest", max(values))):
                self.assertAlmostEqual(summary[f"{word}_deviation_percent"], number, delta=1e-9)
        self.assertEqual([one["points"] for one in told["quantities"]], [4, 3])

    def test_csv_and_table_tell_the_same(self):
        text = HEAD + "0.01,7,0.05\n0.1,30,0.06\n4,,0.1\n"
        told = self.compared(text, None, "--format", "json").json()
        self.assertIn("the film has collapsed", told["points"][-1]["undefined"])
        rows = self.compared(text, None, "--format", "csv").rows()
        points = [row for row in rows if row["line"].isdigit()]
        for one, row in zip(told["points"], points, strict=True):
            self.assertEqual((row["id"], int(row["line"]), row["quantity"], row["unit"]), ("smooth", one["line"], one["quantity"], one["unit"]))
            for name in ("speed", "measured", "computed", "deviation_percent"):
                self.assertEqual(float(row[name]) if row[name] else None, one[name])
        self.assertEqual({row["quantity"]: float(row["deviation_percent"]) for row in rows if row["line"] == "median"},
                         {one["quantity"]: one["median_deviation_percent"] for one in told["quantities"]})
        self.assertEqual([row["quantity"] for row in rows if row["line"] == "median on the curve"], [])  # all are on it
        table = self.compared(text).out.splitlines()
        self.assertIn("  - computed: the film has collapsed: nothing balances the load", table)
        for one in told["quantities"]:
            self.assertIn(f"  - {one['quantity']}: median of 2 deviations {one['median_deviation_percent']:+.2f} %, the least "
                          f"{one['least_deviation_percent']:+.2f} %, the greatest {one['greatest_deviation_percent']:+.2f} %", table)

    def test_outputs_that_a_scene_asks_for_by_name_are_compared_too(self):
        tree = quiet_scene("smooth", outputs=["film", "minimum_film", "peak_pressure"])
        told = self.compared("speed [m/s],minimum_film [nm],peak_pressure [MPa]\n0.1,15,650\n", tree, "--format", "json").json()["points"]
        point, = self.solved(tree, [0.1])
        self.assertEqual([(one["quantity"], one["unit"], one["computed"]) for one in told],
                         [("minimum_film", "m", point["minimum_film"]), ("peak_pressure", "Pa", point["peak_pressure"])])
        self.assertTrue(math.isclose(told[1]["measured"], 650e6))

    def test_files_as_programs_write_them(self):
        def numbers(text):
            return [(one["speed"], one["quantity"], one["measured"]) for one in self.compared(text, None, "--format", "json").json()["points"]]
        wanted = numbers(HEAD + "0.01,7,0.05\n")
        self.assertEqual(wanted, [(0.01, "film", 7e-9), (0.01, "friction", 0.05)])
        for text in ("Rolling Speed (mm/s);Film Thickness (nm);Traction Coeff. (-)\n10;7,0;0,05\n", "SPEED / mm/s\tfilm/nm\tCoF\n1e1\t7\t0,05\n",
                     "entrainment speed (m/s),film_thickness [nm],μ [%]\n0.01,7,5\n", "\ufeff" + HEAD + "0.01,7,0.05", "speed [m/s];film [nm];friction\r\n0.01;7;0.05\r\n",
                     "speed [mm/s]\tfilm [µm]\tfriction [%]\n10\t0.007\t5\n", '"speed [m/s]","film [um]","friction [-]"\n"1e-2","7e-3","0.05"\n',
                     "film [mm] , friction , speed [mm/s]\n 7e-6 , 0.05 , 10 \n", "Rolling Speed U [mm/s],h [nm],CoF\n10,7,0.05\n",
                     "ue [m/s],Film Thickness h (nm),μ\n0.01,7,0.05\n", "Entrainment Velocity (m/s),hc [nm],Friction Coefficient mu\n0.01,7,0.05\n",
                     "Mean Entrainment Velocity U_e [mm/s],h_c [nm],mu\n10,7,0.05\n",
                     "v / (m/s),h/(nm),traction / (%)\n0.01,7,5\n", "v/(mm/s)\tfilm / [nm]\tfriction coeff\n10\t7\t0.05\n",
                     "u_e [m/s],h_cen [nm],Traction [-]\n0.01,7,0.05\n",
                     "v [m/s],h [nm],CoF\n0.01,7,0.05\n", "Velocity v (mm/s),h [nm],coefficient of friction\n10,7,0.05\n"):
            with self.subTest(text):
                self.assertEqual(numbers(text), wanted)

    def remarked(self, text, tree=None):
        """The points of a file, and what is said of its columns."""
        path = self.folder.write("measured.csv", text)
        result = run("curve", self.write(tree or quiet_scene("smooth")), "--data", path, "--format", "json")
        self.assertEqual((result.code, len(result.error_lines)), (0, 1), result.err)
        return ([(one["line"], one["speed"], one["quantity"], one["measured"]) for one in result.json()["points"]],
                result.err.removeprefix(f"tribocheck: {path}: columns that are not compared: "))

    def test_a_cell_in_quotes_may_have_the_separator_and_quotes(self):
        wanted = [(2, 0.01, "film", 7e-9), (2, 0.01, "friction", 0.05)]
        for text, ignored in (('run,speed [m/s],film [nm],friction\n"run 1, dirty",0.01,7,0.05\n', "run\n"),
                              ('run;speed [m/s];film [nm];friction\n "a; ""b""; c" ;0,01;7;0.05\n', "run\n"),
                              ('"speed [m/s]","film [nm]","friction","a; ""b"", c"\r\n0.01,7,0.05,","\r\n', 'a; "b", c\n'),
                              ("speed [m/s]\tfilm [nm]\tfriction\tremark\n0.01\t7\t0.05\t\n", "remark\n"),
                              ('speed [m/s],film [nm],friction,ball\n0.01,7,0.05,3/8" or 3/4"\n', "ball\n")):
            with self.subTest(text):
                self.assertEqual(self.remarked(text), (wanted, ignored))
        for cell in ('"run 1, dirty', '"run 1" dirty', '"run ""1', '"'):
            with self.subTest(cell):
                self.refused(f"u [m/s],CoF,run\n0.01,0.05,{cell}\n", "line 2: a cell begins with a quote and does not end with one")
        self.refused('u [m/s],CoF,run\n0.01,0.05,a, b\n', "line 2: 4 cells")

    def test_symbols_that_are_printed_are_taken(self):
        tree = with_field(quiet_scene("smooth", outputs=["film", "film_parameter", "lambda_ratio"]), "surface.rms_roughness", 2e-8)
        point, = self.solved(tree, [0.1])
        for head in ("λ,Λ", "λ,Lambda", "film_parameter,Lambda Ratio"):
            told = self.compared(f"v / (m/s),{head}\n0.1,1.2,2\n", tree, "--format", "json").json()["points"]
            self.assertEqual([(one["quantity"], one["measured"], one["computed"]) for one in told],
                             [(name, measured, point[name]) for name, measured in (("film_parameter", 1.2), ("lambda_ratio", 2))])

    def test_a_name_of_two_outputs_is_told_with_both(self):
        self.assertEqual(self.remarked("u [m/s],CoF,Load Share,lambda\n0.01,0.05,0.1,2\n"),
                         ([(2, 0.01, "friction", 0.05)],
                          "Load Share (name it asperity_load_share or fluid_load_share), lambda (name it film_parameter or lambda_ratio)\n"))
        told = self.compared("u [m/s],asperity load share,µ\n0.01,0.1,0.05\n", None, "--format", "json").json()["points"]
        self.assertEqual([one["quantity"] for one in told], ["asperity_load_share", "friction"])

    def test_numbers_stand_in_the_units_of_the_file(self):
        table = self.compared("v [mm/s],h [µm],friction [%]\n10,0.0091,5.5\n").out.splitlines()
        point, = self.solved(quiet_scene("smooth"), [0.01])
        rows = [line.split() for line in table if line.startswith("     2 ")]
        self.assertEqual([row[2:5] for row in rows], [["film", "[µm]", "0.0091"], ["friction", "[%]", "5.5"]])
        for row, computed in zip(rows, (1e6 * point["film"], 100 * point["friction"]), strict=True):
            self.assertAlmostEqual(float(row[5]) / computed, 1, delta=1e-4)

    def test_the_median_without_points_off_the_curve_stands_apart(self):
        tree = quiet_scene("smooth", load=50)
        head, good = "u [m/s],film [nm],load [N]\n", "0.01,7,50\n0.02,20,50\n"
        off = {"outside": "5,30,50\n", "other": "0.01,40,20\n", "-": "2,20,50\n"}  # at the last speed the film has collapsed
        for words, line in off.items():
            clean = self.compared(head + good, tree, "--format", "json").json()["quantities"][0]
            path = self.folder.write("measured.csv", head + good + line)
            told = run("curve", self.write(tree), "--data", path, "--format", "json").json()
            found, = told["quantities"]
            self.assertEqual([(one["outside"], one["other"]) for one in told["points"]],
                             [(False, False)] * 2 + [(words == "outside", words == "other")])
            self.assertEqual((found["compared"], found["on_curve"], found["median_on_curve_percent"]), (3, 2, clean["median_deviation_percent"]))
            self.assertNotEqual(found["median_deviation_percent"], found["median_on_curve_percent"])
            rows = run("curve", self.write(tree), "--data", path, "--format", "csv").rows()
            self.assertEqual([row["other"] for row in rows if row["line"].isdigit()], ["false", "false", "true" if words == "other" else "false"])
            self.assertEqual({row["line"]: float(row["deviation_percent"]) for row in rows if not row["line"].isdigit()},
                             {"median": found["median_deviation_percent"], "median on the curve": clean["median_deviation_percent"]})
            table = run("curve", self.write(tree), "--data", path).out
            self.assertIn(f"  - film on the curve: median of 2 deviations {clean['median_deviation_percent']:+.2f} %\n", table)
            self.assertEqual(words == "other", "  - other: measured at another load" in table)
        self.assertEqual((clean["on_curve"], clean["median_on_curve_percent"]), (2, clean["median_deviation_percent"]))
        self.assertNotIn("on the curve", self.compared(head + good, tree).out)

    def test_headings_are_read_with_their_symbol_commas_hyphens_and_dashes(self):
        tree = quiet_scene("smooth", load=50)
        head, row = "u [m/s],film [nm],friction,load [N]\n", "0.01,7,0.04,70\n"

        def points(text):
            path = self.folder.write("measured.csv", text)
            return run("curve", self.write(tree), "--data", path, "--format", "json").json()["points"]
        plain = points(head + row)
        for names in ('"Speed, u [m/s]","Central film, h_c (nm)",friction coefficient µ (–),Normal load F (N)\n',
                      'speed u (m/s),film h* (nm),CoF [–],load / N\n'):
            self.assertEqual(points(names + row), plain)
        self.assertTrue(all(one["other"] for one in plain))
        for name in ("Slide-to-roll ratio (%)", "slide-roll ratio", "SRR [–]"):
            self.assertTrue(points(f"u [m/s],film [nm],{name}\n0.01,7,900\n")[0]["other"], name)
        for name in ("normal load V (N)", "load of the rig (N)"):  # these may be something else
            self.assertFalse(points(f"u [m/s],film [nm],{name}\n0.01,7,900\n")[0]["other"], name)

    def test_each_mistake_is_one_line_with_its_place(self):
        for text, *expected in [
                ("", "line 0: no columns"), (HEAD, "line 1: nothing was measured"),
                ("0.01,7\n", "line 1: there is no column speed"),
                ("speed [m/s],flim [nm]\n", "line 1: there is no column of what was measured"),
                ("speed [m/s],regime\n", "line 1: there is no column of what was measured"),
                ("speed [m/s],CoF,friction\n", "line 1, column 3 (friction): this column is there twice"),
                ("speed [m/s],friction\n0,105,3\n", "line 2: 3 cells"),
                ("speed [m/s];film [nm]\n0,1;-2\n", "line 2, column 2 (film [nm]): -2 is not allowed"),
                ("speed,film [nm]\n", "line 1, column 1 (speed): its unit is missing"),
                ("speed [m/s],film\n", "line 1, column 2 (film): its unit is missing"),
                ("speed [m/s],film [µm\n", "line 1, column 2 (film [µm): this unit does not fit"),
                ("speed [m/s],friction [nm]\n", "line 1, column 2 (friction [nm]): this unit does not fit"),
                ("speed [m/s],film [nm],film [m]\n", "line 1, column 3 (film [m]): this column is there twice"),
                ("film [nm]\n7\n", "line 1: there is no column speed"), ("U [V],CoF\n", "line 1: there is no column speed"),
                ("v [V],CoF\n", "line 1: there is no column speed"),
                ("sliding speed [m/s],CoF\n", "line 1: there is no column speed: the sliding speed is that of the faces against each other"),
                ("speed h [m/s],CoF\n", "line 1: there is no column speed;"), ("v / (V),CoF\n", "line 1: there is no column speed;"),
                ("v [m/s],traction (N)\n", "line 1: there is no column of what was measured; allowed: film_flooded, film (also h, hc,"),
                ("v [m/s],Λ\n", "line 1, column 2 (Λ): the scene's `outputs` do not ask for lambda_ratio"), ("ue,CoF\n", "line 1, column 1 (ue): its unit is missing"),
                ("speed [m/s],h [hPa]\n", "line 1: there is no column of what was measured"), ("speed [m/s]\n7\n", "line 1: there is no column of what was measured"),
                (HEAD + "0.1,20\n0.2,20,0.1,3\n", "line 2: 2 cells", "line 3: 4 cells"),
                (HEAD + "0,20,0.1\n-1,20,x\n,20,0.1\n", "line 2, column 1 (speed [m/s]): 0 is not allowed",
                 "line 3, column 1 (speed [m/s]): -1 is not allowed", "line 3, column 3 (friction): x is not allowed",
                 "line 4, column 1 (speed [m/s]): the cell is empty"),
                ("speed [m/s];film [nm]\n1.000,1;20\n0.1;nan\n0.1;-2\n", "line 2, column 1 (speed [m/s]): 1.000,1 is not allowed",
                 "line 3, column 2 (film [nm]): nan is not allowed", "line 4, column 2 (film [nm]): -2 is not allowed")]:
            with self.subTest(text):
                self.refused(text, *expected)
        self.refused(HEAD + "0.1,20,0.1\n", "line 1, column 3 (friction): the scene's `outputs` do not ask for friction",
                     tree=quiet_scene("smooth", outputs=["film"]))

    def test_other_columns_are_named_in_one_line(self):
        path = self.folder.write("measured.csv", "U [V],h [s],u [m/s],CoF\n1,2,0.01,0.05\n")
        result = run("curve", self.write(quiet_scene("smooth")), "--data", path, "--format", "json")
        self.assertEqual((result.code, result.err), (0, f"tribocheck: {path}: columns that are not compared: U [V], h [s]\n"))
        path = self.folder.write("measured.csv", "time [s],speed [m/s],friction,temperature [°C]\n1,0.01,-0.002,warm\n,5,0.05,\n")
        result = run("curve", self.write(quiet_scene("smooth")), "--data", path, "--format", "json")
        self.assertEqual((result.code, result.err), (0, f"tribocheck: {path}: columns that are not compared: time [s], temperature [°C]\n"))
        first, second = result.json()["points"]
        self.assertEqual((first["measured"], first["deviation_percent"], first["outside"]), (-0.002, None, False))
        self.assertEqual((second["measured"], second["outside"]), (0.05, True))
        table = run("curve", self.write(quiet_scene("smooth")), "--data", path).out.splitlines()
        self.assertEqual([line.split()[-1] for line in table[4:6]], ["-", "outside"])
        self.assertIn("  - outside: the speed is not among those of the scene's curve", table)

    def test_rows_that_contradict_the_scene_are_told_in_a_line_of_each_column(self):
        tree = quiet_scene("smooth", load=50, friction={"boundary_coefficient": 0.13, "slide_roll_ratio": 0.5})
        tree["lubricant"] = {key: value for key, value in tree["lubricant"].items() if key != "viscosity"} | {
            "iso_vg": 32, "viscosity_index": 95, "density": 870, "temperature": "60 °C"}
        def said(head, *rows):
            path = self.folder.write("measured.csv", f"u [m/s],CoF,{head}\n" + "".join(f"0.01,0.05,{row}\n" for row in rows))
            result = run("curve", self.write(tree), "--data", path, "--format", "csv")
            self.assertEqual((result.code, sum(row["line"].isdigit() for row in result.rows())), (0, len(rows)), result.err)
            return result.err.replace(f"tribocheck: {path}: ", "")
        for head, rows, words in (
                ("load [kN]", ("0.05", "0.02", "0.1"), "column load [kN]: 2 of 3 rows have 20 N to 100 N, and the scene has load = 50 N"),
                ("Normal Force (N)", ("20", "50.5", ""), "column Normal Force (N): 1 of 2 rows have 20 N, and"),
                ("SRR [%]", ("50", "-50", "2"), "column SRR [%]: 1 of 3 rows have 0.02, and the scene has friction.slide_roll_ratio = 0.5"),
                ("slide_roll_ratio", ("50", "50"), "column slide_roll_ratio: 2 of 2 rows have 50, and"),
                ("Oil Temperature [°C]", ("60.4", "40"), "column Oil Temperature [°C]: 1 of 2 rows have 40 °C, and the scene has lubricant.temperature = 60 °C")):
            with self.subTest(head):
                told = said(head, *rows)
                self.assertTrue(told.startswith(words) and told.count("\n") == 1, told)
        for head, row in (("load [N]", "50"), ("load [kN]", "0.0505"), ("SRR [-]", "-0.5"), ("T [°C]", "60.9"), ("load [N],SRR", "50,0.5")):
            with self.subTest(head):
                self.assertEqual(said(head, row), "")
        tree["friction"]["slide_roll_ratio"] = 0  # rigs hold pure rolling as well as any other ratio
        self.assertEqual(said("SRR [%]", "1.9", "-1.9"), "")
        self.assertIn("1 of 2 rows have 0.021, and the scene has friction.slide_roll_ratio = 0", said("SRR [%]", "1.9", "-2.1"))
        self.assertEqual(said("load [s],SRR [N]", "50,0.5"), "columns that are not compared: load [s], SRR [N]\n")

    def test_many_mistakes_are_twenty_lines_and_their_number(self):
        path = self.folder.write("measured.csv", HEAD + "x,1,1\n" * 30)
        result = run("curve", self.write(quiet_scene()), "--data", path)
        self.assertEqual((result.code, len(result.error_lines)), (2, 21))
        self.assertEqual(result.error_lines[-1], f"tribocheck: {path}: 10 more mistakes")

    def test_what_cannot_be_compared_is_one_line(self):
        path = self.write(quiet_scene())
        for arguments, words in ((["--data", self.folder.path("none.csv")], "none.csv: the file cannot be read: No such file or directory"),
                                 (["--data", self.folder.name], "the file cannot be read"),
                                 ([path, "--data", self.folder.write("m.csv", HEAD)], "--data is compared with one scene, and these are 2")):
            result = run("curve", path, *arguments)
            self.assertEqual((result.code, result.out, len(result.error_lines)), (2, "", 1), result.err)
            self.assertIn(words, result.err)


class Speeds(CurveTest):
    def test_a_list_is_answered_at_its_speeds(self):
        tree = quiet_scene("smooth", speed=[0.01, 0.1, 0.5])
        told = run("curve", self.write(tree), "--format", "json").json()["points"]
        self.assertEqual(told, self.solved(tree, [0.01, 0.1, 0.5]))


class Pictures(CurveTest):
    def drawn(self, *arguments, name="curve.svg"):
        target = self.folder.path(name)
        result = run("curve", *arguments, "--picture", target)
        self.assertEqual((result.code, result.err), (0, f"tribocheck: drew {target}\n"))
        return target

    def panels(self, target):
        """Each panel with its axes."""
        plots, _ = svg_plots.read(target)
        across = svg_plots.Axis(plots[-1].labels["x"], True)
        return [(plot, across, svg_plots.Axis(plot.labels["y"], name == "film")) for plot, name in zip(plots, PANELS, strict=True)]

    def test_curves_marks_and_measured_points_are_where_their_numbers_are(self):
        tree = quiet_scene("smooth")
        measured = [(0.01, 7.4, 0.049), (5, 30, 0.02)]
        target = self.drawn(self.write(tree), "--data", self.folder.write("m.csv", HEAD + "".join(f"{u},{h},{f}\n" for u, h, f in measured)))
        self.assertEqual(list(svg_plots.looks(target)), [])
        onset = next(one for one in run("onset", self.write(tree), "--format", "json").json()["onsets"] if one["criterion"] == "film_maximum")
        at, first = self.solved(tree, [onset["speed"], 1e-4])
        points_of = {"friction": [(u, f) for u, _, f in measured], "film": [(u, h) for u, h, _ in measured]}
        for (plot, across, up), (name, (_, factor)) in zip(self.panels(target), PANELS.items()):
            places = [place for series in plot.series for place in series.points]
            for speed, value in [(onset["speed"], factor * at[name]), *points_of.get(name, [])]:
                self.assertTrue(any(math.hypot(x - across.place(speed), y - up.place(value)) < 0.2 for x, y in places), (name, speed, value, places))
            strokes = [place for series in plot.series for place in series.lines]
            self.assertTrue(any(math.hypot(x - across.place(1e-4), y - up.place(factor * first[name])) < 0.2 for x, y in strokes), (name, strokes[:3]))
        words = {text for text, *_ in svg_plots.texts(target)}
        self.assertLessEqual({title for title, _ in PANELS.values()} | {"measured", OFF_CURVE, "film maximum", "last point before the collapse"}, words)

    def test_points_off_the_curve_have_a_mark_of_their_own(self):
        tree, head = quiet_scene("smooth", load=50), "u [m/s],film [nm],load [N]\n"
        def marks(*rows):
            target = self.drawn(self.write(tree), "--data", self.folder.write("m.csv", head + "".join(f"{row}\n" for row in rows)), name="marks.svg")
            words = {text for text, *_ in svg_plots.texts(target)}
            text = pathlib.Path(target).read_text(encoding="utf-8")
            of_legend = 1  # the legend has each mark once
            return [(len(re.findall(f"href='#{mark}' transform='translate", text)) - of_legend if title in words else 0)
                    for title, mark in (("measured", "gpPt4"), (OFF_CURVE, "gpPt3"))]
        on, outside, at_collapse = "0.01,7,50", "5,30,50", "2,20,50"
        self.assertEqual(marks(on, on.replace("7", "8")), [2, 0])
        self.assertEqual(marks(on, outside, at_collapse), [1, 2])
        self.assertEqual(marks(outside), [0, 1])

    def test_only_what_scenes_ask_for_is_drawn(self):
        flooded = self.write(quiet_scene("smooth", id="flooded", supply=None, outputs=["film", "inlet"]), "flooded.toml")
        target = self.drawn(flooded)
        words = {text for text, *_ in svg_plots.texts(target)}
        self.assertIn("film h* (nm)", words)
        self.assertFalse(words & {"friction coefficient μ (–)", "film maximum", "last point before the collapse", "measured"}, words)
        target = self.drawn(flooded, self.write(quiet_scene("rough")), name="both.svg")
        self.assertLessEqual({"flooded", "rough", "friction coefficient μ (–)"}, {text for text, *_ in svg_plots.texts(target)})

    def test_a_curve_that_begins_late_says_why(self):
        smooth = without_field(quiet_scene("smooth", id="ball on a glass disc, at a slide-roll ratio of 50 %", supply=None,
                                           speed={"from": 0.05, "to": 1}), "surface")
        words = {}
        for roughness in ("10 nm", "0.1 nm"):
            tree = {**smooth, "surface": {"rms_roughness": roughness}, "accept": ["rough_as_smooth", "film_below_molecule", "smooth_film_law"]}
            words[roughness] = [text for text, *_ in svg_plots.texts(self.drawn(self.write(tree)))]
        why = "No friction or asperity load share where Λ is below 3: the faces touch"
        self.assertIn(why, words["10 nm"])
        self.assertNotIn(" where ", "".join(words["0.1 nm"]))
        self.assertIn(smooth["id"], words["10 nm"])  # the legend
        self.assertIn(smooth["id"] + ": Stribeck curve", words["10 nm"])

    def test_png(self):
        with open(self.drawn(self.write(quiet_scene()), name="curve.png"), "rb") as file:
            head = file.read(24)
        self.assertEqual((head[12:16], struct.unpack(">I", head[16:20])), (b"IHDR", (1920,)))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["curve.png", "scene.toml"])

    def test_what_cannot_be_drawn_is_one_line(self):
        path = self.write(quiet_scene())
        words = self.write(quiet_scene(outputs=["regime"]), "words.toml")
        for code, arguments, said in ((2, [path] * 7, "--picture draws at most 6 scenes, and these are 7"),
                                      (2, [words], "--picture draws friction, film and asperity_load_share"),
                                      (1, [path], f"cannot write {self.folder.path('no/curve.png')}: there is no folder {self.folder.path('no')}\n")):
            result = run("curve", *arguments, "--picture", self.folder.path("no/curve.png"))
            self.assertEqual((result.code, len(result.error_lines)), (code, 1), result.err)
            self.assertIn(said, result.err)
        self.assertFalse(os.path.exists(self.folder.path("no")))


if __name__ == "__main__":
    unittest.main()
