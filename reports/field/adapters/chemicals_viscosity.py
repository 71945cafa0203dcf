# SPDX-License-Identifier: Apache-2.0
"""Asks the package `chemicals` by Caleb Bell and contributors for the viscosity index without rounding, from viscosities in m^2/s."""

import os
import sys

sys.path.insert(0, os.environ["FIELD_SOURCE"])
from chemicals.viscosity import viscosity_index as index


def viscosity_index(kinematic_viscosity_40, kinematic_viscosity_100):
    return index(kinematic_viscosity_40, kinematic_viscosity_100)
