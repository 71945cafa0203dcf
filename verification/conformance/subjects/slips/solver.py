#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""solver.py --slip NAME: the right solver of ../python_stdlib with the slips that the function NAME puts in, as a subject of `tribocheck verify`."""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python_stdlib"))
import first_maker  # noqa: E402
import later_slips  # noqa: E402
import second_maker  # noqa: E402
import subject  # noqa: E402

SLIPS = {slip.__name__: slip for slip in first_maker.SLIPS + second_maker.SLIPS + later_slips.SLIPS}

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--slip", required=True, choices=SLIPS, metavar="NAME")
    SLIPS[parser.parse_args().slip]()
    subject.main()
