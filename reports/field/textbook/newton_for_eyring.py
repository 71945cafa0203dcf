# SPDX-License-Identifier: Apache-2.0
"""Points with the shear of a Newtonian film in place of Eyring's: the example in plain Python with one formula replaced."""

from math import exp
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../../verification/conformance/subjects/python_stdlib"))
import friction
import subject

limited = friction.reduced_stress
friction.reduced_stress = lambda law, log_x: limited(law, log_x) if law == "limiting" else exp(min(log_x, 700))


def operating_point(**scene):
    return subject.answer(scene)
