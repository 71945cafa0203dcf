# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of report.json: that of each group, ../schema/<group>.json, joined into one."""
import json
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "schema"
MISSING = {
    "description": "the group could not be made", "type": "object", "additionalProperties": False,
    "required": ["missing"],
    "properties": {"missing": {
        "description": "why", "type": "object", "additionalProperties": False, "required": ["why", "how_to"],
        "properties": {"why": {"description": "what is wrong", "type": "string"},
                       "how_to": {"description": "what gives the group, as Markdown", "type": "string"}}}}}


def joined():
    groups = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(FOLDER.glob("*.json"))}
    whole = groups.pop("report")
    for name, group in groups.items():
        del group["$schema"]
        whole["properties"][name] = {"description": group.pop("description"),
                                     "oneOf": [group, {"$ref": "#/$defs/missing"}]}
    return whole | {"$defs": {"missing": MISSING}}
