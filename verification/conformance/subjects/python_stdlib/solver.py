# SPDX-License-Identifier: Apache-2.0
"""Contacts of smooth bodies, and mixed lubrication of rough ones: pure functions, SI units, no input or output.

Symbols: F load, E effective modulus E*, R reduced radius, K stiffness of the asperities, sd standard deviation of
summit heights, lam a film or separation divided by sd, delta the offset of the summit planes divided by sd.
"""

import math

import moments

TRIPP = "greenwood_tripp"


# Two bodies as one

def plane_strain_modulus(E, nu):
    return E / ((1 - nu) * (1 + nu))


def in_series(a, b):
    """1/(1/a + 1/b), of two moduli or of two radii."""
    small, large = sorted((a, b), key=abs)
    return small * (large / (small + large))


def effective_modulus(E1, nu1, E2, nu2):
    return in_series(plane_strain_modulus(E1, nu1), plane_strain_modulus(E2, nu2))


def has_point(R1, R2):
    """Do the faces touch at a point? A concave face has a radius below 0."""
    return 1 / R1 + 1 / R2 > 0


def radius_of_gap(R1, R2):
    return in_series(R1, R2)


def sum_of_curvatures(Rx, Ry):
    return 1 / Rx + 1 / Ry


def reduced_radius(R1x, R2x, R1y, R2y):
    Rx, Ry = radius_of_gap(R1x, R2x), radius_of_gap(R1y, R2y)
    return {"radius_x": Rx, "radius_y": Ry, "reduced_radius": 1 / sum_of_curvatures(Rx, Ry)}


# Hertz and the flooded film

def nominal_area(radius):
    return math.pi * radius * radius


def peak_over_mean_pressure():
    return 1.5


def contact_radius(F, E, R):
    return math.cbrt(0.75 * F * R / E)


def approach(F, E, R):
    return contact_radius(F, E, R) ** 2 / R


def hertz_point(F, E, R):
    radius = contact_radius(F, E, R)
    mean = F / nominal_area(radius)
    return {"radius": radius, "mean_pressure": mean,
            "peak_pressure": peak_over_mean_pressure() * mean, "approach": approach(F, E, R)}


# Hertz' ellipse, with the ratio of axes k >= 1 and the ratio of radii alpha >= 1, and Hertz' line

def integral_arguments(k):
    """The parameter q = 1 - 1/k^2 of the elliptic integrals, and 1 - q."""
    return (k - 1) * (k + 1) / (k * k), 1 / (k * k)


def complete_integrals(parameter, complement):
    """K, E and (K - E)/K by the arithmetic-geometric mean."""
    mean, root, power, total = 1.0, math.sqrt(complement), 0.5, 0.5 * parameter
    while mean - root > 1e-9 * mean:
        half = (mean - root) / 2
        mean, root = (mean + root) / 2, math.sqrt(mean * root)
        power *= 2
        total += power * half * half
    first = math.pi / (mean + root)
    return first, first * (1 - total), total


def radii_ratio(k):
    """alpha = (k^2 E - K)/(K - E)."""
    _, _, part = complete_integrals(*integral_arguments(k))
    return (k - 1) * (k + 1) / part - k * k if part > 0 else 1.0


def axes_ratio(alpha):
    def is_too_round(k):
        return radii_ratio(k) < alpha
    return sign_change(is_too_round, 1.0, beyond(is_too_round, 1.0))


def ellipse_shape(alpha):
    """k, and the elliptic integrals K and E at this k."""
    k = axes_ratio(alpha)
    return (k, *complete_integrals(*integral_arguments(k))[:2])


def radius_of_both(Rx, Ry):
    return Rx * Ry / (Rx + Ry)


def minor_axis(F, E, R, k, second):
    return math.cbrt(3 * second * F * R / (math.pi * k * E))


def approach_of_ellipse(F, E, Rx, Ry, k, first, second):
    R = radius_of_both(Rx, Ry)
    return minor_axis(F, E, R, k, second) ** 2 * first / (2 * R * second)


def hertz_ellipse(F, E, Rx, Ry):
    small, large = sorted((Rx, Ry))
    k, first, second = ellipse_shape(large / small)
    minor = minor_axis(F, E, radius_of_both(Rx, Ry), k, second)
    x, y = (minor, k * minor) if Rx == small else (k * minor, minor)
    mean = F / (math.pi * x * y)
    return {"semi_axis_x": x, "semi_axis_y": y, "ellipticity": y / x, "mean_pressure": mean,
            "peak_pressure": 1.5 * mean, "approach": approach_of_ellipse(F, E, Rx, Ry, k, first, second)}


def line_half_width(load, E, R):
    return math.sqrt(4 * load * R / (math.pi * E))


def line_peak_over_mean():
    return 4 / math.pi


def line_shear_over_peak():
    """The greatest shear stress divided by the peak pressure. It lies below the contact's middle, at z = 0.786 b."""
    z2 = (math.sqrt(5) - 1) / 2
    return math.sqrt(z2) - z2 / math.sqrt(1 + z2)


def hertz_line(load, E, R):
    """`load` is the load per length, in N/m."""
    b = line_half_width(load, E, R)
    mean = load / (2 * b)
    peak = line_peak_over_mean() * mean
    return {"half_width": b, "mean_pressure": mean, "peak_pressure": peak,
            "peak_shear": line_shear_over_peak() * peak}


def film_constant(ellipticity):
    return 2.69 * (1 - 0.61 * math.exp(-0.73 * ellipticity))


def film_numbers(speed, viscosity, alpha, F, E, R):
    """The dimensionless U, G and W of Hamrock and Dowson, with E' = 2E*."""
    return viscosity * speed / (2 * E * R), alpha * 2 * E, F / (2 * E * R * R)


