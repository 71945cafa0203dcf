# SPDX-License-Identifier: Apache-2.0
"""Sweeps for the tests: makes their texts, runs them, and reads their results by h5py."""

import collections
import ctypes
import math
import os
import random
import re
import signal
import struct
import subprocess
import time

from program import ENVIRONMENT, PROGRAM, ProgramTest, run

with open(PROGRAM, "rb") as program:
    SANITIZED = b"__asan_init" in program.read()  # sanitizers take time and memory of their own

ONE_LINE = {"accept": '["elastic_summits", "film_below_molecule", "smooth_film_law", "summit_capacity", "inlet_supply", '
                      '"default_inlet", "default_sliding"]',
            "load": "50", "bodies.effective_modulus": "107.9e9", "bodies.reduced_radius": "9.5e-3",
            "surface.summit_density": "2e11", "surface.summit_radius": "1e-5",
            "surface.summit_height_sd": "2.5e-8", "surface.summit_plane_offset": "0.919",
            "lubricant.viscosity": "0.0202", "lubricant.pressure_viscosity": "2e-8",
            "lubricant.eyring_stress": "2.5e6", "supply.inlet_film_ratio": "4",
            "friction.boundary_coefficient": "0.13"}
UNIFORM = '{ distribution = "uniform", from = 0.01, to = 0.03 }'
NORMAL = '{ distribution = "normal", mean = 0.0202, sd = 0.001 }'


def sweep(changes=None, **settings):
    """The TOML of a sweep. `changes` has fields by their paths, where None leaves a field out; `settings` stand in [sweep]."""
    fields = {"id": '"smooth"', **ONE_LINE, **(changes or {})}
    lines = {"": []}
    for path, value in fields.items():
        section, _, key = path.rpartition(".")
        if value is not None:
            lines.setdefault(section, []).append(f"{key} = {value}\n")
    text = "".join(lines.pop(""))
    for section, content in lines.items():
        text += f"[{section}]\n" + "".join(content)
    return text + "[sweep]\n" + "".join(f"{k} = {v}\n" for k, v in settings.items())


# Parts have few chunks, so that short sweeps have several parts: a sweep of ten chunks has three.
ENVIRONMENT["TRIBOCHECK_PART_CHUNKS"] = "4"

# Takes some tenths of a second, in many chunks. With sanitizers it has fewer draws, to take as long.
LONG = sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }',
              "surface.summit_height_sd": '{ printed = "2.5e-8" }'},
             onset='["film_maximum", "film_departure"]', draws=30000 if SANITIZED else 150000, sensitivity="true")

# A chunk of this sweep takes minutes, and the whole sweep days.
DAYS = sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }',
               "speed": "{ from = 1e-3, to = 3, count = 20 }"}, onset='["friction_minimum"]',
              keep='"summaries"', draws=2000000000)


SHORT = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, draws=5000)

# Takes less than a tenth of a second, in eight parts: for trials that are repeated many times.
MINI = sweep({"lubricant.viscosity": UNIFORM}, onset='["film_maximum"]', draws=30000)


