# SPDX-License-Identifier: Apache-2.0
"""Tests the tool that makes mutants on a small tree: the places that it finds, its draws, switches and verdicts."""
import collections
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock

import run  # noqa: F401  puts the folders of its modules in front
import places
import sample
import schemata
import tests

SOURCE = """\
struct Film { double central, minimum; };
struct Counter { int calls = 0; };
double thinner(const Film& film) {
  if (film.central < 2.0) return film.minimum;
  return film.central - film.minimum;
}
int calls_until(int end) {
  Counter counter;
  for (int i = 0; i < end; i++) counter.calls += 1;
  return counter.calls;
}
constexpr int twice(int x) { return 2 * x; }
static_assert(twice(3) == 6);
"""
MAIN = '#include <cstdio>\nint main() { std::printf("%g %d %d", thinner({1, 3}), calls_until(4), twice(5)); }\n'


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()


class Cpp(Folder):
    """Mutants of one source: found, put behind switches, built, and turned on one after the other."""

    def setUp(self):
        super().setUp()
        self.source = self.folder / "model/src/film.cpp"
        self.source.parent.mkdir(parents=True)
        self.source.write_text(SOURCE + MAIN)
        self.places = [{**one, "id": sample.name_of(one), "room": "engine"}
                       for one in places.cpp_part(self.folder, [(f"c++ -std=c++20 -c {self.source}", str(self.source))])]

    def built(self, mutants):
        numbers = {one["id"]: n for n, one in enumerate(mutants)}
        changed = self.folder / "changed.cpp"
        changed.write_text(schemata.switched(SOURCE + MAIN, mutants, numbers))
        subprocess.run(["c++", "-std=c++20", "-w", changed, "-o", self.folder / "film"], check=True)
        return numbers

    def says(self, **environment):
        return subprocess.run([self.folder / "film"], env={**os.environ, **environment}, capture_output=True, text=True, timeout=20).stdout

    def test_each_operator_finds_its_places_and_types_have_none(self):
        found = collections.Counter(one["operator"] for one in self.places)
        for operator in ("boundary", "comparison", "condition", "arithmetic", "constant", "field", "statement", "early return", "end"):
            self.assertGreater(found[operator], 0, operator)
        self.assertFalse([one for one in self.places if "static_assert" in SOURCE[one["begin"] - 25:one["begin"]]])

    def test_every_mutant_compiles_behind_its_switch_as_well_as_planted(self):
        for one in self.places:
            with self.subTest(one["operator"], at=one["begin"]):
                self.built([one])
                patch = sample.patch(one, SOURCE + MAIN)
                self.assertEqual((SOURCE + MAIN).count(patch["find"]), 1)
                planted = (SOURCE + MAIN).replace(patch["find"], patch["replace"])
                planted = planted.replace("static_assert(twice(3) == 6);", "")  # some change twice()
                subprocess.run(["c++", "-std=c++20", "-w", "-fsyntax-only", "-x", "c++", "-"], input=planted, text=True, check=True)

    def test_a_mutant_changes_what_the_program_says_only_while_it_is_on(self):
        drawn = sample.draw(self.places, {"engine": 6}, 1)
        numbers = self.built(drawn)
        self.assertEqual(self.says(), "3 4 10")
        self.assertEqual(self.says(TRIBOCHECK_MUTANT="1000,99999999"), "3 4 10")
        self.assertTrue(any(self.says(TRIBOCHECK_MUTANT=str(n)) != "3 4 10" for n in numbers.values()))

    def test_a_mutant_that_is_reached_and_changes_no_value_is_told_apart(self):
        boundary = next(one for one in self.places if one["operator"] == "boundary" and "central" in one["replacement"])
        twice = next(one for one in self.places if one["operator"] == "comparison" and "central" in one["replacement"])
        for one, how in ((boundary, 1), (twice, 2)):  # 1 <= 2 has the value of 1 < 2; 1 >= 2 has the other value
            self.built([one])
            reached = self.folder / "reached"
            reached.write_bytes(bytes(4))
            self.says(TRIBOCHECK_MUTANTS_REACHED=str(reached))
            self.assertEqual(reached.read_bytes(), bytes([how, 0, 0, 0]))

    def test_arguments_are_exchanged_where_their_order_counts(self):
        self.source.write_text("namespace vec { double Mul(double, double); double Div(double, double); double MulAdd(double, double, double); }\n"
                               "struct V { double x; }; bool operator==(V, V); V operator+(V, V);\n"
                               "double all(double a, double b, double c, V u, V v) {\n"
                               "  if (u == v) return vec::Mul(a, b);\n"
                               "  return vec::MulAdd(a, b, c) + vec::Div(a, c) + (u + v).x;\n}\n")
        found = {one["replacement"] for one in places.cpp_part(self.folder, [(f"c++ -std=c++20 -c {self.source}", str(self.source))])
                 if one["operator"] == "arguments"}
        self.assertEqual(found, {"c, b", "c, a", "v + u"})  # a sum of texts or a product of matrices depends on the order

    def test_sources_that_the_build_joins_in_one_file_are_found_like_others(self):
        other = self.source.with_name("other.cpp")
        other.write_text(SOURCE)
        outside = self.folder / "build/made.cpp"
        joined = self.folder / "build/Unity/unity_0_cxx.cxx"
        joined.parent.mkdir(parents=True)
        outside.write_text(SOURCE)
        joined.write_text(f'/* made */\n\n#include "{self.source}"\n\n#include "{outside}"\n')
        entries = [{"command": f"c++ -std=c++20 -c {file}", "file": str(file)} for file in (joined, other)]
        (self.folder / "build/compile_commands.json").write_text(json.dumps(entries))
        found = collections.Counter(one["file"] for one in places.cpp_places(self.folder, self.folder / "build", 1))
        self.assertEqual(set(found), {"model/src/film.cpp", "model/src/other.cpp"})
        self.assertEqual(found["model/src/film.cpp"], len(self.places))

    def test_rooms_that_are_read_alone_have_the_places_that_they_have_among_all(self):
        header = self.folder / "model/ehl/thin.hpp"  # included by another room's source alone
        header.parent.mkdir()
        header.write_text("inline int next(int x) { return x + 1; }\n")
        other = self.folder / "model/ehl/film.cpp"
        other.write_text(SOURCE)
        self.source.write_text('#include "ehl/thin.hpp"\n' + SOURCE)
        (self.folder / "compile_commands.json").write_text(json.dumps(
            [{"command": f"c++ -std=c++20 -I{self.folder / 'model'} -c {file}", "file": str(file)} for file in (self.source, other)]))
        found = lambda **rooms: {json.dumps(one) for one in places.cpp_places(self.folder, self.folder, 1, **rooms)}  # noqa: E731
        film, engine = (found(rooms=[room]) for room in ("film", "engine"))
        self.assertEqual({json.loads(one)["file"] for one in film}, {"model/ehl/thin.hpp", "model/ehl/film.cpp"})
        self.assertEqual({json.loads(one)["file"] for one in engine}, {"model/src/film.cpp"})
        self.assertEqual(film | engine, found())

    def test_room_that_is_reserved_changes_nothing(self):
        self.source.write_text("struct List { void reserve(int); void resize(int); };\nvoid f(List& a, int n) {\n  a.reserve(n + 1);\n  a.resize(n + 2);\n}\n")
        found = [one for one in places.cpp_part(self.folder, [(f"c++ -std=c++20 -c {self.source}", str(self.source))])]
        self.assertIn("n - 2", [one["replacement"] for one in found])
        self.assertNotIn("n - 1", [one["replacement"] for one in found])

    def test_what_is_computed_while_compiling_is_the_original(self):
        one = next(one for one in self.places if one["operator"] == "constant" and (SOURCE + MAIN)[one["begin"] - 7:one["begin"]] == "return ")
        self.built([one])  # with its static_assert
        self.assertNotEqual(self.says(TRIBOCHECK_MUTANT="0"), "3 4 10")
        self.assertNotEqual(self.says(TRIBOCHECK_MUTANT="7,0"), "3 4 10")


