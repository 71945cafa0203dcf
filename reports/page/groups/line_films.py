# SPDX-License-Identifier: Apache-2.0
"""Compares films that formulas give for a line contact with the solved film, over the load number M and the material number L,
and solves one contact of reference/scenes."""
import bisect
import csv
import itertools
import json
import math
import statistics
import typing

import contour_labels
import scenes
from group import Group, Missing, finding
from numbers_text import exact

QUANTITIES = ("central", "minimum", "at_greatest_pressure")
SPEED_NUMBER = 1e-11  # U, on which some formulas depend a little
LOAD_STEPS, MATERIAL_STEPS = 60, 45
HEAVY_FROM = 2.0  # below this M the central film has a kink: the front of the stiffened liquid passes the contact's middle
PROFILE_SCENE, PROFILE_SPEED, PROFILE_FROM = "gear_flank", 1.0, -3  # m/s, x/b


class Formula(typing.NamedTuple):
    name: str  # as in scenes and in the catalogue of functions
    authors: str
    quantity: str  # the number of the solved film that the formula stands for
    liquid: str  # the liquid of the films that the formula was fitted to

    @property
    def is_compressible(self):
        return self.liquid == "roelands, compressible"


FORMULAS = (Formula("moes_line", "Moes", "at_greatest_pressure", "barus, incompressible"),
            Formula("ertel_grubin", "Ertel and Grubin", "at_greatest_pressure", "barus, incompressible"),
            Formula("dowson_higginson_minimum", "Dowson and Higginson", "minimum", "unknown"),
            Formula("dowson_toyoda_central", "Dowson and Toyoda", "central", "unknown"),
            Formula("pan_hamrock_minimum", "Pan and Hamrock", "minimum", "roelands, compressible"),
            Formula("pan_hamrock_central", "Pan and Hamrock", "central", "roelands, compressible"))


class Numbers(typing.NamedTuple):
    """A solved contact: film numbers (h/R)(2U)^(−1/2) and the error of each, in the order of QUANTITIES."""
    load: float
    material: float
    film: tuple
    error: tuple

    def of(self, formula):
        return self.film[QUANTITIES.index(formula.quantity)]


def rows_of(path):
    try:
        with path.open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))
    except OSError as error:
        raise Missing(f"{path}: cannot be read") from error


def numbers_of(rows, role=None):
    """The rows that have all three films. If `role` is given, only rows with this word in the column `role`."""
    errors = [f"{name}_error" for name in QUANTITIES]
    try:
        return [Numbers(float(row["load_number"]), float(row["material_number"]), tuple(float(row[name]) for name in QUANTITIES),
                        tuple(float(row[name]) for name in errors))
                for row in rows if role in (None, row.get("role")) and all(row[name] for name in (*QUANTITIES, *errors))]
    except (KeyError, TypeError, ValueError) as error:
        raise Missing(f"reference/ehl has a row that is no film: {error}") from error


class Axis:
    """Cubic splines over the logarithms of four or more numbers, which interpolate a value at each number. A knot is the mean
    of three neighbouring places, by de Boor."""

    def __init__(self, numbers):
        self.numbers = sorted(numbers)
        if len(self.numbers) < 4:
            raise Missing("line_films.csv has fewer than four load or material numbers")
        places = [self.place(number) for number in self.numbers]
        inner = [sum(places[i:i + 3]) / 3 for i in range(1, len(places) - 3)]
        self.knots = [0.0] * 4 + inner + [1.0] * 4
        self.inverse = inverse_of([self.basis(place) for place in places])

    def place(self, number):
        """The place of a number, from 0 at the first number to 1 at the last. It is −∞ at L = 0 (constant viscosity)."""
        return math.log(number / self.numbers[0]) / math.log(self.numbers[-1] / self.numbers[0]) if number > 0 else -math.inf

    def at(self, place):
        return self.numbers[0] * math.exp(math.log(self.numbers[-1] / self.numbers[0]) * place)

    def basis(self, place):
        """The values of all cubic basis functions, by Cox and de Boor."""
        knots = self.knots
        span = min(bisect.bisect_right(knots, place), len(self.numbers)) - 1
        row = [float(i == span) for i in range(len(knots) - 1)]
        for degree in (1, 2, 3):
            row = [(row[i] and row[i] * (place - knots[i]) / (knots[i + degree] - knots[i])) +
                   (row[i + 1] and row[i + 1] * (knots[i + degree + 1] - place) / (knots[i + degree + 1] - knots[i + 1]))
                   for i in range(len(row) - 1)]
        return row

    def weights(self, number):
        """The spline's value at a number is a sum of the interpolated values with these weights."""
        values = self.basis(min(max(self.place(number), 0.0), 1.0))
        parts = [(value, row) for value, row in zip(values, self.inverse) if value]
        return [sum(value * row[i] for value, row in parts) for i in range(len(self.numbers))]