class SweepTest(ProgramTest):
    def check_kills(self, kills, begin, end, pick):
        """Kills processes at random moments. begin(*options) starts processes on MINI, pick(process, draw) gives the id of the
        process to kill for each of them, and end() completes out.h5, which has to have the bytes of an undisturbed run."""
        whole = self.whole_mini()
        draw = random.Random(7)
        processes = begin()
        self.wait_until(lambda: self.locks() or all(process.poll() is not None for process in processes))
        started = time.monotonic()
        for process in processes:
            process.wait()
        seconds = time.monotonic() - started
        kept, done = [], 0
        for kill in range(kills):
            for name in self.names():
                if name not in ("sweep.toml", "whole.h5"):
                    os.remove(self.path(name))
            processes = begin()
            for _ in range(1 + (draw.random() < 0.3)):  # sometimes a second kill, after the run was resumed
                if draw.random() < 0.8:  # else the kill may come before it computes
                    self.wait_until(lambda: self.locks() or all(process.poll() is not None for process in processes))
                time.sleep(draw.uniform(0, seconds))
                for process in processes:
                    try:
                        os.kill(pick(process, draw), signal.SIGKILL)
                    except ProcessLookupError:  # it had ended
                        pass
                    process.wait()
                kept.append(len([name for name in self.names() if re.search(r"\.part-[\d-]+$", name)]))
                done += "out.h5" in self.names()
                processes = begin("--resume")
            for process in processes:
                process.wait()
            end()
            with self.subTest(kill=kill):
                self.assertEqual(self.bytes_of("out.h5"), whole)
                self.assertEqual([name for name in self.names() if name.startswith((".", "out.h5."))], [])
        print(f"{len(kept)} kills in {kills} trials of {seconds:.2f} s; parts that were there: "
              f"{dict(sorted(collections.Counter(kept).items()))}; results that were there: {done}", flush=True)

    def locks(self):
        return [name for name in self.names() if name.endswith(".lock")]

    def whole_mini(self):
        self.swept(MINI, "--force", out="whole.h5")
        return self.bytes_of("whole.h5")

    def path(self, name):
        return self.folder.path(name)

    def names(self):
        return sorted(os.listdir(self.folder.name))

    def parts(self, out="out.h5"):
        """The names of the parts that are there."""
        return [name for name in self.names() if re.fullmatch(re.escape(out) + r"\.part-\d+-\d+(-\d+)?", name)]

    def wait_until(self, is_so):
        """Waits until it is so. The test fails if it is not within a minute."""
        end = time.monotonic() + 60
        while not is_so():
            if time.monotonic() > end:
                self.fail("what was waited for did not come within a minute")
            time.sleep(0.002)

    def wait_for_handler(self, process, number):
        """Waits until the process has its own handler for the signal. Without a handler the signal would end it."""
        def has_handler():
            with open(f"/proc/{process.pid}/status", encoding="ascii", errors="replace") as file:
                mask = next((line.split()[1] for line in file if line.startswith("SigCgt:")), "0")
            return int(mask, 16) >> (number - 1) & 1
        self.wait_until(has_handler)

    def wait_for_parts(self, count=3):
        self.wait_until(lambda: len(self.parts()) >= count)

    def assert_same(self, got, expected, name, data):
        if isinstance(expected, str):
            words = [word.decode() if isinstance(word, bytes) else word for word in data.attrs["words"]]
            self.assertEqual(words[int(got)], expected, name)
        elif expected is None:
            self.assertTrue(math.isnan(got), name)
        else:  # sweeps and the other commands use different kernels, each with rounding errors of its own
            self.assertLessEqual(abs(got - expected), 1e-13 * abs(expected), (name, got, expected))

    def ended_at_last(self, process):
        """The process, which ends with the test if not before."""
        for stream in filter(None, (process.stdout, process.stderr)):
            self.addCleanup(stream.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def stopped(self, process, parts=3):
        """The process, stopped when it has computed so many parts."""
        self.wait_for_parts(parts)
        process.send_signal(signal.SIGSTOP)
        return process

    def put(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)

    def bytes_of(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def sweep(self, text, *options, name="sweep.toml", out="out.h5", **more):
        """Writes a sweep and runs it; returns the program's result."""
        return run("sweep", self.folder.write(name, text), "-o", self.path(out), *options, **more)

    def swept(self, text, *options, out="out.h5", **more):
        return self.sweep(text, *options, out=out, **more).ended(0)


XXHASH = ctypes.CDLL("libxxhash.so.0")
XXHASH.XXH3_64bits.restype = ctypes.c_uint64
XXHASH.XXH3_64bits.argtypes = [ctypes.c_char_p, ctypes.c_size_t]


def sealed(content):
    """The content with the checksum that ends a result or a part."""
    return content + b"\x93TBSR1\r\n" + struct.pack("<QQ", len(content), XXHASH.XXH3_64bits(content, len(content)))


def opened(path):
    import h5py  # imported only here, as this takes a tenth of a second
    return h5py.File(path)


def preloadable(name):
    """Builds a library from a C source beside this file; returns its path."""
    library = os.path.join(os.path.dirname(os.path.abspath(PROGRAM)), f"{name}.so")
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), f"{name}.c")
    unfinished = f"{library}.{os.getpid()}"
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-Wall", "-Werror", "-fexceptions", "-U_FORTIFY_SOURCE", "-o", unfinished, source, "-ldl"],
                   check=True)
    os.rename(unfinished, library)
    return library


def mpirun(ranks):
    return ["mpirun", "--oversubscribe", "-n", str(ranks)]


def mpi_environment():
    # Open MPI refuses root without these, and containers often have no other user.
    return dict(ENVIRONMENT, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
