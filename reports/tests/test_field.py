# SPDX-License-Identifier: Apache-2.0
"""tribocheck field: each cell of its pages is that of matrix.json and of the verdicts; the pages in a browser; changes, badges,
refusals; and the script that asks solvers, each in a sandbox."""

import copy
import html.parser
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import tomllib
import unittest
import urllib.parse
import xml.etree.ElementTree as xml

from conformance import SUBJECTS
from program import ENVIRONMENT, PROGRAM, ProgramTest, run
from test_page import CLIPPED, CONTRAST, UNNAMED_REGIONS, browser

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
STATUSES = ["held", "held in the physical range", "held in part", "FAILED", "not offered"]
SMALL = f"{sys.executable} {SUBJECTS}/small_python/my_solver.py"


class Tables(html.parser.HTMLParser):
    """The tables of a page, as rows of cells. A cell has its text, and the title, link and class of the elements in it."""
    def __init__(self, text):
        super().__init__()
        self.tables, self.cell = [], None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("th", "td"):
            self.cell = {"text": "", "title": "", "href": "", "class": ""}
            self.tables[-1][-1].append(self.cell)
        elif self.cell is not None:
            self.cell |= {name: value for name, value in attributes if name in ("title", "href", "class")}

    def handle_endtag(self, tag):
        if tag in ("th", "td"):
            self.cell = None

    def handle_data(self, data):
        if self.cell is not None:
            self.cell["text"] += data


