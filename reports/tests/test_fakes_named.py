# SPDX-License-Identifier: Apache-2.0
"""verify --subject names the mistake of each fake, all mistakes of solvers with two or three, and none where nothing is wrong."""

import concurrent.futures
import unittest

from conformance import SUBJECTS, subject, verify
from program import run
from test_fakes import listed

# The name that the diagnosis gives to the mistake of each fake. Mistakes that numbers do not tell apart share a name.
NAMED = {
    "point_ellipse_as_circle": "point-ellipse-as-circle",
    "point_film_of_circle": "point-film-of-circle",
    "point_ellipse_exchanged": "point-ellipse-exchanged",
    "point_line_too_wide": "point-line-too-wide",
    "asperity_stiffness_halved": "stiffness-halved",
    "asperity_stiffness_of_williamson": "stiffness-gw-for-gt",
    "asperity_sd_in_micrometres": "stiffness-sigma-in-um",
    "asperity_radius_in_micrometres": "stiffness-beta-in-um",
    "asperity_sd_of_one_face": "sigma-of-one-face",
    "asperity_offset_two_planes": "offset-of-two-planes",
    "asperity_offset_none": "sharing-offset-ignored",
    "asperity_offset_other_sign": "sharing-offset-added",
    "sharing_order_of_williamson": "sharing-order-3/2",
    "sharing_share_exponent_one": "sharing-q-1",
    "sharing_none": "sharing-none",
    "sharing_film_exponent_067": "sharing-exponent-0.67",
    "bodies_modulus_doubled": "modulus-2E*",
    "bodies_modulus_halved": "modulus-E*-halved",
    "bodies_modulus_without_poisson": "modulus-without-poisson-ratio",
    "bodies_modulus_one_minus_nu": "modulus-1-minus-ν",
    "bodies_modulus_of_first": "modulus-of-first-body",
    "bodies_modulus_of_alike": "modulus-of-first-twice",
    "bodies_modulus_one_poisson": "modulus-ν-of-first",
    "bodies_modulus_mean": "modulus-mean",
    "bodies_modulus_in_gpa": "modulus-in-GPa",
    "bodies_radius_difference": "radius-difference",
    "bodies_radius_without_sign": "radius-sign-ignored",
    "bodies_radius_sum": "radius-sum",
    "bodies_radius_mean": "radius-mean",
    "bodies_radius_harmonic_mean": "radius-all-doubled",
    "bodies_radius_of_first": "radius-of-first-body",
    "bodies_radius_exchanged": "radius-x-and-y-exchanged",
    "bodies_radius_of_mean_curvature": "radius-mean-curvature",
    "bodies_radius_geometric_mean": "radius-geometric-mean",
    "bodies_radius_in_mm": "radius-in-mm",
    "hertz_modulus_doubled": "hertz-2E*",
    "hertz_modulus_halved": "hertz-E*-halved",
    "hertz_approach_modulus_doubled": "hertz-approach-2E*",
    "hertz_half_radius": "hertz-radius-halved",
    "hertz_radius_in_mm": "hertz-R-in-mm",
    "hertz_area_without_pi": "hertz-area-without-pi",
    "hertz_peak_without_3_2": "hertz-peak-is-mean",
    "ellipse_modulus_for_parameter": "ellipse-modulus-for-parameter",
    "ellipse_auxiliary_angle": "ellipse-auxiliary-angle-halved",
    "ellipse_fit_1_0339": "ellipse-fit-1.0339",
    "ellipse_fit_two_over_pi": "ellipse-fit-2/π",
    "ellipse_fit_1_03": "ellipse-fit-1.03-of-k",
    "ellipse_as_circle": "ellipse-as-circle",
    "ellipse_exchanged": "ellipse-x-and-y-exchanged",
    "ellipse_modulus_doubled": "ellipse-2E*",
    "ellipse_radius_along_x": "ellipse-R_x-for-R",
    "ellipse_mean_curvature": "ellipse-mean-curvature",
    "ellipse_diameters": "ellipse-diameters",
    "ellipse_peak_is_mean": "ellipse-peak-is-mean",
    "ellipse_approach_of_circle": "ellipse-approach-of-circle",
    "line_eight_for_four": "line-half-width-8",
    "line_modulus_doubled": "line-2E*",
    "line_load_per_millimetre": "line-load-per-mm",
    "line_without_pi": "line-half-width-without-pi",
    "line_whole_width": "line-whole-width",
    "line_peak_of_point": "line-peak-of-a-point",
    "line_shear_of_point": "line-shear-0.31",
    "line_shear_quarter": "line-shear-0.25",
    "film_half_radius": "film-radius-halved",
    "film_radius_in_mm": "film-R-in-mm",
    "film_speed_sum": "film-speed-sum",
    "film_modulus_in_speed": "film-E*-in-U",
    "film_modulus_in_material": "film-E*-in-G",
    "film_modulus_in_load": "film-E*-in-W",
    "film_modulus_single": "film-E*",
    "film_modulus_doubled": "film-4E*",
    "film_constant_0_6": "film-0.6",
    "film_constant_without_bracket": "film-bracket-dropped",
    "film_minimum": "film-minimum",
    "law_central_for_minimum": "film-of-hamrock_dowson_central",
    "law_ellipticity_inverted": "film-ellipticity-inverted",
    "law_load_exponent": "film-load-exponent-of-G",
    "law_soft_central_for_minimum": "film-of-hamrock_dowson_soft_central",
    "line_minimum_for_central": "film-of-dowson_higginson_minimum",
    "line_modulus_single": "film-E*",
    "line_diameter": "film-radius-doubled",
    "line_load_of_a_point": "film-load-number-of-a-point",
    "moes_single_speed": "film-speed-halved",
    "regime_hundredth": "regime-1.41",
    "thermal_percent": "thermal-slide-roll-in-percent",
    "density_rounded": "density-rounded",
    "roelands_rounded": "roelands-5.1e-9",
    "roelands_giga": "liquid-pressure-in-GPa",
    "d341_without_offset": "d341-without-0.7",
    "d341_celsius": "d341-celsius",
    "summits_of_roots": "summits-all-rms",
    "summits_sd_of_heights": "summits-sd-of-heights",
    "inlet_ratio_to_oil": "inlet-over-r",
    "inlet_circular_gap": "inlet-circular-gap",
    "inlet_printed_exponents": "inlet-printed_exponents-for-flooded_inlet",
    "friction_viscosity_ambient": "viscosity-ambient-for-barus",
    "friction_roelands_log10": "viscosity-decimal-logarithm",
    "friction_limiting_for_eyring": "shear-limiting-for-eyring",
    "friction_slide_roll_ignored": "slide-roll-ignored",
    "friction_boundary_by_fluid_share": "friction-share-swapped",
    "friction_area_not_subtracted": "friction-area-not-subtracted",
    "moment_fit_power_5_2": "moment-fit-6.804",
    "moment_fit_power_5_2_miscopied": "moment-fit-4.4068",
    "moment_fit_power_2": "moment-fit-6.9",
    "moment_fit_exponential_5_2": "moment-fit-exponential",
    "moment_fit_exponential_2": "moment-fit-exponential-2",
    "moment_fit_error_function": "moment-fit-erf",
    "moment_simpson_201_points": "moment-by-simpson-200-d-plus-20",
    "moment_simpson_200_intervals": "moment-cut-at-d-plus-4.5",
    "moment_zero_beyond_10": "moment-zero-beyond-10",
    "moment_cut_at_4": "moment-cut-at-4",
    "moment_cut_at_5_beyond": "moment-cut-at-d-plus-5",
    "moment_bessel_stray_root": "moment-stray-root",
    "moment_without_root_two_pi": "moment-unnormalized",
    "moment_order_half_up": "moment-order-half-higher",
    "moment_order_one_up": "moment-order-higher",
    "moment_sign_of_argument": "moment-sign",
    "moment_about_zero": "moment-about-zero",
}


