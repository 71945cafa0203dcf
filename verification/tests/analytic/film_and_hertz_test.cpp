// SPDX-License-Identifier: Apache-2.0
// Hertz' contact and the flooded film: hand checks of the paper's case, values that another library
// computed, exponents, and 50 digits.
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

// Steel on steel, 210 GPa and 0.3 on both: E* = 210/(2·0.91) GPa.
struct Independent {
  double speed, load, pressure_viscosity, radius, viscosity;
  double central_film, contact_radius, peak_pressure, approach;
};
constexpr std::array independent{Independent{1, 20, 2e-8, 0.01, 0.04, 2.612153512768e-7,
                                             1.0913928830611e-4, 801694948.59, 1.191138425196e-6},
                                 Independent{0.1, 10, 2.3e-8, 0.009525, 0.08, 9.79988571843e-8,
                                             8.5230057282759e-5, 657288184.93, 7.626417495457e-7},
                                 Independent{5, 100, 1.5e-8, 0.0127, 0.01, 2.612430892919e-7,
                                             2.0210281339357e-4, 1168951972.05, 3.216184817448e-6}};
constexpr double steel = 210e9 / (2 * 0.91);

TEST(Hertz, AgreesWithAnotherLibrary) {
  for (const Independent& row : independent) {
    const HertzPoint<double> hertz = hertz_point(row.load, steel, row.radius);
    // Half a unit of the last digit that is printed.
    EXPECT_TRUE(is_close(hertz.radius, row.contact_radius, 5e-14, {{"load", row.load}}));
    EXPECT_TRUE(is_close(hertz.peak_pressure, row.peak_pressure, 1e-11, {{"load", row.load}}));
    EXPECT_TRUE(is_close(hertz.approach, row.approach, 1e-12, {{"load", row.load}}));
  }
}

TEST(Hertz, DoubleAgreesWithFiftyDigitsAndStressesBalance) {
  Sampler sampler(3);
  for (int i = 0; i < 500; ++i) {
    const double load = sampler.log_uniform(1e-6, 1e6);
    const double modulus = sampler.log_uniform(1e6, 1e12);
    const double radius = sampler.log_uniform(1e-6, 10);
    const HertzPoint<double> got = hertz_point(load, modulus, radius);
    const HertzPoint<Reference> exact =
        hertz_point(Reference(load), Reference(modulus), Reference(radius));
    const auto close = [&](double value, const Reference& expected) {
      EXPECT_TRUE(is_close(value, expected, 10 * 0x1p-52,
                           {{"load", load}, {"modulus", modulus}, {"radius", radius}}));
    };
    close(got.radius, exact.radius);
    close(got.nominal_area, exact.nominal_area);
    close(got.peak_pressure, exact.peak_pressure);
    close(got.approach, exact.approach);
    close(got.mean_pressure * got.nominal_area, Reference(load));
    // a³ = 3FR/(4E*), and p_max = 2aE*/(πR) by the other textbook form
    close(2 * got.radius * modulus / (pi<double>() * radius), exact.peak_pressure);
  }
}

TEST(HamrockDowson, ConstantOfTheCircularContactIs18992) {
  EXPECT_TRUE(is_within(hamrock_dowson_constant(1.0), 1.8992, 0.00005));
  const double ratio_to_other_library = 1.9 / hamrock_dowson_constant(1.0);
  EXPECT_TRUE(is_within(ratio_to_other_library, 1.00040251, 0.000000005));
}

TEST(HamrockDowson, AgreesWithAnotherLibraryUpToItsRoundedConstant) {
  const Reference constants = hamrock_dowson_constant(Reference(1)) / Reference("1.9");
  for (const Independent& row : independent)
    EXPECT_TRUE(is_close(hamrock_dowson_central(row.speed, row.viscosity, row.pressure_viscosity,
                                                row.load, steel, row.radius, 1.0),
                         row.central_film * constants, 1e-12, {{"speed", row.speed}}));
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

TEST(HamrockDowson, DoubleAgreesWithFiftyDigits) {
  Sampler sampler(4);
  for (int i = 0; i < 500; ++i) {
    const double speed = sampler.log_uniform(1e-6, 100), viscosity = sampler.log_uniform(1e-4, 10);
    const double alpha = sampler.log_uniform(1e-9, 1e-7), load = sampler.log_uniform(1e-3, 1e5);
    const double modulus = sampler.log_uniform(1e8, 1e12), radius = sampler.log_uniform(1e-4, 1);
    const double k = sampler.uniform(0.3, 10);
    EXPECT_TRUE(
        is_close(hamrock_dowson_central(speed, viscosity, alpha, load, modulus, radius, k),
                 hamrock_dowson_central(Reference(speed), Reference(viscosity), Reference(alpha),
                                        Reference(load), Reference(modulus), Reference(radius),
                                        Reference(k)),
                 20 * 0x1p-52,
                 {{"speed", speed}, {"load", load}, {"modulus", modulus}, {"radius", radius}}));
  }
}

// The powers of the dimensional inputs that follow from U^0.67 G^0.53 W^−0.067 with 2E* in each:
// E* to −0.67 + 0.53 + 0.067, R to 1 − 0.67 + 0.134.
TEST(HamrockDowson, ExponentOfEachInputIsTheDerivedOne) {
  const std::array<Reference, 6> base{Reference("0.3"), Reference("0.02"), Reference("2e-8"),
                                      Reference("50"),  Reference("1e11"), Reference("0.01")};
  const std::array exponents{"0.67", "0.67", "0.53", "-0.067", "-0.073", "0.464"};
  const auto film = [](const std::array<Reference, 6>& x) {
    return hamrock_dowson_central(x[0], x[1], x[2], x[3], x[4], x[5], Reference(1));
  };
  for (std::size_t i = 0; i < base.size(); ++i) {
    std::array<Reference, 6> doubled = base;
    doubled[i] *= 2;
    const Reference exponent = log(Reference(film(doubled) / film(base))) / log(Reference(2));
    EXPECT_LT(abs(exponent - Reference(exponents[i])), Reference("1e-45")) << "input " << i;
  }
}

}  // namespace
}  // namespace tribo::verification
