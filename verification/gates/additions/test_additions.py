# SPDX-License-Identifier: Apache-2.0
"""Tests prove.py on a small tree: changes that do not apply, counts of files, and outputs that a check refuses."""
import contextlib
import io
import pathlib
import tempfile
import unittest
from unittest import mock

import prove

TEXT = """
[law]
adds = "a law"
wanted = 1
limit = 2
made = ["table.csv"]
hand = [{ file = "laws.hpp", find = "one,\\n", after = "two,\\n" }, { file = "laws.hpp", find = "= 1;", replace = "= 2;" },
        { file = "new.hpp", new = "three\\nlines\\nmore\\n" }]
texts = [{ file = "README.md", find = "one", before = "two, " }]
checks = [{ says = "it is there", run = ["laws"], contains = ["two"] }]
"""


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "laws.hpp").write_text("one,\ncount = 1;\n")
        (self.root / "README.md").write_text("Laws: one\n")

    def kinds(self, *changes):
        """The kinds of additions that TEXT describes, after these (old, new) replacements."""
        text = TEXT
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        return prove.read_additions(text)

    def problems(self, *changes):
        return list(prove.problems_of(self.root, self.kinds(*changes)))


class Counts(Files):
    def test_files_by_hand_are_counted_once_and_texts_and_tables_apart(self):
        law, = self.kinds()
        self.assertEqual(law.files, ["laws.hpp", "new.hpp"])
        self.assertEqual(law.counted_apart, ["README.md", "table.csv"])
        self.assertEqual(prove.added_lines(self.root, law), 5)
        self.assertEqual([line.split() for line in prove.table_of(self.root, [law])][1], ["law", "2", "2", "1", "5", "2"])
        self.assertEqual(self.problems(), [])

    def test_changes_are_written_where_they_belong_and_nothing_else_is(self):
        law, = self.kinds()
        tree, to = prove.Tree(self.root), self.root / "copy"
        for change in law.hand + law.texts:
            tree.apply(change)
        tree.write(to)
        self.assertEqual({str(file.relative_to(to)): file.read_text() for file in to.rglob("*")},
                         {"laws.hpp": "one,\ntwo,\ncount = 2;\n", "new.hpp": "three\nlines\nmore\n", "README.md": "Laws: two, one\n"})
        self.assertEqual((self.root / "laws.hpp").read_text(), "one,\ncount = 1;\n")

    def test_more_files_than_the_limit_are_named(self):
        problem, = self.problems(("limit = 2", "limit = 1"))
        self.assertIn("2 files by hand, at most 1 are allowed: laws.hpp, new.hpp", problem)


class Stale(Files):
    def test_a_text_that_stands_twice_or_never_does_not_apply(self):
        self.assertIn("0 times", self.problems(("= 1;", "= 3;"))[0])
        (self.root / "laws.hpp").write_text("one,\none,\ncount = 1;\n")
        self.assertIn("2 times", self.problems()[0])
        (self.root / "laws.hpp").write_text("one,\ncount = 1;\n")
        (self.root / "README.md").write_text("one and one\n")
        self.assertIn("README.md", self.problems()[0])

    def test_a_file_that_is_missing_or_should_be_new_does_not_apply(self):
        self.assertIn("none.hpp is not there", self.problems(('"laws.hpp"', '"none.hpp"'))[0])
        (self.root / "new.hpp").write_text("")
        self.assertIn("new.hpp is there already", self.problems()[0])

    def test_two_kinds_that_apply_alone_but_not_together_are_told(self):
        twice = prove.read_additions(TEXT + TEXT.replace("[law]", "[other]").replace("new.hpp", "other.hpp"))
        self.assertEqual([list(prove.problems_of(self.root, [one])) for one in twice], [[], []])
        problem, = prove.problems_of(self.root, twice)
        self.assertRegex(problem, "^other: laws.hpp: .* 0 times")