def inverse_of(matrix):
    """The inverse of a matrix, by Gauss and Jordan without pivots: splines' matrices are totally positive."""
    size = len(matrix)
    rows = [row + [float(i == j) for j in range(size)] for i, row in enumerate(matrix)]
    for i, row in enumerate(rows):
        row[:] = [value / row[i] for value in row]
        for other in rows:
            if other is not row and other[i]:
                other[:] = [a - other[i] * b for a, b in zip(other, row)]
    return [row[size:] for row in rows]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Films:
    """Solved films of one liquid: `table`, with which formulas are compared; a map that interpolates these and further nodes; and
    `checks`, by which the map is judged. U = speed_number·L^power."""

    def __init__(self, program, table, nodes, checks, speed_number, power):
        self.program, self.table, self.checks, self.speed_number, self.power = program, table, checks, speed_number, power
        known = {(one.load, one.material): one.film for one in reversed(nodes + table)}
        self.loads, self.materials = Axis({load for load, _ in known}), Axis({material for _, material in known if material > 0})
        loads, materials = self.loads.numbers, self.materials.numbers
        for load, material in itertools.product(loads, materials):
            if (load, material) not in known:
                raise Missing(f"no table of line films in reference/ehl has the film of M = {load:g}, L = {material:g}")
        moes = self.formula("moes_line", list(itertools.product(loads, materials)))
        moes = {at: film for at, film in zip(itertools.product(loads, materials), moes)}
        # The maps interpolate the logarithm of film/(Moes' film), which is smooth.
        self.logs = [[[math.log(known[load, material][i] / moes[load, material]) for load in loads] for material in materials]
                     for i in range(len(QUANTITIES))]

    def formula(self, name, places):
        """The film numbers of a formula at places M, L, by a contact whose E*, R and viscosity are 1."""
        speeds = [2 * (self.speed_number * math.pow(material, self.power)) for _, material in places]
        answers = self.program.ask(*(json.dumps({
            "function": name, "speed": speed, "viscosity": 1, "pressure_viscosity": material / math.sqrt(math.sqrt(speed)) / 2,
            "load_per_length": 2 * load * math.sqrt(speed), "effective_modulus": 1, "reduced_radius": 1})
            for (load, material), speed in zip(places, speeds)))
        return [answer["value"] / math.sqrt(speed) for answer, speed in zip(answers, speeds)]

    def map(self, loads, materials):
        """The films at each of these loads with each of these materials, in the order of QUANTITIES."""
        moes = iter(self.formula("moes_line", list(itertools.product(loads, materials))))
        columns = [self.materials.weights(material) for material in materials]
        made = []
        for load in loads:
            row = self.loads.weights(load)
            over_load = [[dot(row, logs) for logs in one] for one in self.logs]
            made.append([[by_moes * math.exp(dot(column, one)) for one in over_load] for column, by_moes in zip(columns, moes)])
        return made


