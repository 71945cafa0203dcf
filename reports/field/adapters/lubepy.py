# SPDX-License-Identifier: Apache-2.0
"""Asks lubepy by Leodanis Pozo Ramos in cSt and degrees Celsius, with viscosities at 40 and 100 degrees. Cases that it refuses are skipped."""

import os
import sys

sys.path.insert(0, os.environ["FIELD_SOURCE"])
from lubepy.exceptions import ConceptError, ValidationError
from lubepy.lube import viscosity as lubepy


def viscosity_index(kinematic_viscosity_40, kinematic_viscosity_100):
    try:
        return lubepy.viscosity_index(1e6 * kinematic_viscosity_40, 1e6 * kinematic_viscosity_100)
    except (ConceptError, ValidationError):
        return None


def astm_d341_viscosity(first_temperature, first_viscosity, second_temperature, second_viscosity, temperature):
    if (first_temperature, second_temperature) != (313.15, 373.15):
        return None
    try:
        return 1e-6 * lubepy.viscosity_at_any_temp(1e6 * first_viscosity, 1e6 * second_viscosity, temperature - 273.15)
    except (ConceptError, ValidationError):
        return None
