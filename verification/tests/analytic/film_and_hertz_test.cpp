// SPDX-License-Identifier: Apache-2.0
// Two bodies as one, Hertz' contact and the flooded film: hand checks, and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "support/judge.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(EffectiveModulus, OfSteelOnSteelIsHalfOfThePlaneStrainModulus) {
  const double steel = 206e9 / (1 - 0.3 * 0.3);
  EXPECT_TRUE(is_within(effective_modulus(206e9, 0.3, 206e9, 0.3), steel / 2, 1e-4));
  EXPECT_TRUE(is_within(effective_modulus(206e9, 0.3, infinity, 0.5), steel, 1e-4));
  EXPECT_EQ(effective_modulus(infinity, 0.3, infinity, 0.3), infinity);
}

TEST(EffectiveModulus, IsTheSameWithTheBodiesExchangedAndScalesWithTheModuli) {
  Sampler sampler(4);
  for (int i = 0; i < 500; ++i) {
    const double e1 = sampler.log_uniform(1e5, 1e12), e2 = sampler.log_uniform(1e5, 1e12);
    const double nu1 = sampler.uniform(-1, 0.5), nu2 = sampler.uniform(-1, 0.5);
    const double both = effective_modulus(e1, nu1, e2, nu2);
    EXPECT_EQ(effective_modulus(e2, nu2, e1, nu1), both);
    EXPECT_EQ(effective_modulus(4 * e1, nu1, 4 * e2, nu2), 4 * both);
    EXPECT_LT(both, e1 / (1 - nu1 * nu1));
  }
}

// A ball of 10 mm in a groove of 5.5 mm, 45 mm from the bearing's axis.
TEST(ReducedRadius, OfABallInABearingIsTheHandCheck) {
  const ReducedRadius<double> got = reduced_radius(5e-3, -45e-3, 5e-3, -5.5e-3);
  EXPECT_TRUE(is_within(got.radius_x, 5.625e-3, 1e-15));
  EXPECT_TRUE(is_within(got.radius_y, 55e-3, 1e-15));
  EXPECT_TRUE(is_within(got.reduced_radius, 0.495 / 97, 1e-15));
}

TEST(ReducedRadius, OfABallOnAFlatIsHalfOfTheBalls) {
  const double largest = std::numeric_limits<double>::max();
  for (const double flat : {infinity, -infinity, 1e30, largest}) {
    const ReducedRadius<double> got = reduced_radius(9.5e-3, flat, flat, 9.5e-3);
    EXPECT_EQ(got.radius_x, 9.5e-3);
    EXPECT_EQ(got.radius_y, 9.5e-3);
    EXPECT_EQ(got.reduced_radius, 9.5e-3 / 2);
  }
  EXPECT_EQ(reduced_radius(largest, largest, 1.0, 1.0).radius_x, largest / 2);
}

TEST(ReducedRadius, OfFacesThatDoNotMeetAtAPointIsNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<double, double> apart[] = {
      {5e-3, -4e-3},        {5e-3, -5e-3}, {-1, -2}, {-1, 1e30},
      {infinity, infinity}, {0, 1},        {nan, 1}, {1, nan}};
  for (const auto& [first, second] : apart) {
    for (const ReducedRadius<double>& got :
         {reduced_radius(first, second, 1.0, 2.0), reduced_radius(second, first, 1.0, 2.0),
          reduced_radius(1.0, 2.0, first, second)}) {
      EXPECT_EQ(std::isnan(got.radius_x), true) << first << ' ' << second;
      EXPECT_EQ(std::isnan(got.radius_y), true) << first << ' ' << second;
      EXPECT_EQ(std::isnan(got.reduced_radius), true) << first << ' ' << second;
    }
  }
}

TEST(Hertz, TableOneGivesTheHandChecks) {
  const HertzPoint<double> hertz = hertz_point(50.0, 107.9e9, 9.5e-3);
  EXPECT_TRUE(is_within(hertz.radius, 148.9e-6, 0.05e-6));
  EXPECT_TRUE(is_within(hertz.peak_pressure, 1.077e9, 0.0005e9));
}

// The mean pressure times the area is the load; the peak is 2E*a/(πR), as other textbooks have it.
TEST(Hertz, StressesBalance) {
  Sampler sampler(3);
  for (int i = 0; i < 500; ++i) {
    const double load = sampler.log_uniform(1e-6, 1e6), modulus = sampler.log_uniform(1e6, 1e12);
    const double radius = sampler.log_uniform(1e-6, 10);
    const HertzPoint<double> got = hertz_point(load, modulus, radius);
    const double peak = 2 * got.radius * modulus / (pi<double>() * radius);
    const std::initializer_list<Input> inputs{{"load", load}, {"modulus", modulus}, {"R", radius}};
    EXPECT_TRUE(is_close(got.mean_pressure * got.nominal_area, load, 10 * 0x1p-52, inputs));
    EXPECT_TRUE(is_close(got.peak_pressure, peak, 20 * 0x1p-52, inputs));
  }
}

TEST(HamrockDowson, ConstantOfTheCircularContactIs18992) {
  EXPECT_TRUE(is_within(hamrock_dowson_constant(1.0), 1.8992, 0.00005));
  const double ratio_to_other_library = 1.9 / hamrock_dowson_constant(1.0);
  EXPECT_TRUE(is_within(ratio_to_other_library, 1.00040251, 0.000000005));
}

TEST(HamrockDowson, TableOneGivesTheHandChecks) {
  const auto film = [](double speed) {
    return hamrock_dowson_central(speed, 0.0202, 2e-8, 50.0, 107.9e9, 9.5e-3, 1.0) * 1e9;
  };
  EXPECT_TRUE(is_within(film(1e-4), 0.319, 0.0005));
  EXPECT_TRUE(is_within(film(0.01), 6.97, 0.005));
  EXPECT_TRUE(is_within(film(0.1), 32.6, 0.05));
  EXPECT_TRUE(is_within(film(1), 152, 0.5));
  EXPECT_TRUE(is_within(film(3), 318, 0.5));
}

}  // namespace
}  // namespace tribo::verification
