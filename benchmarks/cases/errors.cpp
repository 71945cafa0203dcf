// SPDX-License-Identifier: Apache-2.0
#include "cases/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tribo::benchmarks {

double ulps_off(double got, double high, double low) {
  const double unit = std::max(std::numeric_limits<double>::denorm_min(),
                               std::ldexp(1.0, high == 0 ? -1074 : std::ilogb(high) - 52));
  return std::abs((got - high) - low) / unit;
}

void ErrorTally::add(double got, double high, double low, double condition) {
  if (got == not_offered) return;
  ++judged_;
  const double allowed = failed_beyond * std::max(1.0, condition) * std::abs(high);
  if (!(std::abs((got - high) - low) <= allowed)) ++failures_;
  if (std::isfinite(got)) ulps_.push_back(ulps_off(got, high, low));
}

void ErrorTally::add(double got, long double exact) {
  const auto high = static_cast<double>(exact);
  add(got, high, static_cast<double>(exact - high));
}

Errors ErrorTally::errors() const {
  Errors result{judged_, failures_, judged_ - ulps_.size(), 0, 0, 0};
  if (ulps_.empty()) return result;
  std::vector<double> sorted = ulps_;
  std::sort(sorted.begin(), sorted.end());
  result.max_ulp = sorted.back();
  result.p99_ulp = sorted[(sorted.size() - 1) * 99 / 100];
  result.mean_ulp =
      std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
  return result;
}

}  // namespace tribo::benchmarks
