#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles the model to WebAssembly: reports/live/tribocheck.wasm, as `make live` does.

  reports/live/make_live.py build/release            writes it
  reports/live/make_live.py build/release --check    makes it in build/live, and compares its bytes with those of the tree

The bytes depend on the sources, on the table of solved films in the build folder and on Debian's packages alone
(.ci/packages/live.txt). Exit code 1: the bytes differ, or a step failed.
"""
import argparse
import concurrent.futures
import gzip
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "reports/live"
# None of these sources reads a file, starts a thread or throws.
SOURCES = [*sorted((ROOT / "model/src").glob("*.cpp")), *sorted((ROOT / "model/catalogue").glob("*.cpp")),
           *(path for path in sorted((ROOT / "model/scene").glob("*.cpp"))
             if path.stem not in ("input_text", "reader", "reader_json")),
           ROOT / "verification/protocol/output_values.cpp", *sorted(HERE.glob("*.cpp"))]
COMPILER = ["clang++-14", "--target=wasm32-wasi", "-fno-exceptions"]
FLAGS = ["-std=c++20", "-ffp-contract=off", "-ffunction-sections", "-fdata-sections", "-DNDEBUG", "-Wall", "-Wextra",
         # The program does not ask the processor for its instruction sets. include/charconv reads numbers, without a locale.
         "-DHWY_COMPILE_ONLY_SCALAR", "-DTOML_HEADER_ONLY=1", "-DTOML_FLOAT_CHARCONV=1", "-DFMT_HEADER_ONLY", "-DFMT_EXCEPTIONS=0",
         "-DFMT_STATIC_THOUSANDS_SEPARATOR=0x2c"]
INCLUDES = ["reports/live/include", "build/live", "model/include", "model/src", "model", "verification", "reports"]

# --- The tables of solved films: those of the central film, and packed those of the least one.


def film_tables(text):
    """The tables of central films only. NaN replaces the least and the starved films, which would take two thirds of all bytes."""
    for table in ("line_minimum", "point_minimum", "inlet"):
        text = re.sub(rf"(double {table}_nodes\[\]\[4\] = {{\n).*?\n}};",
                      r"\1" + "{no_film, no_film, no_film, no_film},\n" * 4 + "};", text, flags=re.DOTALL)
        text, count = re.subn(rf"(?: \d+,)+ {table}_nodes}};",
                              (" 1, 1, 1, " if table == "inlet" else " 1, 1, ") + f"{table}_nodes}};", text)
        if count != 1:
            raise ValueError(f"film_tables.inc has no table {table}")
    return text


# The packed tables hold multiples of this, of ln Ĥ and of its derivatives.
UNIT = 2.0**-14


def packed(numbers):
    """A code for each signed difference, in bytes of seven bits, the lowest first; the last byte is above 127. Code 0: no number."""
    for number in numbers:
        code = 0 if number is None else 1 + (2 * number if number >= 0 else -2 * number - 1)
        while code > 127:
            yield code % 128
            code //= 128
        yield 128 + code


def differences(numbers, row):
    """Each number of rows of length `row` minus left + above − between, a plane through its earlier neighbours. A missing number is on the plane."""
    known = []
    for i, number in enumerate(numbers):
        left = known[i - 1] if i % row else 0
        above, between = (known[i - row], known[i - row - 1] if i % row else 0) if i >= row else (0, 0)
        plane = left + above - between
        known.append(plane if number is None else number)
        yield None if number is None else number - plane


def least_films(text):
    """The tables of the least film of lines and of circles, packed: least_films.cpp unpacks them."""
    for table in ("line_minimum", "point_minimum"):
        nodes, = re.findall(rf"double {table}_nodes\[\]\[4\] = {{\n(.*?)\n}};", text, re.DOTALL)
        head, = re.findall(rf"FilmTable {table}{{(.*?) {table}_nodes}};", text)
        rows = [[None if one == "no_film" else round(float.fromhex(one) / UNIT) for one in line.strip("{},").split(", ")]
                for line in nodes.splitlines()]
        row = int(head.split(",")[4]) + 1
        data = b"".join(bytes(packed(differences(numbers, row))) for numbers in zip(*rows, strict=True))
        yield f"constexpr unsigned char {table}_bytes[] = {{{','.join(map(str, data))}}};\n"
        yield f"constexpr PackedFilms {table}{{{UNIT}, {head} {table}_bytes}};\n"


# --- The certified rows that the page is tested with.

ROWS = 52  # for each function; half of them are the worst conditioned
# The functions with certified rows in the page, besides operating_point.
SHOWN = ["hertz_point", "hertz_ellipse", "hertz_line", "load_sharing", "starvation_ratio", "lambda_ratio",
         "hamrock_dowson_central", "hamrock_dowson_minimum", "hamrock_dowson_soft_central", "hamrock_dowson_soft_minimum",
         "dowson_higginson_minimum", "dowson_toyoda_central", "pan_hamrock_minimum", "pan_hamrock_central", "ertel_grubin",
         "moes_line", "nijenbanning_venner_moes"]


def read_rows(name):
    lines = [line for line in (ROOT / f"reference/exact/{name}.csv").read_text().splitlines() if line and line[0] != "#"]
    names = lines[0].split(",")
    rows = [dict(zip(names, line.split(","), strict=True)) for line in lines[1:]]
    return [row for row in rows if row["high"]]  # a row without `high` is of an undefined result


def chosen(rows, count):
    """The worst conditioned rows, and as many at even steps through the table."""
    worst = sorted(rows, key=lambda row: -float(row["condition"]))[:count // 2]
    others = [row for row in rows if row not in worst]
    rest = count - len(worst)
    return worst + others[::max(1, len(others) // rest)][:rest]


def chosen_scenes(rows):
    """All rows of some scenes: the three worst conditioned for each output, and about ROWS others that have all outputs."""
    outputs, scenes = {}, {}
    for row in rows:
        outputs.setdefault(row["output"], []).append(row)
        scenes.setdefault(row["id"].split(".")[0], []).append(row)
    whole = {name for name, parts in scenes.items() if len(parts) == len(outputs)}
    names = dict.fromkeys(row["id"].split(".")[0] for of_one in outputs.values() for row in chosen(of_one, 6)[:3])
    names |= dict.fromkeys(sorted(whole)[::max(1, len(whole) // ROWS)][:ROWS])
    return [row for name in names for row in scenes[name]]


def scene_fields(row):
    """The fields of the scene of a row of operating points, by their paths: see verification/accuracy/reference_scene.cpp."""
    is_circle = row["shape"] == "circle"
    across = {"circle": "bodies.ellipticity", "ellipse": "bodies.radius_y", "line": "bodies.length"}[row["shape"]]
    places = {"asperity": "closures.asperity", "starvation": "closures.starvation", "fluid": "friction.fluid",
              "viscosity_law": "friction.viscosity", "film": "closures.film", "offset_planes": "surface.offset_planes",
              "load": "load", "speed": "speed", "summit_density": "surface.summit_density", "summit_radius": "surface.summit_radius",
              "summit_height_sd": "surface.summit_height_sd", "summit_plane_offset": "surface.summit_plane_offset",
              "effective_modulus": "bodies.effective_modulus", "radius_x": "bodies.reduced_radius" if is_circle else "bodies.radius_x",
              "across": across, "viscosity": "lubricant.viscosity", "pressure_viscosity": "lubricant.pressure_viscosity",
              "eyring_stress": "lubricant.eyring_stress", "boundary_coefficient": "friction.boundary_coefficient",
              "slide_roll_ratio": "friction.slide_roll_ratio", "damiens_exponent": "closures.damiens_exponent"}
    fields = {path: row[column] for column, path in places.items()}
    if row["supply_kind"] != "flooded":
        fields[f"supply.{row['supply_kind']}"] = row["supply"]
    return fields


def row_lines():
    """Lines of function, output, id, high and low part of the value, condition, and name=argument …; a line without
    arguments has those of the line before."""
    points = [row for row in read_rows("operating_point") if "solved" not in (row["film"], row["starvation"])]
    tables = {name: chosen(read_rows(name), ROWS) for name in SHOWN} | {"operating_point": chosen_scenes(points)}
    of_result = ("id", "output", "value", "high", "low", "condition", "region")
    for name, rows in tables.items():
        before = None
        for row in rows:
            arguments = scene_fields(row) if name == "operating_point" else {
                column: text for column, text in row.items() if column not in of_result}
            # A thousandth of an ulp of the high part is enough of the low part.
            low = f"{float.fromhex(row['low']):.4g}"
            told = [f"{column}={text}" for column, text in arguments.items()] if arguments != before else []
            yield ",".join([name, row.get("output", ""), row["id"], row["high"], low, row["condition"], *told])
            before = arguments


# --- The build


def run(arguments):
    done = subprocess.run(arguments, cwd=ROOT, capture_output=True, text=True)
    if done.returncode or done.stderr:
        raise RuntimeError(f"{' '.join(map(str, arguments))}\n{done.stdout}{done.stderr}")


def compile_one(source, folder):
    target = folder / f"{source.relative_to(ROOT).as_posix().replace('/', '_')}.o"
    warns = ["-w"] if "toml" in source.name else []  # warnings of toml++ itself
    size = "-O2" if source.parent.name in ("src", "live") else "-Oz"  # code for texts is small rather than fast
    run([*COMPILER, *FLAGS, size, *warns, *(f"-I{one}" for one in INCLUDES), "-c", source.relative_to(ROOT), "-o", target])
    return target


def build(release):
    folder = ROOT / "build/live"
    folder.mkdir(parents=True, exist_ok=True)
    tables = (release / "model/film_tables.inc").read_text()
    (folder / "film_tables.inc").write_text(film_tables(tables))
    # The polynomials for ellipses would take 40 kB. The page computes the integrals, as the program does outside their range.
    (folder / "ellipse_pieces.inc").write_text(
        "constexpr int octaves = 0, parts = 1, degree = 5;\nconstexpr double pieces[1][degree + 2] = {};\n")
    (folder / "least_films.inc").write_text("".join(least_films(tables)))
    (folder / "certified_rows.inc").write_text("".join(f'R"({line}\n)"\n' for line in row_lines()))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(lambda source: compile_one(source, folder), SOURCES))
    made = folder / "tribocheck.wasm"
    run([*COMPILER, "-mexec-model=reactor", *objects, "-o", made, "-Wl,--strip-all,--gc-sections",
         "-lc-printscan-long-double"])
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("release", type=pathlib.Path, help="the build folder with model/film_tables.inc")
    parser.add_argument("--check", action="store_true", help="compare with reports/live/tribocheck.wasm")
    asked = parser.parse_args()
    try:
        made = build(asked.release.resolve()).read_bytes()
    except (OSError, RuntimeError, ValueError) as error:
        print(f"make live: {error}", file=sys.stderr)
        return 1
    kept = HERE / "tribocheck.wasm"
    if not asked.check:
        kept.write_bytes(made)
    elif not kept.is_file() or kept.read_bytes() != made:
        print("reports/live/tribocheck.wasm is not what the sources give: run `make live` and commit it", file=sys.stderr)
        return 1
    print(f"reports/live/tribocheck.wasm: {len(made)} bytes, {len(gzip.compress(made, 9))} packed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
