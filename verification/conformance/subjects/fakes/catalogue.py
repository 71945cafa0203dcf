# SPDX-License-Identifier: Apache-2.0
"""The list of mistakes. Each mistake replaces a single function of the right solver.

It is a function with the name of the mistake. Its first argument is the function that it replaces; the other
arguments are those of that function.
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
    """The decorated function replaces module.name. capability: the first function of the protocol that becomes
    wrong, or operating_point if no single function does."""
    def register(wrong):
        def make():
            setattr(module, name, functools.partial(wrong, getattr(module, name)))
        MISTAKES[wrong.__name__] = Mistake(wrong.__name__, description, capability, make)
        return wrong
    return register


def replaces_moment(moments, orders, description):
    """The decorated function, called with the right F_n, order and d, replaces F_n(d) for these orders."""
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