# Sets of fakes of each function: one solver makes all mistakes of a set.
TOGETHER = {
    "hamrock_dowson_central": """
        film_half_radius+film_modulus_single        film_half_radius+film_speed_sum
        film_half_radius+film_constant_0_6          film_half_radius+film_constant_without_bracket
        film_half_radius+film_modulus_in_speed      film_half_radius+film_modulus_in_load
        film_radius_in_mm+film_modulus_doubled      film_radius_in_mm+film_constant_0_6
        film_speed_sum+film_modulus_single          film_speed_sum+film_constant_0_6
        film_speed_sum+film_modulus_in_material     film_speed_sum+film_constant_without_bracket
        film_modulus_in_speed+film_modulus_in_load  film_modulus_in_material+film_constant_0_6
        film_modulus_single+film_constant_0_6       film_modulus_doubled+film_constant_without_bracket
        film_minimum+film_half_radius               film_minimum+film_speed_sum
        film_minimum+film_radius_in_mm              film_minimum+film_modulus_single
        film_half_radius+film_modulus_single+film_constant_0_6
        film_half_radius+film_speed_sum+film_constant_0_6
        film_minimum+film_half_radius+film_speed_sum
        film_radius_in_mm+film_modulus_in_load+film_constant_without_bracket""",
    "hertz_point": """
        hertz_modulus_doubled+hertz_area_without_pi   hertz_modulus_doubled+hertz_peak_without_3_2
        hertz_modulus_halved+hertz_area_without_pi    hertz_modulus_halved+hertz_peak_without_3_2
        hertz_half_radius+hertz_area_without_pi       hertz_half_radius+hertz_peak_without_3_2
        hertz_half_radius+hertz_modulus_halved        hertz_half_radius+hertz_radius_in_mm
        hertz_radius_in_mm+hertz_modulus_doubled      hertz_area_without_pi+hertz_peak_without_3_2
        hertz_half_radius+hertz_area_without_pi+hertz_peak_without_3_2
        hertz_radius_in_mm+hertz_modulus_doubled+hertz_peak_without_3_2""",
    "load_sharing": """
        asperity_offset_none+sharing_order_of_williamson        asperity_offset_none+sharing_share_exponent_one
        asperity_offset_none+sharing_film_exponent_067          asperity_offset_other_sign+sharing_film_exponent_067
        asperity_offset_other_sign+sharing_order_of_williamson  asperity_offset_other_sign+sharing_share_exponent_one
        sharing_order_of_williamson+sharing_film_exponent_067   sharing_share_exponent_one+sharing_film_exponent_067""",
    "starvation_ratio": """
        inlet_ratio_to_oil+inlet_circular_gap""",
    "operating_point": """
        asperity_stiffness_halved+asperity_sd_of_one_face       asperity_stiffness_halved+friction_viscosity_ambient
        asperity_sd_of_one_face+asperity_stiffness_of_williamson asperity_offset_two_planes+asperity_stiffness_halved
        friction_slide_roll_ignored+friction_viscosity_ambient  asperity_sd_of_one_face+friction_slide_roll_ignored
        friction_boundary_by_fluid_share+friction_slide_roll_ignored""",
}
SETS = [(function, fakes) for function, sets in TOGETHER.items() for fakes in sets.split()]


