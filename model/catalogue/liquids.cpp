// SPDX-License-Identifier: Apache-2.0
// Liquids under pressure and temperature.
#include "tribo/liquids.hpp"

#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::catalogue {
namespace {

constexpr Parameter pressure{.name = "pressure",
                             .meaning = "p, above ambient pressure",
                             .unit = "Pa",
                             .range = Range::not_below_zero,
                             .greatest = 4e9};
constexpr std::array density_parameters{pressure};
constexpr std::array density_results{Result{"value", "ρ/ρ₀"}};
constexpr std::array viscosity_parameters{viscosity, pressure_viscosity, pressure};
// ln(η/η₀) is bounded, because at the greatest α and p Roelands' η is beyond what a double holds.
constexpr Combination exponent(std::string_view meaning, double (*value)(const Arguments&)) {
  return {.name = "exponent",
          .meaning = meaning,
          .greatest = 70,
          .value = value,
          .parameter = "pressure"};
}
constexpr std::array barus_combinations{
    exponent("αp = ln(η/η₀)", [](const Arguments& x) { return x[1] * x[2]; })};
constexpr std::array roelands_combinations{exponent("ln(η/η₀)", [](const Arguments& x) {
  return log_viscosity_ratio(ViscosityLaw::roelands, x[0], x[1], x[2]);
})};
constexpr std::array viscosity_results{Result{"value", "η, at the pressure", "Pa·s"}};

constexpr std::array thinning_parameters{
    Parameter{.name = "viscosity",
              .meaning = "η₀, at rest",
              .unit = "Pa·s",
              .least = viscosity.least,
              .greatest = 1e6},
    Parameter{.name = "high_shear_viscosity",
              .meaning = "η_∞, at the highest shear rates",
              .unit = "Pa·s",
              .range = Range::not_below_zero,
              .greatest = 100},
    Parameter{
        .name = "relaxation_time", .meaning = "λ", .unit = "s", .least = 1e-12, .greatest = 100},
    Parameter{.name = "shear_rate",
              .meaning = "γ̇",
              .unit = "1/s",
              .range = Range::not_below_zero,
              .greatest = 1e10},
    Parameter{
        .name = "transition_exponent", .meaning = "a; 2 by Carreau", .least = 0.2, .greatest = 10},
    Parameter{.name = "power_law_index", .meaning = "n, at most 1", .least = 0.1, .greatest = 1}};
constexpr std::array thinning_combinations{
    Combination{.name = "shear_number",
                .meaning = "λγ̇",
                .greatest = 1e6,
                .value = [](const Arguments& x) { return x[2] * x[3]; },
                .parameter = "shear_rate"}};
constexpr std::array thinning_results{Result{"value", "η, at the shear rate", "Pa·s"}};

constexpr Parameter temperature_of(std::string_view name, std::string_view meaning) {
  return {.name = name, .meaning = meaning, .unit = "K", .least = 200, .greatest = 600};
}
// Below about 4 mm²/s the standard has a further term that can be seen. This law does not have it.
constexpr double least_kinematic_viscosity = 4e-6;
constexpr Parameter kinematic(std::string_view name, std::string_view meaning,
                              double least = least_kinematic_viscosity, double greatest = 1) {
  return {.name = name, .meaning = meaning, .unit = "m²/s", .least = least, .greatest = greatest};
}
constexpr std::array temperature_parameters{
    temperature_of("first_temperature", "T₁"),
    kinematic("first_viscosity", "ν₁, kinematic viscosity at T₁: 1 mm²/s is 1e-6 m²/s"),
    temperature_of("second_temperature", "T₂"), kinematic("second_viscosity", "ν₂, at T₂"),
    temperature_of("temperature", "T, at which the viscosity is asked")};
constexpr std::array temperature_combinations{Combination{
    .name = "viscosity",
    .meaning = "ν, at T",
    .unit = "m²/s",
    .least = least_kinematic_viscosity,
    .greatest = 1,
    .value =
        [](const Arguments& x) { return tribo::astm_d341_viscosity(x[0], x[1], x[2], x[3], x[4]); },
    .parameter = "temperature"}};
constexpr std::array kinematic_results{Result{"value", "ν, kinematic viscosity at T", "m²/s"}};

constexpr std::array index_parameters{
    kinematic("kinematic_viscosity_40", "ν at 40 °C: 1 mm²/s is 1e-6 m²/s", 5e-6, 3e-3),
    kinematic("kinematic_viscosity_100", "ν at 100 °C, 2e-6 m²/s or more", 2e-6, 1e-4)};
constexpr std::array index_combinations{
    Combination{.name = "value",
                .meaning = "VI",
                .least = -100,
                .greatest = 400,
                .value = [](const Arguments& x) { return tribo::viscosity_index(x[0], x[1]); },
                .parameter = "kinematic_viscosity_40"}};
constexpr std::array index_results{
    Result{"value", "VI, not rounded; below 0 of an oil thicker at 40 °C than one of the index 0"}};

void barus(const Arguments& x, Results& y) {
  y[0] = viscosity_at(ViscosityLaw::barus, x[0], x[1], x[2]);
}
void roelands(const Arguments& x, Results& y) {
  y[0] = viscosity_at(ViscosityLaw::roelands, x[0], x[1], x[2]);
}

std::optional<Refusal> too_thin_for_roelands(const Arguments& x) {
  if (std::log(x[0]) + roelands_log_viscosity<double>() > 0) return std::nullopt;
  return Refusal{"viscosity",
                 "Roelands' law needs a viscosity above 6.315e-5 Pa·s, where ln η₀ + 9.67 is above "
                 "0"};
}
std::optional<Refusal> thickens(const Arguments& x) {
  if (x[5] <= 1) return std::nullopt;
  return Refusal{"power_law_index", "a liquid that shear thins has an index of at most 1"};
}
std::optional<Refusal> no_line_of_astm_d341(const Arguments& x) {
  constexpr std::string_view too_thin =
      "log log(ν + 0.7) with ν in mm²/s needs a viscosity above 3e-7 m²/s";
  const auto is_too_thin = [](double viscosity) { return !(1e6 * viscosity + 0.7 > 1); };
  if (is_too_thin(x[1])) return Refusal{"first_viscosity", too_thin};
  if (is_too_thin(x[3])) return Refusal{"second_viscosity", too_thin};
  if (x[0] == x[2])
    return Refusal{"second_temperature", "two different temperatures are needed to draw the line"};
  return std::nullopt;
}
std::optional<Refusal> has_no_index(const Arguments& x) {
  if (!(x[1] >= 2e-6))
    return Refusal{"kinematic_viscosity_100",
                   "the viscosity index is defined from 2e-6 m²/s at 100 °C on"};
  if (!(x[0] > x[1]))
    return Refusal{"kinematic_viscosity_40",
                   "an oil is thicker at 40 °C than at 100 °C: kinematic_viscosity_40 has to be "
                   "above kinematic_viscosity_100"};
  return std::nullopt;
}

constexpr std::array entries{
    Function{.name = "dowson_higginson_density",
             .meaning = "density of an oil under pressure over that at ambient pressure",
             .equation = "ρ/ρ₀ = (5.9e8 + 1.34p)/(5.9e8 + p)",
             .source = "D. Dowson, G. R. Higginson: Elasto-hydrodynamic Lubrication (1966); also "
                       "printed as 1 + 0.6e-9 p/(1 + 1.7e-9 p), which rounds 1 + 0.5763e-9 p/(1 + "
                       "1.695e-9 p) to more",
             .parameters = density_parameters,
             .results = density_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::dowson_higginson_density(x[0]); },
             .contract = density_contract,
             .example = {1e9}},
    Function{.name = "barus_viscosity",
             .meaning = "viscosity under pressure by Barus' law",
             .equation = "η = η₀ e^(αp)",
             .source = "C. Barus: Isothermals, isopiestics and isometrics relative to viscosity. "
                       "Am. J. Sci. 45 (1893) 87",
             .parameters = viscosity_parameters,
             .results = viscosity_results,
             .value = barus,
             .contract = barus_contract,
             .example = {0.0202, 2e-8, 3e8},
             .combinations = barus_combinations},
    Function{.name = "roelands_viscosity",
             .meaning = "viscosity under pressure by Roelands' law",
             .equation = "η = η₀ exp{(ln η₀ + 9.67)[(1 + p/p_R)^z − 1]}, z = αp_R/(ln η₀ + 9.67), "
                         "p_R = 0.196 GPa",
             .source = "C. J. A. Roelands: Correlational aspects of the "
                       "viscosity-temperature-pressure relationship of lubricating oils. Thesis, "
                       "Delft (1966); z is that of the same slope at p = 0 as Barus' law",
             .parameters = viscosity_parameters,
             .results = viscosity_results,
             .value = roelands,
             .contract = roelands_contract,
             .example = {0.0202, 2e-8, 1e9},
             .refusal = too_thin_for_roelands,
             .combinations = roelands_combinations},
    Function{.name = "carreau_yasuda_viscosity",
             .meaning = "viscosity of a liquid that shear thins",
             .equation = "η = η_∞ + (η₀ − η_∞)[1 + (λγ̇)^a]^((n − 1)/a)",
             .source = "P. J. Carreau: Rheological equations from molecular network theories. "
                       "Trans. Soc. Rheol. 16 (1972) 99, with a = 2; K. Yasuda: Investigation of "
                       "the analogies between viscometric and linear viscoelastic properties of "
                       "polystyrene fluids. Thesis, MIT (1979)",
             .parameters = thinning_parameters,
             .results = thinning_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   y[0] = tribo::carreau_yasuda_viscosity(x[0], x[1], x[2], x[3], x[4], x[5]);
                 },
             .contract = carreau_yasuda_contract,
             .example = {0.1, 0.01, 1e-6, 1e7, 2, 0.5},
             .refusal = thickens,
             .combinations = thinning_combinations},
    Function{.name = "astm_d341_viscosity",
             .meaning = "kinematic viscosity at a temperature, from those at two others",
             .equation = "log log(ν + 0.7) = A − B log T, ν in mm²/s, T in K",
             .source = "ASTM D341: Standard practice for viscosity-temperature equations and "
                       "charts for liquid petroleum or hydrocarbon products; for 2 mm²/s and more, "
                       "below which the standard has a further term",
             .parameters = temperature_parameters,
             .results = kinematic_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   y[0] = tribo::astm_d341_viscosity(x[0], x[1], x[2], x[3], x[4]);
                 },
             .contract = astm_d341_contract,
             .example = {313.15, 32e-6, 373.15, 5.4e-6, 353.15},
             .refusal = no_line_of_astm_d341,
             .combinations = temperature_combinations},
    Function{
        .name = "viscosity_index",
        .meaning = "viscosity index, from the kinematic viscosities at 40 and 100 °C",
        .equation = "with U = ν at 40 °C, Y = ν at 100 °C in mm²/s: VI = 100(L − U)/(L − H), "
                    "L = aY² + bY + c, H = dY² + eY + f; where U is below H, VI = 100 + (10^N "
                    "− 1)/0.00715, N = log(H/U)/log Y",
        .source = "ASTM D2270-10 (ISO 2909): Standard practice for calculating viscosity "
                  "index from kinematic viscosity at 40 and 100 °C, equations 3, 6 and 7; a "
                  "to f from its table X2.1, within 0.1 % of its table 1; at the end of a "
                  "range those of the lower range",
        .parameters = index_parameters,
        .results = index_results,
        .value = [](const Arguments& x, Results& y) { y[0] = tribo::viscosity_index(x[0], x[1]); },
        .contract = viscosity_index_contract,
        .example = {46e-6, 6.8e-6},
        .refusal = has_no_index,
        .combinations = index_combinations},
};

}  // namespace

std::span<const Function> liquids() { return entries; }

}  // namespace tribo::catalogue
