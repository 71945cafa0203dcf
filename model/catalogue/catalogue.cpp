// SPDX-License-Identifier: Apache-2.0
#include "catalogue/catalogue.hpp"

#include <algorithm>

#include "tribo/film_thickness.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/scene.hpp"
#include "tribo/starvation.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::catalogue {
namespace {

template <class Enum>
Enum enum_at(double place) {
  return static_cast<Enum>(static_cast<int>(place));
}

// What several functions take.
constexpr Parameter load{
    .name = "load", .meaning = "F", .unit = "N", .least = 1e-3, .greatest = 1e6};
constexpr Parameter effective_modulus{.name = "effective_modulus",
                                      .meaning = "E*, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, never 2E*",
                                      .unit = "Pa",
                                      .least = 1e5,
                                      .greatest = 1e12};
constexpr Parameter reduced_radius{.name = "reduced_radius",
                                   .meaning = "R, of a ball on a flat the ball's radius",
                                   .unit = "m",
                                   .least = 1e-6,
                                   .greatest = 10};

// --- Two bodies

constexpr Parameter young_modulus(std::string_view name, std::string_view meaning) {
  return {.name = name, .meaning = meaning, .unit = "Pa", .least = 1e5, .greatest = 1e12};
}
constexpr Parameter poisson_ratio(std::string_view name, std::string_view meaning) {
  return {.name = name, .meaning = meaning, .range = Range::poisson_ratio, .greatest = 0.5};
}
constexpr std::array modulus_parameters{
    young_modulus("first_modulus", "E₁, Young's modulus of the first body"),
    poisson_ratio("first_poisson_ratio", "ν₁"),
    young_modulus("second_modulus", "E₂, Young's modulus of the second body"),
    poisson_ratio("second_poisson_ratio", "ν₂")};
constexpr std::array modulus_results{Result{"value", "E*, never E′ = 2E*", "Pa"}};

constexpr Parameter face_radius(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .meaning = meaning,
          .unit = "m",
          .range = Range::not_zero,
          .least = -10,
          .greatest = 1e30};
}
constexpr std::array radius_parameters{
    face_radius("first_radius_x",
                "R₁x, of the first face along x, the direction of entrainment: above 0 convex, "
                "below 0 concave, 1e30 flat"),
    face_radius("second_radius_x", "R₂x, of the second face, likewise"),
    face_radius("first_radius_y", "R₁y, of the first face across x, likewise"),
    face_radius("second_radius_y", "R₂y, of the second face across x, likewise")};
constexpr std::array radius_results{
    Result{"radius_x", "R_x; of a ball on a flat the ball's radius, the R of hertz_point", "m"},
    Result{"radius_y", "R_y", "m"},
    Result{"reduced_radius",
           "R; of a ball on a flat half of the ball's radius, not the R of hertz_point", "m"}};

std::optional<Refusal> faces_without_a_point(const Arguments& x) {
  const auto meet = [](double first, double second) {
    const double radius = relative_radius(first, second);
    return radius > 0 && is_finite(radius);
  };
  if (!meet(x[0], x[1]))
    return Refusal{"first_radius_x",
                   "the faces do not meet at a point: 1/first_radius_x + 1/second_radius_x has to "
                   "be above 0, so that a concave face needs the greater radius"};
  if (!meet(x[2], x[3]))
    return Refusal{"first_radius_y",
                   "the faces do not meet at a point: 1/first_radius_y + 1/second_radius_y has to "
                   "be above 0, so that a concave face needs the greater radius"};
  return std::nullopt;
}

// --- Rough contact

constexpr std::array moment_parameters{
    Parameter{.name = "order", .meaning = "n", .range = Range::half_order, .greatest = 2.5},
    Parameter{.name = "argument",
              .meaning = "d, separation less offset, over the sd of summit heights",
              .range = Range::any,
              .least = -10,
              .greatest = 10}};
constexpr std::array moment_results{Result{"value", "F_n(d)"}};

