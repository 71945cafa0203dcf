// SPDX-License-Identifier: Apache-2.0
// Films of flooded, smooth contacts.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/film_regimes.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/moes_line.hpp"
#include "tribo/nijenbanning_venner_moes.hpp"
#include "tribo/similarity_numbers.hpp"
#include "tribo/thermal_reduction.hpp"

namespace tribo::catalogue {
namespace {

constexpr Parameter ellipticity{.name = "ellipticity",
                                .meaning = "k, in the film's constant alone",
                                .least = 0.1,
                                .greatest = 20,
                                .default_value = 1};
constexpr std::array circle_parameters{
    speed, viscosity, pressure_viscosity, load, effective_modulus, reduced_radius, ellipticity};
constexpr std::array point_parameters{
    speed, viscosity, pressure_viscosity, load, effective_modulus, radius_x, ellipticity};
constexpr std::array soft_parameters{speed,    viscosity,  load, effective_modulus,
                                     radius_x, ellipticity};
constexpr std::array line_parameters{speed,           viscosity,         pressure_viscosity,
                                     load_per_length, effective_modulus, reduced_radius};
constexpr std::array central_results{Result{"value", "h₀, central film thickness", "m"}};
constexpr std::array minimum_results{Result{"value", "h_min, minimum film thickness", "m"}};

constexpr Arguments steel_point{0.05, 0.0202, 2e-8, 50, 107.9e9, 9.5e-3, 1};
constexpr Arguments soft_point{0.05, 0.0202, 2, 5e6, 9.5e-3, 1};
constexpr Arguments steel_line{1, 0.0202, 2e-8, 1e5, 107.9e9, 9.5e-3};

// U, G and W of the arguments of each kind of film law.
using Groups = SimilarityNumbers<double>;
Groups groups_of_point(const Arguments& x) {
  return similarity_numbers(x[0], x[1], x[2], x[3], x[4], x[5]);
}
Groups groups_of_soft(const Arguments& x) {
  return similarity_numbers(x[0], x[1], 0.0, x[2], x[3], x[4]);
}
Groups groups_of_line(const Arguments& x) {
  return similarity_numbers(x[0], x[1], x[2], x[3] * x[5], x[4], x[5]);
}
MoesNumbers<double> moes_of_line(const Arguments& x) {
  return moes_numbers(groups_of_line(x), true);
}

template <Groups (*groups)(const Arguments&)>
constexpr Combination speed_number{.name = "speed_number",
                                   .meaning = "U = η₀u/(2E*R)",
                                   .least = 1e-18,
                                   .greatest = 1e-4,
                                   .value = [](const Arguments& x) { return groups(x).speed; },
                                   .parameter = "speed"};
template <Groups (*groups)(const Arguments&)>
constexpr Combination material_number{
    .name = "material_number",
    .meaning = "G = 2αE*",
    .least = 1e-3,
    .greatest = 1e5,
    .value = [](const Arguments& x) { return groups(x).material; },
    .parameter = "pressure_viscosity"};
template <Groups (*groups)(const Arguments&)>
constexpr Combination point_load{.name = "load_number",
                                 .meaning = "W = F/(2E*R²)",
                                 .least = 1e-12,
                                 .greatest = 100,
                                 .value = [](const Arguments& x) { return groups(x).load; },
                                 .parameter = "load"};
constexpr Combination line_load{.name = "load_number",
                                .meaning = "W = (F/L)/(2E*R)",
                                .least = 1e-13,
                                .greatest = 100,
                                .value = [](const Arguments& x) { return groups_of_line(x).load; },
                                .parameter = "load_per_length"};
constexpr std::array point_combinations{
    speed_number<groups_of_point>, material_number<groups_of_point>, point_load<groups_of_point>};
constexpr std::array soft_combinations{speed_number<groups_of_soft>, point_load<groups_of_soft>};
constexpr std::array line_combinations{speed_number<groups_of_line>,
                                       material_number<groups_of_line>, line_load};
constexpr std::array moes_combinations{
    Combination{.name = "moes_load",
                .meaning = "M = W(2U)^(−1/2)",
                .least = 1e-6,
                .greatest = 1e7,
                .value = [](const Arguments& x) { return moes_of_line(x).load; },
                .parameter = "load_per_length"},
    Combination{.name = "moes_material",
                .meaning = "L = G(2U)^(1/4)",
                .least = 1e-4,
                .greatest = 100,
                .value = [](const Arguments& x) { return moes_of_line(x).material; },
                .parameter = "pressure_viscosity"}};

constexpr std::array ellipse_parameters{
    speed,
    viscosity,
    pressure_viscosity,
    load,
    effective_modulus,
    radius_x,
    radius_y,
    Parameter{
        .name = "exponent", .meaning = "x of s", .words = moes_exponent_words, .default_value = 0},
    Parameter{.name = "bracket",
              .meaning = "the exponent within the first bracket",
              .words = moes_bracket_words,
              .default_value = 0}};
MoesNumbers<double> moes_of_point(const Arguments& x) {
  return moes_numbers(groups_of_point(x), false);
}
constexpr std::array ellipse_combinations{
    Combination{.name = "moes_load",
                .meaning = "M = W(2U)^(−3/4)",
                .least = 1e-6,
                .greatest = 1e7,
                .value = [](const Arguments& x) { return moes_of_point(x).load; },
                .parameter = "load"},
    Combination{.name = "moes_material",
                .meaning = "L = G(2U)^(1/4)",
                .least = 1e-4,
                .greatest = 100,
                .value = [](const Arguments& x) { return moes_of_point(x).material; },
                .parameter = "pressure_viscosity"},
    Combination{.name = "radius_ratio",
                .meaning = "R_x/R_y",
                .least = 1e-4,
                .greatest = 1e4,
                .value = [](const Arguments& x) { return x[5] / x[6]; },
                .parameter = "radius_x"}};

constexpr std::array regime_parameters{
    Parameter{.name = "regime", .meaning = "bodies and liquid", .words = film_regime_words},
    Parameter{.name = "viscosity_parameter",
              .meaning = "g_V = GW³/U²; isoviscous regimes do not look at it",
              .least = 1e-3,
              .greatest = 1e12},
    Parameter{.name = "elasticity_parameter",
              .meaning = "g_E = W^(8/3)/U²; rigid regimes do not look at it",
              .least = 1e-3,
              .greatest = 1e12},
    Parameter{.name = "radius_ratio",
              .meaning = "α = R_y/R_x; only isoviscous_rigid and viscous_rigid_roelands look at it",
              .least = 0.05,
              .greatest = 100,
              .default_value = 1},
    Parameter{.name = "ellipticity",
              .meaning = "k, of the ellipse of contact; the other three regimes look at it",
              .least = 0.1,
              .greatest = 20,
              .default_value = 1}};
constexpr std::array regime_results{Result{"value", "Ĥ = (h_min/R_x)(W/U)²"}};

constexpr Parameter temperature_viscosity{.name = "temperature_viscosity",
                                          .meaning = "β = −d ln η/dT",
                                          .unit = "1/K",
                                          .least = 1e-3,
                                          .greatest = 0.2};
constexpr Parameter thermal_conductivity{.name = "thermal_conductivity",
                                         .meaning = "k_f, of the oil",
                                         .unit = "W/(m·K)",
                                         .least = 0.01,
                                         .greatest = 10};
constexpr std::array thermal_parameters{
    Parameter{.name = "peak_pressure",
              .meaning = "p₀, of Hertz",
              .unit = "Pa",
              .least = 1e6,
              .greatest = 5e9},
    effective_modulus,
    Parameter{.name = "slide_roll_ratio",
              .meaning = "S, sliding speed over the mean of the two surfaces' speeds",
              .range = Range::not_below_zero,
              .greatest = 10},
    temperature_viscosity,
    viscosity,
    speed,
    thermal_conductivity};
// L, where the arguments from `first` on are β, η₀, u and k_f.
template <std::size_t first>
constexpr Combination thermal_loading{.name = "thermal_loading",
                                      .meaning = "L = βη₀u²/k_f",
                                      .least = 1e-12,
                                      .greatest = 100,
                                      .value =
                                          [](const Arguments& x) {
                                            return x[first] * x[first + 1] * x[first + 2] *
                                                   x[first + 2] / x[first + 3];
                                          },
                                      .parameter = "temperature_viscosity"};
constexpr std::array rolling_parameters{temperature_viscosity, viscosity, speed,
                                        thermal_conductivity};
constexpr std::array rolling_combinations{thermal_loading<0>};
constexpr std::array thermal_results{Result{"value", "φ_T, film over that of an isothermal inlet"}};

double thermal_reduction(const Arguments& x) {
  return gupta_thermal_reduction(x[0], x[1], x[2], x[3], x[4], x[5], x[6]);
}
constexpr std::array thermal_combinations{thermal_loading<3>,
                                          Combination{.name = "value",
                                                      .meaning = "φ_T",
                                                      .least = 0.01,
                                                      .greatest = 1,
                                                      .value = thermal_reduction,
                                                      .parameter = "temperature_viscosity"}};
std::optional<Refusal> too_hot(const Arguments& x) {
  if (!std::isnan(thermal_reduction(x))) return std::nullopt;
  return Refusal{"peak_pressure",
                 "1 − 13.2 (p₀/E′) L^0.42 has to be above 0; so much heating is beyond what was "
                 "fitted"};
}

// The film by `law`, at the arguments of the function whose law is `own`.
double film(const FilmLaw& own, const FilmLaw& law, const Arguments& x) {
  const bool is_soft = own.material_exponent.p == 0;  // it has no α
  const double alpha = is_soft ? 1 : x[2];
  const double* const rest = x.data() + (is_soft ? 2 : 3);
  return law.is_of_lines ? line_film_thickness(law, x[0], x[1], alpha, rest[0], rest[1], rest[2])
                         : film_thickness(law, x[0], x[1], alpha, rest[0], rest[1], rest[2],
                                          own.is_of_lines ? 1 : rest[3]);
}

struct Words {
  std::string_view name, meaning, equation, source;
};

template <const FilmLaw& law>
constexpr Function entry(const Words& words, std::span<const Parameter> parameters,
                         std::span<const Combination> combinations, std::span<const Result> results,
                         const Arguments& example) {
  return {.name = words.name,
          .meaning = words.meaning,
          .equation = words.equation,
          .source = words.source,
          .parameters = parameters,
          .results = results,
          .value = [](const Arguments& x, Results& y) { y[0] = film(law, law, x); },
          .contract = film_contract,
          .example = example,
          .film_law = &law,
          .combinations = combinations};
}

constexpr std::string_view of_hamrock_and_dowson =
    "B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point contacts, part "
    "III, fully flooded results. J. Lubr. Technol. 99 (1977) 264, doi 10.1115/1.3453074";
constexpr std::string_view of_soft_bodies =
    "B. J. Hamrock, D. Dowson: Elastohydrodynamic lubrication of elliptical contacts for materials "
    "of low elastic modulus, part I, fully flooded conjunction. J. Lubr. Technol. 100 (1978) 236";
constexpr std::string_view of_pan_and_hamrock =
    "P. Pan, B. J. Hamrock: Simple formulas for performance parameters used in "
    "elastohydrodynamically lubricated line contacts. J. Tribol. 111 (1989) 246; as printed in B. "
    "J. Hamrock, S. R. Schmid, B. O. Jacobson: Fundamentals of Fluid Film Lubrication, chapter 18";

constexpr std::array entries{
    entry<hamrock_dowson_central_law>(
        {"hamrock_dowson_central", "central film thickness of the flooded, smooth point contact",
         "h₀/R = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^(−0.73k)), U = η₀u/(2E*R), G = 2αE*, W = "
         "F/(2E*R²)",
         "B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point contacts, "
         "part III, fully flooded results. J. Lubr. Technol. 99 (1977) 264, doi "
         "10.1115/1.3453074; the paper that is reproduced misprints 0.61 as 0.6"},
        circle_parameters, point_combinations, central_results, steel_point),
    entry<hamrock_dowson_minimum_law>(
        {"hamrock_dowson_minimum", "minimum film thickness of the flooded, smooth point contact",
         "h_min/R_x = 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^(−0.68k)), U = η₀u/(2E*R_x), G = 2αE*, W "
         "= F/(2E*R_x²)",
         of_hamrock_and_dowson},
        point_parameters, point_combinations, minimum_results, steel_point),
    entry<hamrock_dowson_soft_central_law>(
        {"hamrock_dowson_soft_central",
         "central film thickness of the flooded, isoviscous contact of a soft body",
         "h₀/R_x = 7.32 U^0.64 W^−0.22 (1 − 0.72 e^(−0.28k)), U = η₀u/(2E*R_x), W = F/(2E*R_x²)",
         of_soft_bodies},
        soft_parameters, soft_combinations, central_results, soft_point),
    entry<hamrock_dowson_soft_minimum_law>(
        {"hamrock_dowson_soft_minimum",
         "minimum film thickness of the flooded, isoviscous contact of a soft body",
         "h_min/R_x = 7.43 U^0.65 W^−0.21 (1 − 0.85 e^(−0.31k)), U = η₀u/(2E*R_x), W = "
         "F/(2E*R_x²)",
         of_soft_bodies},
        soft_parameters, soft_combinations, minimum_results, soft_point),
    entry<dowson_higginson_minimum_law>(
        {"dowson_higginson_minimum", "minimum film thickness of the flooded, smooth line contact",
         "h_min/R = 2.65 U^0.7 G^0.54 W^−0.13, U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
         "D. Dowson: Elastohydrodynamics. Proc. Inst. Mech. Eng. 182 (1967) 151; it renews D. "
         "Dowson, G. R. Higginson: Elasto-hydrodynamic Lubrication (1966)"},
        line_parameters, line_combinations, minimum_results, steel_line),
    entry<dowson_toyoda_central_law>(
        {"dowson_toyoda_central", "central film thickness of the flooded, smooth line contact",
         "h₀/R = 3.06 U^0.69 G^0.56 W^−0.1, U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
         "D. Dowson, S. Toyoda: A central film thickness formula for elastohydrodynamic line "
         "contacts. Proc. 5th Leeds–Lyon Symp. (1979) 60"},
        line_parameters, line_combinations, central_results, steel_line),
    entry<pan_hamrock_minimum_law>(
        {"pan_hamrock_minimum", "minimum film thickness of the flooded, smooth line contact",
         "h_min/R = 1.714 U^0.694 G^0.568 W^−0.128, U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
         of_pan_and_hamrock},
        line_parameters, line_combinations, minimum_results, steel_line),
    entry<pan_hamrock_central_law>(
        {"pan_hamrock_central", "central film thickness of the flooded, smooth line contact",
         "h₀/R = 2.922 U^0.692 G^0.47 W^−0.166, U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
         of_pan_and_hamrock},
        line_parameters, line_combinations, central_results, steel_line),
    entry<ertel_grubin_law>(
        {"ertel_grubin", "central film thickness of the flooded, smooth line contact, by its inlet",
         "h₀/R = 1.95 (GU)^(8/11) W^(−1/11), U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
         "A. N. Grubin, I. E. Vinogradova (1949) after A. M. Ertel; D. Dowson, G. R. Higginson: "
         "Elasto-hydrodynamic Lubrication (1966)"},
        line_parameters, line_combinations, central_results, steel_line),
    Function{
        .name = "moes_line",
        .meaning = "central film thickness of the flooded line contact, from rigid to elastic",
        .equation = "H = {(RI^(7/3) + EI^(7/3))^(3s/7) + (RP^(−7/2) + EP^(−7/2))^(−2s/7)}^(1/s), s "
                    "= (7 + 8e^(−2EI/RI))/5, RI = 3/M, EI = 2.621M^(−1/5), RP = 1.287L^(2/3), EP = "
                    "1.311M^(−1/8)L^(3/4); M = W(2U)^(−1/2), L = G(2U)^(1/4), H = "
                    "(h₀/R)(2U)^(−1/2), U = η₀u/(2E*R), G = 2αE*, W = (F/L)/(2E*R)",
        .source = "H. Moes: Optimum similarity analysis with applications to elastohydrodynamic "
                  "lubrication. Wear 159 (1992) 57; H. Moes: Lubrication and Beyond. Twente (2000)",
        .parameters = line_parameters,
        .results = central_results,
        .value = [](const Arguments& x,
                    Results& y) { y[0] = tribo::moes_line(x[0], x[1], x[2], x[3], x[4], x[5]); },
        .contract = moes_line_contract,
        .example = steel_line,
        .combinations = moes_combinations},
    Function{
        .name = "nijenbanning_venner_moes",
        .meaning = "film thickness of the flooded point contact, from rigid to elastic",
        .equation =
            "H = {[RI^(3/2) + (EI^(−4) + H00^(−4))^(−3/8)]^(2s/3) + [RP^(−8) + "
            "EP^(−8)]^(−s/8)}^(1/s), "
            "s = 1.5(1 + e^(−1.2x)), x = EI/RI (ei_over_ri) or EI/EP (ei_over_ep); with "
            "three_halves_of_s the first bracket is [RI^(3s/2) + (EI^(−4) + "
            "H00^(−4))^(−3s/8)]^(2/(3s)); RI = 145(1 + 0.796D^(14/15))^(−15/7)D^(−1)M^(−2), EI = "
            "3.18Q^(−14/25)D^(−1/15)M^(−2/15), RP = 1.29(1 + 0.691D)^(−2/3)L^(2/3), EP = "
            "1.48Q^(−7/20)D^(−1/24)M^(−1/12)L^(3/4), Q = 1 + 0.006 ln D + 0.63D^(4/7), H00 = "
            "1.8/D, "
            "D = R_x/R_y; M = W(2U)^(−3/4), L = G(2U)^(1/4), H = (h₀/R_x)(2U)^(−1/2), U = "
            "η₀u/(2E*R_x), G = 2αE*, W = F/(2E*R_x²)",
        .source =
            "G. Nijenbanning, C. H. Venner, H. Moes: Film thickness in elastohydrodynamically "
            "lubricated elliptic contacts. Wear 176 (1994) 217; the print is not at hand, and "
            "public transcriptions differ in x and in the first bracket: all readings are "
            "kept, and solved films are nearest to the default",
        .parameters = ellipse_parameters,
        .results = central_results,
        .value =
            [](const Arguments& x, Results& y) {
              y[0] = tribo::nijenbanning_venner_moes(x[0], x[1], x[2], x[3], x[4], x[5], x[6],
                                                     enum_at<MoesExponent>(x[7]),
                                                     enum_at<MoesBracket>(x[8]));
            },
        .contract = nijenbanning_venner_moes_contract,
        .example = {0.05, 0.0202, 2e-8, 50, 107.9e9, 9.5e-3, 19e-3, 0, 0},
        .combinations = ellipse_combinations},
    Function{.name = "regime_film",
             .meaning = "dimensionless minimum film of a flooded point contact, by its regime",
             .equation =
                 "isoviscous_rigid 128αφ²(0.131 atan(α/2) + 1.683)², φ = 1/(1 + 2/(3α)); "
                 "viscous_rigid_barus 1.66 g_V^(2/3) (1 − e^(−0.68k)); viscous_rigid_roelands "
                 "141 g_V^0.375 (1 − e^(−0.0387α)); isoviscous_elastic 8.70 g_E^0.67 (1 − 0.85 "
                 "e^(−0.31k)); viscous_elastic 3.42 g_V^0.49 g_E^0.17 (1 − e^(−0.68k))",
             .source =
                 "B. J. Hamrock, D. Dowson: Minimum film thickness in elliptical contacts for "
                 "different regimes of fluid-film lubrication. NASA TP-1342 (1978); B. J. Hamrock: "
                 "Fundamentals of Fluid Film Lubrication. NASA RP-1255 (1991); "
                 "viscous_rigid_roelands by Y.-R. Jeng, B. J. Hamrock, D. E. Brewe: Piezoviscous "
                 "effects in nonconformal contacts lubricated hydrodynamically. ASLE Trans. 30 "
                 "(1987) 452; 141 is printed as 1.41 elsewhere, a hundredth of it",
             .parameters = regime_parameters,
             .results = regime_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   y[0] = tribo::regime_film(enum_at<FilmRegime>(x[0]), x[1], x[2], x[3], x[4]);
                 },
             .contract = film_contract,
             .example = {4, 1e6, 1e4, 1, 1}},
    Function{
        .name = "gupta_thermal_reduction",
        .meaning = "film of an inlet that shear heats over that of an isothermal one",
        .equation = "φ_T = (1 − 13.2 (p₀/E′) L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64), L = "
                    "βη₀u²/k_f, E′ = 2E*; refused where the numerator is not above 0",
        .source = "P. K. Gupta, H. S. Cheng, D. Zhu, N. H. Forster, J. B. Schrand: Viscoelastic "
                  "effects in MIL-L-7808-type lubricant, part I. Tribol. Trans. 35 (1992) 269, doi "
                  "10.1080/10402009208982117; E′ is taken as that of G = αE′",
        .parameters = thermal_parameters,
        .results = thermal_results,
        .value = [](const Arguments& x, Results& y) { y[0] = thermal_reduction(x); },
        .contract = gupta_thermal_contract,
        .example = {1e9, 107.9e9, 0.1, 0.04, 0.0202, 5, 0.14},
        .refusal = too_hot,
        .combinations = thermal_combinations},
    Function{
        .name = "murch_wilson_thermal_reduction",
        .meaning = "film of an inlet that shear heats in pure rolling over an isothermal one",
        .equation = "φ_T = 3.94/(3.94 + L^0.62), L = βη₀u²/k_f",
        .source = "L. E. Murch, W. R. D. Wilson: A thermal elastohydrodynamic inlet zone "
                  "analysis. J. Lubr. Technol. 97 (1975) 212, doi 10.1115/1.3452559; u is "
                  "the mean speed, and 1/3.94 is printed as 0.254, by W. R. D. Wilson, S. "
                  "Sheu: Effect of inlet shear heating due to sliding on "
                  "elastohydrodynamic film thickness. J. Lubr. Technol.",
        .parameters = rolling_parameters,
        .results = thermal_results,
        .value = [](const Arguments& x,
                    Results& y) { y[0] = murch_wilson_thermal_reduction(x[0], x[1], x[2], x[3]); },
        .contract = murch_wilson_thermal_contract,
        .example = {0.04, 0.0202, 5, 0.14},
        .combinations = rolling_combinations},
};

}  // namespace

std::span<const Function> films() { return entries; }

double film_by(const FilmLaw& law, const Function& function, const Arguments& arguments) {
  return film(*function.film_law, law, arguments);
}

}  // namespace tribo::catalogue