class Build(Folder):
    def test_what_does_not_compile_is_blamed_whether_its_place_is_told_from_the_root_or_from_the_build(self):
        copy = schemata.Copy(self.folder, self.folder / "tree", self.folder / "tree/build/release")
        copy.build.mkdir(parents=True)
        (copy.tree / "a.cpp").write_text("int a;\nint b = tribocheck_mutants::value<int>(7, 1, 2);\n")
        for place in (str(copy.tree / "a.cpp"), "../../a.cpp"):
            said = f"[1/2] x\nFAILED: a.o\n{place}:2:9: error: not usable in a constant expression\n"
            with unittest.mock.patch.object(subprocess, "run", return_value=subprocess.CompletedProcess([], 1, said)):
                self.assertEqual(copy.failing(), {7}, place)


class Texts(unittest.TestCase):
    def changes(self, reader, text):
        return {(one["operator"], text.encode()[one["begin"]:one["end"]].decode(), one["replacement"]) for one in reader("x", text)}

    def test_of_python(self):
        found = self.changes(places.python_places, "def f(a, b):\n    g(a, b)\n    return a < b and not 2.0\n")
        self.assertIn(("boundary", " < ", " <= "), found)
        self.assertIn(("logic", " and ", " or "), found)
        self.assertIn(("arguments", "a, b", "b, a"), found)
        self.assertIn(("statement", "g(a, b)", "pass"), found)

    def test_cells_of_a_table_are_exchanged_and_dropped_and_a_filter_bar_parts_none(self):
        found = self.changes(places.template_places, "ä\n| {{ one.a | code }} | {{ one.b }} |\n")
        self.assertIn(("exchanged cells", " {{ one.a | code }} | {{ one.b }} ", " {{ one.b }} | {{ one.a | code }} "), found)
        self.assertIn(("dropped cell", " {{ one.b }} ", " – "), found)
        self.assertIn(("field", "a", "b"), found)
        self.assertEqual(sum(operator == "dropped cell" for operator, *_ in found), 2)

    def test_columns_of_gnuplot_are_exchanged_and_comments_are_left(self):
        found = self.changes(places.text_places, "# using 3:4\nplot data using 1:2 linewidth 1.5\n")
        self.assertEqual({one for one in found if one[0] == "exchanged columns"}, {("exchanged columns", "1:2", "2:1")})
        self.assertFalse([one for one in found if one[1] in ("3", "4")])

    def test_brackets_of_what_is_decided_while_compiling_are_known(self):
        for text, is_so in ((b"if constexpr (f(1) && ", True), (b"if constexpr (f(1)) return ", False), (b"if (a && ", False)):
            self.assertEqual(places.decides_while_compiling(text, len(text)), is_so, text)

    def test_tests_are_never_mutated(self):
        for file in ("verification/tests/analytic/x.cpp", "reports/tests/test_x.py", "benchmarks/gates/test_rules.py",
                     "verification/gates/inventory.py", "verification/conformance/subjects/fakes/fake.py"):
            self.assertIsNone(places.room_of(file), file)
        self.assertEqual(places.room_of("reports/page/render/render.py"), "page's templates and pictures")


