# SPDX-License-Identifier: Apache-2.0
"""Puts every fake, alone and together with others, to `tribocheck verify --subject`, and keeps the diagnoses.

  make diagnosis    calls it; writes reference/baselines/diagnosis.json

Exit code 1: a mistake was not named, or a right solver was accused.
"""
import concurrent.futures
import datetime
import json
import pathlib
import re
import subprocess
import sys

from conformance import subject, verify
from test_fakes import listed
from test_fakes_named import NAMED, SETS

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/gates/faults"))
import plant  # noqa: E402


def asked(one):
    """A row of the ledger: a function, its fakes, and the diagnosis."""
    function, fakes = one
    expected = {NAMED[fake] for fake in fakes.split("+")}
    diagnoses = verify("--subject", subject("fakes/fake.py", "--mistake", fakes, "--only", function)).json()["diagnoses"]
    named = {name for one in diagnoses for cause in one["mistakes"] for name in cause.split(" + ")}
    return {"function": function, "fakes": fakes.split("+"), "named": expected <= named,
            "said": diagnoses[0]["text"] if diagnoses else "nothing"}


def tries_of_right_solvers(program):
    """The number of right solvers that the C++ test judged, and whether one was accused."""
    done = subprocess.run([program, "--gtest_filter=Said.OfRightSolversIsNothingInAThousandTries"],
                          capture_output=True, text=True, check=False)
    tries = re.search(r"Ran (\d+) cases", done.stdout)
    return {"tries": int(tries[1]) if tries else 0, "accused": done.returncode != 0}


def main():
    out, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    everyone = [(function, name) for name, _, function in listed()] + SETS
    rows = []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for row in pool.map(asked, everyone):
            rows.append(row)
            if sys.stderr.isatty():
                print(f"\r{len(rows)} of {len(everyone)} wrong solvers\033[K", end="", file=sys.stderr, flush=True)
    right = tries_of_right_solvers(program)
    ledger = {"commit": plant.commit(), "date": datetime.date.today().isoformat(), "environment": plant.environment(),
              "right_solvers": right, "wrong_solvers": rows}
    out.write_text(json.dumps(ledger, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    unnamed = [row for row in rows if not row["named"]]
    print(f"{len(rows) - len(unnamed)} of {len(rows)} wrong solvers named; right solvers: {right['tries']} tries, "
          f"{'one was accused' if right['accused'] else 'none was accused'}")
    for row in unnamed:
        print(f"  not named: {' + '.join(row['fakes'])}: {row['said']}")
    return 1 if unnamed or right["accused"] or not right["tries"] else 0


if __name__ == "__main__":
    sys.exit(main())
