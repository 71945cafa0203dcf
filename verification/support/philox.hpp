// SPDX-License-Identifier: Apache-2.0
// Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3, SC11):
// ten rounds of multiplication and exchange turn a counter into four random words. No state: sample
// i is the same whatever was drawn before it.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tribo::verification {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

constexpr PhiloxCounter philox4x32(PhiloxCounter counter, PhiloxKey key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

// Two independent standard normal heights and a uniform number in (0, 1), for sample i of a stream.
struct RandomSample {
  double first, second, uniform;
};
inline RandomSample random_sample(std::uint32_t stream, std::uint64_t i) {
  const PhiloxCounter word = philox4x32(
      {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 0, 0}, {stream, 0});
  const auto unit = [](std::uint32_t bits) { return (bits + 0.5) * 0x1p-32; };
  const double radius = std::sqrt(-2 * std::log(unit(word[0])));  // Box and Muller
  const double angle = 2 * std::numbers::pi * unit(word[1]);
  return {radius * std::cos(angle), radius * std::sin(angle), unit(word[2])};
}

}  // namespace tribo::verification
