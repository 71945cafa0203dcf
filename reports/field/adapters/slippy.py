# SPDX-License-Identifier: Apache-2.0
"""Asks slippy, a package for Python, with E* as two bodies with nu = 0.3, one of them flat, and the load per length of a line."""
from math import inf, log, pi
from answering import load as file
import numpy as np
np.seterr(all="ignore")  # else numpy warns at each case on the surface
hertz, liquid = file("slippy/contact/hertz.py"), file("slippy/contact/lubricant_models.py")

def contact(radii, modulus, load, nu=0.3, **line):
    found = hertz.hertz_full(radii, inf, 2 * (1 - nu**2) * modulus, nu, load, **line)
    return found, {"mean_pressure": found["mean_pressure"], "peak_pressure": found["max_pressure"], "approach": found.get("total_deflection")}
def hertz_point(load, effective_modulus, reduced_radius):
    found, answer = contact(reduced_radius, effective_modulus, load)
    return {"radius": found["contact_radii"][0], **answer}
def hertz_ellipse(load, effective_modulus, radius_x, radius_y):
    found, answer = contact([radius_x, radius_y], effective_modulus, load)
    x, y = sorted(found["contact_radii"], reverse=radius_x > radius_y)  # it does not say which is along x
    return {"semi_axis_x": x, "semi_axis_y": y, **answer}
def hertz_line(load_per_length, effective_modulus, reduced_radius):
    E = 2 * (1 - 0.3**2) * effective_modulus
    line = hertz.solve_hertz_line(r_rel=reduced_radius, e1=E, e2=E, v1=0.3, v2=0.3, load=load_per_length)
    return {**contact([reduced_radius, inf], effective_modulus, load_per_length, line=True)[1], "half_width": line.contact_width,
            "peak_pressure": line.max_pressure, "peak_shear": line.max_shear_stress}
def subsurface_shear(peak_pressure, radius, depth, poisson_ratio):
    stress = contact(radius, pi / 2 * peak_pressure, 2 / 3 * pi * radius**2 * peak_pressure, poisson_ratio)[0]["stress_z_axis_b_f"][0](depth)
    return abs(stress["sigma_z"] - stress["sigma_theta"]) / 2
barus_viscosity = lambda viscosity, pressure_viscosity, pressure: liquid.barus(viscosity, pressure_viscosity)(pressure)
roelands_viscosity = lambda viscosity, pressure_viscosity, pressure: liquid.roelands(
    viscosity, 0.196e9, pressure_viscosity * 0.196e9 / (log(viscosity) + 9.67))(pressure)
dowson_higginson_density = lambda pressure: liquid.dowson_higginson(1.0)(pressure)
