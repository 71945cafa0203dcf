// SPDX-License-Identifier: Apache-2.0
#include "protocol/output_values.hpp"

#include <cmath>

namespace tribo::protocol {
namespace {

OutputValue number(double value) {
  if (!std::isfinite(value)) return {.undefined = beyond_double, .word = {}};
  return {.undefined = {}, .word = {}, .number = value};
}

OutputValue word(std::string_view text, bool rests_on_finite_numbers) {
  if (!rests_on_finite_numbers) return {.undefined = beyond_double, .word = {}};
  return {.undefined = {}, .word = text};
}

}  // namespace

OutputValue value_of(const OperatingPoint<double>& point, Output output) {
  switch (output) {
    case Output::asperity_load_share:
    case Output::fluid_load_share:
    case Output::friction:
      if (point.regime == Regime::collapsed) return {.undefined = film_collapsed, .word = {}};
      break;
    case Output::regime:
      return word(name(point.regime),
                  point.regime == Regime::collapsed ||
                      std::isfinite(point.asperity_load_share + point.fluid_load_share));
    case Output::inlet:
      return word(name(point.inlet), std::isfinite(point.film));
    default:
      break;
  }
  return number(numbers_of(point)[static_cast<std::size_t>(output)]);
}

OutputSet needed_for(OutputSet asked) {
  if (asked.contains(Output::inlet)) asked.insert(Output::film);
  return asked;
}

}  // namespace tribo::protocol