class Draw(unittest.TestCase):
    PLACES = [{"room": "film", "file": "a", "begin": 10 * i, "end": 10 * i + 4, "operator": "abcdef"[i % 6 if i < 60 else 0],
               "replacement": "x"} for i in range(200)]

    def test_hangs_on_the_seed_alone_and_no_operator_has_more_than_a_fifth(self):
        one, two = (sample.draw(self.PLACES[::step], {"film": 20}, 7) for step in (1, -1))
        self.assertEqual(one, two)
        self.assertNotEqual(one, sample.draw(self.PLACES, {"film": 20}, 8))
        self.assertEqual(len(one), 20)
        self.assertLessEqual(max(collections.Counter(row["operator"] for row in one).values()), 4)

    def test_mutants_of_the_same_text_are_not_drawn_together(self):
        both = [{**self.PLACES[0], "operator": name, "replacement": name} for name in "abcde"]
        self.assertEqual(len(sample.draw(both, {"film": 20}, 1)), 1)

    def test_one_that_was_dropped_leaves_its_place_to_another(self):
        first = sample.draw(self.PLACES, {"film": 20}, 7)
        again = sample.draw(self.PLACES, {"film": 20}, 7, {first[3]["id"]})
        self.assertEqual(len(again), 20)
        self.assertNotIn(first[3]["id"], {row["id"] for row in again})


