# SPDX-License-Identifier: Apache-2.0
"""Mistakes in Hertz' elliptical contact and in his line contact."""

import math

from catalogue import replaces
import solver

ELLIPSE, LINE = "hertz_ellipse", "hertz_line"


# The shape of the ellipse

@replaces(solver, "integral_arguments", ELLIPSE, "ellipk(e) for ellipk(e**2), and ellipe likewise")
def ellipse_modulus_for_parameter(right, k):
    parameter, complement = right(k)
    e = math.sqrt(parameter)
    return e, complement / (1 + e)


@replaces(solver, "ellipse_shape", ELLIPSE, "the auxiliary angle of the tables with its cosine halved")
def ellipse_auxiliary_angle(right, alpha):
    cosine = (alpha - 1) / (alpha + 1) / 2
    return right((1 + cosine) / (1 - cosine))


@replaces(solver, "ellipse_shape", ELLIPSE, "k = 1.0339 alpha^0.636 and the fits of K and E to it")
def ellipse_fit_1_0339(right, alpha):
    return 1.0339 * alpha**0.636, 1.5277 + 0.6023 * math.log(alpha), 1.0003 + 0.5968 / alpha


@replaces(solver, "ellipse_shape", ELLIPSE, "k = alpha^(2/pi) and the simplified K and E")
def ellipse_fit_two_over_pi(right, alpha):
    q = math.pi / 2 - 1
    return alpha ** (2 / math.pi), math.pi / 2 + q * math.log(alpha), 1 + q / alpha


@replaces(solver, "axes_ratio", ELLIPSE, "k = 1.03 alpha^0.64, with the integrals of that ellipse")
def ellipse_fit_1_03(right, alpha):
    return 1.03 * alpha**0.64


@replaces(solver, "ellipse_shape", ELLIPSE, "a circle, whatever the radii are: the ball's formula with 2/(1/Rx + 1/Ry)")
def ellipse_as_circle(right, alpha):
    return right(1.0)


# Radii, moduli, results

@replaces(solver, "hertz_ellipse", ELLIPSE, "x and y exchanged")
def ellipse_exchanged(right, F, E, Rx, Ry):
    return right(F, E, Ry, Rx)


@replaces(solver, "hertz_ellipse", ELLIPSE, "2E* for E* in the ellipse")
def ellipse_modulus_doubled(right, F, E, Rx, Ry):
    return right(F, 2 * E, Rx, Ry)


@replaces(solver, "radius_of_both", ELLIPSE, "R_x for R, R_y in the shape alone")
def ellipse_radius_along_x(right, Rx, Ry):
    return Rx


@replaces(solver, "radius_of_both", ELLIPSE, "the mean of the curvatures for their sum in R")
def ellipse_mean_curvature(right, Rx, Ry):
    return 2 / (1 / Rx + 1 / Ry)


@replaces(solver, "hertz_ellipse", ELLIPSE, "the axes of the ellipse for its semi-axes")
def ellipse_diameters(right, *given):
    found = right(*given)
    return {**found, "semi_axis_x": 2 * found["semi_axis_x"], "semi_axis_y": 2 * found["semi_axis_y"]}


@replaces(solver, "hertz_ellipse", ELLIPSE, "the mean pressure for the peak pressure")
def ellipse_peak_is_mean(right, *given):
    found = right(*given)
    return {**found, "peak_pressure": found["mean_pressure"]}


@replaces(solver, "approach_of_ellipse", ELLIPSE, "the approach of the circle of the mean radius 2/(1/Rx + 1/Ry)")
def ellipse_approach_of_circle(right, F, E, Rx, Ry, k, first, second):
    return solver.approach(F, E, 2 / (1 / Rx + 1 / Ry))


# The line

@replaces(solver, "line_half_width", LINE, "8 for 4 in the half-width, sqrt(2) too large, and the pressures of it")
def line_eight_for_four(right, load, E, R):
    return math.sqrt(8 * load * R / (math.pi * E))


@replaces(solver, "hertz_line", LINE, "2E* for E* in the line")
def line_modulus_doubled(right, load, E, R):
    return right(load, 2 * E, R)


@replaces(solver, "hertz_line", LINE, "the load in N per millimetre, all else in SI")
def line_load_per_millimetre(right, load, E, R):
    return right(load / 1000, E, R)


@replaces(solver, "line_half_width", LINE, "sqrt(4 w R/E), without pi")
def line_without_pi(right, load, E, R):
    return math.sqrt(4 * load * R / E)


@replaces(solver, "hertz_line", LINE, "the whole width for the half-width")
def line_whole_width(right, *given):
    found = right(*given)
    return {**found, "half_width": 2 * found["half_width"]}


@replaces(solver, "line_peak_over_mean", LINE, "the point's 3/2 for 4/pi in the line's peak pressure")
def line_peak_of_point(right):
    return 1.5


@replaces(solver, "line_shear_over_peak", LINE, "the point's 0.31 for 0.300283 in the greatest shear stress")
def line_shear_of_point(right):
    return 0.31


@replaces(solver, "line_shear_over_peak", LINE, "0.25 for 0.300283 in the greatest shear stress")
def line_shear_quarter(right):
    return 0.25
