# SPDX-License-Identifier: Apache-2.0
"""Films, contacts and friction of lubricated contacts, and a judge of your own code for them. SI units.

Each function of `tribocheck functions` is here by its name, for numbers and arrays:

    >>> import tribocheck
    >>> tribocheck.hertz_point(load=50, effective_modulus=1.079e11, reduced_radius=9.5e-3).radius
    0.00014888...

`help(tribocheck.hertz_point)` has its units, ranges and source; `tribocheck.functions` is the list of all.
tribocheck.check() holds a function of yours to certified values.
"""
from . import _library
from ._check import check
from ._functions import functions

__version__ = _library.version()
globals().update(functions)
__all__ = ["check", "functions", *functions]