def films_of(program, folder):
    """Films of two liquids. Those of Barus' incompressible liquid depend on M and L alone; their U is chosen. Those of a compressible
    liquid are between bodies of one material, so that U ∝ L⁴; Pan and Hamrock's formulas are compared with these."""
    path = folder / "line_films.csv"
    table, between = numbers_of(rows_of(path)), rows_of(folder / "line_films_between.csv")
    if not table:
        raise Missing("reference/ehl/line_films.csv has no films")
    barus = Films(program, table, numbers_of(between, "node"), numbers_of(between, "check"), SPEED_NUMBER, 0)
    rows = rows_of(folder / "line_films_compressible.csv")
    table = numbers_of(rows, "table")
    if not table:
        raise Missing("reference/ehl/line_films_compressible.csv has no films")
    speed_number = float(rows[0]["speed_number"]) / math.pow(float(rows[0]["material_number"]), 4)
    return barus, Films(program, table, numbers_of(rows, "node"), numbers_of(rows, "check"), speed_number, 4)


# --- The errors of the formulas, the solved films and the maps.

def place_of(error, at):
    return {"error": error, "load_number": at.load, "material_number": at.material}


def is_elastic_and_viscous(at):
    """Whether Moes' film (1992), max(RI, EI, min(RP, EP)) of his four asymptotes, is EP: elastic bodies (E, not rigid, R) and a
    piezoviscous liquid (P, not isoviscous, I)."""
    elastic, rigid = 1.311 * at.load**(-1 / 8) * at.material**(3 / 4), 1.287 * at.material**(2 / 3)
    return max(3 / at.load, 2.621 * at.load**(-1 / 5)) < elastic < rigid


def formula_data(formula, films):
    """The errors of a formula over the rows of the table with L > 0."""
    table = [one for one in films.table if one.material > 0]
    if not table:
        raise Missing("line_films.csv has no films with L > 0")
    numbers = films.formula(formula.name, [(one.load, one.material) for one in table])
    errors = [number / one.of(formula) - 1 for number, one in zip(numbers, table)]
    at_home = [place for place in zip(errors, table) if is_elastic_and_viscous(place[1])]
    return {"name": formula.name, "authors": formula.authors, "quantity": formula.quantity, "liquid": formula.liquid,
            "points": len(errors), "least": place_of(*min(zip(errors, table))), "median": statistics.median(errors),
            "greatest": place_of(*max(zip(errors, table))),
            "median_size": statistics.median([abs(error) for error in errors]),
            "elastic_viscous": {"points": len(at_home), "least": place_of(*min(at_home)), "greatest": place_of(*max(at_home))} if at_home else None}


def solved_data(table):
    """The relative errors that the table states for its films."""
    errors = [(error / film, one) for one in table for film, error in zip(one.film, one.error)]
    return {"films": len(errors), "within_1e_4": sum(error <= 1e-4 for error, _ in errors),
            "median": statistics.median([error for error, _ in errors]), "greatest": place_of(*max(errors, key=lambda one: one[0]))}


def interpolation_data(barus, compressible):
    """The greatest errors of the maps against films solved between the nodes, for quantities with which formulas are compared."""
    greatest, light = (dict.fromkeys(QUANTITIES, 0.0) for _ in range(2))
    for films in (barus, compressible):
        used = {formula.quantity for formula in FORMULAS if formula.is_compressible == (films is compressible)}
        for one in films.checks:
            for name, film, solved in zip(QUANTITIES, films.map([one.load], [one.material])[0][0], one.film):
                if name in used:
                    worst = light if one.load < HEAVY_FROM else greatest
                    worst[name] = max(worst[name], abs(film / solved - 1))
    return {"points": len(barus.checks) + len(compressible.checks), "heavy_from": HEAVY_FROM, "greatest": greatest,
            "greatest_light": light}


# --- The maps.

def cell(value):
    return f"{value:.5g}"