def all_verdicts(asked, ones):
    """The answer of asked(one) for each, two at a time."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return dict(zip(ones, pool.map(asked, ones)))


class Fakes(unittest.TestCase):
    """Every fake is caught, and its mistake is named."""

    def test_the_table_of_names_has_every_fake(self):
        self.assertEqual(sorted(NAMED), sorted(name for name, _, _ in listed()))

    def test_each_mistake_is_named(self):
        # The first fake of each function answers all functions, also those that use its own. Other fakes answer only their own function.
        functions = {name: function for name, _, function in listed()}
        first = {function: name for name, function in reversed(functions.items())}

        def asked(fake):
            only = [] if fake in first.values() else ["--only", functions[fake]]
            return verify("--subject", subject("fakes/fake.py", "--mistake", fake, *only), "--sample", "400")
        results = all_verdicts(asked, NAMED)
        for fake, mistake in NAMED.items():
            with self.subTest(fake):
                result = results[fake]
                # This fake is wrong only beyond the physical range.
                self.assertEqual(result.code, 0 if fake == "moment_zero_beyond_10" else 1)
                diagnoses = result.json()["diagnoses"]
                self.assertIn(mistake, sum((one["mistakes"] for one in diagnoses), []),
                              [one["text"] for one in diagnoses])

    def test_nothing_is_named_where_nothing_is_wrong(self):
        result = verify("--subject", subject("fakes/fake.py", "--mistake", "none"))
        self.assertEqual((result.code, result.json()["diagnoses"]), (0, []))

    def test_the_three_verdicts_are_those_of_the_readme(self):
        readme = (SUBJECTS.parent / "README.md").read_text()
        shown = readme.split("## Three verdicts")[1].split("```")[1].strip().splitlines()
        for fake, code, line in zip(("none", "moment_zero_beyond_10", "moment_cut_at_4"), (0, 0, 1), shown, strict=True):
            with self.subTest(fake):
                done = run("verify", "--subject", subject("fakes/fake.py", "--mistake", fake))
                self.assertEqual((done.code, done.out.splitlines()[-1]), (code, line))
        run("verify", "--tolerance", "strict",
            "--subject", subject("fakes/fake.py", "--mistake", "moment_zero_beyond_10")).ended(1)

    def test_the_newcomers_film_is_told_in_a_sentence(self):
        result = run("verify", "--subject", subject("small_python/my_solver.py")).ended(1)
        self.assertIn("hamrock_dowson_central is 27.5 % low everywhere. These are the numbers that this gives: "
                      "R/2 in place of R", result.out)


class Together(unittest.TestCase):
    def test_there_are_at_least_forty(self):
        self.assertGreaterEqual(len(set(SETS)), 40)

    def test_all_mistakes_of_a_set_are_named(self):
        def asked(one):
            function, fakes = one
            return verify("--subject", subject("fakes/fake.py", "--mistake", fakes, "--only", function))
        for (function, fakes), result in all_verdicts(asked, SETS).items():
            with self.subTest(fakes):
                self.assertEqual(result.code, 1)
                diagnoses = result.json()["diagnoses"]
                named = {name for one in diagnoses for cause in one["mistakes"] for name in cause.split(" + ")}
                self.assertLessEqual({NAMED[fake] for fake in fakes.split("+")}, named,
                                     [one["text"] for one in diagnoses])


if __name__ == "__main__":
    unittest.main()