// --- Smooth contact

constexpr std::array hertz_parameters{load, effective_modulus, reduced_radius};
constexpr std::array hertz_results{Result{"radius", "a of the circle of contact", "m"},
                                   Result{"mean_pressure", "F/(πa²)", "Pa"},
                                   Result{"peak_pressure", "3/2 of the mean pressure", "Pa"},
                                   Result{"approach", "a²/R, of the two bodies", "m"}};

// --- Film

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

// --- Inlet

constexpr std::array inlet_parameters{
    Parameter{.name = "closure",
              .meaning = "what ties the starved film to the inlet",
              .words = starvation_closure_words},
    Parameter{
        .name = "flooded_over_inlet", .meaning = "r = h_ff/h_oil", .least = 1e-6, .greatest = 1e6},
    Parameter{.name = "damiens_exponent",
              .meaning = "γ, of the closure damiens alone",
              .least = 1,
              .greatest = 6,
              .default_value = 3}};
constexpr std::array inlet_results{Result{"value", "y = h*/h_ff"}};

// --- Load sharing

constexpr std::array sharing_parameters{
    Parameter{
        .name = "asperity", .meaning = "model of the rough contact", .words = asperity_model_words},
    Parameter{
        .name = "flooded_film_parameter", .meaning = "λ₀ = h₀/σ_s", .least = 1e-4, .greatest = 1e3},
    Parameter{.name = "stiffness",
              .meaning = "K of A = (K F_p(λ−δ))^q",
              .range = Range::not_below_zero,
              .greatest = 1e6},
    Parameter{.name = "offset",
              .meaning = "δ, mean plane to the plane of summits, over σ_s",
              .range = Range::not_below_zero,
              .greatest = 10}};
constexpr std::array sharing_results{Result{"value", "λ = h/σ_s"}};

