// SPDX-License-Identifier: Apache-2.0
// The viscosity index against the standard's worked examples and its table 1, and solved backwards.
#include "tribo/viscosity_index.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

double index_of(double at_40, double at_100) { return viscosity_index(at_40 / 1e6, at_100 / 1e6); }
double at_100(double at_40, double index) {
  return 1e6 * viscosity_at_100_celsius(at_40 / 1e6, index);
}

// ASTM D2270-10, 5.2.3.1, 5.2.4.1, 5.2.4.2 and X2.5.
TEST(ViscosityIndex, IsThatOfTheStandardsExamples) {
  EXPECT_EQ(std::round(index_of(73.30, 8.86)), 92);
  EXPECT_EQ(std::round(index_of(22.83, 5.05)), 156);
  EXPECT_EQ(std::round(index_of(53.47, 7.80)), 111);
  EXPECT_EQ(std::round(index_of(73.50, 8.86)), 92);
  const auto oils = detail::index_oils(8.86e-6);
  EXPECT_TRUE(is_within(oils.zero, 119.9588, 5e-5));
  EXPECT_TRUE(is_within(oils.hundred, 69.4765, 5e-5));
}

// Y, L and H of the standard's table 1, some in each range of the quadratic equations.
TEST(ViscosityIndex, OilsAreThoseOfTheStandardsTable) {
  struct Row {
    double y, zero, hundred;
  };
  constexpr Row table[] = {
      {2, 7.994, 6.394},   {2.5, 11.45, 9.063},  {3, 15.49, 12.15},   {3.8, 23.13, 17.97},
      {4, 25.32, 19.56},   {4.3, 29.07, 22.05},  {4.5, 31.96, 23.81}, {4.8, 36.79, 26.57},
      {5, 40.23, 28.49},   {5.5, 49.09, 33.34},  {6, 57.97, 38.19},   {6.4, 65.18, 42.14},
      {6.7, 71.29, 45.33}, {7, 78, 48.57},       {7.3, 84.53, 51.78}, {7.7, 93.2, 56.2},
      {8, 100, 59.6},      {8.5, 111.5, 65.32},  {9, 123.3, 71.1},    {10, 147.7, 82.87},
      {11, 173.9, 95.19},  {12, 201.9, 108},     {13, 231.9, 121.5},  {14, 263.3, 135.4},
      {15, 296.5, 149.7},  {16.5, 350.3, 172.3}, {18, 408.6, 196.2},  {20, 493.2, 229.5},
      {22, 585.2, 264.9},  {25, 736.5, 320.9},   {28, 904.1, 380.6},  {33, 1217, 487},
      {40, 1730, 651.8},   {47, 2333, 835.5},    {55, 3126, 1066},    {62, 3908, 1286},
      {69, 4773, 1523},    {70, 4905, 1558}};
  for (const Row& row : table) {
    const auto oils = detail::index_oils(row.y / 1e6);
    EXPECT_TRUE(is_within(oils.zero / row.zero, 1, 1.5e-3)) << row.y;
    EXPECT_TRUE(is_within(oils.hundred / row.hundred, 1, 1.5e-3)) << row.y;
  }
}

TEST(ViscosityIndex, IsSolvedBackwards) {
  Sampler sampler(73);
  for (int i = 0; i < 2000; ++i) {
    const double y = sampler.log_uniform(2.1, 300), index = sampler.uniform(0, 300);
    const auto oils = detail::index_oils(y / 1e6);
    const double u = index <= 100
                         ? oils.zero - index / 100 * (oils.zero - oils.hundred)
                         : oils.hundred / std::pow(y, std::log10(1 + 0.00715 * (index - 100)));
    if (!(u > y)) continue;
    EXPECT_TRUE(is_within(index_of(u, y), index, 1e-9)) << y;
    // Next to an end of a range two viscosities may have the same index.
    EXPECT_TRUE(is_within(at_100(u, index) / y, 1, 2e-3)) << y << ' ' << index;
    EXPECT_TRUE(is_within(index_of(u, at_100(u, index)), index, 1.5)) << y << ' ' << index;
  }
}

TEST(ViscosityIndex, GivesKnownOils) {
  EXPECT_TRUE(is_within(at_100(46, 100), 6.8, 0.05));  // an ordinary mineral oil ISO VG 46
  EXPECT_TRUE(is_within(at_100(32, 100), 5.4, 0.05));  // and 32
  EXPECT_TRUE(is_within(at_100(220, 95), 18.7, 0.1));  // a gear oil
}

TEST(ViscosityIndex, IsNothingWhereItIsNotDefined) {
  EXPECT_EQ(std::isnan(index_of(5, 1.9)), true);
  EXPECT_EQ(std::isnan(index_of(5, 6)), true);
  EXPECT_EQ(std::isnan(at_100(3, 100)), true);
  EXPECT_EQ(std::isnan(at_100(1e7, 0)), true);
  EXPECT_EQ(std::isnan(at_100(7, 100)), false);
}

}  // namespace
}  // namespace tribo::verification
