// SPDX-License-Identifier: Apache-2.0
// Liquids under pressure and temperature, and summits from spectral moments: hand checks, limits
// and identities.
#include "tribo/liquids.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/judge.hpp"
#include "tribo/spectral_moments.hpp"

namespace tribo::verification {
namespace {

TEST(Density, GoesFromOneTo134) {
  EXPECT_EQ(dowson_higginson_density(0.0), 1);
  EXPECT_TRUE(is_within(dowson_higginson_density(5.9e8), 1.17, 1e-15));
  EXPECT_TRUE(is_within(dowson_higginson_density(1e300), 1.34, 1e-15));
  // The law's other form, with rounded numbers, gives more: by 0.6/1.7 − 0.34 at high pressure.
  for (double p = 1e6; p < 1e12; p *= 1.5) {
    const double more = 1 + 0.6e-9 * p / (1 + 1.7e-9 * p) - dowson_higginson_density(p);
    EXPECT_GT(more, 0);
    EXPECT_LT(more, 0.6 / 1.7 - 0.34);
  }
}

TEST(Viscosity, OfBarusAndRoelandsIsTheSameToFirstOrderInPressure) {
  Sampler sampler(21);
  for (int i = 0; i < 200; ++i) {
    const Reference viscosity = sampler.log_uniform(1e-3, 10),
                    alpha = sampler.log_uniform(1e-9, 5e-8);
    const Reference pressure("1e-20");
    EXPECT_EQ(log_viscosity_ratio(ViscosityLaw::ambient, viscosity, alpha, Reference(1e9)), 0);
    for (const ViscosityLaw law : {ViscosityLaw::barus, ViscosityLaw::roelands}) {
      const Reference slope = log_viscosity_ratio(law, viscosity, alpha, pressure) / pressure;
      EXPECT_LT(abs(slope / alpha - 1), Reference("1e-25"));
      EXPECT_EQ(viscosity_at(law, viscosity, alpha, Reference(0)), viscosity);
    }
    // Where z < 1 Roelands' law thickens less.
    EXPECT_LT(viscosity_at(ViscosityLaw::roelands, 0.02, 2e-8, 1e9),
              viscosity_at(ViscosityLaw::barus, 0.02, 2e-8, 1e9));
  }
}

TEST(Viscosity, OfRoelandsIsThePowerOfThePoleAndEndsThere) {
  // z = 1: η = η₀ (η₀/6.315e-5)^{p/p_R}
  const double viscosity = 0.05, pole = std::exp(-9.67);
  const double alpha = std::log(viscosity / pole) / 0.196e9;
  EXPECT_TRUE(is_within(viscosity_at(ViscosityLaw::roelands, viscosity, alpha, 0.392e9),
                        viscosity * std::pow(viscosity / pole, 2), 1e-7));
  EXPECT_EQ(std::isnan(viscosity_at(ViscosityLaw::roelands, 6.3e-5, 2e-8, 1e8)), true);
  EXPECT_EQ(std::isnan(viscosity_at(ViscosityLaw::barus, 6.3e-5, 2e-8, 1e8)), false);
}

TEST(AstmD341, GoesThroughBothPointsInAnyOrder) {
  Sampler sampler(22);
  for (int i = 0; i < 300; ++i) {
    const Reference t1 = sampler.uniform(250, 330), t2 = sampler.uniform(340, 450);
    const Reference thin = sampler.log_uniform(4e-7, 1e-4), thick = thin * sampler.uniform(1.1, 20);
    const Reference t = sampler.uniform(230, 480);
    const auto is_same = [](const Reference& a, const Reference& b) {
      return abs(a / b - 1) < Reference("1e-40");
    };
    EXPECT_EQ(is_same(astm_d341_viscosity(t1, thick, t2, thin, t1), thick), true);
    EXPECT_EQ(is_same(astm_d341_viscosity(t1, thick, t2, thin, t2), thin), true);
    const Reference between = astm_d341_viscosity(t1, thick, t2, thin, t);
    EXPECT_EQ(is_same(astm_d341_viscosity(t2, thin, t1, thick, t), between), true);
    // A third point on the line gives the same line.
    EXPECT_EQ(t == t1 || is_same(astm_d341_viscosity(t1, thick, t, between, t2), thin), true);
  }
}

// ISO VG 32 of a viscosity index of about 100: 32 mm²/s at 40 °C, 5.4 at 100 °C.
TEST(AstmD341, OfAnIndustrialOilIsTheHandCheck) {
  const auto w = [](double viscosity) { return std::log10(std::log10(viscosity + 0.7)); };
  const double b = (w(32) - w(5.4)) / (std::log10(373.15) - std::log10(313.15));
  const double a = w(32) + b * std::log10(313.15);
  const double expected = std::pow(10, std::pow(10, a - b * std::log10(353.15))) - 0.7;
  EXPECT_TRUE(is_within(astm_d341_viscosity(313.15, 32e-6, 373.15, 5.4e-6, 353.15), expected * 1e-6,
                        1e-17));
  EXPECT_TRUE(is_within(expected, 8.533, 0.0005));
}

TEST(AstmD341, HasNoLineWhereTheLogarithmHasNone) {
  for (const double thin : {3e-7, 1e-7})
    EXPECT_EQ(std::isnan(astm_d341_viscosity(313.0, 32e-6, 373.0, thin, 353.0)), true);
  EXPECT_EQ(std::isnan(astm_d341_viscosity(313.0, 32e-6, 313.0, 5e-6, 353.0)), true);
}

// 4/√π · (3/8)√π/(6π√3) = 1/(4π√3): the moments cancel.
TEST(SpectralMoments, OffsetTimesRoughnessIsOneNumberForAllFaces) {
  Sampler sampler(23);
  const Reference expected = 1 / (4 * pi<Reference>() * sqrt(Reference(3)));
  EXPECT_TRUE(is_within(offset_times_roughness, 0.04594, 5e-6));
  EXPECT_TRUE(is_within(offset_times_roughness, static_cast<double>(expected), 1e-17));
  for (int i = 0; i < 300; ++i) {
    const Reference m0 = sampler.log_uniform(1e-18, 1e-10), m2 = sampler.log_uniform(1e-6, 0.1);
    const Reference m4 = sampler.log_uniform(0.9, 500) * m2 * m2 / m0;
    const Summits<Reference> s = summits_from_spectral_moments(m0, m2, m4);
    const Reference roughness = s.summit_density * s.summit_radius * s.summit_height_sd;
    EXPECT_LT(abs(s.summit_plane_offset * roughness / expected - 1), Reference("1e-40"));
  }
}

TEST(SpectralMoments, ScaleWithTheFaceAndEndAtTheNarrowestBand) {
  const Summits<double> s = summits_from_spectral_moments(1e-14, 1e-4, 4e6);
  // twice as wide and twice as high: moments times 4, 1 and 1/4
  const Summits<double> larger = summits_from_spectral_moments(4e-14, 1e-4, 1e6);
  EXPECT_EQ(larger.bandwidth, s.bandwidth);
  EXPECT_TRUE(is_within(larger.summit_density, s.summit_density / 4, 1e-6));
  EXPECT_TRUE(is_within(larger.summit_radius, 2 * s.summit_radius, 1e-18));
  EXPECT_TRUE(is_within(larger.summit_height_sd, 2 * s.summit_height_sd, 1e-22));
  EXPECT_EQ(larger.summit_plane_offset, s.summit_plane_offset);
  EXPECT_GT(summits_from_spectral_moments(0.8969, 1.0, 1.0).summit_height_sd, 0.0);
  EXPECT_EQ(std::isnan(summits_from_spectral_moments(0.8968, 1.0, 1.0).bandwidth), true);
}

}  // namespace
}  // namespace tribo::verification
