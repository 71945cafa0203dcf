# SPDX-License-Identifier: Apache-2.0
"""The list of mistakes, and how one of them is made: a single function of the right solver is replaced.

A mistake is a function of its own. Its first argument is the function that it replaces, the others are that
function's; its name is the mistake's.
"""

import functools
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python_stdlib"))

MISTAKES = {}


class Mistake:
    def __init__(self, name, description, capability, make):
        self.name, self.description, self.capability, self.make = name, description, capability, make


def replaces(module, name, capability, description):
    """The function below stands for module.name. capability: the function of the protocol that is wrong
    first, operating_point if none is."""
    def register(wrong):
        def make():
            setattr(module, name, functools.partial(wrong, getattr(module, name)))
        MISTAKES[wrong.__name__] = Mistake(wrong.__name__, description, capability, make)
        return wrong
    return register


def replaces_moment(moments, orders, description):
    """The function below, of order and d, stands for F_n(d) of these orders."""
    def register(wrong):
        def make():
            right_log = moments.log_moment

            def right(order, d):
                return math.exp(right_log(order, d))

            def log_moment(order, d):
                if order not in orders:
                    return right_log(order, d)
                value = wrong(right, order, d)
                return math.log(value) if value > 0 else -math.inf
            moments.log_moment = log_moment
        MISTAKES[wrong.__name__] = Mistake(wrong.__name__, description, "gaussian_moment", make)
        return wrong
    return register
