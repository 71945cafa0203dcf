# SPDX-License-Identifier: Apache-2.0
"""report.json agrees with report.schema.json beside it, which describes each of its values."""

import copy
import json
import unittest

import jsonschema

from report_files import ROOT, WrittenReport

COMMON = {"tribocheck", "sections", "findings", "not_run", "files"}


def values(schema, path="report"):
    """Each schema of a value within a schema, with its path; without schemas that only choose between others."""
    yield path, schema
    for name, one in schema.get("properties", {}).items():
        yield from values(one, f"{path}.{name}")
    for key in ("items", "additionalProperties"):
        if isinstance(schema.get(key), dict):
            yield from values(schema[key], f"{path}.{key}")
    for one in schema.get("oneOf", []):
        for name, inner in one.get("properties", {}).items():
            yield from values(inner, f"{path}.{name}")


class Schema(WrittenReport):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.report = json.loads((cls.out / "report.json").read_text())
        cls.schema = json.loads((cls.out / "report.schema.json").read_text())

    def problems(self, report):
        return [f"{error.json_path}: {error.message[:300]}"
                for error in jsonschema.Draft202012Validator(self.schema).iter_errors(report)]

    def test_the_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)

    def test_the_report_is_what_it_says(self):
        self.assertEqual(self.problems(self.report), [])

    def test_each_group_is_there_and_described(self):
        groups = set(self.report) - COMMON
        self.assertEqual(self.schema, json.loads((ROOT / "reports/page/groups/report.schema.json").read_text()))
        self.assertEqual(set(self.schema["properties"]), groups | COMMON)
        for name in groups:
            self.assertNotIn("missing", self.report[name], name)

    def test_each_value_says_what_it_is(self):
        for path, schema in values(self.schema):
            if not path.endswith((".items", ".additionalProperties")):
                self.assertTrue(schema.get("description"), path)
            if schema.get("type") == "object" and schema.get("properties"):
                self.assertIs(schema["additionalProperties"], False, path)

    def test_what_is_lacking_unknown_or_of_another_type_is_seen(self):
        for name in set(self.report) - COMMON:
            for key, value in self.report[name].items():
                with self.subTest(group=name, key=key):
                    other = copy.deepcopy(self.report)
                    other[name][key] = "text" if isinstance(value, list) else [[]]
                    self.assertTrue(self.problems(other))
            with self.subTest(group=name):
                self.assertTrue(self.problems(self.report | {name: self.report[name] | {"unknown": 1}}))
                self.assertTrue(self.problems(self.report | {name: dict(list(self.report[name].items())[1:])}))


if __name__ == "__main__":
    unittest.main()
