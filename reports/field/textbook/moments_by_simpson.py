# SPDX-License-Identifier: Apache-2.0
"""Moments of the Gaussian tail by Simpson's rule on 201 points from d to 4, and 0 beyond."""

from math import exp, pi, sqrt


def gaussian_moment(order, argument):
    step = (4 - argument) / 200
    if step <= 0:
        return 0.0
    heights = [(i * step) ** order * exp(-((argument + i * step) ** 2) / 2) / sqrt(2 * pi) for i in range(201)]
    return step / 3 * (heights[0] + 4 * sum(heights[1:-1:2]) + 2 * sum(heights[2:-1:2]) + heights[-1])
