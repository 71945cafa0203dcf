# SPDX-License-Identifier: Apache-2.0
"""Mistakes in F_n(d): published fits where they do not hold, quadratures cut off, slips in the formula."""

import math

from catalogue import replaces_moment
from quadrature import gauss_of_square, simpson
import moments

ALL = (0, 0.5, 1, 1.5, 2, 2.5)


# Fits

@replaces_moment(moments, (2.5,), "fit 4.4086e-5 (4-d)^6.804 for F_5/2")
def moment_fit_power_5_2(right, order, d):
    return 4.4086e-5 * max(4 - d, 0.0) ** 6.804


@replaces_moment(moments, (2.5,), "fit 4.4068e-5 (4-d)^6.804 for F_5/2, its constant copied wrongly")
def moment_fit_power_5_2_miscopied(right, order, d):
    return 4.4068e-5 * max(4 - d, 0.0) ** 6.804


@replaces_moment(moments, (2,), "fit 3.5e-5 (4-d)^6.9 for F_2")
def moment_fit_power_2(right, order, d):
    return 3.5e-5 * max(4 - d, 0.0) ** 6.9


@replaces_moment(moments, (2.5,), "fit 0.6189 exp(-1.973 d) for F_5/2")
def moment_fit_exponential_5_2(right, order, d):
    return 0.6189 * math.exp(-1.973 * d)


@replaces_moment(moments, (2,), "fit 0.5025 exp(-1.844 d) for F_2")
def moment_fit_exponential_2(right, order, d):
    return 0.5025 * math.exp(-1.844 * d)


@replaces_moment(moments, (2.5,), "F_5/2(0) (1 - erf d) for F_5/2")
def moment_fit_error_function(right, order, d):
    return right(2.5, 0.0) * math.erfc(d)


# Quadratures

@replaces_moment(moments, (1.5,), "F_3/2 by Simpson's rule on 201 points from d to d + 20")
def moment_simpson_201_points(right, order, d):
    return simpson(lambda x: x**1.5 * moments.density(x + d), 0, 20, 200)


@replaces_moment(moments, (2.5,), "F_5/2 by Simpson's rule on 200 intervals from d to d + 4.5, too short")
def moment_simpson_200_intervals(right, order, d):
    return simpson(lambda x: x**2.5 * moments.density(x + d), 0, 4.5, 200)


@replaces_moment(moments, ALL, "all F_n taken as 0 beyond d = 10")
def moment_zero_beyond_10(right, order, d):
    return right(order, d) if d <= 10 else 0.0


@replaces_moment(moments, ALL, "all F_n integrated to s = 4 only")
def moment_cut_at_4(right, order, d):
    return gauss_of_square(lambda x: x**order * moments.density(x + d), 4 - d) if d < 4 else 0.0


@replaces_moment(moments, ALL, "all F_n integrated to s = d + 5 only")
def moment_cut_at_5_beyond(right, order, d):
    return gauss_of_square(lambda x: x**order * moments.density(x + d), 5)


@replaces_moment(moments, (2.5,), "F_5/2 by a Bessel form with a stray 1/sqrt(d), d > 0")
def moment_bessel_stray_root(right, order, d):
    return right(order, d) / math.sqrt(d) if d > 0 else right(order, d)


# Slips

@replaces_moment(moments, ALL, "1/sqrt(2 pi) of the normal density is missing")
def moment_without_root_two_pi(right, order, d):
    return right(order, d) * math.sqrt(2 * math.pi)


@replaces_moment(moments, ALL, "F_(n+1/2) for F_n")
def moment_order_half_up(right, order, d):
    return right(order + 0.5, d)


@replaces_moment(moments, ALL, "F_(n+1) for F_n")
def moment_order_one_up(right, order, d):
    return right(order + 1, d)


@replaces_moment(moments, ALL, "F_n(-d) for F_n(d)")
def moment_sign_of_argument(right, order, d):
    return right(order, -d)


@replaces_moment(moments, ALL, "s^n for (s-d)^n; for half-integer n over s > 0 only")
def moment_about_zero(right, order, d):
    if order == int(order):
        tail, density = right(0, d), moments.density(d)
        return (tail, density, tail + d * density)[int(order)]
    start = max(d, 0.0)
    reach = 90 / (start + math.sqrt(start * start + 90))  # the density at the end is e^-45 of that at the start
    return gauss_of_square(lambda x: (start + x) ** order * moments.density(start + x), reach)
