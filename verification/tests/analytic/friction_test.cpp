// SPDX-License-Identifier: Apache-2.0
// Shear laws and viscosity laws: 50 digits, limits, and continuity where a branch begins.
#include "tribo/friction.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using enum FluidShear;
using enum ViscosityLaw;

TEST(Friction, ViscosityLawsAgreeWithFiftyDigits) {
  Sampler sampler(51);
  for (const auto law : {barus, ambient, roelands})
    for (int i = 0; i < 300; ++i) {
      const double viscosity = sampler.log_uniform(1e-4, 10);
      const double alpha = sampler.log_uniform(1e-9, 5e-8);
      const double pressure = sampler.log_uniform(1, 4e9);
      EXPECT_TRUE(is_close(
          log_viscosity_ratio(law, viscosity, alpha, pressure),
          log_viscosity_ratio(law, Reference(viscosity), Reference(alpha), Reference(pressure)),
          1e-13, {{"viscosity", viscosity}, {"alpha", alpha}, {"pressure", pressure}}));
    }
}

// All laws meet at ambient pressure; Barus and Roelands share the slope α there.
TEST(Friction, ViscosityLawsShareValueAndSlopeAtAmbientPressure) {
  for (const double alpha : {1e-8, 2e-8}) {
    EXPECT_EQ(log_viscosity_ratio(ambient, 0.02, alpha, 1e9), 0);
    for (const auto law : {barus, roelands}) {
      EXPECT_EQ(log_viscosity_ratio(law, 0.02, alpha, 0.0), 0);
      const Reference p("1e-20");
      const Reference slope = log_viscosity_ratio(law, Reference("0.02"), Reference(alpha), p) / p;
      EXPECT_LT(abs(slope / Reference(alpha) - 1), Reference("1e-25"));
    }
  }
}

TEST(Friction, ShearStressesAgreeWithFiftyDigits) {
  Sampler sampler(52);
  for (const auto law : {eyring, limiting})
    for (int i = 0; i < 500; ++i) {
      const double stress = sampler.log_uniform(1e5, 1e8),
                   viscosity = sampler.log_uniform(1e-4, 10);
      const double thickening = sampler.uniform(0, 60), speed = sampler.log_uniform(1e-6, 100);
      const double separation = sampler.log_uniform(1e-10, 1e-5);
      // e^thickening and ln x carry its rounding
      EXPECT_TRUE(is_close(
          fluid_shear_stress(law, stress, viscosity, thickening, speed, separation),
          fluid_shear_stress(law, Reference(stress), Reference(viscosity), Reference(thickening),
                             Reference(speed), Reference(separation)),
          20 * 0x1p-52, {{"stress", stress}, {"thickening", thickening}, {"speed", speed}},
          1 + thickening));
    }
}

TEST(Friction, SmallShearIsNewtonianAndLargeShearIsWhatTheLawSays) {
  // x = 1e-9: both laws give ηγ̇
  EXPECT_TRUE(is_within(fluid_shear_stress(eyring, 1e6, 1e-3, 0.0, 1.0, 1.0) / 1e-3, 1, 1e-15));
  EXPECT_TRUE(is_within(fluid_shear_stress(limiting, 1e6, 1e-3, 0.0, 1.0, 1.0) / 1e-3, 1, 1e-9));
  EXPECT_EQ(fluid_shear_stress(limiting, 1e6, 1.0, 800.0, 1.0, 1.0), 1e6);
  // past the overflow of x: τ₀(ln 2 + ln x)
  EXPECT_TRUE(is_close(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 1.0, 1.0),
                       2 * (log(Reference(2)) + 1000 - log(Reference(2))), 1e-15, {}));
  EXPECT_EQ(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 0.0, 1.0), 0);
  EXPECT_EQ(fluid_shear_stress(eyring, 2.0, 1.0, 1000.0, 0.0, 1e-320), 0);
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
