# SPDX-License-Identifier: Apache-2.0
"""verify --subject names two or three mistakes that a solver has at once: all of them."""

import concurrent.futures
import unittest

from conformance import subject, verify
from test_fakes_named import NAMED

# The fakes of each function that are put together.
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


class Together(unittest.TestCase):
    def test_there_are_at_least_forty(self):
        self.assertGreaterEqual(len(set(SETS)), 40)

    def test_all_mistakes_of_a_set_are_named(self):
        def asked(one):
            function, fakes = one
            return verify("--subject", subject("fakes/fake.py", "--mistake", fakes, "--only", function))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = dict(zip(SETS, pool.map(asked, SETS)))
        for (function, fakes), result in results.items():
            with self.subTest(fakes):
                self.assertEqual(result.code, 1)
                diagnoses = result.json()["diagnoses"]
                named = {name for one in diagnoses for cause in one["mistakes"] for name in cause.split(" + ")}
                self.assertLessEqual({NAMED[fake] for fake in fakes.split("+")}, named,
                                     [one["text"] for one in diagnoses])


if __name__ == "__main__":
    unittest.main()
