"""A solver for `tribocheck verify`. It speaks the protocol already, and skips everything.

Fill in a function below, return its result in place of None, and run
    tribocheck verify --subject "python3 solver.py"
All numbers are SI: m, N, Pa, Pa s, m/s. E* is given by 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2 (never twice
that); speed is the mean of the two surfaces'; for a ball on a flat the reduced radius is the ball's.
"""

import json
import sys


def gaussian_moment(order, argument):
    """F_n(d): integral of (s-d)^n phi(s) over s > d, phi the standard normal density; dimensionless."""
    return None  # a number; order n = 0, 0.5, ... 2.5


def hertz_point(load, effective_modulus, reduced_radius):
    """Smooth elastic contact; N, Pa, m."""
    return None  # {"radius": m, "mean_pressure": Pa, "peak_pressure": Pa, "approach": m}, or some of them


def hamrock_dowson_central(speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius,
                           ellipticity=1.0):
    """Central film thickness, fully flooded; m/s, Pa s, 1/Pa, N, Pa, m, -."""
    return None  # m


def starvation_ratio(closure, flooded_over_inlet, damiens_exponent=3.0):
    """h*/h_ff at h_ff/h_oil; closure: flooded_inlet, starved_inlet, printed_exponents or damiens."""
    return None  # a number from 0 to 1


def load_sharing(asperity, flooded_film_parameter, stiffness, offset):
    """lambda from lambda_0, K and delta; asperity: greenwood_tripp or greenwood_williamson."""
    return None  # a number


def operating_point(scene):
    """All of it at one speed. scene: load, speed, and objects surface, bodies, lubricant, supply,
    friction, closures, with the fields and units of section 1 of model/README.md."""
    return None  # {"film": m, "friction": -, ...}, those that you have of film_flooded, film, separation,
    # film_parameter, asperity_load_share, fluid_load_share, real_area_ratio, summit_count, friction,
    # regime, inlet; where one is undefined: None


FUNCTIONS = {function.__name__: function for function in (
    gaussian_moment, hertz_point, hamrock_dowson_central, starvation_ratio, load_sharing)}


def answer(question):
    identity = question.pop("id")
    name = question.pop("function", None)  # without one it is an operating point
    if name is not None and name not in FUNCTIONS:
        return {"id": identity, "skip": f"no function {name}"}
    result = FUNCTIONS[name](**question) if name else operating_point(question)
    if result is None:
        return {"id": identity, "skip": f"no {name or 'operating point'} yet"}
    return {"id": identity, **(result if isinstance(result, dict) else {"value": result})}


for line in sys.stdin:
    print(json.dumps(answer(json.loads(line))), flush=True)