class Verdicts(Folder):
    """The verdicts that the ends of tests give."""

    def tree(self):
        tree = tests.Tree.__new__(tests.Tree)
        tree.root = tree.folder = self.folder
        tree.copy = types.SimpleNamespace(tree=self.folder / "none", build=self.folder / "none/build")
        return tree

    def unit(self, code, **more):
        return {"name": "one", "command": [sys.executable, "-c", code], "folder": str(self.folder), "environment": {}, "fails": [],
                "skips": [], "timeout": 5, "seconds": 0.01, **more}

    def test_green_red_and_hung(self):
        self.assertEqual(self.tree().start(self.unit("pass"), {}, 10)[0], "green")
        self.assertEqual(self.tree().start(self.unit("1 / 0"), {}, 10)[0], "red")
        self.assertEqual(self.tree().start(self.unit("print('Ran 0 tests')", fails=["Ran 0"]), {}, 10)[0], "red")
        self.assertEqual(self.tree().start(self.unit("import time; time.sleep(60)"), {}, 0.3)[0], "hung")

    def test_a_test_that_hangs_leaves_no_process(self):
        code = ("import subprocess, sys, time; child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(60)'], "
                f"start_new_session=True); open({str(self.folder / 'id')!r}, 'w').write(str(child.pid)); time.sleep(60)")
        self.assertEqual(self.tree().start(self.unit(code), {}, 2)[0], "hung")
        state = pathlib.Path("/proc", (self.folder / "id").read_text(), "stat")
        for _ in range(100):  # until the system has ended it
            if not state.exists() or state.read_text().split()[2] == "Z":
                return
            time.sleep(0.05)
        self.fail("a child still runs")

    def test_the_file_is_whole_again_after_mutants_that_were_planted(self):
        path = self.folder / "cells.md"
        path.write_text("ä b c")
        mutants = [{"switched": False, "file": "cells.md", "begin": begin, "end": begin + 1, "replacement": new} for begin, new in ((3, "bb"), (5, "d"))]
        with contextlib.suppress(ZeroDivisionError), self.tree().planted([*mutants, {"switched": True, "file": "none.cpp"}]):
            self.assertEqual(path.read_text(), "ä bb d")
            1 / 0
        self.assertEqual(path.read_text(), "ä b c")

    def test_those_that_wait_meet_a_test_together_and_each_that_it_notices_is_found(self):
        verdicts = run.Verdicts.__new__(run.Verdicts)
        verdicts.prepared = types.SimpleNamespace(numbers={str(n): n for n in range(40)})
        verdicts.rows = {str(n): {} for n in range(40)}
        verdicts.rows["8"]["verdict"] = "caught"
        mutants = [{"id": str(n), "switched": True, "file": "a.cpp"} for n in range(40)]
        with open(self.folder / "runs", "w"):
            pass
        unit = self.unit("import os, sys\nopen('runs', 'a').write('x')\n"
                         "sys.exit(bool({'3', '8', '31'} & set(os.environ['TRIBOCHECK_MUTANT'].split(','))))", test="one")
        found = verdicts.noticed_by(unit, mutants, self.tree())
        self.assertEqual([(one["id"], end) for one, end, _ in found], [("3", "red"), ("31", "red")])
        self.assertLess(len((self.folder / "runs").read_text()), 30)

    def test_those_that_wait_meet_first_what_noticed_most_others_of_their_file_and_then_of_their_room(self):
        def row(file, by, room="film"):
            return {"file": file, "room": room, "by": by}
        units = [{"name": f"{name}:{case}" if case else name, "test": name, "seconds": seconds, "differs": [1], **({"case": case} if case else {})}
                 for name, case, seconds in (("film.a_test", "A.One", 1), ("film.a_test", "A.Two", 1), ("program.test_b:X", "", 9), ("program.test_c:Y", "", 2),
                                             ("program.test_slow:Z", "", 61), ("program.test_never:N", "", 1))]
        for unit in units:
            unit["test"] = unit["test"].split(":")[0]
        verdicts = run.Verdicts.__new__(run.Verdicts)
        verdicts.prepared = types.SimpleNamespace(kept={"coverage": {unit["name"]: unit for unit in units}}, who_can_notice=lambda _: (units, 0))
        verdicts.ledger = {"samples": [{"mutants": [row("x.cpp", "film.A.Two"), *3 * [row("y.cpp", "program.test_c")], row("y.cpp", "program.test_b"),
                                                    row("x.cpp", "program.test_slow"), row("z.py", "program.test_never", "scene")]}]}
        verdicts.rows = {"m": {"outlived": []}}
        mutant = {"id": "m", "file": "x.cpp", "room": "film"}
        self.assertEqual([unit["name"] for unit in verdicts.most_likely(mutant)], ["film.a_test", "program.test_c:Y", "program.test_b:X"])
        verdicts.rows["m"]["outlived"] = ["program.test_c:Y"]
        self.assertEqual([unit["name"] for unit in verdicts.most_likely(mutant)], ["film.a_test", "program.test_b:X"])

    def test_rooms_drawn_later_with_the_same_seed_have_an_entry_of_their_own_and_the_same_rooms_go_on_with_theirs(self):
        path, entries = self.folder / "ledger.json", []
        for room in ("film", "scene", "film"):
            prepared = types.SimpleNamespace(kept={"commit": "c", "population": {room: 9}, "dropped": [], "left_out": ""}, trees=[],
                                             mutants=[{**dict.fromkeys(run.KEPT, ""), "id": room, "room": room}])
            verdicts = run.Verdicts(prepared, 7, path, None)
            self.assertEqual([one["id"] for one in verdicts.waiting()], [room] if len(entries) < 2 else [])
            verdicts.rows[room]["verdict"] = "caught"
            run.write_ledger(path, verdicts.ledger)
            entries = [list(one["rooms"]) for one in json.loads(path.read_text())["samples"]]
        self.assertEqual(entries, [["film"], ["scene"]])

    def test_a_test_that_is_red_without_a_mutant_ends_the_run_with_its_name(self):
        tree = self.tree()
        prepared = run.Prepared.__new__(run.Prepared)
        prepared.lock = threading.Lock()
        prepared.workers, prepared.trees, prepared.copy, prepared.mutants, prepared.numbers = 1, [tree], None, [], {}
        prepared.kept, prepared.file = {"coverage": {}}, self.folder / "prepared.json"
        with unittest.mock.patch.object(tests, "all_units", return_value=[self.unit("1 / 0", name="sick")]), \
                contextlib.redirect_stdout(io.StringIO()), self.assertRaisesRegex(SystemExit, "sick"):
            prepared.cover(None)
        self.assertNotIn("covered", json.loads(prepared.file.read_text()))


