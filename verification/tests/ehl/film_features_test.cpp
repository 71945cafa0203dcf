// SPDX-License-Identifier: Apache-2.0
// Features of films whose numbers are known: polynomials on uneven nodes.
#include "ehl/film_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ehl/grids.hpp"

namespace tribo::verification {
namespace {

template <class Film, class Pressure>
ehl::LineFilm curve_of(const ehl::Numbers& x, const Film& film, const Pressure& pressure) {
  ehl::LineFilm curve;
  curve.x = x;
  const auto at = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  curve.film = at.unaryExpr(film);
  curve.pressure = at.unaryExpr(pressure);
  return curve;
}

// The film is a polynomial of the fourth order. The pressure is the greater of two parabolas, or 0.
// The second parabola is narrow. It is left out; or makes a spike downstream, lower or higher than
// the first one; or makes a bump upstream with a dip behind it. Such a bump is no spike.
TEST(FilmFeatures, AreThoseOfTheCurve) {
  Sampler sampler(310);
  const ehl::LineContact contact{10, 5, {.exponent = 3, .density_pressure = 2}};
  for (int n = 0; n < 100; ++n) {
    const double least = sampler.uniform(0.01, 0.5), place = sampler.uniform(0.6, 1.2);
    const double middle = sampler.uniform(-0.3, 0), spike_place = sampler.uniform(0.7, 0.9);
    const double greatest = sampler.uniform(0.5, 1), spike = sampler.uniform(0.8, 2) * greatest;
    const auto film = [&](double x) {
      const double from = x - place;
      return least + 0.02 * from * from * (1 + 0.3 * from + 0.1 * from * from);
    };
    const auto pressure = [&](double x, double top, double at) {
      const double dome = greatest * (1 - std::pow((x - middle) / 1.2, 2));
      return std::max({0.0, dome, top - 100 * std::pow(x - at, 2)});
    };
    const ehl::Numbers x = uneven_nodes(1500, -4, 1.5, sampler);
    for (const auto& [top, at] :
         {std::pair{0.0, 0.0}, {spike, spike_place}, {0.95 * greatest, -0.8}}) {
      const bool has_spike = at > 0;
      ehl::LineFilm curve = curve_of(
          x, film, [&, top = top, at = at](double there) { return pressure(there, top, at); });
      curve.mass_flow = 0.5;
      const ehl::FilmFeatures found = ehl::features_of(contact, curve);
      EXPECT_TRUE(is_within(found.central, film(0), 2e-12));
      EXPECT_TRUE(is_within(found.minimum, least, 1e-15));
      EXPECT_TRUE(is_within(found.greatest_pressure, greatest, 1e-13));
      EXPECT_TRUE(
          is_within(found.at_greatest_pressure, 0.5 / contact.fluid.density(greatest), 1e-13));
      const auto highest = std::min_element(x.begin(), x.end(), [&](double a, double b) {
        return std::fabs(a - middle) < std::fabs(b - middle);
      });
      EXPECT_EQ(found.pressure_beside_greatest,
                std::min(pressure(highest[-1], top, at), pressure(highest[1], top, at)));
      EXPECT_EQ(found.has_spike, has_spike);
      EXPECT_TRUE(is_within(found.spike_pressure, has_spike ? spike : 0, 1e-13));
      EXPECT_TRUE(is_within(found.spike_place, has_spike ? spike_place : 0, 1e-13));
    }
  }
}

// A film whose least node is an end or the neighbour of one.
TEST(FilmFeatures, HaveTheirMinimumNextToAnEndToo) {
  const ehl::LineContact contact{10, 5, {}};
  for (const auto& [place, least] : {std::pair{-2.0, 1.0}, {-0.9, 1.0}, {1.1, 1.0}, {3.0, 1.25}}) {
    const ehl::FilmFeatures found = ehl::features_of(
        contact, curve_of(
                     {-2, -1, 0, 0.5, 1, 2.5},
                     [from = place](double x) { return 1 + (x - from) * (x - from); },
                     [](double x) { return std::max(0.0, 1 - x * x); }));
    EXPECT_TRUE(is_within(found.minimum, least, 1e-14)) << place;
    EXPECT_TRUE(is_within(found.central, 1 + place * place, 1e-14)) << place;
  }
}

// The pressure has a top near X = −0.5, falls to 0.5 in a valley, and rises behind it to another
// top.
TEST(FilmFeatures, HaveASpikeOnlyBehindAValleyBehindTheMiddle) {
  const ehl::LineContact contact{10, 5, {}};
  ehl::Numbers x;
  for (int i = -8; i <= 6; ++i) x.push_back(i / 4.);
  for (const double valley : {-0.25, 0., 0.25}) {
    const ehl::FilmFeatures found = ehl::features_of(
        contact, curve_of(
                     x, [](double there) { return 1 + there * there; },
                     [&](double there) {
                       return std::max(0.0, std::min(0.5 + std::fabs(there - valley),
                                                     2 - 2 * std::fabs(there)));
                     }));
    EXPECT_EQ(found.has_spike, valley > 0) << "the valley is at X = " << valley;
  }
}

}  // namespace
}  // namespace tribo::verification
