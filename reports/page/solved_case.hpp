// SPDX-License-Identifier: Apache-2.0
// One scene, solved: its curve, its onsets, its collapse.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "page/cases.hpp"
#include "tribo/onset.hpp"

namespace tribo::report {

struct SpeedRange {
  double low;   // m/s
  double high;  // m/s
};

using Point = OperatingPoint<double>;

struct SolvedCase {
  Case source;
  MixedContact<double> contact;
  SpeedRange range;                     // the scene's speeds
  std::vector<Point> curve;             // ascending speeds over the range
  std::array<Onset<double>, 4> onsets;  // in the order of onset_criteria
  std::optional<Point> at_onset;        // film_maximum, if it lies within the range
  std::optional<Point> at_collapse;     // the first collapsed point of the range
  Point slowest;                        // at the lowest speed of the scene

  const Onset<double>& by(OnsetCriterion criterion) const {
    return onsets[static_cast<std::size_t>(criterion)];
  }
};

SolvedCase solve_case(const Case& source);

// The curve of a scene over its speeds, closely spaced where the film drops into its collapse.
std::vector<Point> closely_spaced_curve(const MixedContact<double>& contact, SpeedRange range);

// The first speed of the range at which the film has collapsed, if there is one.
std::optional<double> collapse_speed(const MixedContact<double>& contact, SpeedRange range);

const SolvedCase& find_solved(const std::vector<SolvedCase>& solved, std::string_view surface,
                              AsperityModel model);

}  // namespace tribo::report
