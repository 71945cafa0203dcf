# SPDX-License-Identifier: Apache-2.0
"""Films of lines by D. Dowson and G. R. Higginson (1968), and the same law for points, with the load over 2a."""

import hertz_right


def dowson_higginson_minimum(speed, viscosity, pressure_viscosity, load_per_length, effective_modulus, reduced_radius):
    E, R = 2 * effective_modulus, reduced_radius
    U, G, W = viscosity * speed / (E * R), pressure_viscosity * E, load_per_length / (E * R)
    return 2.65 * U**0.7 * G**0.54 * W**-0.13 * R


def hamrock_dowson_minimum(load, effective_modulus, radius_x, ellipticity=1, **given):
    if ellipticity != 1:
        return None
    a = hertz_right.hertz_point(load, effective_modulus, radius_x)["radius"]
    return dowson_higginson_minimum(load_per_length=load / (2 * a), effective_modulus=effective_modulus,
                                    reduced_radius=radius_x, **given)
