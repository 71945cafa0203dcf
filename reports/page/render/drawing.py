# SPDX-License-Identifier: Apache-2.0
"""Draws the figures with gnuplot, each as SVG and as PNG, and puts an SVG into the page."""
import argparse
import contextlib
import errno
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent / "gnuplot"
NO_GNUPLOT = "gnuplot was not found in PATH"


# Signs that no page and no SVG may hold, or that turn the text around them: controls, and Unicode's signs of direction.
CONTROLS = re.compile("[\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufffe\uffff\ud800-\udfff]+")


def cleaned(value):
    """The value, in which texts and names of members have blanks in place of control signs."""
    if isinstance(value, str):
        return CONTROLS.sub(" ", value)
    if isinstance(value, list):
        return [cleaned(one) for one in value]
    if isinstance(value, dict):
        return {cleaned(name): cleaned(one) for name, one in value.items()}
    return value


def read_data(path):
    """JSON without control signs."""
    return cleaned(json.loads(pathlib.Path(path).read_text(encoding="utf-8")))


def show_step(step):
    """Writes a line on stderr that each step overwrites, on a terminal only."""
    if sys.stderr.isatty():
        print(f"\r{step}\033[K", end="", file=sys.stderr, flush=True)


def enhanced(text):
    """A text of the data for gnuplot's enhanced text, in which these signs are commands."""
    return re.sub(r"([\\_^{}@&~])", r"\\\1", text)


def run_gnuplot(*arguments):
    """Why nothing was drawn; empty where it was."""
    if shutil.which("gnuplot") is None:
        return NO_GNUPLOT
    try:
        done = subprocess.run(["gnuplot", "-d", "-c", SCRIPTS / "canvas.gp", *map(str, arguments)], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
    except OSError as error:
        return f"gnuplot cannot be started: {error.strerror}"
    if done.returncode < 0:
        return f"gnuplot ended by signal {-done.returncode}"
    if done.returncode:  # gnuplot repeats the whole command before the reason
        said = " ".join(done.stderr.split())
        return "gnuplot: " + (said if len(said) <= 300 else "…" + said[-300:].split(" ", 1)[-1])
    return ""


# Traces of gnuplot and its `mousing`: comments, the name of its script, calls of the script, and the places of the last plot's axes.
MOUSING = re.compile(r"""<!--.*?-->\s*|<desc>Produced by GNUPLOT[^<]*</desc>\s*|\s+id="\w+_keyentry" visibility="visible"|<script.*?(?:/>|</script>)\s*|\s+on(?:load|click|mousemove)="[^"]*"|"""
                     r"""<text id="coord_text".*(?=</svg>)|(?<=fill="#ffffff") stroke="black" stroke-width="1"(?=/>)""",
                     re.DOTALL)
UNNAMED = re.compile(r"<title>[^<]* using [^<]*</title>")  # gnuplot's command, as the title of a line that has no name
FAMILY = ' font-family="DejaVu Sans,Verdana,sans-serif"'  # of each text and each part of one
INITIAL = ' stroke-linecap="butt" stroke-linejoin="miter"'  # the defaults of SVG
PATH = re.compile(r"\bd='[^']*'")  # places with two decimals
EMPTY_GROUP = re.compile(r"<g\b[^>]*>\s*</g>\s*")
AXES = re.compile(r"gnuplot_svg\.plot_(xmin|xmax|ybot|ytop|axis_xmin|axis_xmax|axis_ymin|axis_ymax|logaxis_x|logaxis_y)"
                  r" = ([-+.0-9e]+);")


def without_scripts(svg):
    """The picture without gnuplot's traces, its font named once. The attribute data-axes of the element svg has the values at the edges of
    the (last) plot, so that the page can show the values under the pointer."""
    axes = " ".join(f"{name}={value}" for name, value in AXES.findall(svg))
    svg = UNNAMED.sub("", MOUSING.sub("", svg)).replace(INITIAL, "").replace(FAMILY, "")
    svg = svg.replace("<svg", f'<svg data-axes="{axes}"{FAMILY}', 1)
    more = 1
    while more:  # a tenth of each file is empty groups
        svg, more = EMPTY_GROUP.subn("", svg)
    svg = PATH.sub(lambda path: re.sub(r"\.00(?!\d)", "", path[0]), svg)
    return re.sub(r"\n\s+", "\n", svg)


def draw(drawing, data, target):
    """One picture, whole or not at all; its format is that of the target's name. Returns why it was not drawn."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(target) as unfinished:
        why = run_gnuplot(drawing["script"], target.suffix[1:], unfinished, data, drawing["name"],
                          drawing["height"], drawing["title"], drawing["subtitle"])
        if why:
            unfinished.unlink(missing_ok=True)
        elif target.suffix == ".svg":
            unfinished.write_text(without_scripts(unfinished.read_text(encoding="utf-8")), encoding="utf-8")
        return why


def draw_one(description, name, blocks, drawn):
    """The main function of a script that draws one answer of the program. DATA is its JSON. `blocks` makes the file NAME.blocks.tsv of it
    for gnuplot, and `drawn` the figure for draw(). Prints what was drawn, as JSON."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", metavar="DATA", type=pathlib.Path)
    parser.add_argument("picture", metavar="PICTURE", type=pathlib.Path)
    arguments = parser.parse_args()
    data = read_data(arguments.data)
    try:
        if not arguments.picture.parent.is_dir():
            raise FileNotFoundError(errno.ENOENT, f"there is no folder {arguments.picture.parent}")
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, f"{name}.blocks.tsv").write_text(blocks(data), encoding="utf-8")
            why = draw(drawn(data, folder), folder, arguments.picture)
    except OSError as error:
        why = f"cannot write {arguments.picture}: {error.strerror}"
    if why == NO_GNUPLOT:
        why += ": no picture (Debian: apt-get install gnuplot-nox)"
    print(json.dumps({"written": [] if why else [str(arguments.picture)], "undrawn": [why] if why else []}))


