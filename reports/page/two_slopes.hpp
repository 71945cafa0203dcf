// SPDX-License-Identifier: Apache-2.0
// Figure 4: film against speed, u^0.67 while the inlet is flooded, u^−1 once it starves. The second
// slope needs an oil supply that is carried in at a constant rate, and a closure with h* → h_oil.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/solved_case.hpp"

namespace tribo::report {

struct SlopeCurve {
  std::string_view name;  // "flooded", "starved_inlet", …
  std::string change;     // the difference from the scene file
  std::vector<Point> points;
  double first_slope;             // d ln h*/d ln u at the lowest speed, and
  double last_slope;              // at the highest; NaN where the film has collapsed
  std::optional<Point> at_onset;  // film_maximum, if it lies within the range
};

// A straight line on logarithmic axes.
struct GuideLine {
  double slope;
  std::array<double, 3> speeds;  // m/s: start, middle, end
  std::array<double, 3> films;   // m
};

struct TwoSlopes {
  const SolvedCase* base;  // the scene that the curves are variations of
  double inlet_flow;       // q, m²/s: the flooded film meets h_oil = q/u at `knee`
  double knee;             // m/s, the middle of the scene's speeds on a logarithmic axis
  std::vector<SlopeCurve> curves;
  std::array<GuideLine, 2> guides;
};

TwoSlopes two_slopes(const SolvedCase& base);

}  // namespace tribo::report
