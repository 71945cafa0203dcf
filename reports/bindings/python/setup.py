# SPDX-License-Identifier: Apache-2.0
"""The wheel of the package: CMake builds and installs it, with the library and the certified values beside it.

TRIBOCHECK_BUILD in the environment names a build folder that has it already; without it CMake builds it anew.
"""
import os
import pathlib
import re
import subprocess
import tempfile

import setuptools
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = tempfile.TemporaryDirectory()  # setuptools writes there, and not into the sources
SCRATCH = FOLDER.name


class Binary(setuptools.Distribution):
    def has_ext_modules(self):
        return True


class Build(build_py):
    def run(self):
        built = os.environ.get("TRIBOCHECK_BUILD")
        if not built:
            built = f"{SCRATCH}/cmake"
            subprocess.run(["cmake", "-S", ROOT, "-B", built, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTRIBOCHECK_BUILD_PYTHON=ON"], check=True)
            subprocess.run(["cmake", "--build", built, "--target", "tribocheck_python"], check=True)
        subprocess.run(["cmake", "--install", built, "--component", "wheel", "--prefix", self.build_lib], check=True)


setuptools.setup(
    name="tribocheck",
    version=re.search(r"project\(tribocheck VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1],
    description="Films, contacts and friction of lubricated contacts, and a judge of your own code for them",
    license="Apache-2.0",
    python_requires=">=3.11",
    install_requires=["numpy"],
    packages=["tribocheck"],
    entry_points={"pytest11": ["tribocheck = tribocheck.pytest_plugin"]},
    cmdclass={"build_py": Build},
    distclass=Binary,
    options={"egg_info": {"egg_base": SCRATCH}, "build": {"build_base": SCRATCH}, "bdist_wheel": {"bdist_dir": f"{SCRATCH}/wheel"}},
)
