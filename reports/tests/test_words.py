# SPDX-License-Identifier: Apache-2.0
"""Texts of others in ids, file names, arguments and answers have no effect on a terminal, and are plain text in files."""

import csv
import io
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from program import ENVIRONMENT, PROGRAM, ProgramTest, quiet_scene, read_terminal, run, strict_json

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
# Escape sequences of both kinds, formulas, and signs that reverse the text, or that end a line, a cell, a quotation or an element.
HOSTILE = ["\x1b[2J\x1b]0;owned\x07", "a\u009b31mred", "a\u202egpj.exe", "a\u2066b\u2069", "two\nlines", "a\rb", "tab\tbed",
           "del\x7f", 'a,"b",c', "=cmd|' /C calc'!A0", "+1+cmd|'x'!A1", "-2+3", "@SUM(1)", "-1e-5", "<script>alert(1)</script>",
           "<img src=x onerror=alert(1)>", "a|b`c`*d*_e_[f](g)", "&amp;&#27;", "{/Symbol a}_b^c@~", "' \" \\ $(touch x) `y`"]
LIVE = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]")


class Words(ProgramTest):
    def assert_dead(self, result):
        for text in (result.out, result.said):
            self.assertIsNone(LIVE.search(text), repr(text[:2000]))
        for line in result.said.splitlines():
            self.assertRegex(line, "^(tribocheck: |  )")

    def scene(self, word, **changes):
        fields = {"speed": [0.01, 0.1], "outputs": ["film", "film_parameter"], **changes}
        return self.folder.write("scene.json", json.dumps(quiet_scene(id=word, **fields)).encode())


