# SPDX-License-Identifier: Apache-2.0
"""Asks hertz.py by R. F. Smith for a cylinder on a plane, given its diameter. nu = 0.3 for both bodies, as its constant 2.86 implies."""

from answering import load as file

hertz = file("hertz.py")


def hertz_line(load_per_length, effective_modulus, reduced_radius):
    E = 2 * (1 - 0.3**2) * effective_modulus
    return {"peak_pressure": hertz.cylinder_plane(load_per_length, 1, 2 * reduced_radius, E, E)}
