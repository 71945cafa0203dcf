# SPDX-License-Identifier: Apache-2.0
"""Asks the reference solution of JKR in Adhesion, of the group of Lars Pastewka, with E* and the work of adhesion of both faces."""

from answering import load as file

jkr = file("Adhesion/ReferenceSolutions/JKR.py")


def jkr_radius(load, work_of_adhesion, effective_modulus, reduced_radius):
    return jkr.contact_radius(force=load, radius=reduced_radius, contact_modulus=effective_modulus, work_of_adhesion=work_of_adhesion)
