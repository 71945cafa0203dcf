// SPDX-License-Identifier: Apache-2.0
// The effective modulus and the reduced radii of two bodies, and Hertz' point, elliptic and line
// contacts: printed numbers, limits, and the load, displacements and stresses that quadratures of
// the pressure give without elliptic integrals. certified/certified_tables_test.cpp and
// contract/contract_test.cpp check the values.
#include "tribo/hertz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/judge.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::verification {
namespace {

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
constexpr double ulp = 0x1p-52;
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

// A ball of 10 mm diameter in a groove of 5.5 mm radius, 45 mm from the bearing's axis.
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

// The mean pressure times the area is the load. The peak pressure is also 2aE*/(πR).
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

TEST(HertzEllipse, ShapesAreThePrintedNumbers) {
  struct Printed {
    double ratio, k, first, second, accuracy;
  };
  for (const Printed& printed :
       {Printed{1.5, 1.31010296211275, 1.78976509504229, 1.39113754192085, 5e-15},
        Printed{2, 1.58580211970255, 1.95211383915685, 1.29715215638873, 5e-15},
        Printed{5, 2.89018103983641, 2.49374399466825, 1.12051972408493, 5e-15},
        Printed{10, 4.49944730315542, 2.91420269, 1.05988434, 5e-9},
        Printed{100, 18.1871030043889, 4.28949545, 1.00573002, 5e-9}}) {
    const EllipseShape<double> shape = ellipse_shape(printed.ratio);
    EXPECT_TRUE(is_within(shape.ellipticity, printed.k, printed.k < 10 ? 5.1e-15 : 5.1e-14));
    EXPECT_TRUE(is_within(shape.first_integral, printed.first, 1.02 * printed.accuracy));
    EXPECT_TRUE(is_within(shape.second_integral, printed.second, 1.02 * printed.accuracy));
  }
}

// k² = 1 + 4(α − 1)/3 + O((α − 1)²).
TEST(HertzEllipse, NextToTheCircleGrowsByTwoThirds) {
  EXPECT_EQ(ellipse_shape(1.0).ellipticity, 1);
  for (double above = 1e-15; above < 1e-7; above *= 3) {
    const double ratio = 1 + above;
    const double k = ellipse_shape(ratio).ellipticity;
    EXPECT_TRUE(is_within(k - 1, (ratio - 1) * 2 / 3, ulp / 2 * 1.01 + above * above));
  }
}

TEST(HertzEllipse, OfEqualRadiiIsTheCircle) {
  Sampler sampler(31);
  for (int i = 0; i < 300; ++i) {
    const double load = sampler.log_uniform(1e-6, 1e6), modulus = sampler.log_uniform(1e5, 1e12);
    const double radius = sampler.log_uniform(1e-6, 10);
    const auto circle = hertz_point(Reference(load), Reference(modulus), Reference(radius));
    const HertzEllipse<double> got = hertz_ellipse(load, modulus, radius, radius);
    const std::initializer_list<Input> inputs{{"load", load}, {"modulus", modulus}, {"R", radius}};
    EXPECT_EQ(got.semi_axis_x, got.semi_axis_y);
    EXPECT_EQ(got.ellipticity, 1);
    EXPECT_TRUE(is_close(got.semi_axis_x, circle.radius, ulp, inputs));
    EXPECT_TRUE(is_close(got.mean_pressure, circle.mean_pressure, ulp, inputs));
    EXPECT_TRUE(is_close(got.peak_pressure, circle.peak_pressure, ulp, inputs));
    EXPECT_TRUE(is_close(got.approach, circle.approach, ulp, inputs));
  }
}

TEST(HertzEllipse, WithXAndYExchangedHasItsAxesExchanged) {
  Sampler sampler(32);
  for (int i = 0; i < 300; ++i) {
    const double x = sampler.log_uniform(1e-4, 1), y = x * sampler.log_uniform(1e-4, 1e4);
    const HertzEllipse<double> got = hertz_ellipse(20.0, 1e11, x, y);
    const HertzEllipse<double> other = hertz_ellipse(20.0, 1e11, y, x);
    EXPECT_EQ(got.semi_axis_x, other.semi_axis_y);
    EXPECT_EQ(got.semi_axis_y, other.semi_axis_x);
    EXPECT_EQ(got.peak_pressure, other.peak_pressure);
    EXPECT_EQ(got.mean_pressure, other.mean_pressure);
    EXPECT_EQ(got.approach, other.approach);
    EXPECT_TRUE(is_close(got.ellipticity, 1 / Reference(other.ellipticity), 1.5 * ulp,
                         {{"R_x", x}, {"R_y", y}}));
    EXPECT_EQ(got.ellipticity > 1, y > x);
  }
}

// The integral of p₀√(1 − x²/a_x² − y²/a_y²), a strip at a time.
TEST(HertzEllipse, PressureCarriesTheLoad) {
  for (const double ratio : {1.0, 2.0, 1 / 3.0, 30.0, 1e-2, 1e4}) {
    const HertzEllipse<double> got = hertz_ellipse(50.0, 107.9e9, 9.5e-3, 9.5e-3 * ratio);
    // x = a_x sin s and y = chord sin t remove the square roots at the edge.
    const auto strip = [&](double s) {
      const double chord = got.semi_axis_y * std::cos(s);
      const auto pressure = [&](double t) { return std::cos(s) * std::pow(std::cos(t), 2); };
      return chord * Quadrature::integrate(pressure, -pi<double>() / 2, pi<double>() / 2, 0) *
             got.semi_axis_x * std::cos(s);
    };
    const double load =
        got.peak_pressure * Quadrature::integrate(strip, -pi<double>() / 2, pi<double>() / 2, 0);
    EXPECT_TRUE(is_within(load, 50, 1e-12 * 50)) << ratio;
    EXPECT_TRUE(is_within(got.mean_pressure / got.peak_pressure, 2.0 / 3, 2 * ulp));
  }
}

// The faces touch all over the ellipse: the pressure moves them by δ − x²/(2R_x) − y²/(2R_y). By
// Boussinesq the displacement is ∫∫ p ds dφ/(πE*) over rays from the point. Along a ray p is the
// root of a quadratic polynomial, whose integral to the edge is elementary.
TEST(HertzEllipse, PressureClosesTheGap) {
  for (const double ratio : {1.0, 1.001, 2.0, 0.5, 10.0, 0.1, 100.0}) {
    const double modulus = 107.9e9, radius_x = 9.5e-3, radius_y = radius_x * ratio;
    const HertzEllipse<double> got = hertz_ellipse(50.0, modulus, radius_x, radius_y);
    for (const auto& place : {std::pair{0.0, 0.0},
                              {0.5, 0.0},
                              {0.0, 0.5},
                              {0.9, 0.0},
                              {0.0, 0.9},
                              {0.4, -0.3},
                              {-0.6, 0.7}}) {
      const double u = place.first, v = place.second;
      const auto ray = [&](double angle) {
        const double x = std::cos(angle) / got.semi_axis_x, y = std::sin(angle) / got.semi_axis_y;
        // (p/p₀)² = c − 2bs − as² = g² − a(s + b/a)²
        const double a = x * x + y * y, b = u * x + v * y, c = 1 - u * u - v * v;
        const double g2 = c + b * b / a;
        return (g2 * (pi<double>() / 2 - std::asin(b / std::sqrt(a * g2))) -
                b / std::sqrt(a) * std::sqrt(c)) /
               (2 * std::sqrt(a));
      };
      // The trapezoidal rule converges geometrically; `stretch` fits the angles to a long ellipse.
      const int count = 4000;
      const double stretch = got.ellipticity;
      double sum = 0;
      for (int i = 0; i < count; ++i) {
        const double t = 2 * pi<double>() * i / count;
        const double cosine = std::cos(t), sine = stretch * std::sin(t);
        sum += ray(std::atan2(sine, cosine)) * stretch / (cosine * cosine + sine * sine);
      }
      const double moved =
          got.peak_pressure / (pi<double>() * modulus) * sum * 2 * pi<double>() / count;
      const double x = u * got.semi_axis_x, y = v * got.semi_axis_y;
      const double gap = got.approach - x * x / (2 * radius_x) - y * y / (2 * radius_y);
      EXPECT_TRUE(is_within(moved, gap, 1e-12 * got.approach)) << ratio << ' ' << u << ' ' << v;
    }
  }
}

// At some of these shapes C = (D − B)/q has few digits, by its series and by its difference.
TEST(HertzEllipse, SolvesItsEquationInFiftyDigits) {
  for (double above = 1e-16; above < 1e4; above *= 1.7) {
    const Reference ratio = 1 + Reference(above);
    const Reference k = ellipse_shape(ratio).ellipticity;
    const auto [b, d] = detail::associated_integrals(k);
    EXPECT_TRUE(is_within(relative_error(Reference(k * k * b / d), ratio), 0, 1e-49)) << above;
  }
}

TEST(HertzEllipse, FollowsFromTheRadiiThatItsEllipticityGives) {
  for (double k = 1e-8; k < 1e8; k *= 1.7) {
    const double ratio = radius_ratio_of(k);
    EXPECT_TRUE(is_within(ellipse_of_circle(1.0, ratio).axes_ratio, k, 4 * ulp * k)) << k;
    EXPECT_TRUE(is_within(radius_ratio_of(1 / k) * ratio, 1, 8 * ulp)) << k;
  }
  EXPECT_EQ(radius_ratio_of(1.0), 1);
}

// The ratios are the ends and the middles of four parts of each octave, their neighbours, and
// random numbers. Some lie beyond the octaves that have polynomials.
TEST(HertzEllipse, OfDoublesIsThatOfFiftyDigits) {
  std::vector<double> ratios;
  for (int octave = 0; octave < 16; ++octave)
    for (const double of_part : {1.0, 1.125, 1.25, 1.375, 1.5, 1.625, 1.75, 1.875})
      for (const double at : {std::nextafter(of_part, 0.0), of_part, std::nextafter(of_part, 2.0)})
        ratios.push_back(std::ldexp(at, octave));
  Sampler sampler(15);
  for (int i = 0; i < 3000; ++i) ratios.push_back(sampler.log_uniform(1, 5e4));
  for (const double ratio : ratios)
    for (const bool is_exchanged : {false, true}) {
      // One radius in eight is near the least normal number.
      const double x = sampler.log_uniform(1e-4, 0.1) * (sampler.uniform(0, 8) < 1 ? 0x1p-990 : 1);
      const double y = is_exchanged ? x / ratio : x * ratio;
      const EllipseOfCircle<double> got = ellipse_of_circle(x, y);
      const EllipseOfCircle<Reference> expected = ellipse_of_circle(Reference(x), Reference(y));
      const std::initializer_list<Input> inputs{{"R_x", x}, {"R_y", y}};
      EXPECT_TRUE(is_close(got.axis_cube, expected.axis_cube, ulp, inputs));
      EXPECT_TRUE(is_close(got.axes_ratio, expected.axes_ratio, ulp, inputs));
      EXPECT_TRUE(is_close(got.approach, expected.approach, ulp, inputs));
    }
}

// The middle of a long ellipse is a line contact under p₀a_xπ/2, the load per length there. The
// half-widths differ by 1/√B − 1 = (2 ln(4k) − 3)/(8k²) + O(ln²k/k⁴).
TEST(HertzEllipse, MiddleOfALongOneIsALine) {
  double before = 1;
  for (const double ratio : {1e2, 1e4, 1e6, 1e8, 1e12}) {
    const HertzEllipse<double> got = hertz_ellipse(50.0, 107.9e9, 9.5e-3, 9.5e-3 * ratio);
    const double load_per_length = pi<double>() / 2 * got.peak_pressure * got.semi_axis_x;
    const HertzLine<double> line = hertz_line(load_per_length, 107.9e9, 9.5e-3);
    const double difference = line.half_width / got.semi_axis_x - 1, k = got.ellipticity;
    EXPECT_TRUE(is_within(line.peak_pressure / got.peak_pressure, 1 / (1 + difference), 4 * ulp));
    EXPECT_TRUE(is_within(difference, (2 * std::log(4 * k) - 3) / (8 * k * k),
                          2 * std::pow(std::log(k) / (k * k), 2) + 2 * ulp));
    EXPECT_LT(difference, before);
    before = difference;
  }
}

TEST(HertzEllipse, EndsAtEveryRatio) {
  for (double ratio = 1e4; ratio < 1e308; ratio *= 1e4) {
    // α = k²B/D, with D = ln(4k) − 1 and B = 1 for a long ellipse
    const EllipseShape<double> shape = ellipse_shape(ratio);
    const double k = shape.ellipticity;
    EXPECT_TRUE(
        is_within(k / ratio * k / (std::log(4 * k) - 1), 1, 20 * std::log(k) / k / k + 4 * ulp))
        << ratio;
    EXPECT_TRUE(is_within(shape.first_integral, std::log(4 * k), 2 * std::log(k) / k / k + 1e-13));
  }
  EXPECT_EQ(ellipse_shape(infinity).ellipticity, infinity);
  EXPECT_EQ(ellipse_shape(infinity).second_integral, 1);
  EXPECT_EQ(std::isnan(ellipse_shape(std::nan("")).ellipticity), true);
  EXPECT_EQ(std::isnan(ellipse_shape(std::nan("")).second_integral), true);
  const HertzEllipse<double> far = hertz_ellipse(1.0, 1.0, 1e-200, 1e200);
  EXPECT_EQ(far.semi_axis_x > 0, false);  // 0 or NaN, and never the circle's
  EXPECT_EQ(far.ellipticity, infinity);
}

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
    // At half of the half-width the faces move by x²/(2R) less than in the middle: by 2/(πE*) ∫ p
    // ln|(s − x)/s| ds. The two logarithms are integrated separately.
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

// The stresses below the middle by Flamant's solution: σ_z = −(2z³/π) ∫ p/(s²+z²)² ds and σ_x =
// −(2z/π) ∫ ps²/(s²+z²)² ds. The greatest shear stress is half of their difference.
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
