# SPDX-License-Identifier: Apache-2.0
"""verify --subject names the mistakes of wrong solvers, whose makers did not know how it finds causes."""

import concurrent.futures
import unittest

from conformance import subject, verify
from program import ProgramTest

# For each slip, the quantity that shows it, and words that have to stand in the diagnosis of this quantity.
SAID = {
    "moes_material_with_single_modulus": ("moes_line", "with α/2 in place of α ("),
    "moes_load_without_root_two": ("moes_line", "with √2 F/L in place of F/L ("),
    "eyring_stress_in_megapascals": ("operating_point.friction", "with 10⁶ `lubricant.eyring_stress` in place of"),
    "inlet_flow_over_sum_of_speeds": ("operating_point.film", "with `supply.inlet_flow`/2 in place of"),
    "full_film_from_three": ("load_sharing", "wrong answers are λ₀ itself"),
    "film_at_least_a_nanometre": ("hamrock_dowson_central", "wrong answers are 1e-09: a floor"),
    "barus_exponent_capped": ("barus_viscosity", "with αp = 25 wherever it is greater: it is cut off there"),
    "kelvins_taken_for_degrees": ("astm_d341_viscosity", "with each of T₁, T₂, T + 273.15 in place of"),
    "default_ellipticity": ("hamrock_dowson_central", "with k = 1.03 where it is left out"),
    "index_digits_of_two_rows": ("viscosity_index", "with 5.7941 in place of 5.9741, and -57.07 in place of -50.77 ("),
    "central_film_speed_and_load": ("hamrock_dowson_central", "with U^0.76 in place of U^0.67, and 2 F in place of F ("),
    "line_film_and_its_sharing_exponent": ("operating_point_of_line.film_flooded",
                                           "0.2 in place of the film's exponent, in load sharing, where `closures.film` is dowson_toyoda_central"),
    "boundary_word_from_ninety_percent": ("operating_point.regime",
                                          "`boundary` is answered from asperity_load_share = 0.9 on; it is right from"),
    "stiffness_kept_without_load": ("operating_point.film_flooded", "looks for it without bodies.reduced_radius and load ("),
    "closures_kept_where_left_out": ("operating_point.asperity_load_share",
                                     "`closures.asperity`, `closures.starvation`, `closures.damiens_exponent` of the last question that gave it"),
    "moes_exponent_is_static": ("moes_line", "s of the first question in all later ones: it is kept"),
    "moes_norms_of_whole_numbers": ("moes_line", "with 2 in place of 7/3, and -3 in place of −7/2 ("),
    "chart_of_old_and_rounded_zero": ("astm_d341_viscosity",
                                      "0.6 in place of 0.7, and each of T₁, T₂, T − 0.15 in place of each of T₁, T₂, T"),
    "roelands_exponent_of_two_decimals": ("roelands_viscosity", "with z rounded to 2 decimals"),
    "minimum_film_of_converted_ellipticity": ("hamrock_dowson_minimum", "with 1.0339 k^0.636 in place of k ("),
    "friction_of_smooth_film_and_no_zero": ("operating_point.friction", "`friction.slide_roll_ratio` = 1 where it is 0 ("),
    "index_by_e_of_next_row_and_not_below_zero": (
        "viscosity_index", "the row after the right one in the table of L and H, and e in place of 10 above 100 ("),
    "summits_of_a_square_metre": ("operating_point.summit_count", "n in place of nA in the number of summits ("),
}


class Slips(ProgramTest):
    def test_each_is_told_with_what_its_maker_has_to_mend(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = pool.map(lambda slip: verify("--subject", subject("slips/solver.py", "--slip", slip)), SAID)
            for (slip, (quantity, words)), result in zip(SAID.items(), results):
                with self.subTest(slip=slip):
                    self.assertEqual(result.code, 1)
                    texts = [one["text"] for one in result.json()["diagnoses"] if one["quantity"] == quantity]
                    self.assertTrue(any(words in text for text in texts), texts)
                    said = [other for _, other in SAID.values() if other != words and any(other in text for text in texts)]
                    self.assertEqual(said, [])  # no other slip is named


if __name__ == "__main__":
    unittest.main()
