#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The certified values, cases, solved films and known mistakes as one archive: data.py PROGRAM FOLDER.

FOLDER gets tribocheck-data-VERSION.zip. The same program and sources give the same bytes.
"""
import argparse
import csv
import hashlib
import io
import json
import pathlib
import subprocess
import tomllib
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parents[2]


def number_of(text):
    """The double of a decimal or hexadecimal text; None where it is no number."""
    try:
        return float.fromhex(text) if "0x" in text else float(text)
    except ValueError:
        return None


def read_table(path):
    """The facts of a table's head, and its rows. Numbers are doubles, but `value` with its 40 digits is a text. An empty cell is None."""
    lines = path.read_text(encoding="utf-8").splitlines()
    head = dict(line[2:].partition(": ")[::2] for line in lines if line.startswith("# "))
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    for name in rows[0]:
        cells = [row[name] for row in rows]
        is_number = name not in ("id", "value") and all(number_of(cell) is not None for cell in cells if cell)
        for row in rows:
            row[name] = None if not row[name] else number_of(row[name]) if is_number else row[name]
    return head, rows


def csv_text(rows):
    """The rows as CSV. A row may lack members; a member that is an object or a list is JSON in its cell."""
    out = io.StringIO()
    writer = csv.DictWriter(out, list(dict.fromkeys(name for row in rows for name in row)), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({name: value if isinstance(value, (str, float, int)) else json.dumps(value, ensure_ascii=False) for name, value in row.items()})
    return out.getvalue()


def schema_of(title, description, rows):
    """The JSON Schema of one row."""
    types = {str: "string", float: "number", int: "number", bool: "boolean", type(None): "null", dict: "object", list: "array"}
    found = {}
    for row in rows:
        for name, value in row.items():
            found.setdefault(name, {}).setdefault(types[type(value)])
    return json.dumps({"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, "description": description, "type": "object",
                       "properties": {name: {"type": sorted(kinds)} for name, kinds in found.items()},
                       "required": [name for name in found if all(name in row for row in rows)], "additionalProperties": False},
                      indent=2, ensure_ascii=False) + "\n"


def files_of(program):
    """The version, and the files of the archive as {path: text}."""
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    version, commit = said.split()[1], said.partition("commit ")[2].partition(",")[0]
    files = {name: (SOURCES / name).read_text(encoding="utf-8") for name in ("CITATION.cff", "LICENSE")}
    files["README.md"] = (HERE / "data.md").read_text(encoding="utf-8").replace("VERSION", version).replace("COMMIT", commit)

    def add(name, rows, title, description, table=None):
        files[f"{name}.csv"] = table or csv_text(rows)
        files[f"{name}.jsonl"] = "".join(json.dumps(row, ensure_ascii=False, allow_nan=False) + "\n" for row in rows)
        files[f"{name}.schema.json"] = schema_of(title, description, rows)

    for folder in ("exact", "ehl"):
        for path in sorted((SOURCES / "reference" / folder).glob("*.csv")):
            head, rows = read_table(path)
            facts = "; ".join(f"{key}: {text}" for key, text in head.items() if key != "quantity" and not key.startswith("sha256"))
            add(f"{folder}/{path.stem}", rows, head["quantity"], facts, path.read_text(encoding="utf-8"))
    cases = subprocess.run([program, "verify", "--save-cases", "-"], cwd=SOURCES, capture_output=True, text=True, check=True).stdout
    add("cases", [json.loads(line) for line in cases.splitlines()], "the questions of `tribocheck verify`",
        "A function and its arguments, or a scene with one speed; SI units. An id is that of the first row in exact/FUNCTION with these arguments.")
    mistakes = (SOURCES / "reference/mistakes.toml").read_text(encoding="utf-8")
    about = mistakes.partition("\n\n")[0].replace("# ", "").replace("#", "")
    rows = json.loads(json.dumps(tomllib.loads(mistakes)["mistake"]), parse_constant=str)  # JSON has no infinity: the text "Infinity"
    add("mistakes", rows, "mistakes that people make", about)
    files["SHA256SUMS"] = "".join(f"{hashlib.sha256(text.encode()).hexdigest()}  {name}\n" for name, text in sorted(files.items()))
    return version, files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    version, files = files_of(given.program)
    name = f"tribocheck-data-{version}"
    given.folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(given.folder / f"{name}.zip", "w") as archive:
        for path, text in sorted(files.items()):
            info = zipfile.ZipInfo(f"{name}/{path}")  # its date is 1980-01-01
            info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(info, text)
    print(given.folder / f"{name}.zip")


if __name__ == "__main__":
    main()
