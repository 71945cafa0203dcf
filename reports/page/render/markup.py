# SPDX-License-Identifier: Apache-2.0
"""From data to Markdown, and from Markdown to the page's HTML."""
import html
import re

import cmarkgfm
import markupsafe
from cmarkgfm.cmark import Options

# Text that is Markdown already. Jinja escapes all other text, by escaped().
Markdown = markupsafe.Markup

SPECIAL = re.compile(r"([\\`*_\[\]|#<>~^&])")
CODE = re.compile(r"(?<!\\)(?P<ticks>`+)(?!`)[^\n]*?(?<!`)(?P=ticks)(?!`)")
CODE_OR_TEXT = re.compile(r"`[^`]+`|[^`]+|`")


def escaped(text):
    return Markdown(SPECIAL.sub(r"\\\1", str(text)))


def marked(text):
    """A text of the data that has the marks of the templates: h~ff~, m^2^ and `code`."""
    return Markdown("".join(part.replace("|", "\\|") if CODE.fullmatch(part) else
                            re.sub(r"([\\`*_\[\]|#<>&])", r"\\\1", part) for part in CODE_OR_TEXT.findall(str(text))))


def code(text):
    """The text as code, in as many backticks as it needs. An empty text gives "": Markdown has no empty code."""
    if not text:
        return Markdown("")
    fence = "`" * (1 + max(map(len, re.findall("`+", text)), default=0))
    space = " " if text[:1] == "`" or text[-1:] == "`" else ""
    return Markdown(f"{fence}{space}{text}{space}{fence}".replace("|", "\\|"))


def link(path, text=None):
    return Markdown(f"[{escaped(text or path.rsplit('/', 1)[-1])}]({path})")


# F_5/2, σ_s, e^−0.73 and film_maximum in a text of the data.
TYPESET = re.compile(r"""
    (?<![A-Za-z0-9_])(?P<name>[a-z]{2,}_[a-z0-9_.]*[a-z0-9_])
  | (?<=[^\W\d_])_(?P<sub>[A-Za-z0-9]+(?:(?<=\d)/\d+)?)
  | \^(?P<super>−?\d+(?:[./]\d+)*|[A-Za-z])
""", re.VERBOSE)


def typeset(text):
    """A formula of the data: its names as code, its indices and exponents set as such."""
    made, at = "", 0
    for match in TYPESET.finditer(text):
        made += escaped(text[at:match.start()])
        made += (code(match["name"]) if match["name"] else
                 Markdown(f"<sub>{match['sub']}</sub>" if match["sub"] else f"<sup>{match['super']}</sup>"))
        at = match.end()
    return Markdown(made + escaped(text[at:]))


# h~ff~ and m^2^ of the templates, outside of code.
INDEX = re.compile(rf"(?P<code>{CODE.pattern})|(?<!\\)~(?P<sub>[^~\s|`]+)~|(?<!\\)\^(?P<super>[^^\s|`]+)\^")


def indices(text):
    return INDEX.sub(lambda m: m["code"] or (f"<sub>{m['sub']}</sub>" if m["sub"] else f"<sup>{m['super']}</sup>"), text)


def plain(markdown):
    """The plain text of Markdown, for labels and descriptions."""
    return html.unescape(re.sub(r"<[^>]*>", "", to_html(indices(markdown)))).strip()


def to_html(markdown):
    """HTML, with GitHub's additions to Markdown except links of bare addresses, which may stand in texts of others."""
    return cmarkgfm.markdown_to_html_with_extensions(str(markdown), Options.CMARK_OPT_UNSAFE,
                                                     ["table", "strikethrough", "tagfilter"])


def inline_html(markdown):
    return to_html(indices(markdown)).strip().removeprefix("<p>").removesuffix("</p>")


TABLE = re.compile(r"(?:<p><strong>((?:(?!</p>).)*?)</strong></p>\s*)?<table>(.*?)</table>", re.DOTALL)
ROW = re.compile(r"<tr>(.*?)</tr>", re.DOTALL)
CELL = re.compile(r"<t[hd](?: align=\"(\w+)\")?>(.*?)</t[hd]>", re.DOTALL)
LONG = 25  # rows; more are scrolled under their headings


def column_class(cells, align):
    if align == "right":
        return "number"
    longest = max((len(re.sub(r"<[^>]*>", "", cell)) for cell in cells), default=0)
    return "word" if longest <= 24 else "line" if longest <= 60 else "prose" if longest <= 200 else "list"


def table_html(match):
    """A table with its caption, set to scroll by itself where it is wider than the screen."""
    rows = [CELL.findall(row) for row in ROW.findall(match[2])]
    head, body = rows[0], rows[1:]
    classes = [column_class([row[i][1] for row in body], align) + (" verdict" if name == "verdict" else "")
               for i, (align, name) in enumerate(head)]
    lines = ["".join(f'<th scope="col" class="{kind}">{cell}</th>' for kind, (_, cell) in zip(classes, head))]
    lines += ["".join(f'<th scope="row" class="{kind}">{cell}</th>' if i == 0 else f'<td class="{kind}">{cell}</td>'
                      for i, (kind, (_, cell)) in enumerate(zip(classes, row))) for row in body]
    caption = match[1] or ""
    count = f" ({len(body)} rows)" if len(body) > LONG else ""
    label = html.escape(html.unescape(re.sub(r"<[^>]*>", "", caption)))
    joined = "</tr>\n<tr>".join(lines[1:])
    return (f'<div class="scroll table{" long" if count else ""}" tabindex="0" role="region" aria-label="{label}">\n'
            f"<table>\n" + (f"<caption><span>{caption}{count}</span></caption>\n" if caption else "") +
            f"<thead>\n<tr>{lines[0]}</tr>\n</thead>\n<tbody>\n<tr>{joined}</tr>\n</tbody>\n</table>\n</div>\n"
            '<p class="hint">Wider than this screen: scroll the table sideways.</p>')


def breakable_code(match):
    """A long name may go on in the next line after a point, a slash or an underscore, if four or more letters follow: .cpp stays."""
    return "<code>" + re.sub(r"([./_])(?=\w{4})", r"\1<wbr>", match[1]) + "</code>"


def section_html(markdown):
    text = TABLE.sub(table_html, to_html(markdown))
    return re.sub(r"<code>(.*?)</code>", breakable_code, text)
