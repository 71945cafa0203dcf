# SPDX-License-Identifier: Apache-2.0
"""A group of report.json: the numbers of one part of the page, computed and judged once. The page's templates
(../render/templates) take every number and every verdict from it."""
import re
import typing


class Missing(Exception):
    """The reason why a group, or a part of one, cannot be made. The page tells it in the place of that part."""


class Refused(Exception):
    """No report can be made from the scenes or options that are given. Each argument is a line that says why."""


class Group(typing.NamedTuple):
    data: dict
    findings: list = []
    not_run: list = []  # parts that are missing from the page
    files: list = []  # (path below the report's folder, text): data of the figures


def finding(name, section, about, standing, why=""):
    """A line at the top of the page, about the `paper` or the `software`. Its sentence stands in the section's template,
    as finding_<name>; where the template has none, `why` is the sentence.

    holds: agrees, within what is declared; differs: does not agree with the paper, or in part; fails: a promise of this
    software is broken; missed: a target that it sets itself is not reached; measured: neither good nor bad; absent: not
    known, as its source is missing or was not run.
    """
    made = {"id": name, "section": section, "about": about, "standing": standing}
    return made | {"why": why} if why else made


def promise(name, section, held, count):
    """The finding on a promise. It holds if there is at least one case and all cases are held."""
    if 0 < count == held:
        return finding(name, section, "software", "holds")
    return finding(name, section, "software", "fails", f"{count - held} of {count} are not held.")


def not_run(what, why, how_to):
    """An entry on a part that was not run. `how_to` is Markdown: the command that gives the part."""
    return {"what": what, "why": why, "how_to": how_to}


CONTROLS = re.compile("[\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]")


def printable(text):
    """The text as one line: line ends and other control signs are escaped."""
    return CONTROLS.sub(lambda sign: {"\n": "\\n", "\t": "\\t"}.get(sign[0], f"\\u{ord(sign[0]):04x}"), text)
