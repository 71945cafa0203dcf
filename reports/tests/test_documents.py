# SPDX-License-Identifier: Apache-2.0
"""Each JSON document that a command writes begins with its schema and its version, and conforms to that schema of reference/schemas.

A command or option that writes a new document needs a row in DOCUMENTS. A new member needs a place in the schema."""
import json
import os
import pathlib
import re
import typing
import unittest

import jsonschema

from conformance import altered
from program import Folder, quiet_scene, run, scene, strict_json, with_field, without_field
from sweeps import UNIFORM, sweep
from test_usage import COMMANDS, commands_in

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
SCHEMAS = ROOT / "reference/schemas"


class Document(typing.NamedTuple):
    schema: str  # its file is SCHEMAS/<schema>.schema.json
    arguments: str  # words in capitals stand for paths: files_in makes these files
    code: int = 0  # the exit code
    file: str = ""  # the word of the file that is the document; empty where --format json prints the document


DOCUMENTS = [
    Document("solve", "solve SCENE"), Document("solve", "solve ALL"), Document("solve", "solve COLLAPSED BAD", 2),
    Document("solve", "solve HUGE"), Document("solve", "curve SCENE"), Document("solve", "solve ALL LOUD --explain"),
    Document("curve-data", "curve COLLAPSED --data MEASURED"), Document("curve-data", "curve LOUD --data MEASURED"),
    Document("solve-about", "solve ALL ROLLER LOUD --about"), Document("solve-about", "solve BAD SCENE --about", 2),
    Document("contact", "contact ALL ROLLER LOUD SPEEDLESS"), Document("contact", "contact BAD HUGE", 2),
    Document("onset", "onset SCENE FLOODED"), Document("onset", "onset SCENE --criterion film_maximum"),
    Document("film", "film ROLLER --tolerance 1e-2"), Document("film", "film FRICTIONLESS --tolerance 1e-2"), Document("film", "film ROLLER --tolerance 1e-2 --profile"),
    Document("film", "film RIGID BAD --tolerance 1e-2", 2), Document("film", "film RIGID --tolerance 1e-2", 1), Document("film", "film BALL --speed 1 --tolerance 1e-2"),
    Document("film", "film STARVED --tolerance 1e-2"), Document("film", "film AWASH --tolerance 1e-2", 1),
    Document("functions", "functions"),
    *(Document("function", f"functions {name}") for name in ("hertz_ellipse", "load_sharing", "starvation_ratio")),
    Document("reproduce", "reproduce"), Document("reproduce", "reproduce --claim C1 --reading literal"),
    Document("accuracy", "verify"), Document("accuracy", "verify --reference WITHOUT_FRICTION", 1),
    Document("sweep", "sweep DRAWN -o OUT"), Document("sweep", "sweep show OUT"), Document("sweep", "sweep GRID -o GRID_OUT"),
    Document("sweep", "sweep CROSSED -o CROSSED_OUT"), Document("contact", "contact SOFT"), Document("solve", "solve SOFT --explain"),
    Document("sweep", "sweep merge FIRST SECOND -o MERGED"),
    Document("sweep-diff", "sweep diff OUT MORE_LOAD --most 1000", 1), Document("sweep-diff", "sweep diff OUT OUT"),
    Document("verify-baseline", "verify --subject RIGHT --sample 5 --baseline BASE --update-baseline", file="BASE"),
    Document("verify-baseline", "verify --subject WRONG --sample 5 --baseline WRONG_BASE --update-baseline", file="WRONG_BASE"),
    Document("verify-subject", "verify --subject RIGHT --sample 5"),
    Document("verify-subject", "verify --subject WRONG --sample 5", 1),
    Document("verify-subject", "verify --subject WRONG --sample 5 --baseline BASE", 1),
    Document("field", "field VERDICTS"),
    Document("bench", "bench --subject RIGHT --quick --filter ^hertz_point"),
    Document("bench-baseline", "bench --subject RIGHT --quick --filter ^hertz_point --baseline SPEED --update-baseline", file="SPEED"),
    Document("bench", "bench --subject WRONG --quick --filter ^hertz_point --baseline SPEED", 1),  # its rows have another name
    Document("profile", "profile --plugin PLUGIN --function hertz_point --seconds 0.1"),
]
# Schemas with members that need another program, and the tests that check these.
ELSEWHERE = {"bench-baseline": "test_bench_gate has rows of contenders", "profile": "test_profile"}


