# SPDX-License-Identifier: Apache-2.0
"""Asks the reference solutions of ContactMechanics, of the group of Lars Pastewka, with E* and the ball's radius."""

from math import pi

from answering import load as file
import numpy as np

np.seterr(all="ignore")  # else numpy warns at each case on the surface
hertz = file("ContactMechanics/ReferenceSolutions/Hertz.py")
greenwood_tripp = file("ContactMechanics/ReferenceSolutions/GreenwoodTripp.py")


def hertz_point(load, effective_modulus, reduced_radius):
    given = load, reduced_radius, effective_modulus
    a, peak = hertz.radius_and_pressure(*given)
    return {"radius": a, "mean_pressure": load / (pi * a**2), "peak_pressure": peak, "approach": hertz.penetration(*given)}


def subsurface_shear(peak_pressure, radius, depth, poisson_ratio):
    radial, axial = hertz.centerline_stress(np.float64(depth / radius), poisson_ratio)
    return peak_pressure * abs(radial - axial) / 2


def gaussian_moment(order, argument):
    return greenwood_tripp.Fn(argument, order)
