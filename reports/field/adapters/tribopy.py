# SPDX-License-Identifier: Apache-2.0
"""Asks tribopy, whose 1/R' is the sum of four curvatures, whose E' is 2 E*, and whose length is half the length of the contact."""
from math import inf, log, pi
from answering import load as file

solid, liquid, rough, basic, film = (file(f"{name}.py") for name in (
    "NonConformalSolidContact", "LiquidProperties", "SurfaceRoughness", "FundamentalConcepts", "LubricationNonConformalContacts"))
effective_modulus = lambda first_modulus, first_poisson_ratio, second_modulus, second_poisson_ratio: 1 / solid.effective_elastic_modulus(
    first_poisson_ratio, second_poisson_ratio, first_modulus, second_modulus)  # tribopy returns 1/E', and 1/R' below
plasticity_index = lambda **q: solid.plasticity_index(q["effective_modulus"], q["hardness"], q["summit_height_sd"], q["summit_radius"])
barus_viscosity = lambda viscosity, pressure_viscosity, pressure: liquid.Barus(viscosity, pressure_viscosity, pressure)
roelands_viscosity = lambda viscosity, pressure_viscosity, pressure: liquid.Roelands(
    6.31e-5, viscosity, pressure, -0.196e9, pressure_viscosity * 0.196e9 / log(viscosity / 6.31e-5))[0]
dowson_higginson_density = lambda pressure: liquid.DowsonHigginson(1.0, 1e-9 * pressure)
carreau_yasuda_viscosity = lambda **q: liquid.Carreau(q["high_shear_viscosity"], q["viscosity"], q["shear_rate"], 1 / q["relaxation_time"],
                                                      q["transition_exponent"], q["power_law_index"])
lambda_ratio = lambda minimum_film, first_roughness, second_roughness: {
    "lambda_ratio": basic.lambda_ratio(minimum_film, rough.Rq_composite(first_roughness, second_roughness))}
def hertz_point(load, effective_modulus, reduced_radius):
    a = solid.point.a(load, 1 / solid.effective_radius(reduced_radius, inf, reduced_radius, inf), effective_modulus)
    return {"radius": a, "mean_pressure": solid.point.pavg(load, a), "peak_pressure": solid.point.pmax(load, a)}
def hertz_line(load_per_length, effective_modulus, reduced_radius, half=0.5):
    b = solid.line.b(load_per_length, reduced_radius, half, effective_modulus)
    peak = solid.line.pmax(load_per_length, b, half)
    return {"half_width": b, "mean_pressure": solid.line.pavg(load_per_length, b, half), "peak_pressure": peak, "peak_shear": solid.line.tmax(peak)}
def regime_film(regime, viscosity_parameter, elasticity_parameter, radius_ratio=1, ellipticity=1):
    ratio = ellipticity ** (pi / 2)  # it takes R_y/R_x, and k = (R_y/R_x)^(2/pi) for the elastic regimes
    return {"viscous_rigid_roelands": lambda: film.h0PrimePR(viscosity_parameter, radius_ratio),
            "isoviscous_rigid": lambda: film.h0PrimeIR(radius_ratio), "isoviscous_elastic": lambda: film.h0PrimeIE(elasticity_parameter, ratio),
            "viscous_elastic": lambda: film.h0PrimePE(viscosity_parameter, elasticity_parameter, ratio)}.get(regime, lambda: None)()