class Written(Files):
    """Contents of additions.toml that are refused."""

    def refused(self, words, old, new):
        with self.assertRaisesRegex(ValueError, words):
            self.kinds((old, new))

    def test_a_kind_has_its_fields_and_no_others(self):
        self.refused("law: limit: missing", "limit = 2\n", "")
        self.refused("law: most: not a field", "limit = 2", "limit = 2\nmost = 2")
        self.refused("law: limit: not a field", "limit = 2", 'limit = "2"')

    def test_a_change_says_where_and_what_to_put_there(self):
        for old, new in ((', after = "two,\\n"', ""), ('after = "two,\\n"', 'after = "two,\\n", before = "x"'),
                         ('find = "= 1;", ', ""), ('new = "three', 'find = "a", new = "three')):
            self.refused("a change has `new`, or", old, new)

    def test_a_check_asks_something(self):
        self.refused("a check has `says`", ', contains = ["two"]', "")
        self.refused("a check has `says`", 'run = ["laws"], ', "")
        self.refused("a check has `says`", 'contains = ["two"]', 'contains = ["two"], containz = ["two"]')

    def test_no_file_is_counted_by_hand_and_apart(self):
        self.refused("laws.hpp is counted by hand and apart", "README.md", "laws.hpp")
        self.refused("new.hpp is counted by hand and apart", "table.csv", "new.hpp")


class Judged(unittest.TestCase):
    """The outputs of a program that a check accepts, and those that it refuses."""

    JSON = '[\n{"name": "a", "film": 1.0, "other": 1.0000000001, "is_held": true},\n{"name": "b", "film": 2.0, "other": null}\n]\n'

    def red(self, words, check, text=JSON):
        with self.assertRaisesRegex(prove.Red, words):
            prove.judge(check, text, text)

    def test_texts_have_to_stand_there_in_their_order(self):
        prove.judge({"contains": ["b", "c"]}, "", "abc")
        self.red('"c" does not stand there', {"contains": ["c"]}, "ab")
        self.red('"b" does not stand there', {"contains": ["c", "b"]}, "abc")
        self.red('"b" does not stand there', {"contains": ["b", "b"]}, "abc")

    def test_values_have_to_be_those_asked(self):
        prove.judge({"value": {"0/film": 1, "name=b/film": 2.0000000001, "0/is_held": True, "0/name": "a"}}, self.JSON, "")
        self.red("0/film is 1.0, not 1.00001", {"value": {"0/film": 1.00001}})
        self.red("0/name is a, not b", {"value": {"0/name": "b"}})
        self.red("1/other is None, not 0", {"value": {"1/other": 0}})
        self.red("0/film is 1.0, not True", {"value": {"0/film": True}})
        self.red("0/is_held is True, not 1", {"value": {"0/is_held": 1}})

    def test_a_path_that_leads_nowhere_is_red(self):
        for path, part in (("2/film", "2"), ("0/width", "width"), ("name=c/film", "name=c"), ("0/film/0", "0"), ("x", "x")):
            self.red(f"there is no {part}", {"value": {path: 1}})

    def test_equal_numbers_and_ranges(self):
        prove.judge({"equal": {"0/film": "0/other"}, "between": {"0/film": [1, 1]}}, self.JSON, "")
        self.red("0/film is 1.0, and 1/film 2.0", {"equal": {"0/film": "1/film"}})
        self.red("1/film is 2.0, not from 0 to 1", {"between": {"1/film": [0, 1]}})

    def test_lines_of_json_are_a_list_and_other_texts_are_red(self):
        prove.judge({"value": {"0/a": 1, "1/a": 2}}, '{"a": 1}\n{"a": 2}\n', "")
        prove.judge({"value": {"0/a": 1}}, '{"a": 1}\n', "")
        self.red("this is no JSON", {"value": {"0/a": 1}}, "a = 1")


