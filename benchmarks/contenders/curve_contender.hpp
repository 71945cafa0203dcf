// SPDX-License-Identifier: Apache-2.0
// Methods that compute many operating points of one scene: film, load share of the asperities and
// friction.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "contenders/contender.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/scene.hpp"

namespace tribo::benchmarks {

struct CurveContender {
  std::string family;
  std::string name;
  // Fills `points`, which the caller has resized.
  std::function<void(const Scene& scene, std::span<const double> speeds, OperatingPoints& points)>
      run;
  bool is_slow;  // a point takes some microseconds or more; then fewer points are timed
};

OutputSet curve_outputs();

// All contenders. Our own come last.
std::vector<CurveContender> curve_contenders(Settings settings = Settings::usual);

}  // namespace tribo::benchmarks
