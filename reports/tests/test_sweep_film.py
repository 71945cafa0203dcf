# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep with solved_film = true: solved films of line contacts over M and L."""

import math
import unittest

from program import run
from sweeps import SweepTest, opened

# At one speed M depends on the load alone, and L on the pressure-viscosity coefficient alone.
LINES = """id = "lines"
load = [500, 5000]
speed = [0.5, 2]
[bodies]
effective_modulus = 1.1e11
radius_x = 0.01
length = 0.01
[lubricant]
viscosity = 0.05
pressure_viscosity = [2e-9, 1.5e-8]
"""
SWEEP = LINES + "[sweep]\nsolved_film = true\n"
COLUMNS = ("load_number", "material_number", "central", "central_error", "minimum", "minimum_error")


class SolvedFilms(SweepTest):
    solved_once = {}

    def solved(self):
        """The program's output on SWEEP, the bytes of its result, and its columns. All tests share one run, because films take long."""
        if not self.solved_once:
            said = self.sweep(SWEEP, "--threads", "2", out="once.h5")
            with opened(self.path("once.h5")) as file:
                columns = {name: file["lines/outputs/solved_film"][name][:] for name in COLUMNS}
            self.solved_once.update(said=said, bytes=self.bytes_of("once.h5"), columns=columns)
        return self.solved_once

    def test_films_are_those_of_the_command(self):
        found = self.solved()["columns"]
        case = 0
        for coefficient in (2e-9, 1.5e-8):
            for load in (500, 5000):
                scene = LINES.replace("[500, 5000]", str(load)).replace(
                    "[2e-9, 1.5e-8]", str(coefficient))
                done = run("film", self.folder.write("line.toml", scene), "--format", "csv").ended(0)
                for at, row in enumerate(done.rows()):
                    for name in ("central", "minimum"):
                        value, error = float(row[f"{name}_film"]), float(row[f"{name}_film_error"])
                        got, own_error = found[name][case][at], found[f"{name}_error"][case][at]
                        self.assertLessEqual(abs(got - value), error + own_error, (scene, row))
                        self.assertLess(own_error, 1e-4 * got)
                    self.assertTrue(math.isclose(found["load_number"][case][at],
                                                 float(row["load_number"]), rel_tol=1e-12))
                case += 1

    def test_m_and_l_form_the_grid(self):
        found = self.solved()["columns"]
        m, l = found["load_number"], found["material_number"]
        for at in range(2):
            self.assertEqual(m[0][at], m[2][at])
            self.assertTrue(math.isclose(m[1][at], 10 * m[0][at], rel_tol=1e-12))
            self.assertEqual(l[0][at], l[1][at])
            self.assertTrue(math.isclose(l[2][at], 7.5 * l[0][at], rel_tol=1e-12))

    def test_a_film_that_is_not_solved_is_told_with_its_place(self):
        # At the lowest speed the film is too thin for the grids.
        text = SWEEP.replace("speed = [0.5, 2]", "speed = [1e-20, 0.5]")
        result = self.sweep(text).ended(1)
        self.assertIn("speed 1e-20 m/s", result.warned)
        told, = result.error_lines
        self.assertIn("4 of 8 films were not solved", told)
        with opened(self.path("out.h5")) as file:
            films = file["lines/outputs/solved_film"]
            words = [str(word, "utf-8") if isinstance(word, bytes) else word
                     for word in films["outcome"].attrs["words"]]
            outcome = [[words[place] for place in row] for row in films["outcome"][:]]
            self.assertEqual(outcome, 4 * [["not_solved", "solved"]])
            self.assertTrue(all(math.isnan(slow) and fast > 0 for slow, fast in films["central"][:]))
        rows = run("sweep", "show", self.path("out.h5"), "--cases", "--format", "csv").rows()
        for row in rows:
            self.assertEqual(row["solved_film.outcome"] == "not_solved", row["solved_film.central [m]"] == "", row)
        shown = run("sweep", "show", self.path("out.h5"))
        self.assertEqual((shown.code, shown.error_lines), (0, [told]))
        whole = self.solved()["said"]
        self.assertEqual((whole.code, whole.error_lines), (0, []))

    def test_threads_change_no_byte(self):
        by_two = self.solved()["bytes"]
        self.swept(SWEEP, "--threads", "1")
        self.assertEqual(self.bytes_of("out.h5"), by_two)

    def test_a_circle_is_refused_in_one_line(self):
        circle = SWEEP.replace("radius_x = 0.01\nlength = 0.01", "reduced_radius = 0.01")
        self.assert_refused(self.sweep(circle), "a sweep solves films of line contacts alone")

    def test_the_c_library_cannot_leave_fused_multiply_add_out(self):
        self.assert_refused(self.sweep(SWEEP, "--without-fma"), "--without-fma", "without solved_film")

    def test_a_speed_is_needed(self):
        self.assert_refused(self.sweep(SWEEP.replace("speed = [0.5, 2]\n", "")), "speed: missing")


if __name__ == "__main__":
    unittest.main()
