// SPDX-License-Identifier: Apache-2.0
// Numbers read off the curves, for the captions.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "page/solved_case.hpp"

namespace tribo::report {

struct RatioPoint {
  double speed;
  double ratio;
};
struct RatioRange {
  double least, greatest;
};

// first/second of a quantity at the speeds of the curve of `first`, up to `highest_speed` and while
// neither film has collapsed.
std::vector<RatioPoint> ratios(const SolvedCase& first, const SolvedCase& second,
                               double Point::*quantity,
                               double highest_speed = std::numeric_limits<double>::infinity());
RatioRange range_of(const std::vector<RatioPoint>& ratios);

// The first speed at which the film carries half the load; none if it does nowhere.
std::optional<double> equal_share_speed(const SolvedCase& solved);

// The least friction of the curve; none if it is undefined throughout.
std::optional<double> least_friction(const SolvedCase& solved);

}  // namespace tribo::report
