# SPDX-License-Identifier: Apache-2.0
"""Texts that other people write into baselines and scenes stay plain text on the page and in its pictures."""

import html.parser
import json
import pathlib
import re
import shutil
import unittest
import xml.etree.ElementTree

from program import Folder, folder_until, run
from report_files import ROOT, report

WORD = ("=<script>alert(1)</script><img src=x onerror=alert(2)>\x1b[31m\u009b1m\u202e & &lt;b&gt; | `c` ~d~ ^e^ [f](javascript:g) "
        "![h](http://x.example/i) {/Symbol j}_k^l@m {{ 7*7 }} {% x %} \" ' \\ $(n)\n# o\n\n<h1>p</h1>\n\n```\n")
SECTIONS = ["verification", "worst-inputs", "mutants", "planted-faults", "diagnosis", "work-precision", "gates", "sweep-speed",
            "environment"]
CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


class Live(html.parser.HTMLParser):
    """The live parts of a page: its elements, its links, and the events that its elements react to."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.links, self.reactions = {}, set(), []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags[tag] = self.tags.get(tag, 0) + 1
        self.links |= {value for name, value in attributes if name in ("href", "src", "xlink:href") and "#" not in value}
        self.reactions += [name for name, _ in attributes if name.startswith("on")]


def changed(value, keys, word):
    """Appends the word to each text under one of these keys, at any depth. If `keys` is None, it does so to all texts and most keys."""
    if isinstance(value, list):
        return [changed(one, keys, word) for one in value]
    if not isinstance(value, dict):
        return value
    made = {}
    for name, one in value.items():
        ours = keys is None or name in keys
        if isinstance(one, str) and ours:
            one += word
        elif isinstance(one, list) and ours:
            one = [each + word if isinstance(each, str) else each for each in one]
        made[name if keys is not None or name in ("environment", "commit", "date") else name + word] = changed(one, keys, word)
    return made


def names_of_texts(value):
    if isinstance(value, list):
        return set().union(*map(names_of_texts, value))
    if not isinstance(value, dict):
        return set()
    own = {name for name, one in value.items()
           if isinstance(one, str) or (isinstance(one, list) and any(isinstance(each, str) for each in one))}
    return own.union(*map(names_of_texts, value.values()))


class Baselines(unittest.TestCase):
    def setUp(self):
        self.project = folder_until(self.addCleanup)
        for part in ("published", "scenes", "baselines"):
            shutil.copytree(ROOT / "reference" / part, self.project / "reference" / part)
        for part in ("reference/ehl", "reference/exact", "reference/mistakes.toml", "reports/page"):
            (self.project / part).parent.mkdir(parents=True, exist_ok=True)
            (self.project / part).symlink_to(ROOT / part)
        self.good = {path.name: json.loads(path.read_text()) for path in (self.project / "reference/baselines").glob("*.json")}
        self.out = self.project / "reports/out"

    def write(self, keys, word):
        for name, baseline in self.good.items():
            chosen = keys(name) if callable(keys) else keys
            (self.project / "reference/baselines" / name).write_text(json.dumps(changed(baseline, chosen, word)))

    def page(self, *options, pictures=True, sections=SECTIONS):
        asked = [word for name in sections for word in ("--section", name)]
        environment = {} if pictures else {"PATH": str(self.project / "empty")}
        done = report(*asked, *options, cwd=self.project, environment=environment)
        self.assertIn(done.code, (0, 1), done.err)
        self.assertIsNone(CONTROLS.search(done.out + done.said))
        page = (self.out / "index.html").read_text(encoding="utf-8")
        for text in (page, (self.out / "report.md").read_text(encoding="utf-8")):
            self.assertIsNone(CONTROLS.search(text))
        return Live(page), json.loads((self.out / "report.json").read_text(encoding="utf-8"))

    def assert_dead(self, live, good):
        self.assertLessEqual(set(live.tags), set(good.tags) | {"em"})  # <em> tells "not drawn": gnuplot does not find changed names
        self.assertEqual(live.tags["script"], good.tags["script"])
        self.assertEqual(live.tags.get("img", 0), good.tags.get("img", 0))
        self.assertEqual(live.tags["h1"], good.tags["h1"])
        self.assertLessEqual(live.links, good.links)
        self.assertEqual(live.reactions, [])
        markdown = (self.out / "report.md").read_text(encoding="utf-8")
        self.assertIsNone(re.search(r"(?m)^\s*(<h1>|<script|# o$|```$)", markdown))
        for picture in self.out.rglob("*.svg"):
            root = xml.etree.ElementTree.parse(picture).getroot()
            self.assertFalse([one.tag for one in root.iter() if one.tag.endswith("script")], picture)

    def missing(self, made):
        return {name for name, group in made.items() if isinstance(group, dict) and "missing" in group} | {
            f"{name}.{part}" for name, group in made.items() if isinstance(group, dict)
            for part, one in group.items() if isinstance(one, dict) and "missing" in one}

    def test_in_each_text_of_each_baseline(self):
        drawn, made = self.page()
        good, _ = self.page(pictures=False)
        none_missing = self.missing(made)
        self.write(None, WORD)  # no baseline can be read any more
        live, _ = self.page(pictures=False)
        self.assert_dead(live, good)
        names = set().union(*map(names_of_texts, self.good.values()))
        self.assertLessEqual({"commit", "date", "cpu", "compiler", "fault", "check", "family", "series", "job"}, names)
        for key in ("job", "name", "kernel"):  # texts that name files, and texts that are drawn
            self.write({key}, "/../../" + WORD)
            live, _ = self.page(pictures=False)
            self.assert_dead(live, good)
        outside = [path for path in self.project.rglob("*") if "x.example" in path.name or "alert" in str(path)]
        self.assertEqual(outside, [])
        free = names - {"job"}
        self.write(free, WORD)
        live, made = self.page("--commit", WORD)
        self.assertEqual(self.missing(made), none_missing)
        self.assert_dead(live, drawn)
        self.assertGreater(len(list(self.out.rglob("*.svg"))), 10)
        self.assertEqual(made["environment"]["commit"], WORD)
        for one in made["environment"]["baselines"]:
            if one["date"] != "unknown":
                self.assertTrue(one["date"].endswith(WORD))

    def test_in_the_ids_of_scenes(self):
        sections = ["figures", "contacts", "film-solved", "model"]
        good, _ = self.page(sections=sections)
        named = []
        for path in (self.project / "reference").rglob("*.toml"):
            text = path.read_text()
            if path.parent.name != "sweeps" and re.search(r"(?m)^id = ", text):
                path.write_text(re.sub(r'(?m)^id = "(.*)"', lambda m: "id = " + json.dumps(m[1] + WORD), text))
                named.append(re.search(r'(?m)^id = "(.*)"', text)[1] + WORD)
        self.assertGreater(len(named), 3)
        live, made = self.page(sections=sections)
        self.assert_dead(live, good)
        self.assertGreater(len(list(self.out.rglob("*.svg"))), 5)


class Pictures(unittest.TestCase):
    def test_of_a_film_and_of_a_sweep(self):
        folder = Folder()
        self.addCleanup(folder.cleanup)
        text = (ROOT / "reference/scenes/gear_flank.toml").read_text()
        text = text.replace('id = "gear_flank"', "id = " + json.dumps(WORD))
        path, picture = folder.write("a.toml", text), folder.path("a.svg")
        done = run("film", path, "--speed", "1", "--tolerance", "0.01", "--picture", picture)
        self.assertIn(done.code, (0, 1), done.said)
        self.assertIsNone(CONTROLS.search(done.out + done.said))
        xml.etree.ElementTree.parse(picture)
        text = (ROOT / "reference/published/sweeps/onset_smooth.toml").read_text()
        text = re.sub(r'(?m)^id = ".*"', lambda m: "id = " + json.dumps(WORD.replace("/", "")), text)
        text = re.sub(r"(?m)^draws = .*", "draws = 64", text)
        done = run("sweep", folder.write("b.toml", text), "-o", folder.path("b.h5"), "--pictures", folder.path("pictures")).ended(0)
        self.assertIsNone(CONTROLS.search(done.out + done.said))
        drawn = list(pathlib.Path(folder.path("pictures")).rglob("*.svg"))
        self.assertTrue(drawn)
        for one in drawn:
            xml.etree.ElementTree.parse(one)


if __name__ == "__main__":
    unittest.main()
