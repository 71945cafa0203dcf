# SPDX-License-Identifier: Apache-2.0
"""Asks tribology by Moritz Ploss, a package for Python, with E' = 2 E*."""

from math import inf
import os
import sys
import types

package = types.ModuleType("tribology")  # its own __init__ would also load matplotlib and readers of measurements
package.__path__ = [os.path.join(os.environ["FIELD_SOURCE"], "tribology")]
sys.modules["tribology"] = package
from tribology.dowson_hamrock import dowhampoint
from tribology.hertz import ahertz, dhertz, eeff, phertz, reff
from tribology.lubrication import barus, walther

effective_modulus = lambda first_modulus, first_poisson_ratio, second_modulus, second_poisson_ratio: eeff(
    first_modulus, first_poisson_ratio, second_modulus, second_poisson_ratio)
barus_viscosity = lambda viscosity, pressure_viscosity, pressure: barus(viscosity, pressure_viscosity, pressure)
astm_d341_viscosity = lambda first_temperature, first_viscosity, second_temperature, second_viscosity, temperature: 1e-6 * walther(
    first_temperature - 273.15, 1e6 * first_viscosity, second_temperature - 273.15, 1e6 * second_viscosity, temperature - 273.15)
hamrock_dowson_central = lambda speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius, ellipticity=1: dowhampoint(
    speed, load, pressure_viscosity, effective_modulus, reduced_radius, viscosity) if ellipticity == 1 else None
hertz_point = lambda load, effective_modulus, reduced_radius: {
    name.replace("semi_axis_x", "radius"): value for name, value in hertz_ellipse(load, effective_modulus, reduced_radius, reduced_radius).items()}

def hertz_ellipse(load, effective_modulus, radius_x, radius_y):
    given = reff(radius_x, radius_y, inf, inf) + (effective_modulus, load)
    x, y, _ = ahertz(*given)
    return {"semi_axis_x": x, "semi_axis_y": y, "mean_pressure": phertz(*given), "peak_pressure": phertz(*given, ret="max"),
            "approach": dhertz(effective_modulus, radius_x, radius_y, inf, inf, load)}
