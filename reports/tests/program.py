# SPDX-License-Identifier: Apache-2.0
"""Runs the real program and writes scenes for it. TRIBOCHECK is the program's path."""

import copy
import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ["TRIBOCHECK"]
SWEEP_PROGRAM = PROGRAM + "_sweep"  # `tribocheck sweep` replaces itself by this program
# Seconds after which a program counts as hung; no measure of speed. It is longer where more processes run than there are processors.
TIMEOUT = 280 * max(1, os.getloadavg()[0] / os.cpu_count())

ENVIRONMENT = dict(os.environ)
# Programs that these tests start find this interpreter as `python3`, and not a version manager's script, which starts far more slowly.
ENVIRONMENT["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
# Under nohup, or in the background of a shell, a process ignores these signals, and so would the programs that it starts.
for one, way in ((signal.SIGINT, signal.default_int_handler), (signal.SIGHUP, signal.SIG_DFL), (signal.SIGQUIT, signal.SIG_DFL)):
    signal.signal(one, way)

# AddressSanitizer keeps 256 MB of freed memory, which the program itself does not use.
ENVIRONMENT["ASAN_OPTIONS"] = ":".join(
    filter(None, [os.environ.get("ASAN_OPTIONS"), "quarantine_size_mb=1"]))

# The paper's Table 1: id, summit density, standard deviation of summit heights.
SURFACES = {"rough": (5e10, 1e-7), "medium": (1e11, 5e-8), "smooth": (2e11, 2.5e-8)}


class Literal(str):
    """A text that is written into a scene as it is, without quotes."""


def scene(surface="rough", **changes):
    density, sd = SURFACES[surface]
    result = {
        "id": surface,
        "load": 50,
        "speed": {"from": 1e-4, "to": 3, "count": 20},
        "surface": {"summit_density": density, "summit_radius": 1e-5, "summit_height_sd": sd,
                    "summit_plane_offset": 1.146},
        "bodies": {"effective_modulus": 107.9e9, "reduced_radius": 9.5e-3},
        "lubricant": {"viscosity": 0.0202, "pressure_viscosity": 2e-8, "eyring_stress": 2.5e6},
        "supply": {"inlet_film_ratio": 4},
        "friction": {"boundary_coefficient": 0.13},
    }
    result.update(changes)
    return {key: value for key, value in result.items() if value is not None}


def quiet_scene(*arguments, **changes):
    """A scene() without a warning: an isotropic Gaussian face may have its summits, and it accepts the limits that it goes beyond."""
    accepted = {"accept": ["elastic_summits", "film_below_molecule", "smooth_film_law", "summit_capacity", "inlet_supply", "default_inlet",
                           "default_sliding"]}
    return with_field(scene(*arguments, **accepted | changes), "surface.summit_plane_offset", 0.919)


def split(path):
    section, _, key = path.rpartition(".")
    return section, key


def with_field(base, path, value):
    result = copy.deepcopy(base)
    section, key = split(path)
    (result.setdefault(section, {}) if section else result)[key] = value
    return result


def without_field(base, path):
    result = copy.deepcopy(base)
    section, key = split(path)
    (result.get(section, {}) if section else result).pop(key, None)
    return result


def json_value(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)}: {json_value(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(json_value, value)) + "]"
    return str(value) if isinstance(value, Literal) else json.dumps(value)


def toml(tree):
    """A tree as TOML, with scalars and lists before the tables, as TOML wants them."""
    def line(key, value):
        return f"{key} = {json_value(value)}\n"
    text = "".join(line(k, v) for k, v in tree.items() if not isinstance(v, dict))
    for name, table in tree.items():
        if isinstance(table, dict):
            text += f"[{name}]\n" + "".join(line(k, v) for k, v in table.items())
    return text


OF_LIMITS = "outside of the model's limits: "  # words of a warning that nearly every Stribeck curve gets


class Result:
    """`said` is all of stderr, `err` is stderr without the warning about the model's limits, and `warned` is that warning."""

    def __init__(self, code, out, err):
        self.code, self.out, self.said = code, out, err
        self.err = "".join(line for line in err.splitlines(keepends=True) if OF_LIMITS not in line)
        self.warned = "".join(line for line in err.splitlines() if OF_LIMITS in line)
        self.error_lines = self.err.splitlines()

    def ended(self, code, err=None):
        """Itself. It has to have ended with this code, and with `err` on stderr if that is given."""
        assert self.code == code and err in (None, self.err), f"exit code {self.code}: {self.said}{self.out[-2000:]}"
        return self

    def json(self):
        return strict_json(self.out)

    def json_lines(self):
        return [strict_json(line) for line in self.out.splitlines()]

    def rows(self):
        """The rows of CSV, by the names of their columns."""
        return list(csv.DictReader(io.StringIO(self.out, newline="")))


def strict_json(text):
    """Reads JSON strictly: Python's own reader lets NaN and Infinity through."""
    def refuse(name):
        raise ValueError(f"{name} is not JSON")
    return json.loads(text, parse_constant=refuse)


def run(*arguments, stdin="", environment=None, **options):
    """`environment`: the variables that differ from this process's."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], input=stdin.encode(), capture_output=True, timeout=TIMEOUT,
                          env=ENVIRONMENT | (environment or {}), **options)
    return Result(done.returncode, done.stdout.decode(), done.stderr.decode())


def start(*arguments, **options):
    return subprocess.Popen([PROGRAM, *map(str, arguments)], env=ENVIRONMENT, **options)


def read_terminal(reader):
    """Reads a pseudoterminal until its other end is closed; closes this end."""
    said = b""
    try:
        while part := os.read(reader, 4096):
            said += part
    except OSError:  # the other end is closed
        pass
    os.close(reader)
    return said


def wait_for(process):
    """Waits for the process, in place of process.wait(). Returns its exit code and its greatest memory in MiB."""
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_maxrss / 1024


class Folder(tempfile.TemporaryDirectory):
    """A temporary folder for scene files."""

    def path(self, name):
        return os.path.join(self.name, name)

    def write(self, name, content):
        text = content if isinstance(content, (str, bytes)) else toml(content)
        if name.endswith(".json") and isinstance(content, dict):
            text = json_value(content)
        with open(self.path(name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return self.path(name)


def folder_until(add_cleanup):
    """The path of a temporary folder. `add_cleanup` is addCleanup of a test or addClassCleanup of a class, at whose end it is removed."""
    folder = tempfile.TemporaryDirectory()
    add_cleanup(folder.cleanup)
    return pathlib.Path(folder.name)


class ProgramTest(unittest.TestCase):
    """Tests that write files for the program."""

    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.cleanup)

    def assert_refused(self, result, *words, code=2):
        """Asserts one line on stderr, with these words in it, and nothing on stdout."""
        self.assertEqual((result.code, result.out, len(result.error_lines)), (code, "", 1), result.err)
        self.assertTrue(result.err.startswith("tribocheck: "), result.err)
        for word in words:
            self.assertIn(word, result.err)
