// SPDX-License-Identifier: Apache-2.0
// Rows of the tables of solved films. Each number of a film has its error behind it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "ehl/film_conditions.hpp"
#include "ehl/solved_film.hpp"
#include "generators/table_file.hpp"
#include "tribo/friction.hpp"

namespace tribo::reference {

// With Roelands' viscosity and a compressible liquid, M and L alone do not determine the film. The
// tables therefore have one liquid, with α = 20/GPa and Roelands' z = 0.6, between bodies of steel.
// The speed follows from L, and the load follows from M: as the load of a line contact if
// radius_ratio = R_y/R_x is infinite, else as that of a point contact.
inline constexpr const char* compressible_liquid =
    "Roelands with z = 0.6 and alpha = 20/GPa, density by Dowson and Higginson, E* = 115.4 GPa";
inline ehl::FilmConditions compressible_conditions(double load_number, double material_number,
                                                   double radius_ratio) {
  constexpr double modulus = 115.4e9, radius = 0.01, coefficient = 20e-9, index = 0.6;
  const double viscosity = std::exp(coefficient * roelands_pressure<double>() / index -
                                    roelands_log_viscosity<double>());
  const double root = std::pow(material_number / (2 * coefficient * modulus), 2);  // √(2U)
  const double load_of_line = load_number * root * 2 * modulus * radius;
  return {.speed = root * root * modulus * radius / viscosity,
          .viscosity = viscosity,
          .pressure_viscosity = coefficient,
          .load = std::isinf(radius_ratio) ? load_of_line : load_of_line * std::sqrt(root) * radius,
          .effective_modulus = modulus,
          .radius = radius,
          .viscosity_law = ViscosityLaw::roelands,
          .density_law = ehl::FilmDensity::dowson_higginson,
          .radius_ratio = radius_ratio};
}

// The number and its error, both multiplied by `unit`, each after a comma.
inline std::string fields(const ehl::Estimate& e, double unit) {
  return fmt::format(",{:.9g},{:.2g}", e.value * unit, e.error * unit);
}

// The first `count` fields of a row. An empty field gives NaN.
inline std::vector<double> numbers_of(const std::string& row, std::size_t count) {
  std::vector<double> values;
  std::istringstream in(row);
  for (std::string field; values.size() < count && std::getline(in, field, ',');)
    values.push_back(field.empty() ? std::nan("") : std::stod(field));
  return values;
}

// Whether the first `keys` numbers of two rows are equal, and the later numbers agree. Up to column
// `count`, the later numbers are pairs of a value and its error; two values agree where they differ
// by at most the sum of their errors. The texts are not compared, because their last digits depend
// on how a machine and a compiler round.
inline bool is_within_errors(const std::string& one, const std::string& other, std::size_t keys,
                             std::size_t count) {
  const std::vector<double> a = numbers_of(one, count), b = numbers_of(other, count);
  if (a.size() != count || b.size() != count) return false;
  for (std::size_t i = 0; i < count; i += i < keys ? 1 : 2) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    if (!(std::fabs(a[i] - b[i]) <= (i < keys ? 0 : a[i + 1] + b[i + 1]))) return false;
  }
  return true;
}

}  // namespace tribo::reference
