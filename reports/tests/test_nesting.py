# SPDX-License-Identifier: Apache-2.0
"""Texts nested deep: each reader takes 16 lists and tables within each other, and refuses more by one sentence."""

import json
import os
import pathlib
import shlex
import shutil
import sys
import unittest

from program import ProgramTest, run, scene, toml

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
MOST, FAR = 16, 100_000
SENTENCE = "lists and tables are nested more than 16 deep"

# Values in `depth` brackets, one within the other.
JSON_NESTS = {
    "lists": lambda depth: "[" * depth + "]" * depth,
    "objects": lambda depth: '{"a": ' * (depth - 1) + "{}" + "}" * (depth - 1),
    "both": lambda depth: '[{"a": ' * (depth // 2) + ("[]" if depth % 2 else "0") + "}]" * (depth // 2),
    "open lists": lambda depth: "[" * depth,
    "open objects": lambda depth: '{"a": ' * depth,
}
CLOSED = [name for name in JSON_NESTS if not name.startswith("open")]
# Lines of TOML for a field with `depth` levels.
TOML_NESTS = {
    "lists": lambda depth: "x = " + "[" * depth + "]" * depth,
    "tables": lambda depth: "x = " + "{a = " * (depth - 1) + "{}" + "}" * (depth - 1),
    "dotted keys": lambda depth: "x" + ".a" * depth + " = 1",
    "spaced keys": lambda depth: "x" + " . a" * depth + " = 1",
    "quoted keys": lambda depth: '"x"' + '."a"' * depth + " = 1",
    "dotted keys in a table": lambda depth: "x = {a" + ".a" * depth + " = 1}",
    "headers": lambda depth: "[x" + ".a" * depth + "]",
    "lists of tables": lambda depth: "[[x" + ".a" * depth + "]]",
    "open lists": lambda depth: "x = " + "[" * depth,
    "open tables": lambda depth: "x = " + "{a = " * depth,
}

SUBJECT = """
import json, sys
nest = {"lists": lambda depth: "[" * depth + "]" * depth,
        "objects": lambda depth: '{"a": ' * (depth - 1) + "{}" + "}" * (depth - 1),
        "both": lambda depth: '[{"a": ' * (depth // 2) + ("[]" if depth % 2 else "0") + "}]" * (depth // 2),
        "open lists": lambda depth: "[" * depth, "open objects": lambda depth: '{"a": ' * depth}[sys.argv[1]]
for line in sys.stdin:
    asked = json.loads(line)
    print('{"id": "%s", "value": %s}' % (asked["id"], nest(int(sys.argv[2]))), flush=True)
"""


class Deep(ProgramTest):
    def assert_depth_told(self, result, depth, code=2):
        """Asserts the exit code and short lines. The sentence on nesting is told beyond the allowed depth only, also for open brackets."""
        self.assertEqual(result.code, code, result.said[:500])
        said = result.said + result.out
        self.assertEqual(SENTENCE in said, depth > MOST, said[:500])
        self.assertTrue(all(len(line) < 2000 for line in result.said.splitlines()))

    def depths(self):
        return (MOST, MOST + 1, FAR)


class Scenes(Deep):
    def test_json(self):
        for name, nest in JSON_NESTS.items():
            for depth in self.depths():
                with self.subTest(name, depth=depth):
                    text = f'{{"x": {nest(depth - 1)}}}'
                    self.assert_depth_told(run("solve", self.folder.write("scene.json", text)), depth)
                    answers = run("stream", stdin=f'{text}\n{{"function": "gaussian_moment", "x": {nest(depth - 1)}}}\n').ended(0)
                    for answer in answers.json_lines():
                        self.assertEqual(SENTENCE in answer["error"]["message"], depth > MOST, answer)

    def test_toml(self):
        commands = [("solve",), ("curve",), ("onset",), ("film",), ("sweep", "--estimate")]
        for name, nest in TOML_NESTS.items():
            for depth in self.depths():
                path = self.folder.write("scene.toml", f"{toml(scene())}\n{nest(depth)}\n")
                for command in commands if depth == FAR else commands[:1]:
                    with self.subTest(name, depth=depth, command=command):
                        self.assert_depth_told(run(*command, path), depth)

    def test_mistakes(self):
        reference = pathlib.Path(self.folder.path("reference"))
        shutil.copytree(ROOT / "reference/exact", reference / "exact")
        subject = f"{sys.executable} -B {ROOT}/verification/conformance/subjects/small_python/my_solver.py"
        for name, nest in TOML_NESTS.items():
            for depth in (MOST, FAR):
                with self.subTest(name, depth=depth):
                    tree = pathlib.Path(self.folder.path("tree"))
                    shutil.rmtree(tree, ignore_errors=True)
                    for part in ("reports/page/render", "reference"):
                        (tree / part).mkdir(parents=True)
                    for part in ("exact", "published"):
                        (tree / "reference" / part).symlink_to(ROOT / "reference" / part)
                    (tree / "reference/mistakes.toml").write_text(nest(depth) + "\n")
                    self.assert_depth_told(run("verify", "--subject", subject, "--sample", "1", cwd=tree), depth)


class Answers(Deep):
    def test_of_subjects(self):
        path = self.folder.write("subject.py", SUBJECT)
        for name in JSON_NESTS:
            for depth in (MOST, MOST + 1, FAR):
                with self.subTest(name, depth=depth):
                    command = shlex.join([sys.executable, path, name, str(depth - 1)])
                    result = run("verify", "--subject", command, "--sample", "2", "--format", "json")
                    if depth > MOST or name not in CLOSED:
                        self.assert_depth_told(result, depth)
                        continue
                    self.assertEqual(result.code, 1, result.err)
                    self.assertNotIn(SENTENCE, result.out)
                    self.assertEqual(result.json()["violation_count"], 0)

    def test_within_text_brackets_are_no_depth(self):
        script = ("import json, sys\nfor line in sys.stdin:\n"
                  '    print(json.dumps({"id": json.loads(line)["id"], "skip": "\\\\\\"" + "[{" * 1000}), flush=True)\n')
        result = run("verify", "--subject", shlex.join([sys.executable, self.folder.write("skips.py", script)]),
                     "--sample", "1", "--format", "json")
        self.assertEqual((result.code, result.json()["violation_count"]), (1, 0))
        self.assertNotIn(SENTENCE, result.out)


class Baselines(Deep):
    def test_of_verify(self):
        subject = f"{sys.executable} -B {ROOT}/verification/conformance/subjects/small_python/my_solver.py"
        for name, nest in JSON_NESTS.items():
            for depth in self.depths():
                with self.subTest(name, depth=depth):
                    path = self.folder.write("base.json", f'{{"x": {nest(depth - 1)}}}')
                    self.assert_depth_told(run("verify", "--subject", subject, "--sample", "1", "--baseline", path), depth)

    def test_of_the_report(self):
        tree = pathlib.Path(self.folder.path("tree"))
        for part in ("reports/page/render", "reference/baselines"):
            (tree / part).mkdir(parents=True)
        (tree / "reports/page/groups").symlink_to(ROOT / "reports/page/groups")
        for part in ("published", "exact", "scenes", "ehl", "mistakes.toml"):
            (tree / "reference" / part).symlink_to(ROOT / "reference" / part)
        for name, nest in JSON_NESTS.items():
            for depth in (MOST, FAR):
                with self.subTest(name, depth=depth):
                    for one in (ROOT / "reference/baselines").glob("*.json"):
                        (tree / "reference/baselines" / one.name).write_text(f'{{"x": {nest(depth - 1)}}}')
                    result = run("report", "--out", tree / "out", "--section", "worst-inputs", "--section", "planted-faults",
                                 "--section", "work-precision", "--section", "gates", "--section", "sweep-speed",
                                 "--section", "diagnosis", "--section", "environment", "--section", "verification", cwd=tree)
                    self.assertEqual(result.code, 1, result.said)  # there is no script that makes a page
                    report = json.loads((tree / "out/report.json").read_text())
                    for group in ("stress", "planted_faults", "work_precision", "gates", "sweep_speed"):
                        why = report[group]["missing"]["why"]
                        self.assertEqual(SENTENCE in why, depth > MOST, why)


class Filters(unittest.TestCase):
    def test_brackets_of_an_expression(self):
        for text in ("(" * FAR, "(" * (FAR // 2) + ")" * (FAR // 2), "[[" * 10_000, "(" * 1001):
            result = run("bench", "--filter", text)
            self.assertEqual((result.code, result.err), (2, "tribocheck: --filter: longer than 1000 signs\n"))


if __name__ == "__main__":
    unittest.main()
