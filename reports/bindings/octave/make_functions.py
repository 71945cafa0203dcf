# SPDX-License-Identifier: Apache-2.0
"""make_functions.py LIBRARY FOLDER: a file of Octave for each function of the catalogue, with its help text, and tribocheck.m that lists them."""
import ctypes
import json
import pathlib
import sys


def catalogue(path):
    describe = ctypes.CDLL(path).tribocheck_describe
    length = ctypes.c_size_t()
    describe(None, ctypes.c_size_t(0), ctypes.byref(length))
    text = ctypes.create_string_buffer(length.value + 1)
    describe(text, ctypes.c_size_t(len(text)), None)
    return json.loads(text.value)["functions"]


def parameter_rows(one):
    if "words" in one:
        allowed = "one of " + ", ".join(one["words"])
    else:
        least, greatest = one["physical"]
        allowed = f"{one['allowed']}; usual: {least:g} to {greatest:g}"
    default = f"; default {one['default']!r}" if "default" in one else ""
    return [row(one), f"    {'':<32}{allowed}{default}"]


def row(one):
    return f"    {one['name']:<24}{one['unit'] or '-':<8}{one['meaning']}"


def text_of(entry):
    name, results = f"tribocheck_{entry['name']}", entry["results"]
    parameters = ", ".join(one["name"] for one in entry["parameters"])
    example = ", ".join(repr(entry["example"].get(one["name"], one.get("default"))) for one in entry["parameters"])
    rows = [f"{name} ({parameters})", "", entry['meaning'][:1].upper() + entry['meaning'][1:] + ".", "", f"    {entry['equation']}", "",
            "Arguments, each a number or an array (of words: a text or a cell of texts):", "",
            *(line for one in entry["parameters"] for line in parameter_rows(one)), "",
            "One that is NaN, infinite or not allowed is an error that tells its index.", "",
            "Result:" if len(results) == 1 else "Results, in a struct:", "", *map(row, results), "",
            "A result too large for a double is infinite.", f"Source: {entry['source']}.", "", f"    {name} ({example})"]
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