class Ids(Words):
    def test_tables_have_a_line_for_each_row(self):
        of_film = {"outputs": None, "speed": 0.1, "supply": None, "closures": {"film": "dowson_toyoda_central"},
                   "bodies": {"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 2e-3}}
        for command, changes, words in ((["solve"], {}, HOSTILE), (["onset"], {}, HOSTILE),
                                        (["film", "--tolerance", "0.01"], of_film, HOSTILE[:5])):
            counts = {len(run(*command, self.scene("plain", **changes)).out.splitlines())}
            for word in words:
                with self.subTest(word, command=command):
                    result = run(*command, self.scene(word, **changes))
                    self.assert_dead(result)
                    self.assertNotEqual(result.out, "")
                    counts.add(len(result.out.splitlines()))
            self.assertEqual(len(counts), 1, command)

    def test_csv_gives_the_id_back(self):
        for command in (["solve"], ["onset"]):
            for word in HOSTILE:
                with self.subTest(word, command=command):
                    result = run(*command, self.scene(word), "--format", "csv")
                    self.assert_dead(result)
                    head, *rows = csv.reader(io.StringIO(result.out, newline=""))
                    self.assertEqual(head[0], "id")
                    self.assertTrue(all(len(row) == len(head) for row in rows))
                    shown = LIVE.sub(lambda sign: f"\\u{ord(sign[0]):04x}", word)
                    self.assertEqual({row[0] for row in rows}, {shown})
                    cell = result.out.split("\n", 1)[1]
                    self.assertEqual(cell.startswith('"'), bool(re.search(r'[,"\n\r\t]|^[=+@]|^-2', word)), cell[:40])

    def test_json_gives_the_id_back(self):
        for command, rows in (("solve", "points"), ("onset", "onsets")):
            for word in HOSTILE:
                with self.subTest(word, command=command):
                    result = run(command, self.scene(word), "--format", "json")
                    self.assert_dead(result)
                    self.assertEqual({row["id"] for row in result.json()[rows]}, {word})
        lines = [json.dumps(quiet_scene(id=word, speed=0.1)) for word in HOSTILE]
        calls = [json.dumps({"id": word, "function": "gaussian_moment", "order": 2.5, "argument": 1}) for word in HOSTILE]
        wrong = [json.dumps({"id": word, "function": word, word: 1}) for word in HOSTILE]
        for asked in (lines, calls, wrong):
            result = run("stream", stdin="\n".join(asked) + "\n")
            self.assert_dead(result)
            self.assertEqual([line["id"] for line in result.json_lines()], HOSTILE)

    def test_of_sweeps(self):
        for word in HOSTILE:
            with self.subTest(word):
                text = json.dumps(word, ensure_ascii=True)
                toml = f"id = {text}\nload = [50, 60]\nspeed = 0.1\noutputs = [\"film\"]\n" + "".join(
                    f"[{name}]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in table.items())
                    for name, table in quiet_scene().items() if isinstance(table, dict) and name != "speed")
                path = self.folder.write("sweep.toml", toml)
                done = run("sweep", path, "-o", self.folder.path("out.h5"), "--force", "--format", "csv")
                self.assert_dead(done)
                if "/" in word:
                    self.assertEqual(done.code, 2, done.said)
                    self.assertIn("cannot name a group of the result", done.said)
                    continue
                self.assertEqual(done.code, 0, done.said)
                shown = LIVE.sub(lambda sign: f"\\u{ord(sign[0]):04x}", word)
                head, *rows = csv.reader(io.StringIO(done.out, newline=""))
                self.assertEqual({(row[0], len(row)) for row in rows}, {(shown, len(head))})
                for options in ([], ["--cases"]):
                    for style in ("table", "csv", "json"):
                        result = run("sweep", "show", self.folder.path("out.h5"), "--format", style, *options).ended(0)
                        self.assert_dead(result)
                        if style == "json" and not options:
                            self.assertEqual(result.json()["scenes"][0]["id"], word)
                self.assert_dead(run("sweep", path, "--estimate"))


class Names(Words):
    """Hostile names of files, and other arguments."""

    def test_of_files_that_are_there(self):
        for word in HOSTILE:
            name = word.replace("/", "_")
            with self.subTest(name):
                path = self.folder.write(name + ".toml", quiet_scene(id=None, speed=0.1))
                for style in ("table", "csv", "json"):
                    self.assert_dead(run("solve", path, "--format", style))
                broken = self.folder.write(name + "2.toml", f"{json.dumps(word)} = 1\nload = {json.dumps(word)}\n[")
                self.assert_dead(run("solve", broken))
                out = os.path.join(self.folder.name, name + ".py")
                self.assert_dead(run("init", "subject", "--language", "python", "--out", out))
                self.assert_dead(run("init", "subject", "--language", "python", "--out", out))
                compile(pathlib.Path(out).read_text(encoding="utf-8"), "solver.py", "exec")

    def test_of_anything(self):
        for word in HOSTILE[:8] + [b"\xff\xfe"]:
            word = os.fsdecode(word)
            with self.subTest(word):
                for arguments in ([word], ["solve", word], ["solve", "--format", word, "x"], ["curve", word], ["onset", word],
                                  ["film", word], ["functions", word], ["sweep", word], ["sweep", "show", word], ["sweep", "diff", word, word],
                                  ["sweep", "merge", word, "-o", "x"], ["sweep", "x", "-o", word], ["verify", "--subject", word],
                                  ["verify", "--plugin", word], ["verify", "--reference", word], ["verify", "--show", word],
                                  ["verify", "--subject", "true", "--tolerance", word],
                                  ["verify", "--subject", "true", "--require", word], ["reproduce", "--claim", word],
                                  ["reproduce", "--reading", word], ["report", "--section", word], ["report", "--scenes", word],
                                  ["init", word], ["init", "subject", "--language", word], ["init", "ci", "--for", word], ["plugin-host", word],
                                  ["bench", "--filter", word + "("], ["solve", "--" + word]):
                    result = run(*arguments, cwd=self.folder.name)
                    self.assertIn(result.code, (0, 1, 2), result.said)
                    self.assert_dead(result)


SUBJECT = """
import json, sys
words = json.load(open(sys.argv[1]))
for number, line in enumerate(sys.stdin):
    asked, word = json.loads(line), words[number % len(words)]
    sys.stderr.write(word + "\\n" + "`" * 5 + "\\n<b>\\n")
    sys.stderr.flush()
    sys.stderr.buffer.write(b"\\xff\\xfe\\n")
    sys.stderr.buffer.flush()
    way = number % 6
    answer = {"id": asked["id"]}
    if way == 0:
        answer["error"] = {"message": word}
    elif way == 1:
        answer["skip"] = word
    elif way == 2:
        answer |= {"value": word, word: word}
    elif way == 3:
        answer |= {"value": {word: [word]}}
    elif way == 4:
        print(word)
        answer = {"id": word, "value": 1}
    else:
        print("not JSON " + json.dumps(asked["id"]) + word.replace(chr(10), " "))
        continue
    print(json.dumps(answer, ensure_ascii=False), flush=True)
"""


class Subjects(Words):
    def verify(self, *options):
        words = self.folder.write("words.json", json.dumps(HOSTILE).encode())
        command = shlex.join([sys.executable, self.folder.write("sub <b>*|ject.py", SUBJECT), words])
        return run("verify", "--subject", command, "--sample", "2", *options)

    def test_what_a_subject_says(self):
        junit = self.folder.path("junit.xml")
        results = {style: self.verify("--format", style, "--junit", junit) for style in ("table", "json", "markdown")}
        for style, result in results.items():
            self.assertEqual(result.code, 1, result.said)
            self.assert_dead(result)
        strict_json(results["json"].out)
        self.assertIsNone(LIVE.search(pathlib.Path(junit).read_text(encoding="utf-8")))
        xml.etree.ElementTree.parse(junit)
        import cmarkgfm
        from cmarkgfm.cmark import Options
        page = cmarkgfm.github_flavored_markdown_to_html(results["markdown"].out, Options.CMARK_OPT_UNSAFE)
        self.assertLessEqual(set(re.findall(r"<([a-z0-9]+)", page)),
                             {"h3", "table", "thead", "tbody", "tr", "th", "td", "code", "ul", "li", "p", "pre", "strong"})
        self.assertIn("`" * 5, results["json"].json()["last_errors"])

    def test_a_case_that_is_shown_and_a_silent_subject(self):
        self.assert_dead(self.verify("--show", "e0000"))
        for word in HOSTILE:
            text = self.folder.write("text", word.encode() + b"\n\xff")
            result = run("verify", "--subject", f"cat '{text}'; cat '{text}' >&2; exit 3", "--sample", "1").ended(2)
            self.assert_dead(result)

    def test_a_subject_with_blanks_and_quotes_in_its_path(self):
        for name in ("with blank", "with'quote", 'with"quotes', "with$(touch x)`y`"):
            folder = pathlib.Path(self.folder.path(name))
            folder.mkdir()
            program = folder / "solver.py"
            program.write_text(f"#!{sys.executable}\nimport json, sys\nfor line in sys.stdin:\n"
                               '    print(json.dumps({"id": json.loads(line)["id"], "skip": "no"}), flush=True)\n')
            program.chmod(0o755)
            result = run("verify", "--subject", shlex.quote(str(program)), "--sample", "1", cwd=self.folder.name).ended(1, "")
            self.assertIn("NOTHING", result.out)
            result = run("verify", "--subject", shlex.quote(str(program) + "x"), cwd=self.folder.name).ended(2)
            self.assertIn("there is no file", result.said)
            self.assertEqual([one for one in ("x", "y") if (pathlib.Path(self.folder.name) / one).exists()], [])

    def test_a_foreign_baseline(self):
        subject = f"{sys.executable} -B {ROOT}/verification/conformance/subjects/small_python/my_solver.py"
        path = self.folder.path("base.json")
        made = run("verify", "--subject", subject, "--sample", "1", "--baseline", path, "--update-baseline")
        self.assertIn(made.code, (0, 1), made.said)
        good = json.loads(pathlib.Path(path).read_text())
        for word in HOSTILE:
            for style, changed in zip(("table", "json", "markdown"), (
                            {**good, "tolerance": word}, {**good, "quantities": {**good["quantities"], word: {}}},
                            {**good, "quantities": {name: {**row, "status": word} for name, row in good["quantities"].items()}})):
                self.folder.write("base.json", json.dumps(changed).encode())
                result = run("verify", "--subject", subject, "--sample", "1", "--baseline", path, "--format", style)
                self.assertIn(result.code, (1, 2))
                self.assert_dead(result)


class Terminal(Words):
    def test_progress(self):
        """On a terminal, names of files stand in a line that is overwritten."""
        reader, writer = os.openpty()
        name = "a\u009b31m\x1b]0;b\x07.toml"
        paths = [self.folder.write(name, quiet_scene(id="c\x1bd", speed={"from": 1e-4, "to": 3, "count": 20000}))]
        with subprocess.Popen([PROGRAM, "solve", *paths], env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=writer) as process:
            os.close(writer)
            said = read_terminal(reader)
            process.wait(60)
        self.assertIsNone(LIVE.search(said.decode().replace("\x1b[K", "").replace("\r", "")), said)


if __name__ == "__main__":
    unittest.main()
