// SPDX-License-Identifier: Apache-2.0
// The shear laws at the ends of their range, and without a step where the formula changes.
#include "tribo/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using enum FluidShear;

TEST(Friction, SmallShearIsNewtonianAndLargeShearIsWhatTheLawSays) {
  // With x = 1e-9 both laws give ηγ̇.
  EXPECT_TRUE(is_within(fluid_shear_stress(eyring, 1e6, 1e-3, 0.0, 1.0, 1.0) / 1e-3, 1, 1e-15));
  EXPECT_TRUE(is_within(fluid_shear_stress(limiting, 1e6, 1e-3, 0.0, 1.0, 1.0) / 1e-3, 1, 1e-9));
  EXPECT_EQ(fluid_shear_stress(limiting, 1e6, 1.0, 800.0, 1.0, 1.0), 1e6);
  // Where x overflows, the stress is τ₀(ln 2 + ln x).
  EXPECT_TRUE(is_close(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 1.0, 1.0),
                       2 * (log(Reference(2)) + 1000 - log(Reference(2))), 1e-15, {}));
  EXPECT_EQ(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 0.0, 1.0), 0);
  EXPECT_EQ(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 0.0, 1e-320), 0);
  for (const auto law : {eyring, limiting}) {  // the speed is 0 or the least positive number
    EXPECT_EQ(fluid_shear_stress(law, 1.0, 1.0, 0.0, 0.0, 1.0), 0);
    EXPECT_EQ(fluid_shear_stress(law, 1.0, 1.0, 0.0, 0x1p-1074, 1.0), 0x1p-1074);
  }
}

// x = ηγ̇/τ₀ is 1 or 0x1p-30. Quotients of its factors underflow, overflow, or do neither.
TEST(Friction, StressOverItsScaleIsThatOfXWhateverItsFactors) {
  constexpr int powers[][5] = {// exponents of 2 for τ₀, η₀, S·u, separation, η/η₀
                               {600, -500, 900, -100, 100},  {600, -500, 900, -200, 0},
                               {-600, 500, -900, 100, -100}, {-600, 500, -900, 200, 0},
                               {300, -300, 500, -100, 0},    {20, 10, 20, 10, 0}};
  for (const auto law : {eyring, limiting})
    for (const double x : {1.0, 0x1p-30})
      for (const auto& [scale, viscosity, speed, separation, ratio] : powers) {
        const double stress = fluid_shear_stress(law, std::ldexp(1, scale),
                                                 std::ldexp(x, viscosity), ratio * std::log(2),
                                                 std::ldexp(1, speed), std::ldexp(1, separation));
        EXPECT_TRUE(is_close(std::ldexp(stress, -scale),
                             fluid_shear_stress(law, 1.0, x, 0.0, 1.0, 1.0), 1e-12,
                             {{"power of the scale", 1.0 * scale}, {"x", x}}));
      }
}

TEST(Friction, EyringStressHasNoStepWhereTheLogarithmTakesOver) {
  const double branch = 1 / epsilon<double>();
  double previous = 0;
  for (double x = branch / 4; x < branch * 4; x *= 1.01) {
    const double stress = fluid_shear_stress(eyring, 1.0, x, 0.0, 1.0, 1.0);
    EXPECT_GT(stress, previous) << describe({{"x", x}});
    EXPECT_TRUE(is_close(stress, asinh(Reference(x)), 4 * 0x1p-52, {{"x", x}}));
    previous = stress;
  }
}

}  // namespace
}  // namespace tribo::verification