def files_in(folder):
    """The paths that stand for the words of DOCUMENTS."""
    line = quiet_scene(id="line", load=2000, speed=1, closures={"film": "dowson_toyoda_central"},
                       bodies={"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 1e-2})
    few = quiet_scene(id="few", speed=[0.1, 1], outputs=["film", "regime"])
    made = {"SCENE": quiet_scene(), "ALL": few | {"closures": {"asperity": "greenwood_williamson"}}, "BAD": scene(load=-1),
            "COLLAPSED": scene("smooth", speed=[3, 4]), "FLOODED": scene(supply=None), "LOUD": scene(id="loud", load=5000),
            "HUGE": with_field(scene(speed=1e300, supply=None), "surface.summit_height_sd", 1e-200),
            "SOFT": few | {"bodies": {"effective_modulus": 1e7, "radius_x": 4e-2, "radius_y": 2e-3}, "closures": {"film": "hamrock_dowson_soft_central"}},
            "STARVED": quiet_scene(load=3, speed=1, supply={"inlet_film": 1e-7}), "AWASH": quiet_scene(load=3, speed=1, supply={"inlet_film": 1e-3}),
            "RIGID": line | {"speed": 1e10},
            "SPEEDLESS": with_field(without_field(few, "speed"), "surface.rms_roughness", [1e-7, 2e-7])}
    paths = {word: folder.write(f"{word.lower()}.toml", tree) for word, tree in made.items()}
    roller = (ROOT / "reference/scenes/roller.toml").read_text(encoding="utf-8")
    paths["FRICTIONLESS"] = folder.write("frictionless.toml", roller.replace("eyring_stress", "# eyring_stress"))
    paths["MEASURED"] = folder.write("measured.csv", "speed [m/s],film [nm],friction\n0.1,30,\n4,0,0.1\n")
    paths["DRAWN"] = folder.write("drawn.toml", sweep({"accept": None, "lubricant.viscosity": UNIFORM, "speed": "[0.1, 3.0]",
                                                       "outputs": '["film", "regime"]'},
                                                      onset='["film_maximum"]', draws=64, sensitivity="true"))
    paths["GRID"] = folder.write("grid.toml", sweep({"load": "[20, 50]", "speed": "3"}))
    paths["CROSSED"] = folder.write("crossed.toml", sweep({"accept": None, "load": "[20, 50]", "lubricant.viscosity": UNIFORM, "speed": "3"}, draws=64))
    paths |= {word: folder.path(f"{word.lower()}.h5") for word in ("CROSSED_OUT", "OUT", "GRID_OUT", "MERGED", "FIRST", "SECOND", "MORE_LOAD")}
    more_load = folder.write("more_load.toml", pathlib.Path(paths["DRAWN"]).read_text().replace("load = 50", "load = 51"))
    for sweep_file, word, *shard in ((paths["GRID"], "FIRST", "--shard", "1/2"), (paths["GRID"], "SECOND", "--shard", "2/2"),
                                     (more_load, "MORE_LOAD")):
        assert run("sweep", sweep_file, "-o", paths[word], *shard).code == 0
    wrong = """if name == "hamrock_dowson_central": answer["value"] *= 0.7
    if name == "barus_viscosity": answer["value"] *= 1 + 1e-9 * os.times().elapsed
    if name == "hertz_line": os.kill(os.getpid(), signal.SIGKILL)"""
    paths |= {"RIGHT": altered(folder, "pass"), "WRONG": altered(folder, wrong, name="wrong.py"),
              "BASE": folder.path("base.json"), "WRONG_BASE": folder.path("wrong_base.json"), "SPEED": folder.path("speed.json")}
    paths["VERDICTS"] = folder.path("verdicts")
    os.mkdir(paths["VERDICTS"])
    verdict = run("verify", "--subject", paths["WRONG"], "--sample", "5", "--format", "json").out
    for stem, date in (("now", "2026-11-28"), ("then", "2026-01-01")):
        folder.write(f"verdicts/{stem}.toml", f'name = "x"\nlanguage = "Python"\ndate = {date}\n')
        folder.write(f"verdicts/{stem}.json", verdict if stem == "now" else verdict.replace('"FAILED"', '"held"'))
    exact = pathlib.Path(folder.path("exact"))
    exact.mkdir()
    for table in (ROOT / "reference/exact").iterdir():
        lines = table.read_text(encoding="utf-8").splitlines(keepends=True)
        (exact / table.name).write_text("".join(one for one in lines if ",friction," not in one), encoding="utf-8")
    return paths | {"PLUGIN": os.path.join(os.environ["TRIBOCHECK_SUBJECTS"], "c_plugin.so"), "ROLLER": str(ROOT / "reference/scenes/roller.toml"), "BALL": str(ROOT / "reference/scenes/ball_on_flat.toml"), "WITHOUT_FRICTION": str(exact)}


class Schema:
    def __init__(self, name):
        self.name = name
        self.tree = json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))
        self.validator = jsonschema.Draft202012Validator(self.tree)

    def problems(self, document):
        return [f"{error.json_path}: {error.message[:300]}" for error in self.validator.iter_errors(document)]

    def takes(self, node, value):
        return self.validator.evolve(schema=node).is_valid(value)

    def nodes(self, node=None, path="$"):
        """All schemas within this one, each with its path."""
        node = self.tree if node is None else node
        yield path, node
        for name, one in [*node.get("properties", {}).items(), *node.get("$defs", {}).items()]:
            yield from self.nodes(one, f"{path}.{name}")
        for key in ("items", "additionalProperties"):
            if isinstance(node.get(key), dict):
                yield from self.nodes(node[key], f"{path}.{key}")

    def objects(self, node, value):
        """Each object within a document, with its schema."""
        if "$ref" in node:
            node = self.tree["$defs"][node["$ref"].removeprefix("#/$defs/")]
        for one in node.get("anyOf", []):
            yield from self.objects(one, value)
        if isinstance(value, list) and "items" in node:
            for one in value:
                yield from self.objects(node["items"], one)
        if isinstance(value, dict) and node.get("type") == "object":
            yield node, value
            for name, one in value.items():
                yield from self.objects(self.member(node, name), one)

    @staticmethod
    def member(node, name):
        """The schema of a member of an object; empty where it may be anything."""
        found = [one for pattern, one in node.get("patternProperties", {}).items() if re.search(pattern, name)]
        return node.get("properties", {}).get(name) or (found[0] if found else node.get("additionalProperties")) or {}


