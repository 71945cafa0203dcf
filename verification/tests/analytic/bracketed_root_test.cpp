// SPDX-License-Identifier: Apache-2.0
// The bracketed root by its contract: ends, failures, width and number of evaluations.
#include "tribo/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sampling/sampler.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

TEST(BracketedRoot, AtAnEndIsThatEndWhateverTheSignElsewhere) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(bracketed_root([&](double x) { return sign * (x - 2); }, 2.0, 5.0, 0.0), 2);
    EXPECT_EQ(bracketed_root([&](double x) { return sign * (x - 5); }, 2.0, 5.0, 0.0), 5);
    EXPECT_EQ(bracketed_root([&](double x) { return sign * (x - 5) * (x - 3); }, 2.0, 5.0, 0.0), 5);
  }
}

TEST(BracketedRoot, IsNotANumberWhereTheEndsHaveOneSignOrNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double sign : {1.0, -1.0})
    EXPECT_EQ(std::isnan(bracketed_root([&](double) { return sign; }, 1.0, 2.0, 0.0)), true);
  for (const double end : {1.0, 2.0})
    for (const double other : {-1.0, 1.0})
      EXPECT_EQ(std::isnan(bracketed_root([&](double x) { return x == end ? nan : other; }, 1.0,
                                          2.0, 0.0)),
                true);
}

// The function has one root and is straight, flat or steep there; either end may be the larger one.
// The mean number of evaluations for each kind is compared with a measured one, because a wrong
// interpolation ends at the same root after more of them.
TEST(BracketedRoot, IsWithinItsWidthInAtMost400Evaluations) {
  Sampler sampler(170);
  std::array<int, 3> total{};
  for (int i = 0; i < 3000; ++i) {
    const double root = sampler.uniform(-1, 1) * sampler.log_uniform(1e-12, 1e6);
    const double power = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 7.0 : 0.2;
    const double least_width = i % 2 == 0 ? 0 : sampler.log_uniform(1e-12, 1e-3);
    const double low = root - sampler.log_uniform(1e-9, 1e6),
                 high = root + sampler.log_uniform(1e-9, 1e6);
    int evaluations = 0;
    const auto f = [&](double x) {
      ++evaluations;
      return std::copysign(std::pow(std::fabs(x - root), power), x - root);
    };
    const double found = i % 5 == 0 ? bracketed_root(f, high, low, least_width)
                                    : bracketed_root(f, low, high, least_width);
    const double bound =
        4 * std::numeric_limits<double>::epsilon() * std::fabs(found) + least_width;
    record_part_of_bound(std::fabs(found - root) / bound);
    EXPECT_LE(std::fabs(found - root), bound) << describe(
        {{"root", root}, {"low", low}, {"high", high}, {"power", power}, {"width", least_width}});
    EXPECT_LE(evaluations, 400);
    total[static_cast<std::size_t>(i % 3)] += evaluations;
  }
  EXPECT_TRUE(is_within(total[0] / 1000., 4.66, 0.05));
  EXPECT_TRUE(is_within(total[1] / 1000., 50.8, 0.5));
  EXPECT_TRUE(is_within(total[2] / 1000., 49.2, 0.5));
}

}  // namespace
}  // namespace tribo::verification