class Alone(Folder):
    """A mutant above the built tree: the tests that it meets, their order, and their verdicts."""
    SECONDS = {"film.slow_test": 40.0, "film.quick_test": 2.0, "film.other_test": 1.0, "program.test_film": 20.0, "gates.test_rules": 1.0}

    def meet(self, said, minutes=5, file="model/ehl/a.cpp", made=(0, ""), **row):
        """The verdict, the tests that the mutant met, and those that it outlived. `said` has the ends of the tests that are not green."""
        met = []

        def look(_, name, seconds):
            met.append(name)
            return said.get(name, "green"), f"[ RUN      ] A.First\n[  FAILED  ] A.First\n[ RUN      ] A.Skipped\n[  SKIPPED ] A.Skipped\n"
        built = unittest.mock.Mock(seconds=lambda file, targets: 0 if "other_test" in targets else 5)
        row = {"id": "m", "file": file, **row}
        with unittest.mock.patch.multiple(run.plant.Above, planted=lambda *_: contextlib.nullcontext(), look=look,
                                          make=lambda *_: types.SimpleNamespace(returncode=made[0], stdout=made[1])):
            return run.meet_alone(row, built, self.SECONDS, self.folder, minutes), met, row.get("outlived")

    def test_it_meets_those_that_read_its_text_the_quickest_first_until_one_is_red(self):
        self.assertEqual(self.meet({}), ({"verdict": "survived"}, ["film.quick_test", "program.test_film", "film.slow_test"], None))
        self.assertEqual(self.meet({"program.test_film": "red"}),
                         ({"verdict": "caught", "by": "program.test_film"}, ["film.quick_test", "program.test_film"], None))
        self.assertEqual(self.meet({"film.quick_test": "hung"})[0], {"verdict": "hung", "by": "film.A.First"})
        self.assertEqual(self.meet({}, file="benchmarks/gates/gate.py")[1], ["gates.test_rules"])
        self.assertEqual(self.meet({}, file="model/ehl/slow_film.cpp")[1][0], "film.quick_test")
        self.assertEqual(self.meet({}, file="model/ehl/slow_start.cpp")[1][0], "film.slow_test")

    def test_it_meets_none_that_it_outlived_and_waits_where_the_time_ends(self):
        self.assertEqual(self.meet({}, outlived=["film.quick_test"])[1], ["program.test_film", "film.slow_test"])
        self.assertEqual(self.meet({}, minutes=0.5), (None, ["film.quick_test", "program.test_film"], ["film.quick_test", "program.test_film"]))

    def test_what_does_not_compile_is_caught_by_an_assertion_alone(self):
        self.assertEqual(self.meet({}, made=(1, "error: static assertion failed"))[0], {"verdict": "caught", "by": "static_assert"})
        with self.assertRaises(SystemExit):
            self.meet({}, made=(1, "error: no such name"))


