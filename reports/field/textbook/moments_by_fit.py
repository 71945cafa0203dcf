# SPDX-License-Identifier: Apache-2.0
"""F_5/2 of Greenwood and Tripp by the fit 4.4086e-5 (4 - d)^6.804 that solvers of mixed lubrication use."""


def gaussian_moment(order, argument):
    if order == 2.5:
        return 4.4086e-5 * max(4 - argument, 0) ** 6.804
