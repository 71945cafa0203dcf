# SPDX-License-Identifier: Apache-2.0
"""The sections of the page in their order, each a template, and the page that they make."""
import html
import itertools
import pathlib
import re
import typing

import jinja2
import jinja2.meta
import jinja2.nodes
import live_part
import markup
from section_table import SECTIONS

HERE = pathlib.Path(__file__).resolve().parent


STANDINGS = {"holds": "holds", "differs": "differs", "fails": "FAILS", "missed": "missed",
             "measured": "measured", "absent": "not run"}
# The same about the paper's claims and numbers, in the words of the ledger.
OF_PAPER = STANDINGS | {"holds": "reproduced", "differs": "partly"}


def short_commit(commit):
    """The first twelve digits, and what stands after the hash: 0123456789ab and changes."""
    digits = re.match(r"[0-9a-f]*", commit)[0]
    return markup.code(digits[:12] + commit[len(digits):])


def measured(baseline):
    return markup.Markdown(f"Measured on {markup.escaped(baseline['date'])} at commit {short_commit(baseline['commit'])}.")


def provenance(baseline):
    took = f", in {baseline['seconds']:.0f} s" if "seconds" in baseline else ""
    machine = baseline["environment"]
    return markup.Markdown(f"Measured on {markup.escaped(baseline['date'])} at commit {short_commit(baseline['commit'])}{took}; "
                           f"{markup.escaped(machine['cpu'])}; {markup.escaped(machine['compiler'])}.")


class Made(typing.NamedTuple):
    """A section of the page, as Markdown."""
    id: str
    title: str
    text: str
    is_folded: bool


class Page:
    def __init__(self, report, templates, figures):
        self.report, self.templates, self.figures = report, templates, figures
        self.sentences = {}  # the findings' sentences, by their ids
        self.missing = list(report["not_run"])
        self.parts = [self.section(name) for name in SECTIONS if name in report["sections"]]
        self.missing += figures.missing
        not_run = self.render("not-run.md", missing=self.missing)[0]
        self.parts.append(Made("not-run", "What is missing from this page", not_run, False))
        data = self.render("data.md", files=report["files"])[0]
        self.parts.append(Made("data", "Data", data, True))
        self.first = self.render("first.md", findings=self.findings)[0]

    def render(self, template, **more):
        module = self.templates.get_template(template).make_module(more)
        return self.without_dead_links(markup.indices(str(module))), module

    def without_dead_links(self, text):
        """The text, in which a link to a section that was not asked for is plain text."""
        there = (*self.report["sections"], "not-run", "data")
        return re.sub(r"\[([^\[\]]*)\]\(#([a-z-]+)\)", lambda m: m[0] if m[2] in there else m[1], text)

    def section(self, name):
        one = SECTIONS[name]
        texts = [self.part(one.title, f"{template}.md") for template in (name, *one.further)]
        return Made(name, one.title, "\n".join(texts), one.is_folded)

    def missing_data(self, template):
        """Why data of a template are missing, by the first missing group of report.json that it or an imported template reads; or None."""
        tree = self.templates.parse((HERE / "templates" / template).read_text(encoding="utf-8"))
        for name in sorted({node.name for node in tree.find_all(jinja2.nodes.Name)}):
            group = self.report.get(name)
            if isinstance(group, dict) and "missing" in group:
                return group["missing"]
        imported = map(self.missing_data, jinja2.meta.find_referenced_templates(tree))
        return next(filter(None, imported), None)

    def part(self, title, template):
        """The text of one template, or why it is missing; keeps the sentences of its findings."""
        absent = self.missing_data(template)
        if absent is not None:
            self.missing.append({"what": title, **absent})
            return self.render("missing.md", missing=absent)[0]
        text, module = self.render(template)
        for attribute in dir(module):
            if attribute.startswith("finding_"):
                self.sentences[attribute.removeprefix("finding_")] = markup.indices(getattr(module, attribute)).strip()
        return text

    def findings(self, about):
        """The findings about the paper, or about the software; broken promises first, then missed targets."""
        ours = [one for one in self.report["findings"] if one["about"] == about]
        ours.sort(key=lambda one: (one["standing"] != "fails", one["standing"] != "missed"))
        for one in ours:
            said = self.sentences.get(one["id"]) or markup.indices(markup.escaped(one.get("why") or "It has no data."))
            word = self.of_paper(one) if about == "paper" else STANDINGS[one["standing"]]
            yield one["standing"], word, one["section"], markup.Markdown(SECTIONS[one["section"]].title), markup.Markdown(said)

    def of_paper(self, found):
        """The standing of a finding on the paper in the ledger's words: the worst of its numbers' verdicts."""
        compared = self.report.get("paper", {}).get("comparisons", {}).get(found["id"], {"rows": []})
        if found["standing"] == "differs" and any(row["verdict"] == "not reproduced" for row in compared["rows"]
                                                  if row["criterion"] in (None, "film_maximum")):
            return "not reproduced"
        return OF_PAPER[found["standing"]]

    @property
    def markdown(self):
        text = self.first
        for part in self.parts:
            text += f'\n<a id="{part.id}"></a>\n\n## {part.title}\n\n{part.text}'
        text = re.sub(r"<template\b.*?</template>\n?", "", text, flags=re.DOTALL)
        text = text.replace("</summary>\n", "</summary>\n\n")
        text = re.sub(r"</?(?:figure|figcaption|details|summary|div|span)\b[^>]*>\n?", "", text)
        return re.sub(r"\n{3,}", "\n\n", text)

    @property
    def html(self):
        if "live" not in self.report["sections"]:
            return html_of(self.first, self.parts, self.figures.into)
        style, scripts = live_part.parts(self.figures.out)
        page = html_of(self.first, self.parts, self.figures.into, style)
        return page.replace("</body>", f"{scripts}</body>")


