// SPDX-License-Identifier: Apache-2.0
// Random inputs of the checks.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace tribo::verification {

// A seed gives the same numbers with every standard library, unlike uniform_real_distribution.
class Sampler {
 public:
  explicit Sampler(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
    return low + (high - low) * unit;
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  template <class Choice>
  Choice pick(std::initializer_list<Choice> choices) {
    return choices.begin()[engine_() % choices.size()];
  }
  template <class Choices>
  auto pick(const Choices& choices) {
    return choices[engine_() % choices.size()];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tribo::verification
