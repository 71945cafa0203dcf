# SPDX-License-Identifier: Apache-2.0
"""A newcomer's solver: Hertz, film, one moment. Reads JSON lines, answers JSON lines, skips the rest."""
import json
import math
import sys


def hertz(load, modulus, radius):
    a = (0.75 * load * radius / modulus) ** (1 / 3)
    mean = load / (math.pi * a * a)
    return {"radius": a, "mean_pressure": mean, "peak_pressure": 1.5 * mean, "approach": a * a / radius}


def film(speed, viscosity, alpha, load, modulus, rx, ry, k):
    r = rx * ry / (rx + ry)
    e = 2 * modulus
    u, g, w = viscosity * speed / (e * r), alpha * e, load / (e * r * r)
    return r * 2.69 * u**0.67 * g**0.53 * w**-0.067 * (1 - 0.61 * math.exp(-0.73 * k))


def moment_5_2(d):
    low, high, steps = max(0.0, -d - 9), 9 + max(0.0, -d), 4000
    width = (high - low) / steps
    x = [low + width * (i + 0.5) for i in range(steps)]
    return width * sum(t**2.5 * math.exp(-(t + d) ** 2 / 2) for t in x) / math.sqrt(2 * math.pi)


for line in sys.stdin:
    q = json.loads(line)
    name, answer = q.get("function"), {"skip": "not in this solver"}
    if name == "hertz_point":
        answer = hertz(q["load"], q["effective_modulus"], q["reduced_radius"])
    elif name == "hamrock_dowson_central":
        r = q["reduced_radius"]
        answer = {"value": film(q["speed"], q["viscosity"], q["pressure_viscosity"], q["load"],
                                q["effective_modulus"], r, r, q.get("ellipticity", 1))}
    elif name == "gaussian_moment" and q["order"] == 2.5:
        answer = {"value": moment_5_2(q["argument"])}
    print(json.dumps({"id": q["id"], **answer}), flush=True)