constexpr std::array all{
    Function{.name = "effective_modulus",
             .meaning = "effective modulus of two elastic bodies",
             .equation = "1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂",
             .source = "H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. "
                       "Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), section 4.2",
             .parameters = modulus_parameters,
             .results = modulus_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::effective_modulus(x[0], x[1], x[2], x[3]); },
             .contract = effective_modulus_contract,
             .example = {206e9, 0.3, 72e9, 0.22}},
    Function{.name = "reduced_radius",
             .meaning = "radii of the gap between two curved faces",
             .equation = "1/R_x = 1/R₁x + 1/R₂x > 0, 1/R_y = 1/R₁y + 1/R₂y > 0, 1/R = 1/R_x + "
                         "1/R_y",
             .source = "K. L. Johnson: Contact Mechanics (1985), section 4.1; B. J. Hamrock, D. "
                       "Dowson: Isothermal elastohydrodynamic lubrication of point contacts, part "
                       "I, theoretical formulation. J. Lubr. Technol. 98 (1976) 223",
             .parameters = radius_parameters,
             .results = radius_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   const ReducedRadius<double> radii =
                       tribo::reduced_radius(x[0], x[1], x[2], x[3]);
                   y = {radii.radius_x, radii.radius_y, radii.reduced_radius};
                 },
             .contract = reduced_radius_contract,
             .example = {5e-3, 22.5e-3, 5e-3, -5.2e-3},
             .refusal = faces_without_a_point},
    Function{.name = "gaussian_moment",
             .meaning = "moment of the Gaussian tail, for load, area and count of a rough contact",
             .equation = "F_n(d) = ∫ (s−d)ⁿ e^(−s²/2)/√(2π) ds from d to ∞",
             .source =
                 "J. A. Greenwood, J. H. Tripp: The contact of two nominally flat rough surfaces. "
                 "Proc. Inst. Mech. Eng. 185 (1970) 625, doi 10.1243/PIME_PROC_1970_185_069_02",
             .parameters = moment_parameters,
             .results = moment_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = gaussian_moment(enum_at<Order>(2 * x[0]), x[1]); },
             .contract = gaussian_moment_contract,
             .example = {2.5, -1.146}},
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
    Function{
        .name = "starvation_ratio",
        .meaning = "film behind a starved inlet over the flooded film",
        .equation = "y = (2/π) arctan(2.7ψ), ψ from Crook's gap at h_ff (flooded_inlet) or h* "
                    "(starved_inlet); damiens: y = (1 + r^γ)^(−1/γ)",
        .source =
            "A. W. Crook: The lubrication of rollers. Phil. Trans. R. Soc. Lond. A 250 (1958) 387; "
            "P. E. Wolveridge, K. P. Baglin, J. F. Archard: The starved lubrication of "
            "cylinders in line contact. Proc. Inst. Mech. Eng. 185 (1970) 1159; B. Damiens, "
            "C. H. Venner, P. M. E. Cann, A. A. Lubrecht: Starved lubrication of elliptical "
            "EHD contacts. J. Tribol. 126 (2004) 105, doi 10.1115/1.1631020; the exponents "
            "that the paper prints are a closure of their own",
        .parameters = inlet_parameters,
        .results = inlet_results,
        .value =
            [](const Arguments& x, Results& y) {
              y[0] = starvation_ratio(enum_at<StarvationClosure>(x[0]), x[1], x[2]);
            },
        .contract = starvation_ratio_contract,
        .example = {1, 0.8, 3}},
    Function{
        .name = "load_sharing",
        .meaning = "film parameter at which asperities and film carry the load together",
        .equation = "λ = λ₀ (1−A)^−0.14, A = (K F_p(λ−δ))^q, (p, q) = (5/2, 1/2) of "
                    "greenwood_tripp, (3/2, 1) of greenwood_williamson",
        .source =
            "K. L. Johnson, J. A. Greenwood, S. Y. Poon: A simple theory of asperity contact in "
            "elastohydrodynamic lubrication. Wear 19 (1972) 91, doi 10.1016/0043-1648(72)90445-0",
        .parameters = sharing_parameters,
        .results = sharing_results,
        .value =
            [](const Arguments& x, Results& y) {
              const LoadSharing<double> sharing(enum_at<AsperityModel>(x[0]), x[2], x[3]);
              y[0] = sharing.solve(x[1]).film_parameter;
            },
        .contract = load_sharing_contract,
        .example = {0, 0.5, 20, 1.146}},
};

std::string_view text_of(Range range) {
  switch (range) {
    case Range::above_zero:
      return "a number above 0";
    case Range::not_below_zero:
      return "a number not below 0";
    case Range::not_zero:
      return "a number other than 0";
    case Range::half_order:
      return "0, 0.5, 1, 1.5, 2 or 2.5";
    case Range::poisson_ratio:
      return "a number above -1 and at most 0.5";
    case Range::any:
      break;
  }
  return "a number";
}

}  // namespace

bool is_in_range(double number, Range range) {
  switch (range) {
    case Range::above_zero:
      return number > 0;
    case Range::not_below_zero:
      return number >= 0;
    case Range::not_zero:
      return number < 0 || number > 0;
    case Range::poisson_ratio:
      return number > -1 && number <= 0.5;
    case Range::half_order:
      return number >= 0 && number <= 2.5 && 2 * number == static_cast<int>(2 * number);
    case Range::any:
      break;
  }
  return true;
}

std::optional<double> place_of(std::string_view word, const Parameter& parameter) {
  const auto found = std::find(parameter.words.begin(), parameter.words.end(), word);
  if (found == parameter.words.end()) return std::nullopt;
  return static_cast<double>(found - parameter.words.begin());
}

std::string allowed_text(const Parameter& parameter) {
  std::string text;
  for (const std::string_view word : parameter.words)
    text += (text.empty() ? "" : ", ") + std::string(word);
  return text.empty() ? std::string(text_of(parameter.range)) : text;
}

std::span<const Function> functions() { return all; }

const Function* find(std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Function& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribo::catalogue
