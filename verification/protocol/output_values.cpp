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
  const bool has_collapsed = point.regime == Regime::collapsed;
  if (output == Output::regime)
    return word(name(point.regime),
                has_collapsed || std::isfinite(point.asperity_load_share + point.fluid_load_share));
  if (output == Output::inlet) return word(name(point.inlet), std::isfinite(point.film));
  if (has_collapsed && balance_outputs().contains(output))
    return {.undefined = film_collapsed, .word = {}};
  return number(numbers_of(point)[static_cast<std::size_t>(output)]);
}

bool needs_smooth_contact(const Scene& scene) {
  return scene.outputs.contains_any(smooth_outputs()) || scene.surface.has_rq_alone() ||
         film_law(scene).is_solved();
}

OutputValue value_of(const OperatingPoint<double>& point, const SmoothContact* smooth,
                     Output output) {
  if (smooth == nullptr) return value_of(point, output);
  if (output != Output::peak_pressure && output != Output::mean_pressure &&
      smooth->is_beyond_solved_films(point.film))
    return {.undefined = beyond_solved_films, .word = {}};
  if (info(output).is_of_smooth_contact)
    return number(smooth->value(output, point.speed, point.film));
  if (summit_outputs().contains(output) && point.regime != Regime::collapsed &&
      smooth->has_unknown_summits(point.speed, point.film))
    return {.undefined = unknown_summits, .word = {}};
  return value_of(point, output);
}

}  // namespace tribo::protocol
