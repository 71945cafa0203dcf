// SPDX-License-Identifier: Apache-2.0
// The effective modulus of two bodies, and the radii of the gap between them.
#include "tribo/two_bodies.hpp"

#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"

namespace tribo::catalogue {
namespace {

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
constexpr Combination gap_radius(std::string_view name, std::string_view meaning,
                                 double (*value)(const Arguments&), std::string_view parameter) {
  return {.name = name,
          .meaning = meaning,
          .unit = "m",
          .least = 1e-6,
          .greatest = 1e3,
          .value = value,
          .parameter = parameter};
}
constexpr std::array radius_combinations{
    gap_radius(
        "radius_x", "R_x", [](const Arguments& x) { return relative_radius(x[0], x[1]); },
        "first_radius_x"),
    gap_radius(
        "radius_y", "R_y", [](const Arguments& x) { return relative_radius(x[2], x[3]); },
        "first_radius_y")};
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

constexpr std::array entries{
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
             .refusal = faces_without_a_point,
             .combinations = radius_combinations},
};

}  // namespace

std::span<const Function> two_bodies() { return entries; }

}  // namespace tribo::catalogue
