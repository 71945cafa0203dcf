# SPDX-License-Identifier: Apache-2.0
"""The central film of a point by the formula of Hamrock and Dowson's minimum film."""

import film_right


def hamrock_dowson_central(reduced_radius, **given):
    return film_right.hamrock_dowson_minimum(radius_x=reduced_radius, **given)
