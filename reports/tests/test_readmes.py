# SPDX-License-Identifier: Apache-2.0
"""The Markdown files of the tree: each link leads to a file, and to a heading of it; counts are those of the tree."""
import os
import pathlib
import re
import unittest

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
NOT_OURS = {"build", "out", "node_modules"}  # made, not written
PARTS_OF_THE_PAGE = ROOT / "reports/page/render/templates"  # whose headings and links belong to one page


def pages():
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [one for one in folders if one not in NOT_OURS and not one.startswith(".")]
        if pathlib.Path(folder) != PARTS_OF_THE_PAGE:
            yield from (pathlib.Path(folder, name) for name in names if name.endswith(".md"))


def prose(page):
    """The text without blocks of code."""
    return re.sub(r"(?ms)^```.*?^```", "", page.read_text(encoding="utf-8"))


def anchors(page):
    """The names that GitHub gives to the headings."""
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in re.findall(r"(?m)^#+ (.*)$", prose(page))}


def broken_links(page):
    for link in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        path, _, heading = link.partition("#")
        target = page.parent / path if path else page
        if re.match("https?:|mailto:", link):
            continue
        if not target.exists():
            yield f"{page.relative_to(ROOT)}: {link}: there is no such file"
        elif heading and target.suffix == ".md" and heading not in anchors(target):
            yield f"{page.relative_to(ROOT)}: {link}: there is no such heading"


class Readmes(unittest.TestCase):
    def test_links_lead_somewhere(self):
        found = list(pages())
        self.assertGreater(len(found), 10)
        self.assertEqual([line for page in found for line in broken_links(page)], [])

    def test_the_number_of_fakes_is_that_of_their_list(self):
        fakes = re.findall(r"(?m)^\| `(\w+)` \|", (ROOT / "verification/conformance/subjects/fakes/README.md").read_text(encoding="utf-8"))
        told = [int(number) for page in pages() for number in re.findall(r"\b(\d+) fakes\b", prose(page))]
        self.assertTrue(told)
        self.assertEqual(set(told), {len(fakes)})


if __name__ == "__main__":
    unittest.main()
