# SPDX-License-Identifier: Apache-2.0
"""Starved inlets: the ratio y = h*/h_ff of the starved to the flooded film, from r = h_ff/h_oil > 0, by four closures.

Three of them join Wolveridge's y = (2/pi) arctan(2.7 psi) with Crook's gap. They use t = ln psi, so that nothing under- or overflows.
flooded_inlet gives t in closed form. For the other two, 1/r rises monotonically with t, and t is found by bisection.
"""

import math

CLOSURES = ("flooded_inlet", "starved_inlet", "printed_exponents", "damiens")


def crook_constant():
    """The constant c of Crook's term psi^(3/2)/c. It follows from the gap of a line contact near its edge."""
    return 3 / (4 * math.sqrt(2))


def log_film_ratio(t):
    """ln y at t = ln psi."""
    if t < -30:  # arctan v is v to every digit
        return math.log(5.4 / math.pi) + t
    return math.log(2 / math.pi * math.atan(2.7 * math.exp(min(t, 700))))


def film_parts(t):
    """y and 1 - y at t = ln psi."""
    return math.exp(log_film_ratio(t)), 2 / math.pi * math.atan(math.exp(-max(t, -700)) / 2.7)


def log_sum(a, b):
    """ln(e^a + e^b)."""
    return max(a, b) + math.log1p(math.exp(-abs(a - b)))


def log_inverse_r(closure, t):
    """ln(1/r) at t = ln psi."""
    log_y = log_film_ratio(t)
    crook = 1.5 * t - math.log(crook_constant())
    return log_sum(log_y, crook - 1.25 * log_y if closure == "printed_exponents" else crook)


def implicit(closure, r):
    """y and 1 - y of starved_inlet and printed_exponents, whose equations have y on both sides."""
    low, high = -4 * max(0.0, math.log(r)) - 20, max(0.0, -math.log(r)) + 5
    while low < (t := (low + high) / 2) < high:
        low, high = (t, high) if log_inverse_r(closure, t) + math.log(r) < 0 else (low, t)
    return film_parts(t)


def flooded_inlet(r):
    """y and 1 - y, with the inlet length from the gap at the flooded film. The film has collapsed if r >= 1."""
    return (0.0, 1.0) if r >= 1 else film_parts(2 / 3 * math.log((1 - r) / r * crook_constant()))


def damiens(r, exponent):
    """y = (1 + r^exponent)^(-1/exponent) and 1 - y."""
    if r <= 1:
        log_y = -math.log1p(r**exponent) / exponent
    else:
        log_y = -math.log1p((1 / r) ** exponent) / exponent - math.log(r)
    return math.exp(log_y), -math.expm1(log_y)


def starved(closure, r, exponent):
    """y and 1 - y. Both are returned, because subtracting y from 1 would leave no digits if the inlet is nearly flooded."""
    if closure == "damiens":
        return damiens(r, exponent)
    return flooded_inlet(r) if closure == "flooded_inlet" else implicit(closure, r)


def starvation_ratio(closure, r, exponent):
    return starved(closure, r, exponent)[0]
