#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the report's page from its data: draws the figures, and writes report.md and index.html.

`tribocheck report` writes report.json and data/*.tsv, and calls this. The prose stands in templates/*.md, a file a
section; the page's frame in layout.html and style.css. Prints what was written and what could not be drawn, as JSON.

  python3 reports/page/render/render.py reports/out
"""
import argparse
import json
import pathlib
import sys

MISSING_PACKAGES = 3  # exit code, for the program that calls

try:
    import jinja2
    import cmarkgfm  # noqa: F401
except ImportError as error:
    print(f"Python's {error.name} is missing (Debian: apt-get install python3-jinja2 python3-cmarkgfm)")
    sys.exit(MISSING_PACKAGES)

import drawing  # noqa: E402
import markup  # noqa: E402
import numbers_text as numbers  # noqa: E402
import sections  # noqa: E402
import sweep_pictures  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent


class Figures:
    """The figures that the templates ask for; each is drawn when a template asks for it."""

    def __init__(self, out, files):
        self.out = out
        self.files = files  # data files, for the page to list
        self.written, self.undrawn, self.html, self.missing = [], [], {}, []
        self.gnuplot_is_there = True

    def pictures(self, name, drawn):
        """Draws the SVG and the PNG, or neither. Returns their paths, and why they were not drawn; empty if they were."""
        paths = [f"figures/{name}.{kind}" for kind in ("svg", "png")]
        why = "" if self.gnuplot_is_there else drawing.NO_GNUPLOT
        for path in paths:
            if not why:
                drawing.show_step(f"drawing {path}")
                why = drawing.draw(drawn, self.out / drawn["data"], self.out / path)
                if why and why != drawing.NO_GNUPLOT:
                    why = f"{path}: {why}"
        if why:  # an old picture would not belong to the new data
            for path in paths:
                (self.out / path).unlink(missing_ok=True)
        return paths, why

    def figure(self, name, heading, alternative, script=None, folder="data", data_name=None, title=None,
               subtitle="", height=640, data=(), caller=None):
        """A figure of a template: {% call figure("figure_10", …) %} its caption {% endcall %}."""
        drawn = {"script": script or f"{name}.gp", "data": folder, "name": data_name or name,
                 "title": title or markup.plain(heading), "subtitle": subtitle, "height": height}
        paths, why = self.pictures(name, drawn)
        if why:
            if why != drawing.NO_GNUPLOT:
                self.undrawn.append(why)
            elif self.gnuplot_is_there:
                self.undrawn.append(f"{why}: no figures, but data and page are written "
                                    "(Debian: apt-get install gnuplot-nox)")
                self.gnuplot_is_there = False
            self.missing.append({"what": heading, "why": why, "how_to": "gnuplot, and `make report`,"})
            picture = "*Not drawn: gnuplot was not found, or failed.*"
        else:
            self.written += paths
            picture = f"![{markup.escaped(alternative)}](figures/{name}.png)"
            svg = (self.out / paths[0]).read_text(encoding="utf-8")
            self.html[name] = drawing.inline_svg(svg, name, markup.plain(heading), alternative)
        files = "Data: " + ", ".join(markup.link(path) for path in data) + "."
        if not why:
            files += " Picture: " + ", ".join(markup.link(path) for path in paths) + "."
        return markup.Markdown(f'<figure id="{name}">\n\n### {heading}\n\n{picture}\n\n<figcaption>\n\n'
                               f'{caller().strip() if caller else ""}\n\n{files}\n\n</figcaption>\n</figure>\n')

    def sweep_figure(self, picture, alternative, caller=None):
        """A picture of a sweep: {% call sweep_figure(sweep_pictures.sensitivity(…), …) %} its caption {% endcall %}."""
        if picture is None:
            return ""
        folder = self.out / "data/sweep"
        folder.mkdir(parents=True, exist_ok=True)
        path = sweep_pictures.write_blocks(picture, folder).relative_to(self.out).as_posix()
        self.written.append(path)
        self.files.append(path)
        return self.figure(picture.stem, picture.heading, alternative, picture.script, "data/sweep",
                           subtitle=picture.subtitle, height=picture.height, data=[path], caller=caller)

    def into(self, html):
        """The pictures of a section in place of its images."""
        for name, svg in self.html.items():
            start = html.find(f'<figure id="{name}">')
            if start < 0:
                continue
            image = html.index("<p><img", start)
            end = html.index("</p>", image) + len("</p>")
            html = (f'{html[:image]}<div class="scroll picture" tabindex="0" role="region" '
                    f'aria-label="picture, scrolls sideways">{svg}</div>\n<p class="hint">Wider than this screen: scroll '
                    f"it sideways, or open the picture.</p>{html[end:]}")
        return html


def shown(value):
    """The text that {{ … }} prints. A float has to say how many digits of it are known: {{ x | rounded(3) }}."""
    if isinstance(value, markup.Markdown) or isinstance(value, jinja2.Undefined):
        return value
    if isinstance(value, float):
        raise jinja2.TemplateError(f"the number {value!r} needs a filter that says how many digits to print")
    if value is None:
        return numbers.NO_ENTRY
    return markup.escaped(str(value)) if isinstance(value, str) else value


def as_markdown(function):
    """A filter whose result is Markdown already."""
    return lambda *values, **named: markup.Markdown(function(*values, **named))


def environment(folder, names):
    """The templates of the folder, which know these names."""
    made = jinja2.Environment(loader=jinja2.FileSystemLoader(folder), undefined=jinja2.StrictUndefined,
                              trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True, finalize=shown, autoescape=True)
    made.filters |= {function.__name__: as_markdown(function) for function in
                     (numbers.rounded, numbers.unrounded, numbers.grouped, numbers.interval)}
    # A per cent is escaped, because a line that begins with > would be a quotation.
    made.filters |= {"percent": lambda *values: markup.escaped(numbers.percent(*values)), "code": markup.code, "typeset": markup.typeset, "marked": markup.marked, "link": markup.link,
                     "enhanced": drawing.enhanced, "md": markup.Markdown, "commit": sections.short_commit}
    made.globals |= {"provenance": sections.provenance, "measured": sections.measured, **names}
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path, help="the report's folder, with report.json in it")
    out = parser.parse_args().out
    report = drawing.read_data(out / "report.json")
    figures = Figures(out, report["files"])
    text = environment(HERE / "templates", {"figure": figures.figure, "sweep_figure": figures.sweep_figure,
                                            "sweep_pictures": sweep_pictures,
                                            "has_field": (out / "field.html").is_file(), **report})
    made = sections.Page(report, text, figures)
    drawing.write_text(out / "report.md", made.markdown)
    drawing.write_text(out / "index.html", made.html)
    drawing.show_step("")
    print(json.dumps({"written": figures.written + ["report.md", "index.html"],
                      "undrawn": figures.undrawn}))


if __name__ == "__main__":
    main()