def html_of(first, parts, with_pictures=str, more_style=""):
    """The page of a first part and sections, each Markdown; more_style is appended to style.css."""
    numbers = {part.id: i for i, part in enumerate(parts, 1)}
    frame = (HERE / "layout.html").read_text(encoding="utf-8")
    style, script = ((HERE / name).read_text(encoding="utf-8") for name in ("style.css", "comfort.js"))
    contents = "".join(f'<li><a href="#{part.id}" data-number="{i}">{markup.inline_html(part.title)}</a></li>\n'
                       for i, part in enumerate(parts, 1))
    body = "".join(part_html(part, numbers, with_pictures) for part in parts)
    title = re.search(r"(?m)^# (.*)$", first)[1]
    return (frame.replace("{{title}}", html.escape(markup.plain(title))).replace("{{style}}", style + more_style).replace("{{script}}", script)
            .replace("{{contents}}", contents).replace("{{first}}", with_section_numbers(markup.section_html(first), numbers))
            .replace("{{sections}}", body))


def with_section_numbers(text, numbers):
    """The HTML, in which each link to a section has the section's number, which the printed page shows."""
    return re.sub(r'<a href="#([a-z-]+)"', lambda m: f'{m[0]} data-section="{numbers[m[1]]}"' if m[1] in numbers else m[0], text)


def part_html(part, numbers, with_pictures):
    """A section, numbered as its tables and pictures are; style.css shows the numbers."""
    number = numbers[part.id]
    title = markup.inline_html(part.title)
    text = with_section_numbers(markup.section_html(part.text), numbers)
    for what, start in (("Table", "<caption><span"), ("Picture", r'<figure id="\w+">\s*<h3')):
        count = itertools.count(1)
        text = re.sub(start, lambda m: f'{m[0]} data-number="{what} {number}.{next(count)}"', text)
    text = with_pictures(text)
    heading = f'<h2 id="{part.id}-heading" data-number="{number}">{title}</h2>'
    inside = (f"<details>\n<summary>{heading}</summary>\n{text}</details>\n" if part.is_folded
              else f"{heading}\n{text}")
    return f'<section id="{part.id}" aria-labelledby="{part.id}-heading">\n{inside}</section>\n'
