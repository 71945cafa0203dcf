// SPDX-License-Identifier: Apache-2.0
// The starved inlet: onset constants, limits and inverses of the four closures.
#include "tribo/starvation.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;

double film_over_inlet(StarvationClosure closure, double r) {
  return r * starvation_ratio(closure, r, 3.0);
}

TEST(Starvation, OnsetConstantsAreThoseOfTheSpecification) {
  const double r = InletLaw<double>{flooded_inlet, 3}.at_film_maximum();
  EXPECT_TRUE(is_within(r, 0.6327757634209, 0.5e-13));
  EXPECT_TRUE(is_within(film_over_inlet(flooded_inlet, r), 0.3579155879252, 0.5e-13));
  const double printed = InletLaw<double>{printed_exponents, 3}.at_film_maximum();
  EXPECT_TRUE(is_within(printed, 0.6962389029717, 0.5e-13));
  EXPECT_TRUE(is_within(film_over_inlet(printed_exponents, printed), 0.331495, 0.5e-6));
  EXPECT_TRUE(std::isnan(InletLaw<double>{starved_inlet, 3}.at_film_maximum()));
  EXPECT_TRUE(std::isnan(InletLaw<double>{damiens, 3}.at_film_maximum()));
}

TEST(Starvation, OnsetConstantsAreMaximaOfADenseSweep) {
  for (const auto closure : {flooded_inlet, printed_exponents}) {
    const double r = InletLaw<double>{closure, 3}.at_film_maximum();
    const double top = film_over_inlet(closure, r);
    for (double other = 1e-4; other < 10; other *= 1.001)
      EXPECT_LE(film_over_inlet(closure, other), top) << describe({{"r", other}});
    EXPECT_TRUE(is_close(r, InletLaw<Reference>{closure, 3}.at_film_maximum(), 20 * 0x1p-52, {}));
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

// The ratio near each border between two ways of computing it, and far from it, by the template and
// by the engine. Some of the exponents are legal, though nobody uses them.
TEST(Starvation, KeepsItsContractOnBothSidesOfEachBranch) {
  std::vector<double> ratios{std::nextafter(1.0, 0.0), 1, std::nextafter(1.0, 2.0)};
  for (double off = 1e-12; off < 1; off *= 7) {
    ratios.push_back(1 - off);
    ratios.push_back(1 + off);
  }
  for (double r = 1.5; r < 1e20; r *= 1.9) {
    ratios.push_back(r);
    ratios.push_back(1 / r);
  }
  Scene scene = paper_scene(PaperSurface::rough);
  scene.supply = {SupplyKind::inlet_film_ratio, 1};
  for (const auto closure : starvation_closures)
    for (const double gamma : {0.1, 1.0, 3.0, 20.0, 1e3, 1e5}) {
      if (closure != damiens && gamma != 3) continue;
      scene.closures.starvation = closure;
      scene.closures.damiens_exponent = gamma;
      const MixedContact<double> engine(scene);
      const InletLaw<double> law{closure, gamma};
      const InletLaw<Reference> exact{closure, gamma};
      for (const double r : ratios) {
        const Reference exact_r(r);
        const Reference y = exact.film_ratio(exact_r);
        const bool has_slope = closure != flooded_inlet || r < 1;
        const double condition =
            1 + (has_slope ? std::abs(static_cast<double>(exact.slope(exact_r))) : 0);
        const auto by_engine = engine.inlet({1, {r, 0.5, 0.5, 0}}).film_ratio;
        for (const double got : {law.film_ratio(r), by_engine})
          EXPECT_TRUE(is_close(got, y, 16 * 0x1p-52, {{"r", r}, {"gamma", gamma}}, condition));
        const Reference deficit = exact.deficit(exact_r);
        EXPECT_LT(abs(deficit - (1 - y)), Reference("1e-45"));
        EXPECT_TRUE(
            is_within(law.deficit(r), static_cast<double>(deficit), 16 * 0x1p-52 * condition));
      }
    }
}

TEST(Starvation, LimitsAreThoseOfTheSpecification) {
  for (const auto closure : starvation_closures) {
    EXPECT_EQ(starvation_ratio(closure, 1e-300, 3.0), 1) << static_cast<int>(closure);
    EXPECT_EQ(starvation_ratio(closure, 1e-30, 3.0), 1) << static_cast<int>(closure);
  }
  EXPECT_EQ(starvation_ratio(flooded_inlet, 1.0, 3.0), 0);
  EXPECT_GT(starvation_ratio(flooded_inlet, std::nextafter(1.0, 0.0), 3.0), 0);
  for (const double r : {std::nextafter(1.0, 2.0), 1.5, 1e10, 1e300})
    EXPECT_EQ(starvation_ratio(flooded_inlet, r, 3.0), 0) << "r = " << r;
  EXPECT_TRUE(is_within(film_over_inlet(damiens, 1e6), 1, 1e-15));
  for (const double r : {1e-300, 0.5, 1.0, 1e5, 1e300})
    for (const double gamma : {1e-3, 1.0, 700.0})
      EXPECT_TRUE(std::isfinite(starvation_ratio(damiens, r, gamma))) << r << " " << gamma;
  for (const auto closure : {starved_inlet, printed_exponents, damiens})
    EXPECT_TRUE(std::isfinite(starvation_ratio(closure, 1e300, 3.0)));
}

TEST(Starvation, FilmNeverExceedsFloodedFilmOrInletAndFallsWithTheRatio) {
  for (const auto closure : starvation_closures) {
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
  for (const auto closure : starvation_closures)
    for (int i = 0; i < 200; ++i) {
      const double departure = sampler.uniform(0.001, 0.999);
      const InletLaw<Reference> law{closure, sampler.uniform(0.5, 6)};
      const Reference r = law.at_departure(Reference(departure));
      EXPECT_LT(abs(law.film_ratio(r) - (1 - Reference(departure))), Reference("1e-45"));
    }
}

}  // namespace
}  // namespace tribo::verification
