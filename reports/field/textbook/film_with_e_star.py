# SPDX-License-Identifier: Apache-2.0
"""Films of points by Hamrock and Dowson with E* in the place of their E' = 2 E*."""

import film_right


def halved(film):
    return lambda effective_modulus, **given: film(effective_modulus=effective_modulus / 2, **given)


hamrock_dowson_central = halved(film_right.hamrock_dowson_central)
hamrock_dowson_minimum = halved(film_right.hamrock_dowson_minimum)
