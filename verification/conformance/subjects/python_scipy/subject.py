#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A solver as SciPy users write it, with moments by quad and roots by brentq. An operating point has only its films.

It reads one question per line from stdin, writes one answer per line to stdout, and skips questions that it does not offer.
"""

import json
import math
import sys

from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import erfc

TRIPP = "greenwood_tripp"
FILMS = ("film_flooded", "film", "separation", "film_parameter")


class Skip(Exception):
    """The question is not offered. The text says why."""


def gaussian_moment(order, argument):
    """F_n(d) = integral of x^n phi(x + d) over x > 0."""
    if order == 0:
        return erfc(argument / math.sqrt(2)) / 2
    def integrand(x):
        return x**order * math.exp(-(x + argument) ** 2 / 2) / math.sqrt(2 * math.pi)
    # Over an infinite range quad misses the peak. So the range is split at the peak, and ends where the integrand is negligible.
    peak = max(0.0, -argument)
    width = 40 / (2 + max(0.0, argument))
    below = quad(integrand, max(0.0, peak - 12), peak, epsabs=0, epsrel=1e-11)[0] if peak > 0 else 0.0
    return below + quad(integrand, peak, peak + width, epsabs=0, epsrel=1e-11, limit=200)[0]


def hertz_point(load, effective_modulus, reduced_radius):
    radius = (3 * load * reduced_radius / (4 * effective_modulus)) ** (1 / 3)
    mean = load / (math.pi * radius**2)
    return {"radius": radius, "mean_pressure": mean, "peak_pressure": 1.5 * mean,
            "approach": radius**2 / reduced_radius}


def hamrock_dowson_central(speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius,
                           ellipticity=1.0):
    E, R = 2 * effective_modulus, reduced_radius
    return (2.69 * R * (viscosity * speed / (E * R)) ** 0.67 * (pressure_viscosity * E) ** 0.53
            * (load / (E * R**2)) ** -0.067 * (1 - 0.61 * math.exp(-0.73 * ellipticity)))


def load_sharing(asperity, flooded_film_parameter, stiffness, offset):
    """The film parameter and the floor, both divided by the standard deviation of summit heights."""
    order, q = (2.5, 0.5) if asperity == TRIPP else (1.5, 1.0)
    if not 1e-30 <= stiffness <= 1e30:
        raise Skip("a stiffness as extreme as this")

    def share(lam):
        return (stiffness * gaussian_moment(order, lam - offset)) ** q
    floor = 0.0
    if share(0) >= 1:
        floor = brentq(lambda lam: share(lam) - 1, 0, offset + 15, xtol=1e-14)
    low = max(flooded_film_parameter, floor)

    def residual(log_lam):
        A = share(math.exp(log_lam))
        return log_lam - math.log(flooded_film_parameter) + 0.14 * math.log(max(1 - A, 1e-300))
    if residual(math.log(low)) >= 0:
        return low, floor
    high = math.log(max(2 * low, offset + 15))
    return math.exp(brentq(residual, math.log(low), high, xtol=1e-14)), floor


def starvation(closure, r, exponent):
    c = 3 / (4 * math.sqrt(2))
    if closure == "flooded_inlet":
        psi = ((1 / r - 1) * c) ** (2 / 3) if r < 1 else 0.0
        return 2 / math.pi * math.atan(2.7 * psi)
    if closure == "damiens":
        return (1 + r**exponent) ** (-1 / exponent)
    raise Skip(f"no closure {closure}")


def operating_point(line):
    load, speed = line["load"], line["speed"]
    surface, bodies, oil = line["surface"], line["bodies"], line["lubricant"]
    closures, supply = line.get("closures", {}), line.get("supply")
    if "reduced_radius" not in bodies or "film" in closures:
        raise Skip("circles with the usual film law alone")
    asperity = closures.get("asperity", TRIPP)
    sd, beta, density = (surface[f"summit_{name}"] for name in ("height_sd", "radius", "density"))
    E, R = bodies["effective_modulus"], bodies["reduced_radius"]
    area = math.pi * hertz_point(load, E, R)["radius"] ** 2
    if asperity == TRIPP:
        K = 16 * math.sqrt(2) * math.pi / 15 * (density * beta * sd) ** 2 * math.sqrt(sd / beta)
    else:
        K = 4 / 3 * density * math.sqrt(beta) * sd**1.5
    K *= E * area / load
    film = hamrock_dowson_central(speed, oil["viscosity"], oil["pressure_viscosity"], load, E, R,
                                  bodies.get("ellipticity", 1.0))
    offset = surface.get("offset_planes", 1) * surface.get("summit_plane_offset", 0)
    lam, floor = load_sharing(asperity, film / sd, K, offset)
    ratio = 1.0
    if supply:
        (kind, value), = supply.items()
        oil_film = {"inlet_film": 1, "inlet_film_ratio": sd, "inlet_flow": 1 / speed}[kind] * value
        ratio = starvation(closures.get("starvation", "flooded_inlet"), lam * sd / oil_film,
                           closures.get("damiens_exponent", 3.0))
    values = {"film_flooded": lam * sd, "film": ratio * lam * sd,
              "separation": max(ratio * lam, floor) * sd, "film_parameter": ratio * lam}
    asked = [name for name in line.get("outputs", FILMS) if name in FILMS]
    if not asked:
        raise Skip("films only")
    return {name: values[name] for name in asked}


FUNCTIONS = {"gaussian_moment": lambda **given: {"value": gaussian_moment(**given)},
             "hertz_point": hertz_point,
             "hamrock_dowson_central": lambda **given: {"value": hamrock_dowson_central(**given)},
             "load_sharing": lambda **given: {"value": load_sharing(**given)[0]}}


def answer(line):
    if "function" not in line:
        return operating_point(line)
    if line["function"] not in FUNCTIONS:
        raise Skip(f"no function {line['function']}")
    return FUNCTIONS[line["function"]](**{k: v for k, v in line.items() if k not in ("id", "function")})


for text in sys.stdin:
    question = json.loads(text)
    try:
        members = answer(question)
    except Skip as reason:
        members = {"skip": str(reason)}
    except OverflowError:
        members = {"skip": "beyond double precision"}
    except (KeyError, TypeError, ValueError) as problem:
        members = {"error": {"field": "", "message": f"{type(problem).__name__}: {problem}"}}
    print(json.dumps({"id": question["id"], **members}), flush=True)
