// SPDX-License-Identifier: Apache-2.0
#include "catalogue/ways_to_ask.hpp"

#include <algorithm>

#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::catalogue {
namespace {

// Two bodies that have this E*: 1/E* = (1 − 0.5²)/E* + (1 − 0²)/(4E*), without rounding. The bodies
// differ strongly, so that a solver that takes one of them for both gives a wrong answer.
Arguments bodies_of(const Arguments& modulus) { return {modulus[0], 0.5, 4 * modulus[0], 0}; }
double modulus_of(const Arguments& bodies, std::size_t /*place*/) {
  return tribo::effective_modulus(bodies[0], bodies[1], bodies[2], bodies[3]);
}

// reduced_radius and radius_x are both R_x: for a ball on a flat, the ball's radius.
constexpr std::array radii{radius_x, radius_y};
double radius_or_ellipticity(const Arguments& given, std::size_t place) {
  return place == 0 ? given[0] : ellipse_of_circle(given[0], given[1]).axes_ratio;
}
Arguments radii_of(const Arguments& x) { return {x[0], x[0] * radius_ratio_of(x[1])}; }

constexpr std::array<std::string_view, 1> of_modulus{"effective_modulus"};
constexpr std::array<std::string_view, 2> of_reduced_radius{"reduced_radius", "ellipticity"};
constexpr std::array<std::string_view, 2> of_radius_x{"radius_x", "ellipticity"};

}  // namespace

std::span<const WayToAsk> ways_to_ask() {
  static const std::array ways{
      WayToAsk{"bodies", function_named("effective_modulus")->parameters, of_modulus, modulus_of,
               bodies_of},
      WayToAsk{"radii", radii, of_reduced_radius, radius_or_ellipticity, radii_of},
      WayToAsk{"radii", radii, of_radius_x, radius_or_ellipticity, radii_of}};
  return ways;
}

bool has_way(const Function& function, const WayToAsk& way) {
  return std::all_of(way.in_place_of.begin(), way.in_place_of.end(), [&](std::string_view name) {
    return place_in(function.parameters, name) < function.parameters.size();
  });
}

std::size_t place_in(std::span<const Parameter> parameters, std::string_view name) {
  return static_cast<std::size_t>(
      std::find_if(parameters.begin(), parameters.end(),
                   [&](const Parameter& one) { return one.name == name; }) -
      parameters.begin());
}

}  // namespace tribo::catalogue