def hamrock_dowson_central(speed, viscosity, alpha, F, E, R, ellipticity):
    U, G, W = film_numbers(speed, viscosity, alpha, F, E, R)
    return R * film_constant(ellipticity) * U**0.67 * G**0.53 * W**-0.067


# Rough contact

def load_order(asperity):
    return 2.5 if asperity == TRIPP else 1.5


def share_exponent(asperity):
    """The exponent q of A = (K F_p)^q. Load sharing turns n into n/A and keeps E/F: K ~ n^2 gives A^2 = K F_p, K ~ n gives A = K F_p."""
    return 0.5 if asperity == TRIPP else 1.0


def stiffness(asperity, density, summit_radius, sd, F, E, area):
    """K of A = (K F_p)^q."""
    common = density * summit_radius * sd * math.sqrt(sd / summit_radius) * E * area / F
    if asperity == TRIPP:
        return 16 * math.sqrt(2) * math.pi / 15 * (density * summit_radius * sd) * common
    return 4 / 3 * common


def moment_argument(lam, delta):
    return lam - delta


def real_area_ratio(asperity, roughness, d):
    """`roughness` is n beta sigma: summit density times radius times sd."""
    if asperity == TRIPP:
        return (math.pi * roughness) ** 2 * moments.gaussian_moment(2, d)
    return math.pi * roughness * moments.gaussian_moment(1, d)


def summit_count(asperity, roughness, density, area, d):
    if asperity == TRIPP:
        return 4 * math.pi * roughness * density * area * moments.gaussian_moment(1, d)
    return density * area * moments.gaussian_moment(0, d)


# Load sharing

def film_exponent():
    """The exponent e of h = h_0 (1 - A)^-e."""
    return 0.14


def safe_log(x):
    return math.log(x) if x > 0 else -math.inf


def log_share(asperity, K, delta, lam):
    """ln A. It is above 0 if lam is below the floor."""
    log_moment = moments.log_moment(load_order(asperity), moment_argument(lam, delta))
    return share_exponent(asperity) * (safe_log(K) + log_moment)


def sign_change(is_low, low, high):
    """The least double of [low, high] at which is_low is false: bisection to the last digit."""
    while low < (middle := low + (high - low) / 2) < high:
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return high


def beyond(is_low, start):
    """A number at which is_low is false, found by doubling `start`. The search ends at 1e300."""
    while is_low(start) and start < 1e300:
        start *= 2
    return start


def floor_of(asperity, K, delta):
    """The lam at which the asperities carry the whole load; 0 if they do not even at lam = 0."""
    def carries_all(lam):
        return log_share(asperity, K, delta, lam) >= 0
    return sign_change(carries_all, 0.0, beyond(carries_all, 1.0)) if carries_all(0.0) else 0.0


def load_sharing(asperity, flooded, K, delta, exponent=None):
    """The lam that solves ln lam - ln flooded + e ln(1 - A(lam)) = 0. `exponent` is e; None means film_exponent()."""
    def film_is_thin(lam):
        log_A = log_share(asperity, K, delta, lam)
        if log_A >= 0:
            return True
        return math.log(lam / flooded) + (exponent or film_exponent()) * safe_log(-math.expm1(log_A)) < 0
    low = max(flooded, floor_of(asperity, K, delta))
    if not film_is_thin(low):
        return low
    return sign_change(film_is_thin, low, beyond(film_is_thin, low))


def shares_of_flooded(asperity, flooded, K, delta, lam, exponent=None):
    """The load shares of asperities and fluid at the root lam of load_sharing. The fluid's share is (flooded/lam)^(1/e)."""
    log_fluid = math.log(flooded / lam) / (exponent or film_exponent())
    if log_fluid < -0.7:
        return -math.expm1(log_fluid), math.exp(log_fluid)
    return math.exp(log_share(asperity, K, delta, lam)), math.exp(log_fluid)


def log_share_slope(asperity, delta, lam):
    """-d ln A/d lam."""
    order, d = load_order(asperity), moment_argument(lam, delta)
    return (share_exponent(asperity) * order
            * math.exp(moments.log_moment(order - 1, d) - moments.log_moment(order, d)))


def log_share_below(asperity, delta, lam, fluid, step):
    """ln A at lam - step: its value at lam by the fluid's share, plus the integral of its slope (Gauss-Legendre). So 1 - A does not cancel."""
    middle, reach = lam - step / 2, math.sqrt(0.15) * step
    slopes = [log_share_slope(asperity, delta, middle + place) for place in (-reach, 0, reach)]
    return math.log1p(-fluid) + step * (5 * slopes[0] + 8 * slopes[1] + 5 * slopes[2]) / 18


def shares_of_starved(asperity, K, delta, flooded_lam, flooded_fluid, ratio, deficit):
    """The load shares of asperities and fluid at the starved film, which is ratio = 1 - deficit times the flooded one."""
    step = flooded_lam * deficit
    if flooded_fluid < 0.25 and abs(step) < 0.1:
        log_A = log_share_below(asperity, delta, flooded_lam, flooded_fluid, step)
    else:
        log_A = log_share(asperity, K, delta, flooded_lam * ratio)
    return (1.0, 0.0) if log_A >= 0 else (math.exp(log_A), -math.expm1(log_A))


# Names of states

def regime(asperity_share, fluid_share):
    if fluid_share < 0.01:
        return "boundary"
    return "elastohydrodynamic" if asperity_share < 0.01 else "mixed"


def inlet_state(ratio):
    if ratio == 0:
        return "collapsed"
    return "flooded" if ratio >= 0.95 else "starved"
