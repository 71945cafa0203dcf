# SPDX-License-Identifier: Apache-2.0
"""python_fakes.py FOLDER NAME...: judges fakes or slips of verification/conformance/subjects by tribocheck.check(), each in a fork.

Prints a line of JSON for each: its name, its diagnoses, and whether all holds.
"""
import json
import os
import pathlib
import sys

import tribocheck

SUBJECTS = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]) / "verification/conformance/subjects"
POINTS = ["operating_point", "operating_point_of_other_film", "operating_point_of_ellipse", "operating_point_of_line"]


def plant(folder, name):
    sys.path[:0] = [str(SUBJECTS / "python_stdlib"), str(SUBJECTS / folder)]  # slips has a solver.py too: the first one is used
    import subject
    if folder == "fakes":
        import fake
        for one in name.split("+"):
            if one != "none":
                fake.MISTAKES[one].make()
    else:
        import first_maker
        import second_maker
        {one.__name__: one for one in first_maker.SLIPS + second_maker.SLIPS}[name]()
    return subject


def offered(subject, name):
    """The subject's function of this name, with keyword arguments."""
    def function(**given):
        return fields(subject.answer({"function": name, **given}))
    return function


def fields(answer):
    if "skip" in answer:
        raise NotImplementedError(answer["skip"])
    return answer


def main():
    folder, *names = sys.argv[1:]
    for name in names:
        if child := os.fork():
            os.waitpid(child, 0)
            continue
        subject = plant(folder, name)
        solver = {one: offered(subject, one) for one in tribocheck.functions}
        solver |= {one: lambda scene: fields(subject.answer(scene)) for one in POINTS}
        try:
            text, holds = tribocheck.check(solver), True
        except AssertionError as error:
            text, holds = str(error), False
        found = [line.removeprefix("Diagnosis: ") for line in text.splitlines() if line.startswith("Diagnosis: ")]
        print(json.dumps([name, found, holds]), flush=True)
        os._exit(0)


if __name__ == "__main__":
    main()
