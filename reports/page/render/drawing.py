# SPDX-License-Identifier: Apache-2.0
"""Draws the figures with gnuplot, each as SVG and as PNG, and puts an SVG into the page."""
import html
import os
import pathlib
import re
import shutil
import subprocess

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent / "gnuplot"
NO_GNUPLOT = "gnuplot was not found in PATH"


def enhanced(text):
    """A text of the data for gnuplot's enhanced text, which takes these signs for orders."""
    return re.sub(r"([\\_^{}@&~])", r"\\\1", text)


def run_gnuplot(frame, *arguments):
    """Why nothing was drawn; empty where it was."""
    if shutil.which("gnuplot") is None:
        return NO_GNUPLOT
    try:
        done = subprocess.run(["gnuplot", "-d", "-c", SCRIPTS / frame, *map(str, arguments)], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
    except OSError as error:
        return f"gnuplot cannot be started: {error.strerror}"
    if done.returncode < 0:
        return f"gnuplot ended by signal {-done.returncode}"
    if done.returncode:  # it repeats the whole command before the reason
        said = " ".join(done.stderr.split())
        return "gnuplot: " + (said if len(said) <= 300 else "…" + said[-300:].split(" ", 1)[-1])
    return ""


def draw(drawing, data, target):
    """One picture, whole or not at all; its format is that of the target's name. Returns why it was not drawn."""
    target.parent.mkdir(parents=True, exist_ok=True)
    unfinished = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        why = run_gnuplot(drawing["frame"], drawing["script"], target.suffix[1:], unfinished, data, drawing["name"],
                          drawing["height"], drawing["title"], drawing["subtitle"])
        if not why:
            unfinished.replace(target)
        return why
    finally:
        unfinished.unlink(missing_ok=True)


def inline_svg(svg, prefix, title, description):
    """An SVG of gnuplot as an element of the page, with identifiers of its own and a text for those who cannot see it."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"""( id=["']|href=["']#|url\('?#)""", rf"\1{prefix}-", svg)
    for element in ("title", "desc"):  # what gnuplot writes about itself
        svg = re.sub(rf"<{element}>.*?</{element}>", "", svg, count=1, flags=re.DOTALL)
    head, rest = svg.split(">", 1)
    head = head.replace("<svg", f'<svg role="img" aria-labelledby="{prefix}-title {prefix}-desc"', 1)
    return (f'{head}>\n<title id="{prefix}-title">{html.escape(title)}</title>\n'
            f'<desc id="{prefix}-desc">{html.escape(description)}</desc>{rest}')