class Field(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.small = json.loads(run("verify", "--subject", SMALL, "--sample", "5", "--format", "json").out)

    def setUp(self):
        super().setUp()
        os.mkdir(self.folder.path("verdicts"))

    def add(self, stem, said=None, **about):
        fields = {"name": stem, "language": "Python", "date": "2026-11-28", **about}
        self.folder.write(f"verdicts/{stem}.toml", "".join(f"{key} = {json.dumps(value)}\n" for key, value in fields.items()))
        self.folder.write(f"verdicts/{stem}.json", json.dumps(said or self.small))

    def turned(self, by):
        """A verdict in which the quantities have the statuses in turn, beginning with the one of this number."""
        said = copy.deepcopy(self.small)
        for i, one in enumerate(said["quantities"]):
            one["status"] = STATUSES[(i + by) % len(STATUSES)]
        return said

    def made(self):
        run("field", self.folder.path("verdicts"), "-o", self.folder.path("out.html")).ended(0, "")
        told = run("field", self.folder.path("verdicts"), "--format", "json")
        self.assertEqual((told.code, told.out), (0, self.text("out/matrix.json")))
        return json.loads(told.out)

    def text(self, name):
        return pathlib.Path(self.folder.path(name)).read_text(encoding="utf-8")

    def refused(self, *said, arguments=()):
        result = run("field", self.folder.path("verdicts"), *arguments)
        self.assertEqual((result.code, result.out, len(result.err.splitlines())), (2, "", 1), result.err)
        for one in said:
            self.assertIn(one, result.err)


class Pages(Field):
    NAMES = ["<b>plain</b> & | `x` *y*", "_two_ [3](#4)", "three"]
    IDS = ["b_plain_b_x_y", "two_3_4", "three"]  # of the pages of these solvers

    def setUp(self):
        super().setUp()
        for i, name in enumerate(self.NAMES):
            self.add(f"s{i}", self.turned(i), name=name, licence=f"L|{i}", address="https://example.org/a_b_c", commit=f"{i}" * 40,
                     conventions="E* & <i>k</i>", group="g")

    def test_each_cell_of_the_matrix_is_that_of_the_verdict(self):
        document = self.made()
        tables = Tables(self.text("out.html")).tables
        (groups, head, *rows), = [table for table in tables if len(table) > 1 and table[1][0]["text"] == "quantity"]
        self.assertEqual([cell["text"] for cell in groups], ["", "g"])
        self.assertEqual({cell["title"] for cell in head[1:]}, {"E* & <i>k</i>"})
        columns = [cell["text"] for cell in head[1:]]
        self.assertEqual(sorted(columns), sorted(self.NAMES))
        signs = {}
        for row in rows:
            for name, cell in zip(columns, row[1:], strict=True):
                i = self.NAMES.index(name)
                verdicts = {one["quantity"]: one["status"] for one in self.turned(i)["quantities"]}
                solver, = (one for one in document["solvers"] if one["name"] == name)
                word = verdicts[row[0]["text"]]
                self.assertEqual((cell["title"].split(". ")[0].rstrip("."), solver["cells"][row[0]["text"]]), (word, word), (name, row[0]))
                signs.setdefault(word, set()).add((cell["text"], cell["class"]))
                if word != "not offered":
                    self.assertEqual(urllib.parse.unquote(cell["href"]), f"out/{self.IDS[i]}.html#{row[0]['text']}")
                    self.assertEqual(self.text(f"out/{self.IDS[i]}.html").count(f'id="{row[0]["text"]}"'), 1)
        self.assertEqual({word: len(found) for word, found in signs.items()}, dict.fromkeys(STATUSES, 1), signs)
        self.assertEqual(len({sign for found in signs.values() for sign, _ in found}), len(STATUSES))
        self.assertEqual([row[0]["text"] for row in rows], document["quantities"])
        self.assertNotIn("No solver offers", self.text("out.html"))

    def test_quantities_that_no_solver_offers_are_named_below_the_matrix(self):
        for i in range(3):
            self.add(f"s{i}", name=self.NAMES[i])
        self.made()
        told = re.sub("<[^>]*>", "", re.search("(?s)No solver offers .*?</p>", self.text("out.html"))[0])
        self.assertEqual(re.findall(r"[\w.]+", told.removeprefix("No solver offers ").rstrip(".")),
                         [one["quantity"] for one in self.small["quantities"] if one["status"] == "not offered"])

    def test_each_cell_of_the_other_tables_is_that_of_the_verdict(self):
        self.made()
        head, *rows = Tables(self.text("out.html")).tables[0]
        self.assertEqual(len(rows), 3)
        for row in rows:
            i = self.NAMES.index(row[0]["text"])
            statuses = [one["status"] for one in self.turned(i)["quantities"]]
            told = dict(zip([cell["text"] for cell in head], [cell["text"] for cell in row], strict=True))
            self.assertEqual((told["licence"], told["group"], told["language"], told["date"], told["overall"]),
                             (f"L|{i}", "g", "Python", "2026-11-28", "failed"))
            self.assertEqual((told["held"], told["in part"], told["failed"]),
                             (str(sum(one.startswith("held") and "part" not in one for one in statuses)),
                              str(statuses.count("held in part")), str(statuses.count("FAILED"))))
            self.assertRegex(self.small["diagnoses"][0]["text"], "^" + re.escape(told["what is wrong"].strip().removesuffix(" …")))
            self.assertGreater(len(told["what is wrong"]), 150)
            about, numbers, history = Tables(self.text(f"out/{self.IDS[i]}.html")).tables
            about = {one["text"]: other["text"] for one, other in about}
            self.assertEqual((about["address"], about["commit"], about["licence"], about["conventions"], about["tolerance"]),
                             ("https://example.org/a_b_c", f"{i}" * 40, f"L|{i}", "E* & <i>k</i>", "engineering: 1e-6 of the value, times its condition"))
            offered = [one for one in self.turned(i)["quantities"] if one["status"] != "not offered"]
            self.assertEqual([[cell["text"] for cell in row[:5]] + [row[6]["text"]] for row in numbers[1:]],
                             [[one["quantity"], one["status"].lower(), *(str(one[key]) for key in ("held", "failed", "skipped", "worst_case"))]
                              for one in offered])
            for row, one in zip(numbers[1:], offered):
                text = row[5]["text"].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")).replace(" × 10", "e")
                self.assertAlmostEqual(float(text) / (one["worst_relative_error"] or 1), bool(one["worst_relative_error"]), delta=0.06)
            self.assertEqual([cell["text"] for cell in history[1]], ["2026-11-28", str(i) * 12, self.small["version"], "failed", told["held"],
                                                                     told["in part"], told["failed"]])

    def test_in_a_browser_it_fits_phone_and_screen_in_light_and_dark_and_can_be_reached_by_keyboard(self):
        self.made()
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            driver = browser(profile)
            self.addCleanup(driver.quit)
            for page in ("out.html", "out/b_plain_b_x_y.html"):
                for width in (390, 1400):
                    for scheme, media in (("light", ""), ("dark", ""), ("light", "print")):
                        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                            "media": media, "features": [{"name": "prefers-color-scheme", "value": scheme}]})
                        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                            "width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})
                        driver.get(pathlib.Path(self.folder.path(page)).as_uri())
                        with self.subTest(page=page, width=width, scheme=scheme, media=media):
                            if not media:
                                self.assertLessEqual(driver.execute_script("return document.documentElement.scrollWidth - innerWidth"), 0)
                                self.assertEqual(driver.execute_script(CLIPPED), [])
                                self.assertEqual(driver.execute_script(UNNAMED_REGIONS), [])
                            self.assertGreaterEqual(driver.execute_script(CONTRAST)[0], 4.5)
                            self.assertEqual(driver.get_log("browser"), [])
                            links = driver.execute_script("return [...document.links].map((one) => [one.href, one.tabIndex])")
                            for link, order in links:
                                self.assertEqual(order, 0, link)
                                path = urllib.parse.urlparse(link)
                                self.assertTrue(path.scheme != "file" or os.path.exists(urllib.parse.unquote(path.path)), link)
            self.assertGreater(len(links), 5)

    def test_a_badge_says_how_much_held_and_its_colour_whether_something_failed(self):
        said = {"failed": self.small, "right": copy.deepcopy(self.small), "partly": copy.deepcopy(self.small)}
        for name in ("right", "partly"):
            for one in said[name]["quantities"]:
                if one["status"] in ("FAILED", "held in part"):
                    one["status"] = "held"
        said["partly"]["quantities"][0]["status"] = "held in part"
        for name, verdict in said.items():
            self.add(name, verdict)
        self.made()
        for name, message, colour in (("failed", "4 of 5 held", "b3001b"), ("right", "5 of 5 held", "0b6b3a"), ("partly", "5 of 6 held", "8a4b00")):
            self.assertEqual(json.loads(self.text(f"out/{name}.badge.json")),
                             {"schemaVersion": 1, "label": "tribocheck", "message": message, "color": colour})
            svg = xml.fromstring(self.text(f"out/{name}.svg"))
            self.assertEqual(svg.get("aria-label"), f"tribocheck: {message}")
            self.assertEqual([one.get("fill") for one in svg.iter("{http://www.w3.org/2000/svg}rect")][1], f"#{colour}")

    def test_the_line_that_repeats_a_worst_case_does(self):
        self.add("small", asked=f"tribocheck verify --subject '{SMALL}'")
        solver, = (one for one in self.made()["solvers"] if one["id"] == "small")
        worst, = solver["worst"]
        environment = dict(ENVIRONMENT, PATH=os.path.dirname(PROGRAM) + os.pathsep + ENVIRONMENT["PATH"])
        again = subprocess.run(worst["repeat"], shell=True, capture_output=True, text=True, env=environment, cwd=ROOT)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertIn(f'got {worst["got"]!r}', again.stdout)
        self.assertIn(worst["case"], again.stdout)