def map_files(barus, compressible, taken):
    """The errors over the map in per cent, and the labels of their contours."""
    loads = [barus.loads.at(i / LOAD_STEPS) for i in range(LOAD_STEPS + 1)]
    materials = [barus.materials.at(i / MATERIAL_STEPS) for i in range(MATERIAL_STEPS + 1)]
    maps = {films: films.map(loads, materials) for films in (barus, compressible)}
    errors = []  # of each formula: rows of M
    for formula in FORMULAS:
        films = compressible if formula.is_compressible else barus
        numbers = iter(films.formula(formula.name, list(itertools.product(loads, materials))))
        which = QUANTITIES.index(formula.quantity)
        errors.append([[100 * (next(numbers) / film[which] - 1) for film in row] for row in maps[films]])
    text = ("# errors of formulas for the film of a line contact against the solved film, of the liquid that each was fitted "
            "to [%]\n"
            "# load number M\tmaterial number L" + "".join(f"\t{formula.name}" for formula in FORMULAS) + "\n")
    for i, load in enumerate(loads):
        text += "".join("\t".join([cell(load), cell(material), *(f"{one[i][j]:.4g}" for one in errors)]) + "\n"
                        for j, material in enumerate(materials)) + "\n"
    blocks = []
    for formula, one in zip(FORMULAS, errors):
        lines = (f"{cell(barus.loads.at(x))}\t{cell(barus.materials.at(y))}\t{exact(level)}\t"
                 f"\"{'+' if level > 0 else '−' if level < 0 else ''}{exact(abs(level))} %\"\n"
                 for level, (x, y) in contour_labels.labels_of(one, taken))
        blocks.append(f'"{formula.name}"\n' + "".join(lines))
    return [("data/line_film_errors.tsv", text),
            ("data/line_film_labels.blocks.tsv", "# labels of the contours, a block for each formula\n"
             "# load number M\tmaterial number L\terror [%]\ttext\n" + "\n\n".join(blocks))]


# --- The line contacts among the scenes.

class Track:
    """The line that a scene draws over the map as its speed grows."""

    def __init__(self, program, path, scene, file, is_of_report):
        self.path, self.name, self.file, self.is_of_report, self.is_on_map = path, path.stem, file, is_of_report, False
        one = program.answer("film", path, "--speed", 1, "--tolerance", 1e-2)["films"][0]
        self.load, self.material = one["load_number"], one["material_number"]
        speed = scene["speed"]
        speeds = list(speed) if isinstance(speed, list) else [speed["from"], speed["to"]] if isinstance(speed, dict) else [speed]
        self.slowest, self.fastest = map(float, (min(speeds), max(speeds)))

    def at(self, speed):
        """M and L at a speed, from M and L at 1 m/s."""
        return self.load / math.sqrt(speed), self.material * math.sqrt(math.sqrt(speed))

    @property
    def told(self):
        return {name: getattr(self, name) for name in ("name", "file", "slowest", "fastest", "is_of_report", "is_on_map")}


def tracks_of(asked):
    """The scenes of line contacts with speeds in reference/scenes, then the published ones; both by name."""
    tracks = []
    for folder in (asked.places.reference / "scenes", asked.places.scenes):
        for path in sorted(folder.glob("*.toml")):
            try:
                scene = scenes.read(path)
                if isinstance(scene.get("bodies"), dict) and "length" in scene["bodies"] and "speed" in scene:
                    tracks.append(Track(asked.program, path, scene, asked.places.shown(path), folder == asked.places.scenes))
            except Missing:
                continue
    return tracks


