# SPDX-License-Identifier: Apache-2.0
"""Each relative link in a Markdown page leads to a file of the project, and to a heading of that file. Counts of fakes are right."""

import os
import pathlib
import re
import unittest
import urllib.parse

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"]).resolve()
# Built folders, and the templates of the page: their links are for the finished page.
LEFT_OUT = {"build", "out", "templates"}


def pages():
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in LEFT_OUT and not name.startswith(".")]
        yield from (pathlib.Path(folder, name) for name in names if name.endswith(".md"))


def without_code(text):
    return re.sub(r"(?ms)^```.*?^```$|(`+)(?!`).*?(?<!`)\1(?!`)", "", text)


def links(text):
    """Targets of links and pictures; a target in angle brackets may have blanks."""
    return [one.strip("<>") for one in re.findall(r"\]\((<[^>\n]*>|[^()\s]*)\)", without_code(text))]


def anchors(text):
    """The names that GitHub and GitLab give to headings. A heading whose text was there before gets a number."""
    found = []
    for heading in re.findall(r"(?m)^#{1,6} +(.*?) *#*$", re.sub(r"(?ms)^```.*?^```$", "", text)):
        name = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()).replace(" ", "-")
        found.append(name)
        again = found.count(name) - 1
        if again:
            found[-1] = f"{name}-{again}"
    return found


def broken(page, text):
    """One sentence for each broken link of a page. Links to other sites are not checked."""
    problems = []
    for link in links(text):
        target, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:", link):
            continue
        file = page.parent / urllib.parse.unquote(target) if target else page
        if not file.exists() or ROOT not in [file.resolve(), *file.resolve().parents]:
            problems.append(f"{link}: no such file")
        elif anchor and (file.suffix != ".md" or anchor not in anchors(
                text if file == page else file.read_text(encoding="utf-8"))):
            problems.append(f"{link}: no such heading")
    return problems


class Links(unittest.TestCase):
    def test_each_leads_somewhere(self):
        seen = 0
        for page in pages():
            text = page.read_text(encoding="utf-8")
            seen += len(links(text))
            with self.subTest(page=str(page.relative_to(ROOT))):
                self.assertEqual(broken(page, text), [])
        self.assertGreater(seen, 30)

    def test_one_that_leads_nowhere_is_noticed(self):
        text = ("# One heading\n## The `λ` of it, twice\n## The `λ` of it, twice\n"
                "[a](#one-heading) [b](#the-λ-of-it-twice-1) [c](README.md) ![d](reports) [e](https://none.example)\n"
                "`[f](none)` [g](none.md) [h](#two-headings) [i](model/README.md#none) [j](LICENSE#none) [k](../none)\n"
                "```\n[l](none)\n```\n")
        self.assertEqual(broken(ROOT / "README.md", text),
                         ["none.md: no such file", "#two-headings: no such heading", "model/README.md#none: no such heading",
                          "LICENSE#none: no such heading", "../none: no such file"])


class Counts(unittest.TestCase):
    def test_the_number_of_fakes_is_that_of_their_list(self):
        fakes = re.findall(r"(?m)^\| `(\w+)` \|", (ROOT / "verification/conformance/subjects/fakes/README.md").read_text(encoding="utf-8"))
        told = [int(number) for page in pages() for number in re.findall(r"\b(\d+) fakes\b", without_code(page.read_text(encoding="utf-8")))]
        self.assertTrue(told)
        self.assertEqual(set(told), {len(fakes)})


if __name__ == "__main__":
    unittest.main()