class History(Field):
    def setUp(self):
        super().setUp()
        for day, by in (("2026-01-01", 0), ("2026-06-01", 1), ("2026-11-28", 3)):
            self.add(f"one_{day}" if by < 3 else "one", self.turned(by), name="one", date=day, commit=f"{by}" * 40)
        self.add("late", name="late", date="2026-11-01")

    def test_the_newest_verdict_stands_in_the_matrix_and_all_in_its_history(self):
        document = self.made()
        self.assertEqual([one["id"] for one in document["solvers"]], ["late", "one"])
        one = document["solvers"][1]
        self.assertEqual(list(one["cells"].values()), [row["status"] for row in self.turned(3)["quantities"]])
        self.assertEqual([(row["date"], row["commit"][0], len(row["changes"])) for row in one["history"]],
                         [("2026-01-01", "0", 0), ("2026-06-01", "1", len(one["cells"])), ("2026-11-28", "3", len(one["cells"]))])
        self.assertEqual([row[0]["text"] for row in Tables(self.text("out/one.html")).tables[-1][1:]], ["2026-01-01", "2026-06-01", "2026-11-28"])

    def test_a_difference_of_two_days_names_what_changed_and_no_more(self):
        def rows(*days):
            result = run("field", self.folder.path("verdicts"), "--diff", *days)
            self.assertEqual((result.code, len(result.err.splitlines())), (0, days[0] < "2026-11-01"))
            head, *lines = [line.split("\t") for line in result.out.splitlines()]
            self.assertEqual(head, ["solver", "quantity", *days])
            return lines
        self.assertEqual(rows("2026-02-01", "2026-03-01"), [])
        self.assertEqual(rows("2026-02-01", "2026-10-31"),
                         [["one", before["quantity"], before["status"].lower(), after["status"].lower()]
                          for before, after in zip(self.turned(0)["quantities"], self.turned(1)["quantities"])])
        self.assertEqual(rows("2026-10-31", "2026-11-01"), [])
        self.assertIn("1 solvers have no verdict on or before 2026-10-31 and are left out: late",
                      run("field", self.folder.path("verdicts"), "--diff", "2026-10-31", "2026-11-01").err)
        for days in (("2026-03-01", "2026-02-01"), ("2026-03-01", "2026-03-01")):
            self.refused("--diff: " + " ".join(days), "the earlier one first", arguments=("--diff", *days))
        self.refused("--diff: '2026-13-01'", "2026-11-28", arguments=("--diff", "2026-01-01", "2026-13-01"))

    def test_a_verdict_of_another_version_has_the_quantities_that_it_was_asked(self):
        old = copy.deepcopy(self.small)
        old["version"] = "0.1.0"
        gone = old["quantities"].pop()["quantity"]
        self.add("old", old)
        document = self.made()
        solver, = (one for one in document["solvers"] if one["id"] == "old")
        self.assertEqual((solver["cells"][gone], solver["tribocheck"]), ("not asked", "0.1.0"))
        self.assertIn("0.1.0, " + self.small["version"], self.text("out.html"))


