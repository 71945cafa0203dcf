// SPDX-License-Identifier: Apache-2.0
// Hertz' line contact: printed numbers; displacements and stresses by quadrature.
#include "tribo/hertz_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
constexpr double ulp = 0x1p-52;

// ∫ f(s) √(1 − s²) ds from −1 to 1, s = sin t.
template <class Function>
double under_the_pressure(Function&& f) {
  const auto in_t = [&](double t) { return f(std::sin(t)) * std::cos(t) * std::cos(t); };
  return Quadrature::integrate(in_t, -pi<double>() / 2, pi<double>() / 2, 12, 1e-13);
}

TEST(HertzLine, OfTheExampleIsTheHandCheck) {
  const HertzLine<double> got = hertz_line(1e5, 107.9e9, 9.5e-3);
  EXPECT_TRUE(is_within(got.half_width, 105.878e-6, 0.0005e-6));
  EXPECT_TRUE(is_within(got.peak_pressure, 0.601276e9, 0.0000005e9));
  EXPECT_TRUE(is_within(got.peak_shear / got.peak_pressure, 0.300283, 0.0000005));
}

TEST(HertzLine, PressureCarriesTheLoadAndClosesTheGap) {
  Sampler sampler(41);
  for (int i = 0; i < 300; ++i) {
    const double load = sampler.log_uniform(1e-3, 1e8), modulus = sampler.log_uniform(1e5, 1e12);
    const double radius = sampler.log_uniform(1e-6, 10);
    const HertzLine<double> got = hertz_line(load, modulus, radius);
    const std::initializer_list<Input> inputs{{"load", load}, {"modulus", modulus}, {"R", radius}};
    const double carried = under_the_pressure([](double) { return 1.0; });
    EXPECT_TRUE(is_close(carried * got.peak_pressure * got.half_width, load, 8 * ulp, inputs));
    EXPECT_TRUE(is_close(2 * got.mean_pressure * got.half_width, load, 2 * ulp, inputs));
    // Between the strip's middle and its half the faces move by x²/(2R) less:
    // 2/(πE*) ∫ p ln|s/(s − x)| ds. The logarithms are integrated apart.
    if (i >= 20) continue;
    const double x = 0.5;
    const auto log_at = [&](double at) {
      // ∫ √(1−s²) ln|s − x| ds = ∫ (√(1−s²) − √(1−x²)) ln|s − x| ds + √(1−x²) ∫ ln|s − x| ds
      const double root = std::sqrt(1 - at * at);
      const auto part = [&](double s) {
        const double apart = std::abs(s - at);
        return apart > 0 ? (std::sqrt(1 - s * s) - root) * std::log(apart) : 0.0;
      };
      const auto side = [](double length) { return length * (std::log(length) - 1); };
      return Quadrature::integrate(part, -1.0, at, 15, 1e-12) +
             Quadrature::integrate(part, at, 1.0, 15, 1e-12) + root * (side(1 - at) + side(1 + at));
    };
    const double moved =
        2 / (pi<double>() * modulus) * got.peak_pressure * got.half_width * (log_at(x) - log_at(0));
    const double gap = std::pow(x * got.half_width, 2) / (2 * radius);
    EXPECT_TRUE(is_within(moved / gap, 1, 1e-9));
  }
}

TEST(HertzLine, GrowsWithTheRootsOfLoadModulusAndRadius) {
  const HertzLine<double> got = hertz_line(3e4, 2e11, 0.02);
  const auto grown = [&](const HertzLine<double>& other, double width, double pressure) {
    EXPECT_EQ(other.half_width, width * got.half_width);
    EXPECT_EQ(other.mean_pressure, pressure * got.mean_pressure);
    EXPECT_EQ(other.peak_pressure, pressure * got.peak_pressure);
    EXPECT_EQ(other.peak_shear, pressure * got.peak_shear);
  };
  grown(hertz_line(4 * 3e4, 2e11, 0.02), 2, 2);
  grown(hertz_line(3e4, 4 * 2e11, 0.02), 0.5, 2);
  grown(hertz_line(3e4, 2e11, 4 * 0.02), 2, 0.5);
}

// The stresses below the middle by Flamant's solution: σ_z = −(2z³/π) ∫ p/(s²+z²)² ds, σ_x with
// zs² for z³; the greatest shear stress is half of their difference.
TEST(HertzLine, GreatestShearStressIsBelowTheSurface) {
  const auto shear = [](double z) {
    return under_the_pressure([&](double s) {
             const double square = s * s + z * z;
             return z * (z * z - s * s) / (square * square);
           }) /
           pi<double>();
  };
  double least = 0.5, most = 1.1;  // golden sections
  while (most - least > 1e-7) {
    const double part = (most - least) * 0.381966;
    if (shear(least + part) < shear(most - part))
      least += part;
    else
      most -= part;
  }
  EXPECT_TRUE(is_within((least + most) / 2, 0.786151, 1e-6));
  EXPECT_TRUE(is_within(shear((least + most) / 2), line_peak_shear_ratio<double>(), 1e-12));
  EXPECT_TRUE(is_within(line_peak_shear_ratio<double>(), 0.300283, 0.0000005));
}

}  // namespace
}  // namespace tribo::verification
