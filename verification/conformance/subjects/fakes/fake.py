#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A subject with one planted mistake: the solver of python_stdlib with one formula replaced.

  fake.py --mistake NAME    answers JSON lines; NAME none: no mistake; A+B: both at once
  fake.py --list            name, description and first wrong capability, separated by tabs
"""

import argparse

from catalogue import MISTAKES
import subject
import wrong_bodies
import wrong_contact
import wrong_ellipse
import wrong_film
import wrong_inlet
import wrong_laws
import wrong_moments

# importing them fills the list
PARTS = (wrong_moments, wrong_bodies, wrong_film, wrong_ellipse, wrong_contact, wrong_inlet, wrong_laws)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--mistake", metavar="NAME")
    action.add_argument("--list", action="store_true")
    parser.add_argument("--only", metavar="FUNCTION", help="skip all other questions; operating_point is one too")
    arguments = parser.parse_args()
    if arguments.list:
        for mistake in MISTAKES.values():
            print(mistake.name, mistake.description, mistake.capability, sep="\t")
        return
    for name in arguments.mistake.split("+"):
        if name not in MISTAKES and name != "none":
            parser.error(f"--mistake: no {name}; --list has them")
        if name != "none":
            MISTAKES[name].make()
    if arguments.only:
        whole = subject.answer
        subject.answer = lambda line: (whole(line) if line.get("function", "operating_point") == arguments.only
                                       else {"skip": "not asked"})
    subject.main()


if __name__ == "__main__":
    main()