class Shipped(unittest.TestCase):
    """reference/field has a verdict on each solver of solvers.toml, which was asked as its row says."""

    def test_each_solver_is_asked_as_its_row_says(self):
        rows = tomllib.loads((ROOT / "reports/field/solvers.toml").read_text(encoding="utf-8"))["solver"]
        document = json.loads(run("field", ROOT / "reference/field", "--format", "json").out)
        solvers = {one["name"]: one for one in document["solvers"]}
        self.assertEqual(set(solvers), {one["name"] for one in rows})
        self.assertGreaterEqual(sum(one["kind"] == "public" for one in rows), 10)
        self.assertGreaterEqual(sum(one["kind"] == "textbook" for one in rows), 12)
        for row in rows:
            with self.subTest(row["id"]):
                one = solvers[row["name"]]
                self.assertEqual([one[key] for key in ("name", "language", "commit", "address", "conventions", "group", "sample")],
                                 [row.get(key) for key in ("name", "language", "commit", "repository", "conventions", "kind")] + ["all"])
                self.assertEqual(one["licence"], row.get("licence", "Apache-2.0"))
                if row["kind"] == "public":
                    self.assertRegex(row["commit"], "^[0-9a-f]{40}$")

    def test_each_adapter_has_at_most_thirty_lines_and_is_asked(self):
        table = (ROOT / "reports/field/solvers.toml").read_text(encoding="utf-8")
        for path in [*(ROOT / "reports/field/adapters").iterdir(), *(ROOT / "reports/field/textbook").iterdir()]:
            if path.suffix in (".py", ".m", ".js", ".pl") and path.stem != "answering":
                self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), 30, path)
                self.assertIn(f"{path.parent.name}/{path.name}", table)

    def test_the_report_links_the_matrix_where_it_is_there(self):
        with tempfile.TemporaryDirectory() as out:
            for has_field in (False, True):
                if has_field:
                    pathlib.Path(out, "field.html").write_text("x")
                self.assertEqual(run("report", "--out", out, "--section", "references").code, 0)
                self.assertEqual('href="field.html"' in pathlib.Path(out, "index.html").read_text(encoding="utf-8"), has_field)


