# SPDX-License-Identifier: Apache-2.0
"""Gaussian moments F_n(d): the integral of (s - d)^n phi(s) over s > d, phi the standard normal density.

With x = s - d the integrand is x^n phi(x + d). It is positive, so that no digits cancel in a quadrature.
Each of four ranges has the trapezoid rule, or a closed form:

  d >= 0           x = e^(t - e^-t)/max(1, d): the integrand falls doubly exponentially on both sides
  d < 0, n whole   F_0, F_1 from erfc, the others by F_(n+1) = n F_(n-1) - d F_n: sums of positive terms
  -9 < d < 0       x = t^2: for half-integer n the integrand is even and entire in t
  d <= -9          x itself: the end x = 0 is at least 9 standard deviations from the peak
"""

import math

ROOT_TWO_PI = math.sqrt(2 * math.pi)
FAR = 9.0


def density(s):
    return math.exp(-s * s / 2) / ROOT_TWO_PI


def exponential_nodes(step=0.1, low=-38, high=40):
    """(y, ln y, ln weight) of the nodes of an integral over y > 0, where y = e^(t - e^-t)."""
    nodes = []
    for j in range(low, high + 1):
        t = j * step
        log_y = t - math.exp(-t)
        nodes.append((math.exp(log_y), log_y, math.log(step * (1 + math.exp(-t))) + log_y))
    return nodes


EXPONENTIAL_NODES = exponential_nodes()
SQUARE_STEP = 0.1
SQUARE_NODES = [j * SQUARE_STEP for j in range(1, 44)]  # t; the integrand is 0 at t = 0
SHIFT_STEP = 0.25
SHIFT_NODES = [(j * SHIFT_STEP, SHIFT_STEP * density(j * SHIFT_STEP)) for j in range(-36, 37)]
weights_of_order = {}


def exponential_weights(order):
    """(y, weight * y^order) of the nodes. They are computed once for each order."""
    if order not in weights_of_order:
        weights_of_order[order] = [(y, math.exp(log_weight + order * log_y))
                                   for y, log_y, log_weight in EXPONENTIAL_NODES]
    return weights_of_order[order]


def log_right(order, d):
    """ln F_n(d) for d >= 0: ln of phi(d) times the integral of x^n e^(-x^2/2 - xd)."""
    scale = max(1.0, d)
    slope, curvature = d / scale, 0.5 / scale / scale
    exp = math.exp
    total = sum([w * exp(-y * (slope + curvature * y)) for y, w in exponential_weights(order)])
    return math.log(total) - (order + 1) * math.log(scale) - d * d / 2 - math.log(ROOT_TWO_PI)


def whole_order(order, d):
    """F_n(d) for d < 0 and n = 0, 1, 2, ..."""
    lower = 0.5 * math.erfc(d / math.sqrt(2))
    if order == 0:
        return lower
    value = density(d) - d * lower
    for n in range(1, int(order)):
        lower, value = value, n * lower - d * value
    return value


def square_substitution(order, d):
    exp = math.exp
    power = round(2 * order + 1)
    total = sum([t**power * exp(-(t * t + d) ** 2 / 2) for t in SQUARE_NODES])
    return 2 * SQUARE_STEP * total / ROOT_TWO_PI


def far_left(order, d):
    return sum([w * (s - d) ** order for s, w in SHIFT_NODES if s > d])


def log_moment(order, d):
    """ln F_n(d) for any order n >= 0. It is finite even where F_n underflows."""
    if d >= 0:
        return log_right(order, d)
    if order == int(order):
        return math.log(whole_order(order, d))
    return math.log(square_substitution(order, d) if d > -FAR else far_left(order, d))


def gaussian_moment(order, d):
    return math.exp(log_moment(order, d))
