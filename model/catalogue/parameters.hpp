// SPDX-License-Identifier: Apache-2.0
// Parameters that functions of several families take.
#pragma once

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

// The word of a parameter as an enumerator, from the word's place in the list.
template <class Enum>
Enum enum_at(double place) {
  return static_cast<Enum>(static_cast<int>(place));
}

// Calls `function` with the first place and the length of each run of equal numbers in a column.
template <class Call>
void for_each_run(const Column& column, std::size_t count, Call function) {
  if (column.is_same) return function(std::size_t{0}, count);
  const double* const numbers = column.numbers;
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    while (end < count && numbers[end] == numbers[first]) ++end;
    function(first, end - first);
  }
}

inline constexpr Parameter load{
    .name = "load", .meaning = "F", .unit = "N", .least = 1e-3, .greatest = 1e6};
inline constexpr Parameter effective_modulus{
    .name = "effective_modulus",
    .meaning = "E*, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, never 2E*",
    .unit = "Pa",
    .least = 1e5,
    .greatest = 1e12};
inline constexpr Parameter reduced_radius{.name = "reduced_radius",
                                          .meaning = "R, of a ball on a flat the ball's radius",
                                          .unit = "m",
                                          .least = 1e-6,
                                          .greatest = 10};

// Parameters of elliptical contacts: x is the direction of entrainment.
inline constexpr Parameter radius_x{.name = "radius_x",
                                    .meaning =
                                        "R_x, 1/R_x = 1/R₁x + 1/R₂x, of a ball on a flat "
                                        "the ball's radius",
                                    .unit = "m",
                                    .least = 1e-6,
                                    .greatest = 1e3};
inline constexpr Parameter radius_y{.name = "radius_y",
                                    .meaning = "R_y, 1/R_y = 1/R₁y + 1/R₂y, across x",
                                    .unit = "m",
                                    .least = 1e-6,
                                    .greatest = 1e3};

// Parameters of line contacts.
inline constexpr Parameter load_per_length{.name = "load_per_length",
                                           .meaning = "F/L, the load over the length of the line",
                                           .unit = "N/m",
                                           .least = 1e-3,
                                           .greatest = 1e8};

// The speed, and parameters of lubricants.
inline constexpr Parameter speed{.name = "speed",
                                 .meaning = "u, entrainment: the mean of the two surfaces' speeds",
                                 .unit = "m/s",
                                 .least = 1e-6,
                                 .greatest = 100};
inline constexpr Parameter viscosity{.name = "viscosity",
                                     .meaning = "η₀, at ambient pressure",
                                     .unit = "Pa·s",
                                     .least = 1e-4,
                                     .greatest = 100};
inline constexpr Parameter pressure_viscosity{
    .name = "pressure_viscosity", .meaning = "α", .unit = "1/Pa", .least = 1e-9, .greatest = 1e-7};

}  // namespace tribo::catalogue