@contextlib.contextmanager
def whole_file(target):
    """A path to write to. At the end a file that was written there takes the target's name. The path lies in a folder that
    belongs to this user alone, so that nobody can put a link to another file there."""
    with tempfile.TemporaryDirectory(prefix=f".{target.name}.", dir=target.parent) as folder:
        unfinished = pathlib.Path(folder, target.name)
        yield unfinished
        if unfinished.exists():
            unfinished.replace(target)


def write_text(target, text):
    """Writes a file, whole or not at all."""
    with whole_file(target) as unfinished:
        unfinished.write_text(text, encoding="utf-8")


def short_path(match):
    """A path without zeros at the ends of its numbers, 86.40 as 86.4, and without the L that SVG takes for granted after M."""
    numbers = re.sub(r"(\.\d*?)0+(?!\d)", r"\1", match[0])
    return re.sub(r"\s+", " ", re.sub(r"\s+L|\s+(?=')", " ", re.sub(r"\.(?!\d)", "", numbers)))


def shortened(svg):
    """The same picture in a tenth less text: colours are written as #003468, and definitions of marks that it does not use are left out."""
    svg = re.sub(r"rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\)", lambda match: "#" + "".join(f"{int(one):02x}" for one in match.groups()), svg)
    svg = re.sub(r""" (?:d|points)\s*=\s*'[^']*'""", short_path, svg)
    defined = re.compile(r"(?m)^<(?:path|rect|circle|use)\b[^>]*? id='(gp\w+)'[^>]*/>\n")
    while unused := [match[0] for match in defined.finditer(svg) if f"#{match[1]}'" not in svg]:
        for one in unused:
            svg = svg.replace(one, "")
    return svg


def inline_svg(svg, prefix, title, description):
    """An SVG of gnuplot as an element of the page, with identifiers of its own and a text for those who cannot see it."""
    svg = shortened(svg[svg.index("<svg"):])
    svg = re.sub(r"""( id=["']|href=["']#|url\('?#)""", rf"\1{prefix}-", svg)
    for element in ("title", "desc"):  # gnuplot's words about itself
        svg = re.sub(rf"<{element}>.*?</{element}>", "", svg, count=1, flags=re.DOTALL)
    head, rest = svg.split(">", 1)
    head = head.replace("<svg", f'<svg role="img" aria-labelledby="{prefix}-title {prefix}-desc"', 1)
    return (f'{head}>\n<title id="{prefix}-title">{html.escape(title)}</title>\n'
            f'<desc id="{prefix}-desc">{html.escape(description)}</desc>{rest}')
