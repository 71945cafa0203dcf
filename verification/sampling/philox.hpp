// SPDX-License-Identifier: Apache-2.0
// Random samples of the checks by Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random
// numbers: as easy as 1, 2, 3, SC11; Random123), which turns a counter into four random words. No
// state: sample i is the same whatever was drawn before it.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tribo::verification {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

inline PhiloxCounter philox_words(PhiloxCounter counter, PhiloxKey key) {
  const auto words =
      r123::Philox4x32()({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
  return {words[0], words[1], words[2], words[3]};
}

// Two independent standard normal heights and a uniform number in (0, 1), for sample i of a stream.
struct RandomSample {
  double first, second, uniform;
};
inline RandomSample random_sample(std::uint32_t stream, std::uint64_t i) {
  const PhiloxCounter word = philox_words(
      {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 0, 0}, {stream, 0});
  const auto unit = [](std::uint32_t bits) { return (bits + 0.5) * 0x1p-32; };
  const double radius = std::sqrt(-2 * std::log(unit(word[0])));  // Box and Muller
  const double angle = 2 * std::numbers::pi * unit(word[1]);
  return {radius * std::cos(angle), radius * std::sin(angle), unit(word[2])};
}

}  // namespace tribo::verification
