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


def read(path):
    """A group's schema, whose own definitions get its name, so that those of all groups can stand in one schema."""
    text = path.read_text(encoding="utf-8").replace('"#/$defs/', f'"#/$defs/{path.stem}_')
    group = json.loads(text)
    return group, {f"{path.stem}_{name}": one for name, one in group.pop("$defs", {}).items()}


def joined():
    read_all = {path.stem: read(path) for path in sorted(FOLDER.glob("*.json"))}
    whole, _ = read_all.pop("report")
    definitions = {"missing": MISSING}
    for name, (group, own) in read_all.items():
        del group["$schema"]
        definitions |= own
        whole["properties"][name] = {"description": group.pop("description"),
                                     "oneOf": [group, {"$ref": "#/$defs/missing"}]}
    return whole | {"$defs": definitions}
