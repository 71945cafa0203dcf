// SPDX-License-Identifier: Apache-2.0
// How sure the computed numbers are: the corrected reading with Table 1 varied within its print
// precision, and within what is plausible. Draws come from a counter (Philox), so that draw i is
// the same whatever was drawn before it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reproduction/evaluation.hpp"

namespace tribo::reproduction {

enum class Spread : std::uint8_t {
  print,      // uniform within half of the last printed digit
  plausible,  // log-uniform within the plausible range
};

struct Interval {
  double low, median, high;  // 2.5 %, 50 %, 97.5 % of the draws
  double least, greatest;
};

struct Uncertainty {
  Spread spread;
  std::size_t draws;
  std::array<Interval, surface_count> onset_speed;          // film_maximum
  std::array<Interval, surface_count> slow_asperity_share;  // at the lowest speed
  Interval medium_over_smooth, rough_over_medium;           // of the onset speeds
  Interval film_parameter;                                  // at the onset
  std::size_t all_onsets_reported;  // draws in which all three speeds print as reported
};

// `reported` with the unit of the last digit, for all_onsets_reported.
struct ReportedOnsets {
  std::array<double, surface_count> speed, last_digit;
};
Uncertainty uncertainty(const PaperScenes& scenes, const std::vector<Input>& inputs, Spread spread,
                        std::size_t draws, const ReportedOnsets& reported);

}  // namespace tribo::reproduction
