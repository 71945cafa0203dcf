# SPDX-License-Identifier: Apache-2.0
"""Moments by SciPy, with Greenwood and Williamson's F_3/2 where Greenwood and Tripp have F_5/2."""

from math import exp, pi, sqrt

from scipy.integrate import quad


def gaussian_moment(order, argument):
    n, peak = 1.5 if order == 2.5 else order, max(-argument, 0.1)
    tail = lambda x: x**n * exp(-((argument + x) ** 2) / 2) / sqrt(2 * pi)
    return quad(tail, 0, peak + 10, points=[peak, peak + 1], epsabs=0, limit=200)[0]