def tracks_file(barus, tracks, taken):
    """Blocks: each track, its name first. Points at whole powers of ten of the speed have the speed in a fourth column, with a label
    to their right where there is room."""
    def place_at(load, material):
        return barus.loads.place(load), barus.materials.place(material)

    def is_on_map(place):
        return 0 <= place[0] <= 1 and 0 <= place[1] <= 1

    blocks = []
    for track in tracks:
        block = f'"{track.name}"\n'
        for i in range(41):  # a straight line in the logarithms; the picture cuts it at the edge of the map
            speed = track.slowest * math.pow(track.fastest / track.slowest, i / 40)
            numbers = track.at(speed)
            track.is_on_map = track.is_on_map or is_on_map(place_at(*numbers))
            block += "\t".join(map(cell, (*numbers, speed))) + '\tNaN\t""\n'
        for speed in (math.pow(10, power) for power in range(-6, 5)):
            numbers = track.at(speed)
            place = place_at(*numbers)
            if track.slowest <= speed <= track.fastest and is_on_map(place):
                label = place[0] + 0.09, place[1]
                has_room = label[0] < 0.94 and contour_labels.is_clear(label, taken)
                taken += [place, label] if has_room else [place]
                text = f"{exact(speed)} m/s" if has_room else ""
                block += "\t".join((*map(cell, numbers), "NaN", cell(speed), f'"{text}"')) + "\n"
        if track.is_on_map:
            blocks.append(block)
    return ("data/line_film_tracks.blocks.tsv", "# line contacts over the numbers of load and of material, each a block\n"
            "# load number M\tmaterial number L\tspeed [m/s]\twhole power of ten of it [m/s]\tlabel\n" + "\n\n".join(blocks))


def over(measured, unit):
    return {name: measured and measured[name] / unit for name in ("value", "error")}


def profile(program, tracks):
    """Pressure and film across a contact, and the numbers that are read off them."""
    found = next((one for one in tracks if one.name == PROFILE_SCENE and not one.is_of_report), None)
    if found is None:
        raise Missing(f"reference/scenes has no line contact {PROFILE_SCENE}")
    one = program.answer("film", found.path, "--speed", PROFILE_SPEED, "--profile")["films"][0]
    if "profile" not in one:
        raise Missing(one["reason"])
    text = (f"# pressure and film across the line contact of {found.file} at {exact(PROFILE_SPEED)} m/s\n"
            "# x/b\tp/p0\tHertz' p/p0\tfilm [µm]\n")
    last_x, last_pressure = 0.0, -1.0  # leaves out nodes that a picture does not tell apart
    for x, pressure, film in zip(*(one["profile"][name] for name in ("x", "pressure", "film"))):
        x, pressure = x / one["half_width"], pressure / one["peak_pressure"]
        if x >= PROFILE_FROM and (abs(x - last_x) >= 0.005 or abs(pressure - last_pressure) >= 0.01):
            last_x, last_pressure = x, pressure
            text += "\t".join(f"{value:.12g}" for value in (x, pressure, math.sqrt(max(0.0, 1 - x * x)), 1e6 * film)) + "\n"
    return {"file": found.file, "speed": PROFILE_SPEED, "viscosity": one["assumptions"]["viscosity"],
            **{name: one[name] for name in ("load_number", "material_number", "half_width", "peak_pressure", "cells")},
            "central": one["central_film"], "minimum": one["minimum_film"],
            "spike_pressure": over(one["spike_pressure"], one["peak_pressure"]),
            "spike_place": over(one["spike_place"], one["half_width"])}, ("data/line_film_profile.tsv", text)


def line_films(asked):
    barus, compressible = films_of(asked.program, asked.places.reference / "ehl")
    tracks, taken = tracks_of(asked), []
    tracks_text = tracks_file(barus, tracks, taken)
    maps = map_files(barus, compressible, taken)
    told, profile_text = profile(asked.program, tracks)
    data = {"speed_number": SPEED_NUMBER, "least_load_number": barus.loads.numbers[0],
            "greatest_load_number": barus.loads.numbers[-1], "least_material_number": barus.materials.numbers[0],
            "greatest_material_number": barus.materials.numbers[-1], "solved": solved_data(barus.table),
            "solved_compressible": solved_data(compressible.table), "interpolation": interpolation_data(barus, compressible),
            "formulas": [formula_data(formula, compressible if formula.is_compressible else barus) for formula in FORMULAS],
            "scenes": [track.told for track in tracks], "profile": told}
    return Group(data, [finding("line_films", "film-solved", "software", "measured")],
                 files=[tracks_text, *maps, profile_text])
