// SPDX-License-Identifier: Apache-2.0
// Nodes for the tests, and the condition on errors on three grids.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/judge.hpp"

namespace tribo::verification {

// Nodes from first to last. The random lengths of the cells vary slowly, at most by a factor of 3.
inline std::vector<double> uneven_nodes(int count, double first, double last, Sampler& sampler) {
  const double a = sampler.uniform(0, 6), b = sampler.uniform(1, 5);
  std::vector<double> x{0};
  for (int i = 1; i < count; ++i) {
    const double at = static_cast<double>(i) / count;
    x.push_back(x.back() + 2 + std::sin(a + 6 * b * at) + sampler.uniform(0, 0.05));
  }
  const double length = x.back();
  for (double& at : x) at = first + (last - first) * at / length;
  x.back() = last;
  return x;
}

// Errors on three grids, whose cells halve in length: two observed orders, both near 2.
inline testing::AssertionResult is_second_order(const std::array<double, 3>& errors) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double order = std::log2(errors[i] / errors[i + 1]);
    record_part_of_bound(std::abs(order - 2) / 0.2);
    if (order > 1.8 && order < 2.2) continue;
    return testing::AssertionFailure()
           << "the observed order is " << order << ", expected 1.8 to 2.2; errors " << errors[0]
           << ", " << errors[1] << ", " << errors[2];
  }
  return testing::AssertionSuccess();
}

}  // namespace tribo::verification
