# SPDX-License-Identifier: Apache-2.0
"""Asks GaPFlow by Hannes Holey and others for its viscosities, with e^-9.67 Pa s and 0.196 GPa in Roelands' law."""

from math import exp, log

from answering import load as file

model = file("GaPFlow/models/viscosity.py")


def barus_viscosity(viscosity, pressure_viscosity, pressure):
    return model.barus_piezo(pressure, viscosity, aB=pressure_viscosity)


def roelands_viscosity(viscosity, pressure_viscosity, pressure):
    z = pressure_viscosity * 1.96e8 / (log(viscosity) + 9.67)
    return model.roelands_piezo(pressure, viscosity, mu_inf=exp(-9.67), p_ref=1.96e8, z=z)


def carreau_yasuda_viscosity(viscosity, high_shear_viscosity, relaxation_time, shear_rate, transition_exponent, power_law_index):
    return viscosity * model.carreau_shear(shear_rate, viscosity, mu_inf=high_shear_viscosity, lam=relaxation_time,
                                           a=transition_exponent, N=power_law_index)
