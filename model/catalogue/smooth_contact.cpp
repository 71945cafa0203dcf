// SPDX-License-Identifier: Apache-2.0
// Smooth elastic contact.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/hertz.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array hertz_parameters{load, effective_modulus, reduced_radius};
constexpr std::array hertz_results{Result{"radius", "a of the circle of contact", "m"},
                                   Result{"mean_pressure", "F/(πa²)", "Pa"},
                                   Result{"peak_pressure", "3/2 of the mean pressure", "Pa"},
                                   Result{"approach", "a²/R, of the two bodies", "m"}};

constexpr std::array entries{
    Function{.name = "hertz_point",
             .meaning = "circular contact of two smooth elastic bodies",
             .equation = "a³ = 3FR/(4E*)",
             .source = "H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. "
                       "Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), section 4.2",
             .parameters = hertz_parameters,
             .results = hertz_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   const HertzPoint<double> hertz = hertz_point(x[0], x[1], x[2]);
                   y = {hertz.radius, hertz.mean_pressure, hertz.peak_pressure, hertz.approach};
                 },
             .contract = hertz_contract,
             .example = {50, 107.9e9, 9.5e-3}},
};

}  // namespace

std::span<const Function> smooth_contact() { return entries; }

}  // namespace tribo::catalogue
