// SPDX-License-Identifier: Apache-2.0
// Hertz' contact and the flooded film: hand checks of the paper's case, and closed forms.
#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"

namespace tribo::verification {
namespace {

TEST(Hertz, TableOneGivesTheHandChecks) {
  const HertzPoint<double> hertz = hertz_point(50.0, 107.9e9, 9.5e-3);
  EXPECT_TRUE(is_within(hertz.radius, 148.9e-6, 0.05e-6));
  EXPECT_TRUE(is_within(hertz.peak_pressure, 1.077e9, 0.0005e9));
}

// p A = F, and p_max by the other textbook form.
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
