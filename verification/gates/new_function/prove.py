#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Adds a function to a scratch copy of the tree, and checks that it is offered everywhere.

The function is a header, an entry of the catalogue, a generator of its certified values, and a mistake: the
files beside this one. Nothing else is written. Then it has to be listed by `tribocheck functions`, answered by
`stream`, certified by `verify`, written by `init`, asked of a solver in Python and of one in C, named when it is
wrong, and shown on the report's page. Some three minutes; exit code 1 where one of these fails.

  verification/gates/new_function/prove.py
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "verification/gates"))
import scratch  # noqa: E402
NAME = "oil_bulk_modulus"


def run(command, code=0, **options):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != code:
        sys.exit(f"exit code {done.returncode}, not {code}: {command}\n{done.stdout[-3000:]}")
    return done.stdout


def insert(path, before, text):
    """Puts a text in front of the first place of another text, which has to be there."""
    whole = path.read_text()
    if before not in whole:
        sys.exit(f"{path}: \"{before}\" is not there any more")
    path.write_text(whole.replace(before, text + before, 1))


def piece(name):
    return (HERE / name).read_text()


def add_function(tree):
    shutil.copy(HERE / "oil_bulk_modulus.hpp", tree / "model/include/tribo")
    family = tree / "model/catalogue/smooth_contact.cpp"
    insert(family, '#include "tribo/hertz.hpp"\n', '#include "tribo/oil_bulk_modulus.hpp"\n')
    insert(family, "constexpr std::array entries{\n", piece("parameters.inc"))
    insert(family, '    Function{.name = "hertz_point"', piece("entry.inc"))
    generators = tree / "reference/generators"
    insert(generators / "liquids.cpp", "}  // namespace tribo::reference\n", piece("generator.inc"))
    insert(generators / "table.hpp", "Table operating_points();", "Table oil_bulk_moduli();\n")
    insert(generators / "generate.cpp", "operating_points", "oil_bulk_moduli, ")
    with open(tree / "reference/mistakes.toml", "a") as mistakes:
        mistakes.write(piece("mistakes.toml"))


def build(tree):
    folder = tree / "build"
    run(["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS=-O1",
         "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DTRIBOCHECK_BUILD_REFERENCES=ON"])
    run(["cmake", "--build", folder, "--target", "tribocheck", "generate_references",
         "-j", str(len(os.sched_getaffinity(0)))])
    exact = tree / "reference/exact"
    run([folder / "reference/generators/generate_references", exact, "--only", f"{NAME}.csv"])
    return folder / "tribocheck"


def verdict_of(said):
    quantities = {one["quantity"]: one["status"] for one in said["quantities"]}
    return quantities[NAME], [mistake for one in said["diagnoses"] for mistake in one["mistakes"]]


def checks(program, tree, folder):
    """Checks each thing in turn, and yields a line for each."""
    def ask(*words, **options):
        return run([program, *words], cwd=tree, **options)

    if NAME not in ask("functions") or "5.9e8" not in ask("functions", NAME):
        sys.exit("`tribocheck functions` does not show it")
    yield "tribocheck functions lists it, and explains it"
    answer = json.loads(ask("stream", input=json.dumps({"id": "d", "function": NAME, "pressure": 1e9})))
    if abs(answer["value"] - 1.93 * 1.59 / 0.2006 * 1e9) > 1e-4:
        sys.exit(f"stream answers {answer}")
    yield "stream answers it"
    own = {one["quantity"]: one for one in json.loads(ask("verify", "--format", "json"))}
    if not own[NAME]["passed"] or own[NAME]["cases"] != 40:
        sys.exit(f"verify says {own[NAME]}")
    yield f"verify certifies it: {own[NAME]['cases']} cases, at most {own[NAME]['worst_ulp']:.2g} ulp"

    solver = folder / "solver.py"
    ask("init", "subject", "--language", "python", "--out", solver)
    head, rest = solver.read_text().split(f"def {NAME}(", 1)
    for scale, verdict, mistakes in (("1", "held", []), ("1e-6", "FAILED", ["bulk-pressure-in-MPa"])):
        body = rest.replace(
            "return None", f"p = pressure * {scale}\n    return (5.9e8 + 1.34 * p) * (5.9e8 + p) / 2.006e8", 1)
        solver.write_text(f"{head}def {NAME}({body}")
        said = ask("verify", "--format", "json", "--subject", f"python3 '{solver}'", code=0 if scale == "1" else 1)
        if verdict_of(json.loads(said)) != (verdict, mistakes):
            sys.exit(f"of a solver in Python, pressure times {scale}: {verdict_of(json.loads(said))}")
    yield "a solver in Python from `init` is asked it; a mistake is named"

    solver, library = folder / "solver.c", folder / "libsolver.so"
    ask("init", "subject", "--language", "c", "--out", solver)
    head, rest = solver.read_text().split(f"static int {NAME}(", 1)
    body = rest.replace(
        "return TRIBOCHECK_NOT_OFFERED;",
        "*value = (5.9e8 + 1.34 * pressure) * (5.9e8 + pressure) / 2.006e8;\n  return TRIBOCHECK_DONE;", 1)
    solver.write_text(f"{head}static int {NAME}({body}")
    run(["cc", "-O2", "-shared", "-fPIC", "-I", tree / "verification/conformance", solver, "-o", library])
    said = json.loads(ask("verify", "--format", "json", "--plugin", library))
    if verdict_of(said) != ("held", []):
        sys.exit(f"of a plug-in in C: {verdict_of(said)}")
    yield "a plug-in in C from `init` is asked it"

    out = folder / "report"
    ask("report", "--section", "verification", "--out", out)
    if NAME not in (out / "report.md").read_text():
        sys.exit("the report's page does not show it")
    yield "the report's page shows it"


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    with tempfile.TemporaryDirectory(prefix="tribocheck-new-function-") as name:
        folder = pathlib.Path(name)
        tree = folder / "tree"
        scratch.copy_tree(ROOT, tree)
        add_function(tree)
        for seen in checks(build(tree), tree, folder):
            print(seen, flush=True)


if __name__ == "__main__":
    main()
