# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the rough contact and in load sharing."""

import math

from catalogue import replaces
import point
import solver

SHARING, POINT = "load_sharing", "operating_point"


# Rough contact

@replaces(solver, "stiffness", POINT, "8 sqrt(2)/15 for 16 sqrt(2)/15 in Greenwood and Tripp's load")
def asperity_stiffness_halved(right, model, *given):
    return right(model, *given) / (2 if model == solver.TRIPP else 1)


@replaces(solver, "stiffness", POINT, "Greenwood and Williamson's prefactor in Greenwood and Tripp's load")
def asperity_stiffness_of_williamson(right, model, *given):
    return right("greenwood_williamson", *given)


@replaces(solver, "stiffness", POINT, "summit heights in micrometres in the asperities' load, all else in SI")
def asperity_sd_in_micrometres(right, model, density, summit_radius, sd, F, E, area):
    return right(model, density, summit_radius, 1e6 * sd, F, E, area)


@replaces(solver, "stiffness", POINT, "summit radius in micrometres in the asperities' load, all else in SI")
def asperity_radius_in_micrometres(right, model, density, summit_radius, sd, F, E, area):
    return right(model, density, 1e6 * summit_radius, sd, F, E, area)


@replaces(point, "height_sd", POINT, "summit heights of one face for the sum of both: sigma/sqrt(2)")
def asperity_sd_of_one_face(right, scene):
    return right(scene) / math.sqrt(2)


@replaces(point, "plane_offset", POINT, "the offset of two summit planes, whatever offset_planes says")
def asperity_offset_two_planes(right, scene):
    return 2 * scene["surface.summit_plane_offset"]


@replaces(solver, "moment_argument", SHARING, "no offset of the summit planes: F_n(lam)")
def asperity_offset_none(right, lam, delta):
    return lam


@replaces(solver, "moment_argument", SHARING, "offset of the summit planes with the other sign: F_n(lam + delta)")
def asperity_offset_other_sign(right, lam, delta):
    return lam + delta


# Load sharing

@replaces(solver, "load_order", SHARING, "F_3/2 for F_5/2 in Greenwood and Tripp's load")
def sharing_order_of_williamson(right, model):
    return 1.5


@replaces(solver, "share_exponent", SHARING, "A = K F for A = (K F)^(1/2) in Greenwood and Tripp's load")
def sharing_share_exponent_one(right, model):
    return 1.0


@replaces(solver, "load_sharing", SHARING, "no load sharing: the film is that of smooth faces")
def sharing_none(right, model, flooded, K, delta, exponent=None):
    return flooded


@replaces(solver, "film_exponent", SHARING, "exponent 0.67 for 0.14 in h = h0 (1-A)^-0.14")
def sharing_film_exponent_067(right):
    return 0.67


# Ellipses and lines

def mean_pressure(scene, radius):
    return solver.hertz_point(scene["load"], scene["bodies.effective_modulus"], radius)["mean_pressure"]


@replaces(point, "smooth_contact", POINT, "the circle of R_x for the ellipse")
def point_ellipse_as_circle(right, scene):
    radius, ellipticity, mean = right(scene)
    return radius, ellipticity, mean if scene["bodies.radius_y"] is None else mean_pressure(scene, radius)


@replaces(point, "smooth_contact", POINT, "k = 1 in the film formula of an ellipse")
def point_film_of_circle(right, scene):
    radius, ellipticity, mean = right(scene)
    return radius, ellipticity if scene["bodies.radius_y"] is None else 1.0, mean


@replaces(point, "smooth_contact", POINT, "R_x and R_y exchanged")
def point_ellipse_exchanged(right, scene):
    across = scene["bodies.radius_y"]
    if across is not None:
        scene = {**scene, "bodies.radius_x": across, "bodies.radius_y": scene["bodies.radius_x"]}
    return right(scene)


@replaces(point, "smooth_contact", POINT, "the half-width of a line sqrt(2) too large")
def point_line_too_wide(right, scene):
    radius, ellipticity, mean = right(scene)
    return radius, ellipticity, mean if scene["bodies.length"] is None else mean / 2 ** 0.5
