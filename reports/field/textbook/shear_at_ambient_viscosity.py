# SPDX-License-Identifier: Apache-2.0
"""Points with the ambient viscosity in the shear of the film: the example in plain Python with one formula replaced."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../../verification/conformance/subjects/python_stdlib"))
import friction
import subject

friction.log_thickening = lambda law, viscosity, alpha, pressure: 0.0


def operating_point(**scene):
    return subject.answer(scene)
