# SPDX-License-Identifier: Apache-2.0
"""Asks plug-ins and programs of verification/conformance/subjects, and makes the lines for them."""
import json
import os
import subprocess

from program import ENVIRONMENT, TIMEOUT, Result, run, scene

SUBJECTS = os.environ["TRIBOCHECK_SUBJECTS"]


def plugin(name):
    return os.path.join(SUBJECTS, name + ".so")


def call(function, identity="f", **arguments):
    return {"id": identity, "function": function, **arguments}


def moment(argument, order=2.5, identity="f"):
    return call("gaussian_moment", identity, order=order, argument=argument)


def hertz(load=50, identity="h"):
    return call("hertz_point", identity, load=load, effective_modulus=107.9e9, reduced_radius=9.5e-3)


def film(speed=1, **changes):
    return call("hamrock_dowson_central", **{
        "speed": speed, "viscosity": 0.0202, "pressure_viscosity": 2e-8, "load": 50,
        "effective_modulus": 107.9e9, "reduced_radius": 9.5e-3, **changes})


def starved(closure, ratio, **changes):
    return call("starvation_ratio", closure=closure, flooded_over_inlet=ratio, **changes)


def shared(asperity, flooded=1, stiffness=0.3, offset=1.146):
    return call("load_sharing", asperity=asperity, flooded_film_parameter=flooded, stiffness=stiffness,
                offset=offset)


def point(surface="rough", speed=0.1, **changes):
    return scene(surface, speed=speed, **changes)


def lines(asked):
    """A line for each: a text as it is, anything else as JSON."""
    return "".join((one if isinstance(one, str) else json.dumps(one)) + "\n" for one in asked)


def ask_plugin(name, *asked):
    return run("plugin-host", plugin(name), stdin=lines(asked))


def ask_program(name, *asked):
    done = subprocess.run([os.path.join(SUBJECTS, name)], input=lines(asked).encode(),
                          capture_output=True, timeout=TIMEOUT, env=ENVIRONMENT)
    return Result(done.returncode, done.stdout.decode(), done.stderr.decode())