class Refusals(Field):
    def test_bad_input_gets_one_line(self):
        self.refused("it has no verdict")
        self.add("x")
        for change, said in (({"schema": "verify-subject/2"}, ["x.json: schema: 'verify-subject/2'", "allowed: verify-subject/1"]),
                             ({"schema": "accuracy/1"}, ["x.json: schema: 'accuracy/1'"]),
                             ({"quantities": [self.small["quantities"][0] | {"status": "good"}]}, ["x.json: quantities: status: 'good'"]),
                             ({"examples": [{}]}, ["x.json: examples: quantity: "]), ({"subject": None}, ["x.json: subject: "]),
                             ({"quantities": 3}, ["x.json: quantities: "]), ({"diagnoses": [3]}, ["x.json: diagnoses: quantity: "]),
                             ({"quantities": [self.small["quantities"][0] | {"worst_relative_error": "1"}]}, ["worst_relative_error: it is missing or of another type"])):
            self.add("x", self.small | change)
            self.refused(*said)
        for about, said in (({"name": ""}, "x.toml: name: ''"), ({"language": 3}, "x.toml: language: 3"), ({"date": "yesterday"}, "x.toml: date: 'yesterday'"),
                            ({"adress": "https://a"}, "x.toml: adress: this field is not known"), ({"address": "a.org"}, "x.toml: address: 'a.org'")):
            self.add("x", **about)
            self.refused(said, "allowed: ")
        self.add("x")
        self.folder.write("verdicts/x.toml", 'name = "x"\nlanguage = "C"\n')
        self.refused("x.toml: date: it is missing")
        self.folder.write("verdicts/x.toml", "name = \n")
        self.refused("x.toml")
        os.remove(self.folder.path("verdicts/x.toml"))
        self.refused("x.json: x.toml is missing")
        self.add("x")
        self.add("y", name="x")
        self.refused("x.toml and y.toml", "2026-11-28")
        self.add("y", name="X", date="2026-11-27")
        self.refused("y.toml: name: 'X' and 'x' of x.toml would both be x.html")
        os.remove(self.folder.path("verdicts/y.json"))
        self.refused("y.toml: y.json is missing")
        os.remove(self.folder.path("verdicts/y.toml"))
        self.refused("--out: a.json", ".html", arguments=("-o", "a.json"))
        self.refused("folder of the verdicts", arguments=("-o", self.folder.path("verdicts.html")))
        for text in ("{", "[" * 100000, "3"):
            self.folder.write("verdicts/x.json", text)
            self.refused("x.json")
        shutil.rmtree(self.folder.path("verdicts"))
        self.refused("verdicts: it is not a folder")

    def test_a_name_breaks_no_line_and_a_folder_called_field_can_be_read_as_json(self):
        for day, by in (("2026-01-01", 0), ("2026-02-01", 1)):
            self.add(f"x_{day}", self.turned(by), name="a\tb\nc", date=day)
        os.rename(self.folder.path("verdicts"), self.folder.path("field"))
        result = run("field", "field", "--diff", "2026-01-01", "2026-02-01", cwd=self.folder.name)
        self.assertEqual((result.code, {line.count("\t") for line in result.out.splitlines()}), (0, {3}))
        result = run("field", "field", "--format", "json", cwd=self.folder.name)
        self.assertEqual((result.code, json.loads(result.out)["solvers"][0]["name"]), (0, "a b c"), result.err)

    def test_a_package_that_is_missing_is_told(self):
        self.add("x")
        os.mkdir(self.folder.path("modules"))
        self.folder.write("modules/cmarkgfm.py", "raise ImportError(name='cmarkgfm')")
        result = run("field", self.folder.path("verdicts"), environment={"PYTHONPATH": self.folder.path("modules")})
        self.assertEqual((result.code, result.out), (1, ""))
        self.assertEqual(result.err, "tribocheck: Python's cmarkgfm is missing (Debian: apt-get install python3-jinja2 python3-cmarkgfm)\n")

    def test_a_page_that_cannot_be_written_is_told(self):
        self.add("x")
        result = run("field", self.folder.path("verdicts"), "-o", self.folder.path("verdicts/x.toml/page.html"))
        self.assertEqual((result.code, result.out, len(result.err.splitlines())), (1, "", 1), result.err)
        self.assertIn("cannot write", result.err)


# A solver that tries what it may not do. It tells what it could do, in place of an answer.
SPY = """import json, os, socket, sys
sys.path.insert(0, "/source")
import solver
tried = []
for place in ("/source/x", %r, "/usr/x"):
    try:
        open(place, "a").close()
        tried.append(place)
    except OSError:
        pass
try:
    socket.create_connection(("127.0.0.1", %d), 1)
    tried.append("the network")
except OSError:
    pass
if os.environ.get("SECRET"): tried.append("the environment")
for line in sys.stdin:
    asked = json.loads(line)
    is_known = asked["function"] == "barus_viscosity" and not tried
    print(json.dumps({"id": asked["id"]} | ({"value": solver.barus(asked)} if is_known else {"skip": f"it can use {tried}"})), flush=True)
"""
RIGHT = "import math\ndef barus(asked):\n    return asked['viscosity'] * math.exp(asked['pressure_viscosity'] * asked['pressure'])\n"


