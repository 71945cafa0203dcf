// SPDX-License-Identifier: Apache-2.0
// Seeded points without the C library, so that all machines have the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace tribo::gates {

class Samples {
 public:
  explicit Samples(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * unit(); }
  // In [2^low, 2^high): a binade as likely as another.
  double binades(int low, int high) {
    const int exponent = low + static_cast<int>(generator_() % static_cast<unsigned>(high - low));
    return std::ldexp(1 + unit(), exponent);
  }

 private:
  double unit() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  std::mt19937_64 generator_;
};

template <class Function>
std::vector<double> filled(std::size_t count, Function&& next) {
  std::vector<double> values(count);
  for (double& value : values) value = next();
  return values;
}

}  // namespace tribo::gates
