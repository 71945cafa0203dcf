// SPDX-License-Identifier: Apache-2.0
// Seeded inputs, the same on every platform: they come from splitmix64 and are rounded to 30 bits,
// so that a math library whose results differ in the last bit changes nothing.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace tribo::reference {

class Sampler {
 public:
  explicit Sampler(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high) { return shorten(low + (high - low) * unit()); }
  double log_uniform(double low, double high) {
    return shorten(std::exp(std::log(low) + (std::log(high) - std::log(low)) * unit()));
  }
  template <class T>
  T pick(std::initializer_list<T> choices) {
    return choices.begin()[next() % choices.size()];
  }

 private:
  static double shorten(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 30)), exponent - 30);
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace tribo::reference
