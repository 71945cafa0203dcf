// SPDX-License-Identifier: Apache-2.0
// Films of flooded, smooth contacts.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/film_thickness.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array film_parameters{
    Parameter{.name = "speed",
              .meaning = "u, entrainment: the mean of the two surfaces' speeds",
              .unit = "m/s",
              .least = 1e-6,
              .greatest = 100},
    Parameter{.name = "viscosity",
              .meaning = "η₀, at ambient pressure",
              .unit = "Pa·s",
              .least = 1e-4,
              .greatest = 100},
    Parameter{.name = "pressure_viscosity",
              .meaning = "α",
              .unit = "1/Pa",
              .least = 1e-9,
              .greatest = 1e-7},
    load,
    effective_modulus,
    reduced_radius,
    Parameter{.name = "ellipticity",
              .meaning = "k, in the film's constant alone",
              .least = 0.1,
              .greatest = 20,
              .default_value = 1}};
constexpr std::array film_results{Result{"value", "h₀, central film thickness", "m"}};

constexpr std::array entries{
    Function{
        .name = "hamrock_dowson_central",
        .meaning = "central film thickness of the flooded, smooth point contact",
        .equation = "h₀/R = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^(−0.73k)), U = η₀u/(2E*R), G = "
                    "2αE*, W = F/(2E*R²)",
        .source = "B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point "
                  "contacts, part III, fully flooded results. J. Lubr. Technol. 99 (1977) 264, doi "
                  "10.1115/1.3453074; the paper that is reproduced misprints 0.61 as 0.6",
        .parameters = film_parameters,
        .results = film_results,
        .value =
            [](const Arguments& x, Results& y) {
              y[0] = hamrock_dowson_central(x[0], x[1], x[2], x[3], x[4], x[5], x[6]);
            },
        .contract = film_contract,
        .example = {0.05, 0.0202, 2e-8, 50, 107.9e9, 9.5e-3, 1}},
};

}  // namespace

std::span<const Function> films() { return entries; }

}  // namespace tribo::catalogue
