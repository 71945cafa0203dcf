# SPDX-License-Identifier: Apache-2.0
"""Films, contacts and friction of lubricated contacts, and a judge of your own code for them. SI units.

    >>> import tribocheck
    >>> scene = tribocheck.Scene("scene.toml")
    >>> scene.solve([0.01, 0.1]).film                       # operating points; curve() and onset() beside it
    array([7.06938833e-09, 2.58012092e-08])
    >>> print(tribocheck.film("reference/scenes/roller.toml", speed=0.5).central)    # solved
    3.008330e-08 ± 2.9e-13 m

Each function of `tribocheck functions` is here by its name, for numbers and arrays:

    >>> tribocheck.hertz_point(load=50, effective_modulus=1.079e11, reduced_radius=9.5e-3).radius
    0.00014890...

`help(tribocheck.hertz_point)` has its units, ranges and source; `tribocheck.functions` is the list of all.
tribocheck.check() holds a function of yours to certified values. Begin with help(tribocheck.Scene).
"""
from . import _library
from ._check import check
from ._functions import functions, kinds
from ._scenes import Curve, Film, Measured, Onset, Points, Profile, Scene, film

__version__ = _library.version()
globals().update(functions | kinds)
__all__ = ["Curve", "Film", "Measured", "Onset", "Points", "Profile", "Scene", "check", "film", "functions", *functions]
