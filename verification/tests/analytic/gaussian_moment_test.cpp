// SPDX-License-Identifier: Apache-2.0
// The shape of F_n, its limits, and the relations between the orders. contract/contract_test.cpp
// checks its values against confluent hypergeometric functions.
#include "tribo/gaussian_moment.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "support/orders.hpp"

namespace tribo::verification {
namespace {

constexpr double contract = gaussian_moment_contract.ulp * 0x1p-52;

class OfEachOrder : public testing::TestWithParam<Order> {};

TEST_P(OfEachOrder, FallsWithItsArgumentAndIsConvexAndLogConcave) {
  // The steps are so wide that second differences are far above rounding.
  const double h = 0.05;
  for (double d = -39; d < 36; d += h) {
    const double left = gaussian_moment(GetParam(), d - h);
    const double here = gaussian_moment(GetParam(), d);
    const double right = gaussian_moment(GetParam(), d + h);
    const double rounding = 3 * contract * left;
    if (GetParam() != Order::zero || d > -8) {  // below, F_0 is 1 to rounding
      EXPECT_GT(left, here) << describe({{"d", d}});
    }
    if (GetParam() >= Order::one) {  // F_n″ = n(n−1)F_{n−2} > 0; F_0 and F_{1/2} are not convex
      EXPECT_GT(left + right + rounding, 2 * here) << describe({{"d", d}});
    }
    EXPECT_LT(log_gaussian_moment(GetParam(), d - h) + log_gaussian_moment(GetParam(), d + h),
              2 * log_gaussian_moment(GetParam(), d) + 4 * contract * (1 + d * d))
        << describe({{"d", d}});
  }
}

TEST_P(OfEachOrder, LogarithmIsThatOfFiftyDigitsAndDoesNotUnderflow) {
  for (double d = -40; d < 2000; d = d < 30 ? d + 0.61 : d * 1.3) {
    const Reference expected = log(scaled_gaussian_moment(GetParam(), Reference(d))) -
                               (d > 0 ? Reference(d) * d / 2 : Reference(0));
    // The bound is absolute where the logarithm is near 0.
    EXPECT_LE(static_cast<double>(abs(log_gaussian_moment(GetParam(), d) - expected)),
              contract + 4 * 0x1p-53 * static_cast<double>(abs(expected)))
        << describe({{"d", d}});
  }
}

TEST_P(OfEachOrder, EndsOfTheLineAreExact) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(gaussian_moment(GetParam(), infinity), 0);
  EXPECT_EQ(gaussian_moment(GetParam(), 1e300), 0);
  EXPECT_EQ(gaussian_moment(GetParam(), -infinity), GetParam() == Order::zero ? 1 : infinity);
  EXPECT_EQ(log_gaussian_moment(GetParam(), infinity), -infinity);
  EXPECT_EQ(gaussian_moment(GetParam(), 0.0), gaussian_moment(GetParam(), -0.0));
  EXPECT_TRUE(std::isnan(gaussian_moment(GetParam(), std::nan(""))));
  EXPECT_TRUE(std::isnan(log_gaussian_moment(GetParam(), std::nan(""))));
}

TEST_P(OfEachOrder, ProductUndoesUnderflow) {
  for (const double d : {36.0, 37.5, 38.5, 39.0, 45.0, 50.0}) {
    const Reference expected = Reference(1e300) * gaussian_moment(GetParam(), Reference(d));
    if (expected < Reference(1e-300)) continue;
    EXPECT_TRUE(is_close(moment_product(1e300, GetParam(), d), expected, 8 * 0x1p-52,
                         {{"d", d}}));  // two exponentials, three products
  }
}

INSTANTIATE_TEST_SUITE_P(GaussianMoment, OfEachOrder, testing::ValuesIn(orders), order_name);

TEST(GaussianMoment, OrdersObeyTheRecurrence) {
  Sampler sampler(11);
  for (int i = 0; i < 2000; ++i) {
    const double d = sampler.uniform(-30, 30);
    for (const Order n : {Order::one, Order::three_halves}) {
      const double above = gaussian_moment(static_cast<Order>(twice(n) + 2), d);
      const double middle = d * gaussian_moment(n, d);
      const double below = value_of<double>(n) * gaussian_moment(lower(n), d);
      // F_{n+1} + dF_n = nF_{n−1}: backward error of each term
      const double scale = above + std::abs(middle) + below;
      // The bound is doubled for the rounding of d F_n and of the sum.
      EXPECT_LE(std::abs(above + middle - below), 2 * contract * scale) << describe({{"d", d}});
    }
  }
}

TEST(GaussianMoment, SlopeIsMinusNTimesTheLowerOrder) {
  const Reference h("1e-16");
  for (double d = -20; d < 30; d += 0.7)
    for (const Order n : {Order::one, Order::three_halves, Order::two, Order::five_halves}) {
      const Reference slope =
          (gaussian_moment(n, Reference(d + h)) - gaussian_moment(n, Reference(d - h))) / (2 * h);
      const Reference expected = -value_of<Reference>(n) * gaussian_moment(lower(n), Reference(d));
      EXPECT_LT(abs((slope - expected) / expected), Reference("1e-28")) << describe({{"d", d}});
    }
}

TEST(GaussianMoment, IsLogConvexInTheOrder) {
  for (double d = -35; d < 36; d += 0.25)
    for (int k = 1; k < 5; ++k) {
      const double below = log_gaussian_moment(static_cast<Order>(k - 1), d);
      const double here = log_gaussian_moment(static_cast<Order>(k), d);
      const double above = log_gaussian_moment(static_cast<Order>(k + 1), d);
      EXPECT_LE(2 * here, below + above + 1e-12 * (1 + d * d)) << describe({{"d", d}});
    }
}

}  // namespace
}  // namespace tribo::verification
