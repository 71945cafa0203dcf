// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "reproduction/ledger.hpp"
#include "sampling/philox.hpp"

namespace tribo::reproduction {
namespace {

// The random factor on an input, from a number `uniform` in (0, 1).
double factor(const Input& input, Spread spread, double uniform) {
  if (spread == Spread::print) return 1 + (uniform - 0.5) * input.last_digit / input.value;
  return std::exp(std::log(input.low) + uniform * std::log(input.high / input.low)) / input.value;
}

double uniform(Spread spread, std::size_t draw, std::size_t input) {
  const verification::PhiloxCounter words = verification::philox_words(
      {static_cast<std::uint32_t>(draw), static_cast<std::uint32_t>(input), 0, 0},
      {static_cast<std::uint32_t>(spread), 0});
  return (words[0] + 0.5) * 0x1p-32;
}

Interval interval(std::vector<double> values) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {none, none, none, none, none};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const double place = part * static_cast<double>(values.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 == values.size()) return values[i];
    return values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]);
  };
  return {at(0.025), at(0.5), at(0.975), values.front(), values.back()};
}

PaperScenes drawn(const PaperScenes& scenes, const std::vector<Input>& inputs, Spread spread,
                  std::size_t draw) {
  PaperScenes changed = scenes;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    // These two inputs are conventions that a reading chooses: they are printed without error.
    if (inputs[k].field == Field::film_constant || inputs[k].field == Field::speed) continue;
    const double by = factor(inputs[k], spread, uniform(spread, draw, k));
    for (std::size_t i = 0; i < surface_count; ++i)
      if (inputs[k].is_of(i)) scale(changed, i, inputs[k].field, by);
  }
  return changed;
}

}  // namespace

Uncertainty uncertainty(const PaperScenes& scenes, const std::vector<Input>& inputs, Spread spread,
                        std::size_t draws, const ReportedOnsets& reported) {
  const Reading reading = corrected_reading();
  const ReadInlet inlet(reading);
  const double lowest = scenes.scene[0].speeds.from;
  std::array<std::vector<double>, surface_count> speed, share;
  std::vector<double> first, second, film_parameter;
  Uncertainty found{};
  found.spread = spread;
  found.draws = draws;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    const PaperScenes changed = drawn(scenes, inputs, spread, draw);
    std::array<double, surface_count> onset{};
    bool as_reported = true;
    for (std::size_t i = 0; i < surface_count; ++i) {
      const ReadContact contact(changed.scene[i], reading, changed.film_scale());
      share[i].push_back(contact.point(lowest, inlet).asperity_share);
      const auto point = explicit_onset(contact, inlet, reading.onset());
      if (!point) continue;
      onset[i] = point->speed;
      speed[i].push_back(point->speed);
      if (i == 0) film_parameter.push_back(point->film_parameter);
      as_reported =
          as_reported && is_as_printed(onset[i], reported.speed[i], reported.last_digit[i]);
    }
    found.all_onsets_reported += as_reported && onset[0] > 0 && onset[1] > 0 && onset[2] > 0;
    if (onset[1] > 0 && onset[2] > 0) first.push_back(onset[1] / onset[2]);
    if (onset[0] > 0 && onset[1] > 0) second.push_back(onset[0] / onset[1]);
  }
  for (std::size_t i = 0; i < surface_count; ++i) {
    found.onset_speed[i] = interval(std::move(speed[i]));
    found.slow_asperity_share[i] = interval(std::move(share[i]));
  }
  found.medium_over_smooth = interval(std::move(first));
  found.rough_over_medium = interval(std::move(second));
  found.film_parameter = interval(std::move(film_parameter));
  return found;
}

}  // namespace tribo::reproduction
