// SPDX-License-Identifier: Apache-2.0
// The starved inlet: onset constants, limits, inverses and slopes of the four closures.
#include "tribo/starvation.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;
constexpr std::array closures{flooded_inlet, starved_inlet, printed_exponents, damiens};

double film_over_inlet(StarvationClosure closure, double r) {
  return r * starvation_ratio(closure, r, 3.0);
}

TEST(Starvation, OnsetConstantsAreThoseOfTheSpecification) {
  const double r = film_maximum_flooded_over_inlet<double>(flooded_inlet);
  EXPECT_TRUE(is_within(r, 0.6327757634209, 0.5e-13));
  EXPECT_TRUE(is_within(film_over_inlet(flooded_inlet, r), 0.3579155879252, 0.5e-13));
  const double printed = film_maximum_flooded_over_inlet<double>(printed_exponents);
  EXPECT_TRUE(is_within(printed, 0.6962389029717, 0.5e-13));
  EXPECT_TRUE(is_within(film_over_inlet(printed_exponents, printed), 0.331495, 0.5e-6));
  EXPECT_TRUE(std::isnan(film_maximum_flooded_over_inlet<double>(starved_inlet)));
  EXPECT_TRUE(std::isnan(film_maximum_flooded_over_inlet<double>(damiens)));
}

TEST(Starvation, OnsetConstantsAreMaximaOfADenseSweep) {
  for (const auto closure : {flooded_inlet, printed_exponents}) {
    const double r = film_maximum_flooded_over_inlet<double>(closure);
    const double top = film_over_inlet(closure, r);
    for (double other = 1e-4; other < 10; other *= 1.001)
      EXPECT_LE(film_over_inlet(closure, other), top) << describe({{"r", other}});
    EXPECT_TRUE(is_close(r, film_maximum_flooded_over_inlet<Reference>(closure), 20 * 0x1p-52, {}));
  }
}

TEST(Starvation, DoubleAgreesWithFiftyDigits) {
  Sampler sampler(41);
  for (const auto closure : closures)
    for (int i = 0; i < 300; ++i) {
      const double r = sampler.log_uniform(1e-8, 1e8);
      const double gamma = sampler.uniform(0.5, 6);
      const Reference exact = starvation_ratio(closure, Reference(r), Reference(gamma));
      // near collapse 1 − r is exact, so that the flooded inlet keeps its digits too
      EXPECT_TRUE(is_close(starvation_ratio(closure, r, gamma), exact,
                           starvation_ratio_contract.ulp * 0x1p-52, {{"r", r}, {"gamma", gamma}}));
    }
}

// Short inlets too, of which the powers underflow in float.
TEST(Starvation, FloatKeepsItsContract) {
  Sampler sampler(46);
  for (const auto closure : closures)
    for (int i = 0; i < 300; ++i) {
      const auto r = static_cast<float>(sampler.log_uniform(1e-8, 1e25));
      const double exact = starvation_ratio(closure, static_cast<double>(r), 3.0);
      if (exact < 1e-36) continue;  // subnormal in float
      EXPECT_TRUE(is_close(starvation_ratio(closure, r, 3.0F), Reference(exact),
                           starvation_ratio_contract.ulp * 0x1p-23, {{"r", r}}));
    }
}

// 1 − y by subtraction in 50 digits; in double it keeps its digits where y has none left of it.
TEST(Starvation, DeficitIsOneMinusTheRatioToEveryDigit) {
  Sampler sampler(42);
  for (const auto closure : closures)
    for (int i = 0; i < 100; ++i) {
      const double r = sampler.log_uniform(1e-8, closure == flooded_inlet ? 1 : 1e8);
      const double gamma = sampler.uniform(0.5, 3);
      const Reference exact = 1 - starvation_ratio(closure, Reference(r), Reference(gamma));
      EXPECT_TRUE(is_close(starvation_deficit(closure, r, gamma), exact,
                           starvation_ratio_contract.ulp * 0x1p-52, {{"r", r}, {"gamma", gamma}}));
    }
}

// The defining equations, with ψ from y = (2/π) arctan(2.7ψ), in 50 digits.
TEST(Starvation, RatioSatisfiesItsDefiningEquation) {
  const Reference c = 3 / (4 * sqrt(Reference(2)));
  for (const auto closure : {flooded_inlet, starved_inlet, printed_exponents})
    for (const char* text : {"1e-6", "0.01", "0.3", "0.6", "0.99", "1.5", "20", "1e5"}) {
      const Reference r(text);
      if (closure == flooded_inlet && r >= 1) continue;
      const Reference y = starvation_ratio(closure, r, Reference(3));
      const Reference psi = tan(Reference(y * pi<Reference>() / 2)) / Reference("2.7");
      const Reference crook = psi * sqrt(psi) / c;
      const Reference inverse = closure == flooded_inlet ? Reference(1 + crook)
                                : closure == starved_inlet
                                    ? Reference(y + crook)
                                    : Reference(y + crook / pow(y, Reference("1.25")));
      EXPECT_LT(abs(inverse * r - 1), Reference("1e-40")) << text;
    }
}

