// SPDX-License-Identifier: Apache-2.0
#include "page/observations.hpp"

#include <algorithm>
#include <limits>

#include "page/speed_search.hpp"

namespace tribo::report {

std::vector<RatioPoint> ratios(const SolvedCase& first, const SolvedCase& second,
                               double Point::*quantity, double highest_speed) {
  std::vector<RatioPoint> found;
  for (const Point& point : first.curve) {
    if (point.speed > highest_speed || point.inlet == Inlet::collapsed) break;
    const Point other = second.contact.solve(point.speed);
    if (other.inlet == Inlet::collapsed) break;
    found.push_back({point.speed, point.*quantity / (other.*quantity)});
  }
  return found;
}

RatioRange range_of(const std::vector<RatioPoint>& ratios) {
  RatioRange range{std::numeric_limits<double>::infinity(), 0};
  for (const RatioPoint& point : ratios)
    range = {std::min(range.least, point.ratio), std::max(range.greatest, point.ratio)};
  return range;
}

std::optional<double> equal_share_speed(const SolvedCase& solved) {
  // The share falls with speed up to the onset, and rises beyond it.
  const double highest = solved.at_onset ? solved.at_onset->speed : solved.range.high;
  return first_speed(solved.range.low, highest, [&](double speed) {
    return solved.contact.solve(speed).asperity_load_share <= 0.5;
  });
}

std::optional<double> least_friction(const SolvedCase& solved) {
  std::optional<double> least;
  for (const Point& point : solved.curve)
    if (!point.friction_undefined && (!least || point.friction < *least)) least = point.friction;
  return least;
}

}  // namespace tribo::report
