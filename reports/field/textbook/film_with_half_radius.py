# SPDX-License-Identifier: Apache-2.0
"""Films and Hertz' point of a ball on a flat with R/2 in place of R, as for two equal balls, or as if R were a diameter."""

import film_right
import hertz_right


def hertz_point(load, effective_modulus, reduced_radius):
    return hertz_right.hertz_point(load, effective_modulus, reduced_radius / 2)


def hamrock_dowson_central(reduced_radius, **given):
    return film_right.hamrock_dowson_central(reduced_radius=reduced_radius / 2, **given)


def hamrock_dowson_minimum(radius_x, **given):
    return film_right.hamrock_dowson_minimum(radius_x=radius_x / 2, **given)
