# SPDX-License-Identifier: Apache-2.0
"""The help text of a function of the catalogue, for Python and for Octave."""


def _row(one):
    return f"    {one['name']:<24}{one['unit'] or '-':<8}{one['meaning']}"


def _range(parameter):
    if "words" in parameter:
        allowed = "one of " + ", ".join(parameter["words"])
    else:
        least, greatest = parameter["physical"]
        allowed = f"{parameter['allowed']}; usual: {least:g} to {greatest:g}"
    return f"    {'':<32}{allowed}" + (f"; default {parameter['default']!r}" if "default" in parameter else "")


def lines(entry, texts, faults, several, example):
    """The lines of the help. `texts`: how words are given; `faults`: what a wrong argument does; `several`: how several results are returned."""
    return [entry["meaning"][:1].upper() + entry["meaning"][1:] + ".", "", f"    {entry['equation']}", "",
            f"Arguments, each a number or an array (of words: a text or {texts}):", "",
            *(line for one in entry["parameters"] for line in (_row(one), _range(one))), "", *faults, "",
            "Result:" if len(entry["results"]) == 1 else f"Results, {several}:", "", *map(_row, entry["results"]), "",
            "A result too large for a double is infinite.", f"Source: {entry['source']}.", "", f"    {example}"]
