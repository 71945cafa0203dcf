# SPDX-License-Identifier: Apache-2.0
"""Computes films, pressures and friction of lubricated contacts, and checks code of yours that computes them. SI units.

    >>> import tribocheck
    >>> scene = tribocheck.Scene("scene.toml")
    >>> scene.solve([0.01, 0.1]).film                       # operating points; a Scene also has curve() and onset()
    array([7.06938833e-09, 2.58012092e-08])
    >>> print(tribocheck.film("reference/scenes/roller.toml", speed=0.5).central)    # solved
    3.008330e-08 ± 2.9e-13 m

This package has each function of `tribocheck functions` under its name, for numbers and arrays:

    >>> tribocheck.hertz_point(load=50, effective_modulus=1.079e11, reduced_radius=9.5e-3).radius
    0.00014890...

`help(tribocheck.hertz_point)` shows its units, ranges and source. tribocheck.check() compares a function of yours with certified
values. Begin with help(tribocheck.Scene).

The dict `tribocheck.functions` has all functions:

"""
from . import _library
from ._check import check
from ._functions import catalogue as _catalogue, functions, kinds
from ._scenes import Curve, Film, Measured as Measured, Onset as Onset, Points, Profile as Profile, Scene, film

__version__ = _library.version()
__doc__ += "".join(f"    {name:<32}{entry['meaning']}\n" for name, entry in _catalogue.items())
globals().update(functions | kinds)
__all__ = ["Curve", "Film", "Points", "Scene", "check", "film"]  # the names that help(tribocheck) describes
