// SPDX-License-Identifier: Apache-2.0
// All bits of an operating point, to compare two that have to be the same. All NaNs count as one:
// the sign of a NaN has no meaning, and differs between processors.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tribo/operating_point.hpp"

namespace tribo::verification {

inline std::vector<std::uint64_t> bits_of(const OperatingPoint<double>& point) {
  std::vector<std::uint64_t> bits{std::bit_cast<std::uint64_t>(point.speed)};
  for (const double number : numbers_of(point))
    bits.push_back(std::bit_cast<std::uint64_t>(
        std::isnan(number) ? std::numeric_limits<double>::quiet_NaN() : number));
  bits.push_back(static_cast<std::uint64_t>(point.regime));
  bits.push_back(static_cast<std::uint64_t>(point.inlet));
  return bits;
}

}  // namespace tribo::verification
