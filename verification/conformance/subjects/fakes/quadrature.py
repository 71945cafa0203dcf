# SPDX-License-Identifier: Apache-2.0
"""Two quadratures on finite ranges: Simpson's rule as it is often written, and a Gauss rule without visible error."""

import functools
import math


def simpson(function, low, high, intervals):
    step = (high - low) / intervals
    inner = [function(low + j * step) for j in range(1, intervals)]
    return step / 3 * (function(low) + 4 * sum(inner[::2]) + 2 * sum(inner[1::2]) + function(high))


def legendre(degree, x):
    """The polynomial and its derivative at x."""
    before, value = 1.0, x
    for k in range(2, degree + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, degree * (x * value - before) / (x * x - 1)


@functools.cache
def gauss_nodes(count=160):
    nodes = []
    for j in range(count):
        x = math.cos(math.pi * (j + 0.75) / (count + 0.5))
        for _ in range(20):
            value, slope = legendre(count, x)
            x -= value / slope
        nodes.append((x, 2 / ((1 - x * x) * legendre(count, x)[1] ** 2)))
    return nodes


def gauss_of_square(function, length):
    """The integral of function(x) over (0, length), with x = t^2: powers of x are smooth in t."""
    half = math.sqrt(length) / 2
    total = 0.0
    for node, weight in gauss_nodes():
        t = half * (1 + node)
        total += weight * 2 * t * function(t * t)
    return half * total
