# SPDX-License-Identifier: Apache-2.0
"""Laws of liquids simplified: the given viscosity in place of Barus' and of Carreau and Yasuda's law, ASTM D341 without 0.7."""

from liquids_as_printed import astm_d341_viscosity as with_added


def barus_viscosity(viscosity, pressure_viscosity, pressure):
    return viscosity


def carreau_yasuda_viscosity(viscosity, **given):
    return viscosity


def astm_d341_viscosity(**given):
    return with_added(**given, added=0)
