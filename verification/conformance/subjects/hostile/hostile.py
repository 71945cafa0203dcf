#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A subject that breaks the protocol in one way, after some right answers.

  hostile.py BEHAVIOUR [--after N]   N right answers first (default 2; at_start ones: none)
  hostile.py --list                  name and description, separated by a tab

No process of it lives longer than LIMIT seconds, even if nobody ends it.
"""

import argparse
import pathlib
import signal
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python_stdlib"))

from behaviours import AT_START, PER_LINE
import subject

LIMIT = 120  # seconds


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("behaviour", nargs="?", choices=["none", *AT_START, *PER_LINE],
                        metavar="BEHAVIOUR")
    parser.add_argument("--after", type=int, default=2, metavar="N")
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    if not given.list and given.behaviour is None:
        parser.error("BEHAVIOUR or --list is needed")
    return given


def main():
    given = arguments()
    if given.list:
        for name, function in {**AT_START, **PER_LINE}.items():
            print(name, function.__doc__, sep="\t")
        return
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # it ends silently if its reader goes away
    signal.alarm(LIMIT)
    if given.behaviour in AT_START:
        AT_START[given.behaviour]()
    misbehave = PER_LINE.get(given.behaviour)
    for count, text in enumerate(sys.stdin):
        right = subject.answer_text(text)
        if misbehave and count >= given.after:
            misbehave(right, count - given.after)
        else:
            print(right, flush=True)


if __name__ == "__main__":
    main()