def is_any(node):
    """Does a schema take any value?"""
    return not set(node) & {"type", "enum", "const", "anyOf", "$ref"}


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = Folder()
        cls.addClassCleanup(folder.cleanup)
        paths = files_in(folder)
        cls.schemas = {path.name.removesuffix(".schema.json"): Schema(path.name.removesuffix(".schema.json"))
                       for path in SCHEMAS.glob("*.schema.json")}
        cls.told = []  # the arguments, the schema and the document of each row
        for one in DOCUMENTS:
            done = run(*(paths.get(word, word) for word in one.arguments.split()), "--format", "json", cwd=ROOT)
            assert done.code == one.code, f"{one.arguments}: exit code {done.code}: {done.err}"
            text = pathlib.Path(paths[one.file]).read_text(encoding="utf-8") if one.file else done.out
            cls.told.append((one.arguments, cls.schemas[one.schema], strict_json(text)))

    def test_each_begins_with_schema_and_version(self):
        version = run("--version").out.split()[1]
        for arguments, schema, document in self.told:
            self.assertEqual(list(document)[:2], ["schema", "version"], arguments)
            self.assertEqual((document["schema"], document["version"]), (schema.tree["properties"]["schema"]["const"], version))

    def test_each_is_what_its_schema_says(self):
        for arguments, schema, document in self.told:
            with self.subTest(arguments):
                self.assertEqual(schema.problems(document), [],
                                 f"either the document is wrong, or {schema.name}.schema.json lacks what is new in it")

    def test_what_is_lacking_unknown_or_of_another_type_is_seen(self):
        no_value = [[None]]  # no member has this value
        for arguments, schema, document in self.told:
            seen = set()
            for node, value in [(schema.tree, document), *schema.objects(schema.tree, document)]:
                if (shape := (id(node), *sorted(value))) in seen:
                    continue
                seen.add(shape)
                is_open = "additionalProperties" not in node
                self.assertIs(schema.takes(node, value | {"unknown": no_value}), is_open, (arguments, value))
                for name in value:
                    inner = schema.member(node, name)
                    self.assertIs(schema.takes(node, value | {name: no_value}), is_any(inner), (arguments, value, name))
                for name in node.get("required", []):
                    less = {key: one for key, one in value.items() if key != name}
                    self.assertFalse(schema.takes(node, less), (arguments, value, name))

    def test_each_command_that_writes_json_is_here(self):
        commands = {(one,) for one in COMMANDS} | {(one, below) for one in COMMANDS for below in commands_in(run(one, "--help").out)}
        writes_json = {one for one in commands if re.search(r"--format: .* not in .*\bjson\b", run(*one, "--format", "no").err)}
        self.assertGreater(len(writes_json), 8)
        here = {tuple(one.arguments.split()[:length]) for one in DOCUMENTS for length in (1, 2)}
        self.assertEqual(writes_json - here, set(), "a command without a row in DOCUMENTS")
        self.assertEqual(set(self.schemas) - {one.schema for one in DOCUMENTS}, set(), "a schema without a row")

    def test_each_member_of_a_schema_is_in_a_document_and_lacks_in_one_where_it_may(self):
        found, lacking = set(), set()
        for _, schema, document in self.told:
            for node, value in schema.objects(schema.tree, document):
                found |= {(id(node), name) for name in value}
                lacking |= {(id(node), name) for name in node.get("properties", {}) if name not in value}
        for schema in self.schemas.values():
            members = [(f"{path}.{name}", (id(node), name), name in node.get("required", []))
                       for path, node in schema.nodes() for name in node.get("properties", {}) if schema.name not in ELSEWHERE]
            self.assertEqual([path for path, member, _ in members if member not in found], [], schema.name)
            self.assertEqual([path for path, member, required in members if not required and member not in lacking], [], schema.name)


