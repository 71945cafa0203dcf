# SPDX-License-Identifier: Apache-2.0
"""Films of points by B. J. Hamrock and D. Dowson (1977), with their E' = 2 E*."""

from math import exp


def groups(speed, viscosity, pressure_viscosity, load, E, R):
    return viscosity * speed / (E * R), pressure_viscosity * E, load / (E * R**2)


def hamrock_dowson_central(speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius, ellipticity=1):
    U, G, W = groups(speed, viscosity, pressure_viscosity, load, 2 * effective_modulus, reduced_radius)
    return 2.69 * U**0.67 * G**0.53 * W**-0.067 * (1 - 0.61 * exp(-0.73 * ellipticity)) * reduced_radius


def hamrock_dowson_minimum(speed, viscosity, pressure_viscosity, load, effective_modulus, radius_x, ellipticity=1):
    U, G, W = groups(speed, viscosity, pressure_viscosity, load, 2 * effective_modulus, radius_x)
    return 3.63 * U**0.68 * G**0.49 * W**-0.073 * (1 - exp(-0.68 * ellipticity)) * radius_x