class Score(unittest.TestCase):
    def row(self, verdict, room="film"):
        return {"room": room, "verdict": verdict}

    def test_of_wilson(self):
        low, high = run.wilson(90, 100)
        self.assertAlmostEqual(low, 0.8256, 4)
        self.assertAlmostEqual(high, 0.9448, 4)
        self.assertEqual(run.wilson(0, 0), (0, 1))

    def test_hung_is_noticed_and_what_no_test_reaches_is_not_and_equivalents_are_counted_apart(self):
        rows = [self.row(verdict) for verdict in ("caught", "hung", "survived", "not reached", "equivalent")]
        row, = run.scores({"samples": [{"rooms": {"film": 9}, "mutants": rows}]})
        self.assertEqual((row["ran"], row["score"], row["with_equivalents"]), (5, 2 / 4, 2 / 5))
        self.assertEqual(run.noticed([row])[:2], (2, 4))

    def test_a_room_has_no_score_before_all_its_mutants_ran(self):
        table = run.scores({"samples": [{"rooms": {"film": 9}, "mutants": [self.row("caught"), {"room": "film"}]}]})
        self.assertEqual((table[0]["ran"], table[0]["score"], table[0]["with_equivalents"], table[0]["interval"]), (1, None, None, (0, 1)))
        self.assertEqual(run.noticed(table)[:2], (0, 0))

    def test_the_last_sample_of_a_room_counts(self):
        ledger = {"samples": [{"rooms": {"film": 9, "scene": 9}, "mutants": [self.row("survived"), self.row("caught", "scene")]},
                              {"rooms": {"film": 9}, "mutants": [self.row("caught")]}]}
        self.assertEqual({row["room"]: row["score"] for row in run.scores(ledger)}, {"film": 1, "scene": 1})


if __name__ == "__main__":
    unittest.main()
