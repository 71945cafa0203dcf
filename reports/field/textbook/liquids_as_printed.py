# SPDX-License-Identifier: Apache-2.0
"""Laws of liquids as textbooks print them: Barus, Roelands, Dowson and Higginson's density with rounded constants, ASTM D341 with 0.7."""

from math import exp, log, log10


def barus_viscosity(viscosity, pressure_viscosity, pressure):
    return viscosity * exp(pressure_viscosity * pressure)


def roelands_viscosity(viscosity, pressure_viscosity, pressure):
    z = pressure_viscosity / (5.1e-9 * (log(viscosity) + 9.67))
    return viscosity * exp((log(viscosity) + 9.67) * ((1 + 5.1e-9 * pressure) ** z - 1))


def dowson_higginson_density(pressure):
    return 1 + 0.6e-9 * pressure / (1 + 1.7e-9 * pressure)


def astm_d341_viscosity(first_temperature, first_viscosity, second_temperature, second_viscosity, temperature, added=0.7):
    first, second = (log10(log10(1e6 * nu + added)) for nu in (first_viscosity, second_viscosity))
    slope = (first - second) / log10(second_temperature / first_temperature)
    return 1e-6 * (10 ** 10 ** (first - slope * log10(temperature / first_temperature)) - added)
