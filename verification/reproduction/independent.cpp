// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "accuracy/reference_table.hpp"
#include "reproduction/ledger.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"

namespace tribo::reproduction {
namespace {

// The number of significant digits of "1.0913928830611e-4". The first digit must not be 0.
double digits_of(const std::string& text) {
  const std::string mantissa = text.substr(0, text.find('e'));
  return static_cast<double>(std::count_if(mantissa.begin(), mantissa.end(),
                                           [](unsigned char c) { return std::isdigit(c) != 0; }));
}

}  // namespace

std::vector<IndependentNumber> independent_numbers(const std::string& path) {
  constexpr double steel = 210e9 / (2 * 0.91);  // E*: 210 GPa and 0.3 for both bodies
  std::vector<IndependentNumber> numbers;
  verification::each_published_row(path, [&](const auto& row) {
    const double load = row.number("load"), radius = row.number("reduced_radius");
    const double speed = row.number("speed");
    const HertzPoint<double> hertz = hertz_point(load, steel, radius);
    // The other library has 1.9 for 2.69(1 − 0.61 e^−0.73).
    const double film =
        hamrock_dowson_central(speed, row.number("viscosity"), row.number("pressure_viscosity"),
                               load, steel, radius, 1.0) *
        (1.9 / hamrock_dowson_constant(1.0));
    const std::string name = fmt::format("{} m/s, {} N", speed, load);
    const auto add = [&](const char* column, const char* unit, double computed) {
      const double reported = row.number(column), digits = digits_of(row.text(column));
      const double unit_of_last = std::pow(10, std::floor(std::log10(reported)) - digits + 1);
      numbers.push_back({name, column, unit, reported, computed, digits,
                         std::abs(computed - reported) <= unit_of_last / 2 * (1 + 1e-3)});
    };
    add("central_film_thickness", "m", film);
    add("radius", "m", hertz.radius);
    add("peak_pressure", "Pa", hertz.peak_pressure);
    add("approach", "m", hertz.approach);
  });
  return numbers;
}

}  // namespace tribo::reproduction