class Programs(unittest.TestCase):
    """Checks on programs, which are shell scripts here."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.copy = prove.Copy(pathlib.Path(folder.name))
        self.copy.tree.mkdir()

    def hold(self, script, **check):
        program = self.copy.folder / "program"
        program.write_text("#!/bin/sh\n" + script)
        program.chmod(0o755)
        with mock.patch.object(self.copy, "program", lambda name: program):
            self.copy.hold({"says": "", "run": [], **check})

    def test_a_program_gets_its_words_its_input_and_its_files(self):
        self.hold('cat "$1" -', run=["{folder}/scene.toml"], files={"scene.toml": "load = 1\n"}, input="speed", contains=["load = 1\nspeed"])

    def test_a_file_that_it_writes_is_read(self):
        self.hold('echo "## One" > "$1/page.md"', run=["{folder}"], read="page.md", contains=["## One"])

    def test_another_exit_code_is_red(self):
        self.hold("exit 2", code=2, contains=[])
        for code in (0, 1):
            with self.assertRaisesRegex(prove.Red, f"exit code 2, not {code}"):
                self.hold("exit 2", code=code, contains=[])

    def test_a_solver_has_the_body_in_its_own_function_alone(self):
        template = "def other(x):\n    return None\ndef law(x):\n    return None\ndef last(x):\n    return None\n"
        with mock.patch.object(prove, "run", lambda command, **_: pathlib.Path(command[-1]).write_text(template)):
            file = self.copy.solver({"language": "python", "function": "law", "body": "return x"}, self.copy.folder)
        self.assertEqual(file.read_text(), template.replace("law(x):\n    return None", "law(x):\n    return x"))


    def test_a_solver_needs_its_function(self):
        with mock.patch.object(prove, "run", lambda command, **_: pathlib.Path(command[-1]).write_text("def laws(x):\n    return None\n")), \
                self.assertRaisesRegex(prove.Red, "does not write a function law"):
            self.copy.solver({"language": "python", "function": "law", "body": "return x"}, self.copy.folder)

    def test_one_check_that_fails_makes_the_whole_red_and_the_others_are_asked(self):
        kind = prove.Kind("law", "a law", 1, 1, [], checks=[{"says": one} for one in ("first", "second", "third")])
        for ends, held in (([None] * 3, True), ([None, prove.Red("no film"), None], False)):
            out = io.StringIO()
            with mock.patch.object(prove.Copy, "make"), mock.patch.object(prove.Copy, "hold", side_effect=ends), \
                    contextlib.redirect_stdout(out):
                self.assertIs(prove.prove([kind], self.copy.folder), held)
            self.assertIn("held    third", out.getvalue())
            self.assertEqual("FAILED  second: no film" in out.getvalue(), not held)


class Whole(Files):
    """The exit code and output of prove.py."""

    def main(self, *words, text=TEXT, held=True):
        file = self.root / "additions.toml"
        file.write_text(text)
        with mock.patch.object(prove, "ADDITIONS", file), mock.patch.object(prove, "ROOT", self.root), \
                mock.patch("sys.argv", ["prove.py", *words]), mock.patch.object(prove, "prove", side_effect=[held]) as proof, \
                contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()):
            return prove.main(), out.getvalue(), proof.called

    def test_the_exit_code_is_1_where_a_count_a_change_or_a_check_is_red(self):
        self.assertEqual([self.main()[0], self.main(held=False)[0], self.main(held=prove.Red("does not build"))[0]], [0, 1, 1])
        self.assertEqual(self.main("--count")[0::2], (0, False))
        code, said, was_built = self.main(text=TEXT.replace("limit = 2", "limit = 1"))
        self.assertEqual((code, was_built), (1, False))
        self.assertIn("RED  law: 2 files by hand", said)
        self.assertEqual(self.main("--count", text=TEXT.replace("= 1;", "= 3;"))[0], 1)

    def test_only_takes_kinds_that_are_there(self):
        self.assertEqual(self.main("--count", "--only", "law")[0], 0)
        with self.assertRaises(SystemExit):
            self.main("--count", "--only", "low")


if __name__ == "__main__":
    unittest.main()
