// SPDX-License-Identifier: Apache-2.0
// The least speed at which something holds, by bisection down to neighbouring doubles.
#pragma once

#include <cmath>
#include <optional>

namespace tribo::report {

// `holds` must be false up to some speed and true from there to `high`. The answer is `low` if
// `holds` is true there, and empty if `holds` is false at `high`. 0 < low ≤ high.
template <class Predicate>
std::optional<double> first_speed(double low, double high, Predicate&& holds) {
  if (holds(low)) return low;
  if (!holds(high)) return std::nullopt;
  while (true) {
    const auto is_between = [&](double x) { return x > low && x < high; };
    double middle = std::sqrt(low) * std::sqrt(high);
    if (!is_between(middle)) middle = low + (high - low) / 2;  // its own rounding is some units
    if (!is_between(middle)) return high;
    (holds(middle) ? high : low) = middle;
  }
}

}  // namespace tribo::report