class Schemas(unittest.TestCase):
    def test_each_is_one_that_is_closed_and_tells_its_members(self):
        for path in sorted(SCHEMAS.glob("*.schema.json")):
            schema = Schema(path.name.removesuffix(".schema.json"))
            jsonschema.Draft202012Validator.check_schema(schema.tree)
            self.assertEqual(schema.tree["$schema"], jsonschema.Draft202012Validator.META_SCHEMA["$id"])
            self.assertRegex(schema.tree["properties"]["schema"]["const"], rf"^{schema.name}/[1-9]\d*$")
            self.assertEqual(schema.tree["required"][:2], ["schema", "version"])
            for where, node in schema.nodes():
                with self.subTest(path.name, where=where):
                    if node.get("properties"):
                        self.assertIsNot(node.get("additionalProperties", True), True)
                    for name, member in node.get("properties", {}).items():
                        self.assertFalse(is_any(member) and "any type" not in member["description"], name)
                        self.assertTrue(member.get("description") or "$ref" in member, name)

    def test_what_two_schemas_describe_is_described_alike(self):
        one, all_of_them = Schema("function").tree, Schema("functions").tree
        self.assertEqual({**all_of_them["properties"]["functions"]["items"]["properties"], **all_of_them["$defs"]},
                         {name: node for name, node in {**one["properties"], **one["$defs"]}.items() if name not in ("schema", "version")})
        report = json.loads((ROOT / "reports/page/groups/report.schema.json").read_text(encoding="utf-8"))
        ledger, reproduce = report["properties"]["ledger"]["oneOf"][0]["properties"], Schema("reproduce").tree
        self.assertEqual({**ledger, **reproduce["properties"]}, {**reproduce["properties"], "committed": ledger["committed"],
                                                            "circular_gap": ledger["circular_gap"]})
        self.assertEqual(reproduce["$defs"], {name: report["$defs"][name] for name in reproduce["$defs"]})


if __name__ == "__main__":
    unittest.main()
