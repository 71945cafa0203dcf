# SPDX-License-Identifier: Apache-2.0
"""Writes a help text and an Octave file for each function of the catalogue, and tribocheck.m, which lists them: make_functions.py LIBRARY FOLDER."""
import ctypes
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python/tribocheck"))
import _help  # noqa: E402


def catalogue(path):
    describe = ctypes.CDLL(path).tribocheck_describe
    length = ctypes.c_size_t()
    describe(None, ctypes.c_size_t(0), ctypes.byref(length))
    text = ctypes.create_string_buffer(length.value + 1)
    describe(text, ctypes.c_size_t(len(text)), None)
    return json.loads(text.value)["functions"]


def text_of(entry):
    name = f"tribocheck_{entry['name']}"
    parameters = ", ".join(one["name"] for one in entry["parameters"])
    example = ", ".join(repr(entry["example"].get(one["name"], one.get("default"))) for one in entry["parameters"])
    rows = [f"{name} ({parameters})", "", *_help.lines(
        entry, "a cell of texts", ["One that is NaN, infinite or not allowed is an error that tells its index."], "in a struct", f"{name} ({example})")]
    return f"{comment(rows)}function answer = {name} (varargin)\n  answer = called ('{entry['name']}', varargin);\nend\n"


def comment(rows):
    return "".join(f"% {line}".rstrip() + "\n" for line in rows)


def list_of(entries):
    rows = ["Films, contacts and friction of lubricated contacts, and a judge of your own code for them. SI units.", "",
            "    contact = tribocheck_hertz_point (50, 1.079e11, 9.5e-3);",
            "    contact.radius                                    % 1.4891e-04", "",
            "`help tribocheck_check` tells how a function of yours is held to certified values. All others, each with its own help:", "",
            *(f"    tribocheck_{one['name']:<32}{one['meaning']}" for one in entries)]
    return f"{comment(rows)}function tribocheck ()\n  help tribocheck\nend\n"


def main():
    library, folder = sys.argv[1:]
    entries = catalogue(library)
    pathlib.Path(folder, "tribocheck.m").write_text(list_of(entries))
    for entry in entries:
        pathlib.Path(folder, f"tribocheck_{entry['name']}.m").write_text(text_of(entry))


main()
