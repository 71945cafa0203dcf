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