class Asking(Field):
    """reports/field/run.py on a local repository."""
    def setUp(self):
        super().setUp()
        self.source = pathlib.Path(self.folder.path("repository"))
        self.source.mkdir()
        listening = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listening.close)
        (self.source / "spy.py").write_text(SPY % (str(ROOT / "README.md"), listening.getsockname()[1]))
        self.commit = commit = self.committed(RIGHT)
        self.later = self.committed(RIGHT.replace("math.exp", "math.expm1"))  # not the pinned commit
        self.write(commit)
        self.has_sandbox = shutil.which("bwrap") and not subprocess.run(["bwrap", "--unshare-all", "--ro-bind", "/", "/", "true"]).returncode

    def committed(self, text):
        (self.source / "solver.py").write_text(text)
        for arguments in (["init", "-q"], ["add", "."], ["-c", "user.name=x", "-c", "user.email=x@y", "commit", "-qm", "x"]):
            subprocess.run(["git", "-C", self.source, *arguments], check=True)
        return subprocess.run(["git", "-C", self.source, "rev-parse", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()

    def write(self, commit):
        self.folder.write("solvers.toml", f"""[[solver]]
id = "spy"
name = "Spy"
kind = "public"
language = "Python"
conventions = "None."
repository = "{self.source}"
commit = "{commit}"
subject = "/usr/bin/python3 -B /source/spy.py"
""")

    def asked(self, *options, **environment):
        return subprocess.run(["/usr/bin/python3", "-B", ROOT / "reports/field/run.py", "--solvers", self.folder.path("solvers.toml"),
                               "--out", self.folder.path("asked"), *(options or ("--sources", self.folder.path("sources")))],
                              capture_output=True, text=True, env=dict(ENVIRONMENT, SECRET="1", **environment))

    def checkout(self):
        subprocess.run(["git", "clone", "-q", self.source, self.folder.path("sources/spy")], check=True)

    def verdict(self, name="spy"):
        rows = json.loads(self.text(f"asked/{name}.json"))["quantities"]
        self.assertNotIn("it can use ['", " ".join(one["reason"] for one in rows))
        return {one["quantity"]: one["status"] for one in rows}["barus_viscosity"]

    def test_a_solver_answers_from_its_pinned_commit_and_can_neither_write_nor_reach_anybody(self):
        self.checkout()
        done = self.asked()
        if not self.has_sandbox:
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            return
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertEqual(self.verdict(), "held")
        self.assertEqual(set(os.listdir(self.folder.path("asked"))), {"spy.json", "spy.toml"})
        self.assertIn('licence = "none stated"\n', self.text("asked/spy.toml"))
        # On another day another commit is asked: the old verdict stays, and the history has both.
        toml = pathlib.Path(self.folder.path("asked/spy.toml"))
        toml.write_text("".join('date = "2026-01-01"\n' if line.startswith("date") else line for line in toml.read_text().splitlines(True)))
        self.write(self.later)
        self.assertEqual(self.asked().returncode, 0)
        self.assertEqual((self.verdict(), self.verdict("spy_2026-01-01")), ("FAILED", "held"))
        run("field", self.folder.path("asked"), "-o", self.folder.path("out.html")).ended(0)
        history = json.loads(self.text("out/matrix.json"))["solvers"][0]["history"]
        self.assertEqual([one["changes"] for one in history], [[], [{"quantity": "barus_viscosity", "before": "held", "after": "FAILED"}]])

    def test_without_a_sandbox_or_a_source_nothing_is_asked(self):
        done = self.asked(PATH="/none")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("bubblewrap", done.stderr)
        self.assertFalse(os.path.exists(self.folder.path("asked")))
        if self.has_sandbox:
            done = self.asked()
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (2, "", 1))
            self.assertIn("sources/spy: it is missing", done.stderr)
        done = self.asked("--only", "nobody")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--only: nobody is not one of spy", done.stderr)

    def test_without_a_folder_of_checkouts_the_pinned_commit_is_cloned(self):
        for commit, status in ((self.commit, "held"), (self.later, "FAILED"), ("newer than the clone", "held")):
            self.write(self.committed(RIGHT + "# again\n") if " " in commit else commit)
            done = self.asked("--clones", self.folder.path("clones"))
            if self.has_sandbox:
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(self.verdict(), status)
        self.write("0" * 40)
        done = self.asked("--clones", self.folder.path("clones"))
        self.assertEqual((done.returncode, "spy" in done.stdout), (1, True) if self.has_sandbox else (2, False), done.stderr)

    def test_a_solver_without_a_verdict_is_told_with_what_it_needs(self):
        self.checkout()
        (pathlib.Path(self.folder.path("sources/spy")) / "solver.py").unlink()
        shutil.rmtree(self.folder.path("sources/spy/.git"))
        done = self.asked()
        if self.has_sandbox:
            self.assertEqual((done.returncode, done.stdout), (1, "spy: no verdict; it needs nothing\n"))
            self.assertIn("field: no verdict of spy", done.stderr)


if __name__ == "__main__":
    unittest.main()
