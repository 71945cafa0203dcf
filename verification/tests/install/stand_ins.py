# SPDX-License-Identifier: Apache-2.0
"""Stand-ins of `make`, `git` and `apt-get` for tests that install the project in a new place.

The stand-in of `make` installs this build under the given PREFIX, and does not build the project again. All three record
their arguments.
"""

import os
import pathlib
import shlex

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
BUILD = pathlib.Path(os.environ["TRIBOCHECK_BUILD"])
NEWCOMER = ROOT / "verification/conformance/subjects/small_python/my_solver.py"
MAKE = f"""#!/bin/sh
echo "make $*" >> "$HOME/asked"
for word; do case $word in PREFIX=*) prefix=${{word#PREFIX=}};; esac; done
exec {os.environ["CMAKE"]} --install {shlex.quote(str(BUILD))} --prefix "$prefix" > /dev/null
"""
OTHERS = """#!/bin/sh
echo "$(basename "$0") $*" >> "$HOME/asked"
"""


def put_into(home, **more):
    """Writes the stand-ins and `more` (texts by name) into a folder of `home`; returns an environment with it on PATH."""
    folder = home / "stands in"
    folder.mkdir()
    for name, text in {"make": MAKE, "git": OTHERS, "apt-get": OTHERS, **more}.items():
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    return {**{name: os.environ[name] for name in ("CXX", "CMAKE_GENERATOR") if name in os.environ},
            "HOME": str(home), "PATH": f"{folder}:/usr/bin:/bin", "LANG": "C.UTF-8"}


def asked(home):
    """The commands that the stand-ins were given since the last call."""
    path = home / "asked"
    lines = path.read_text().splitlines() if path.exists() else []
    path.unlink(missing_ok=True)
    return lines
