# SPDX-License-Identifier: Apache-2.0
"""Asks chemicals by Caleb Bell and contributors in m^2/s, without rounding."""

import os
import sys

sys.path.insert(0, os.environ["FIELD_SOURCE"])
from chemicals.viscosity import viscosity_index as index


def viscosity_index(kinematic_viscosity_40, kinematic_viscosity_100):
    return index(kinematic_viscosity_40, kinematic_viscosity_100)
