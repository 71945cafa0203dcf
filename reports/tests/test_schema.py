# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema and the program judge the same scenes alike.

verification/tests/scene compares the schema file with the reader's table of fields. Here the real program and
a validator, which does not know that table, judge the same good and bad scenes, as JSON and as TOML. Rules
that a schema cannot state have their own test.
"""

import copy
import json
import os
import pathlib
import subprocess
import tempfile
import tomllib
import unittest

import jsonschema

PROGRAM = os.environ["TRIBOCHECK"]
ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
SCHEMA = json.loads((ROOT / "reference/scene.schema.json").read_text(encoding="utf-8"))

# `solve` needs speeds. The schema does not require them, as it is also for scenes of `onset`.
SOLVABLE = {"allOf": [SCHEMA], "required": ["speed"]}

GOOD = {
    "id": "rough",
    "load": 50,
    "speed": 0.1,
    "surface": {
        "summit_density": 5e10,
        "summit_radius": 1e-5,
        "summit_height_sd": 1e-7,
        "summit_plane_offset": 0.919,
    },
    "bodies": {"effective_modulus": 107.9e9, "reduced_radius": 9.5e-3},
    "lubricant": {"viscosity": 0.0202, "pressure_viscosity": 2e-8, "eyring_stress": 2.5e6},
    "supply": {"inlet_film_ratio": 4},
    "friction": {"boundary_coefficient": 0.13},
}

RANGE = {"from": 1e-4, "to": 3, "count": 4}

# One value of each kind, tried in place of every field and every table of a scene.
VALUES = [0, -1, 1, 1.5, 2, 3, 2.0, 0.0, -0.0, 1e-300, 1e300, 10**30, True, False, "", "abc", [], {},
          [1], [0.1, 2], [0], ["film"], ["film", "film"], ["friction", "regime"], [[1]], [True],
          {"from": 1, "to": 2}, {"from": 1}, {"inlet_film": 1e-7}, {"a": 1}]

WORDS = ["log", "lin", "eyring", "limiting", "barus", "ambient", "roelands", "greenwood_tripp",
         "greenwood_williamson", "flooded_inlet", "starved_inlet", "printed_exponents", "damiens"]


def with_value(scene, path, value):
    """A copy with one value set, or removed when `value` is None."""
    changed = copy.deepcopy(scene)
    *tables, name = path.split(".")
    table = changed
    for key in tables:
        table = table.setdefault(key, {})
    if value is None:
        table.pop(name, None)
    else:
        table[name] = value
    return changed


def field_paths(schema=SCHEMA, prefix=""):
    """All paths of the schema, also those of tables and of the fields of a speed range."""
    for name, node in schema["properties"].items():
        yield prefix + name
        for table in [node, *node.get("oneOf", [])]:
            if "properties" in table:
                yield from field_paths(table, prefix + name + ".")


def base_for(path):
    if path.startswith("speed."):
        return with_value(GOOD, "speed", RANGE)
    if path.startswith("supply."):
        return with_value(GOOD, "supply", {})
    return GOOD


def corpus():
    yield GOOD
    yield with_value(GOOD, "speed", RANGE)
    for path in field_paths():
        base = base_for(path)
        yield with_value(base, path, None)
        yield with_value(base, path + "x", 1)
        for value in VALUES:
            yield with_value(base, path, value)
    for path in ["speed.spacing", "friction.fluid", "friction.viscosity", "closures.asperity",
                 "closures.starvation", "closures.film"]:
        for word in WORDS:
            yield with_value(base_for(path), path, word)
    roelands = with_value(GOOD, "friction.viscosity", "roelands")
    for viscosity in [1e-9, 6.315e-5, 6.3151e-5, 1]:
        yield with_value(roelands, "lubricant.viscosity", viscosity)
    for law in ["hamrock_dowson_soft_central", "hamrock_dowson_soft_minimum", "hamrock_dowson_minimum"]:
        for rise in [0, 1e-9, -1e-9]:
            yield with_value(with_value(GOOD, "closures.film", law), "lubricant.pressure_viscosity", rise)
    for outputs in [["film"], ["friction"], ["film", "friction"]]:
        for path in ["friction.boundary_coefficient", "lubricant.eyring_stress", "friction"]:
            yield with_value(with_value(GOOD, "outputs", outputs), path, None)
    for kinds in [("inlet_film", "inlet_flow"), ("inlet_film_ratio", "inlet_flow")]:
        yield with_value(GOOD, "supply", {kind: 1e-7 for kind in kinds})


def toml_value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    if isinstance(value, str):
        return json.dumps(value)
    return repr(value)


def toml_text(scene):
    return "".join(f"{key} = {toml_value(value)}\n" for key, value in scene.items())


def is_valid(scene):
    return jsonschema.Draft202012Validator(SOLVABLE).is_valid(scene)


def is_reversed(scene):
    """Whether a range of speeds is reversed or empty. Only the program can tell: the schema cannot compare two fields."""
    speed = scene.get("speed")
    return isinstance(speed, dict) and not speed["from"] < speed["to"]


class SchemaTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_solve(self, paths):
        command = [PROGRAM, "solve", *map(str, paths), "--format", "json"]
        return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)

    def refused_files(self, texts):
        """Solves all these files in one call. Returns the names of those that get an error line, and stderr."""
        paths = []
        for name, text in texts.items():
            paths.append(self.folder / name)
            paths[-1].write_text(text, encoding="utf-8")
        done = self.run_solve(paths)
        self.assertIn(done.returncode, (0, 2), done.stderr)
        lines = [line for line in done.stderr.splitlines() if "warning" not in line]
        refused = {path.name for path in paths if any(f"{path}:" in line for line in lines)}
        self.assertEqual(done.returncode, 2 if refused else 0, done.stderr)
        return refused, done.stderr

    def assert_judged_alike(self, scenes, suffix, write):
        for start in range(0, len(scenes), 100):
            batch = {f"{start + i:04}{suffix}": scene
                     for i, scene in enumerate(scenes[start:start + 100])}
            refused, stderr = self.refused_files({n: write(s) for n, s in batch.items()})
            for name, scene in batch.items():
                messages = "\n".join(line for line in stderr.splitlines() if name in line)
                good = is_valid(scene) and not is_reversed(scene)
                self.assertEqual(name not in refused, good,
                                 f"\nscene: {json.dumps(scene)}\nprogram: {messages or 'accepts'}")

    def test_the_schema_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_the_corpus_has_good_and_bad_scenes(self):
        verdicts = [is_valid(scene) for scene in corpus()]
        self.assertGreater(verdicts.count(True), 100)
        self.assertGreater(verdicts.count(False), 500)

    def test_json_scenes_are_judged_alike(self):
        self.assert_judged_alike(list(corpus()), ".json", json.dumps)

    def test_toml_scenes_are_judged_alike(self):
        scenes = list(corpus())
        for scene in scenes[::20]:
            self.assertEqual(tomllib.loads(toml_text(scene)), scene)
        self.assert_judged_alike(scenes, ".toml", toml_text)

    def test_published_scenes_are_valid(self):
        paths = sorted((ROOT / "reference/published").glob("*.toml"))
        self.assertGreaterEqual(len(paths), 3)
        for path in paths:
            scene = tomllib.loads(path.read_text(encoding="utf-8"))
            self.assertTrue(is_valid(scene), path.name)

    def test_the_program_refuses_what_the_schema_cannot_say(self):
        texts = {
            "reversed.json": json.dumps(with_value(GOOD, "speed", {"from": 3, "to": 1})),
            "empty.json": json.dumps(with_value(GOOD, "speed", {"from": 3, "to": 3})),
            "large.json": json.dumps(GOOD).replace("50", "1e400", 1),
            "small.json": json.dumps(GOOD).replace("50", "1e-400", 1),
            "twice.json": json.dumps(GOOD).replace("{", '{"load": 50, ', 1),
        }
        refused, stderr = self.refused_files(texts)
        self.assertEqual(refused, set(texts), stderr)


if __name__ == "__main__":
    unittest.main()
