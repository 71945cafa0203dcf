# SPDX-License-Identifier: Apache-2.0
"""Asks kerf by Imran Paruk for Hertz contacts and films, with E' = 2 E*, R_x and R_y. Its u_s is the viscosity times the speed."""

from math import inf
import os
import sys

from answering import load as file

sys.path.insert(0, os.path.join(os.environ["FIELD_SOURCE"], "packages/kerf-cad-core/src"))
hertz = file("packages/kerf-fem/src/kerf_fem/contact/hertzian.py")
film = file("packages/kerf-cad-core/src/kerf_cad_core/lubrication/film.py")


def hertz_point(load, effective_modulus, reduced_radius):
    bodies = hertz.HertzianContactSpec("sphere_on_flat", 1e3 * reduced_radius, inf, effective_modulus, 0, effective_modulus, 0, load)
    found = hertz.hertzian_sphere_on_flat(bodies)
    return {"radius": 1e-3 * found.contact_radius_mm, "peak_pressure": found.contact_pressure_max_pa, "approach": 1e-3 * found.contact_depth_mm}
def hertz_line(load_per_length, effective_modulus, reduced_radius):
    bodies = hertz.HertzianContactSpec("cylinder_on_flat", 1e3 * reduced_radius, inf, effective_modulus, 0, effective_modulus, 0, load_per_length)
    found = hertz.hertzian_cylinder_on_flat(bodies, 1e3)
    return {"half_width": 1e-3 * found.contact_radius_mm, "peak_pressure": found.contact_pressure_max_pa}
def hamrock_dowson_minimum(speed, viscosity, pressure_viscosity, load, effective_modulus, radius_x, radius_y):
    return film.ehl_film_point(radius_x, radius_y, effective_modulus, viscosity * speed, load, pressure_viscosity)["h_min_m"]
def dowson_higginson_minimum(speed, viscosity, pressure_viscosity, load_per_length, effective_modulus, reduced_radius):
    return film.ehl_film_line(reduced_radius, effective_modulus, viscosity * speed, load_per_length, pressure_viscosity)["h_min_m"]
barus_viscosity = lambda viscosity, pressure_viscosity, pressure: film.viscosity_barus(viscosity, pressure_viscosity, pressure)["mu_Pa_s"]
lambda_ratio = lambda **given: dict(zip(("composite_roughness", "lambda_ratio"), (
    film.lambda_ratio(*(given[name] for name in ("minimum_film", "first_roughness", "second_roughness")))[name] for name in ("Rq_m", "lambda"))))
