# SPDX-License-Identifier: Apache-2.0
"""Moments of the Gaussian tail by 100 trapezoids from d to 6, or to d + 6 where d is above 0."""

from math import exp, pi, sqrt


def gaussian_moment(order, argument):
    step = (6 + max(-argument, 0)) / 100
    heights = [x**order * exp(-((argument + x) ** 2) / 2) / sqrt(2 * pi) for x in (i * step for i in range(101))]
    return step * (sum(heights) - (heights[0] + heights[-1]) / 2)