TEST(Starvation, LimitsAreThoseOfTheSpecification) {
  for (const auto closure : closures) {
    EXPECT_EQ(starvation_ratio(closure, 1e-300, 3.0), 1) << static_cast<int>(closure);
    EXPECT_EQ(starvation_ratio(closure, 1e-30, 3.0), 1) << static_cast<int>(closure);
  }
  EXPECT_EQ(starvation_ratio(flooded_inlet, 1.0, 3.0), 0);
  EXPECT_GT(starvation_ratio(flooded_inlet, std::nextafter(1.0, 0.0), 3.0), 0);
  for (const double r : {std::nextafter(1.0, 2.0), 1.5, 1e10, 1e300})
    EXPECT_EQ(starvation_ratio(flooded_inlet, r, 3.0), 0) << "r = " << r;
  // starved_inlet: h*/h_oil ≈ 1 − k r^{−1/2}; y = (5.4/π)ψ gives k = (π/5.4)^{3/2}/c = 0.837
  const double k = std::pow(M_PI / 5.4, 1.5) / crook_constant<double>();
  EXPECT_TRUE(is_within(k, 0.837, 0.0005));
  for (const double r : {1e6, 1e10, 1e14})
    EXPECT_TRUE(is_within((1 - film_over_inlet(starved_inlet, r)) * std::sqrt(r), k,
                          2 / std::sqrt(r) + 1e-2))
        << r;
  EXPECT_TRUE(is_within(film_over_inlet(damiens, 1e6), 1, 1e-15));
  for (const double r : {1e-300, 0.5, 1.0, 1e5, 1e300})
    for (const double gamma : {1e-3, 1.0, 700.0})
      EXPECT_TRUE(std::isfinite(starvation_ratio(damiens, r, gamma))) << r << " " << gamma;
  for (const auto closure : {starved_inlet, printed_exponents, damiens})
    EXPECT_TRUE(std::isfinite(starvation_ratio(closure, 1e300, 3.0)));
}

TEST(Starvation, FilmNeverExceedsFloodedFilmOrInletAndFallsWithTheRatio) {
  for (const auto closure : closures) {
    double previous = 1;
    for (double r = 1e-4; r < 1e6; r *= 1.05) {
      const double y = starvation_ratio(closure, r, 3.0);
      EXPECT_LE(y, previous) << describe({{"r", r}});
      EXPECT_LE(y * r, 1) << describe({{"r", r}});
      previous = y;
    }
  }
}

TEST(Starvation, DepartureIsTheInverseOfTheRatio) {
  Sampler sampler(42);
  for (const auto closure : closures)
    for (int i = 0; i < 200; ++i) {
      const double departure = sampler.uniform(0.001, 0.999);
      const double gamma = sampler.uniform(0.5, 6);
      const Reference r =
          departure_flooded_over_inlet(closure, Reference(departure), Reference(gamma));
      EXPECT_LT(abs(starvation_ratio(closure, r, Reference(gamma)) - (1 - Reference(departure))),
                Reference("1e-45"));
      EXPECT_TRUE(is_close(departure_flooded_over_inlet(closure, departure, gamma), r,
                           starvation_ratio_contract.ulp * 0x1p-52,
                           {{"departure", departure}, {"gamma", gamma}},
                           1 / departure + 1 / (1 - departure)));
    }
}

TEST(Starvation, SlopeIsThatOfTheRatio) {
  const Reference h("1e-15");
  for (const auto closure : closures)
    for (double r = 1e-3; r < 1e3; r *= 1.7) {
      if (closure == flooded_inlet && r > 0.99) break;
      const Reference x(r);
      const auto log_y = [&](const Reference& factor) -> Reference {
        return log(starvation_ratio(closure, Reference(x * factor), Reference(3)));
      };
      const Reference slope = (log_y(exp(h)) - log_y(exp(-h))) / (2 * h);
      EXPECT_TRUE(is_close(starvation_slope(closure, r, 3.0), slope, 1e-13, {{"r", r}}));
    }
  // model.md, section 7: the printed exponents end in h* ∝ u^−2.01, r ∝ u^0.67
  EXPECT_TRUE(is_within(0.67 * (1 + starvation_slope(printed_exponents, 1e8, 3.0)), -2.01, 1e-6));
}

}  // namespace
}  // namespace tribo::verification
