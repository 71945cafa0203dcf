// SPDX-License-Identifier: Apache-2.0
// The walked curve against the root, for every closure and supply, with and without a floor.
#include "tribo/stribeck_walk.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

// All closures and supplies on the paper's rough and smooth surfaces; two offset planes bring
// floors.
std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const auto model : asperity_models)
    for (const auto surface : {PaperSurface::rough, PaperSurface::smooth})
      for (const int planes : {0, 1, 2})
        for (const auto closure : starvation_closures)
          for (const auto supply : {SupplyKind::flooded, SupplyKind::inlet_film_ratio,
                                    SupplyKind::inlet_film, SupplyKind::inlet_flow}) {
            all.push_back(starved_scene(surface, closure, supply, model));
            all.back().surface.offset_planes = planes;
          }
  return all;
}

// 1 + d ln(1−A)/d ln λ, by which the rounding of a starved film shows in its fluid share.
double fluid_condition(const MixedContact<double>& contact, const OperatingPoint<double>& p) {
  if (p.fluid_load_share == 0) return 1;
  const double slope = contact.sharing().asperity_share_slope(p.film_parameter);
  return 1 - slope * p.asperity_load_share / p.fluid_load_share;
}

// The walk in long double, which solves no root, against the engine's roots.
TEST(StribeckCurve, EachPointIsWhatTheRootGivesAtItsSpeed) {
  for (const Scene& scene : scenes()) {
    const MixedContact<double> contact(scene);
    const MixedContact<long double> wide(scene);
    const auto hold = [&](const OperatingPoint<long double>& walked) {
      const OperatingPoint<double> p = detail::in_double(walked);
      const OperatingPoint<double> solved = contact.solve(p.speed);
      const double condition = fluid_condition(contact, p);
      const auto close = [&](double got, double expected, double allowed) {
        EXPECT_TRUE(is_close(got, expected, 2e-14, {{"u", p.speed}}, allowed))
            << describe_scene(scene);
      };
      close(p.film_flooded, solved.film_flooded, 1);
      // near collapse y is ill-conditioned in r
      const double r_condition = p.film > 0 ? 1 + p.film_flooded / p.film : 1;
      close(p.film, solved.film, r_condition);
      close(p.separation, solved.separation, r_condition);
      EXPECT_EQ(p.inlet, solved.inlet) << describe_scene(scene) << describe({{"u", p.speed}});
      EXPECT_EQ(p.regime == Regime::collapsed, solved.regime == Regime::collapsed);
      if (p.regime == Regime::collapsed) return;
      close(p.fluid_load_share, solved.fluid_load_share, 8 + condition * r_condition);
      close(p.friction, solved.friction, 8 + condition * r_condition);
    };
    stribeck_curve(wide, 1e-4L, 3.0L, 60, OutputSet::all(), hold);
  }
}

TEST(StribeckCurve, SpeedsAscendFromEndToEndWithoutGaps) {
  for (const Scene& scene : scenes())
    for (const std::size_t count : {std::size_t{2}, std::size_t{40}, std::size_t{333}}) {
      std::vector<double> speeds;
      stribeck_curve(MixedContact<long double>(scene), 1e-5L, 20.0L, count, OutputSet{},
                     [&](const OperatingPoint<long double>& p) {
                       speeds.push_back(static_cast<double>(p.speed));
                     });
      ASSERT_EQ(speeds.size(), count);
      EXPECT_TRUE(is_within(speeds.front() / 1e-5, 1, 2e-9)) << describe_scene(scene);
      EXPECT_TRUE(is_within(speeds.back() / 20, 1, 2e-9)) << describe_scene(scene);
      const double step = std::log(20 / 1e-5) / static_cast<double>(count - 1);
      for (std::size_t i = 1; i < count; ++i) {
        EXPECT_GT(speeds[i], speeds[i - 1]) << describe_scene(scene);
        EXPECT_LT(std::log(speeds[i] / speeds[i - 1]), 1.51 * step) << describe_scene(scene);
      }
    }
}

// In double the curve has the points of solve() at the speeds of a scene's logarithmic range.
TEST(StribeckCurve, InDoubleIsThatOfTheSpeedsOfTheRange) {
  for (const Scene& scene : scenes()) {
    const MixedContact<double> contact(scene);
    const Speeds range{{}, 1e-5, 20, 40, Spacing::log};
    std::size_t i = 0;
    stribeck_curve(contact, range.from, range.to, range.count, OutputSet::all(),
                   [&](const OperatingPoint<double>& p) {
                     EXPECT_EQ(bits_of(p), bits_of(contact.solve(range[i++])))
                         << describe_scene(scene);
                   });
    EXPECT_EQ(i, range.count);
  }
}

// With so large a plane offset λ_b and λ agree to the last bit, while the shares do not.
TEST(StribeckCurve, AbsurdOffsetsGiveSharesBetweenZeroAndOne) {
  for (const auto model : asperity_models)
    for (const double offset : {1e6, 1e12, 1e30}) {
      Scene scene = paper_scene(PaperSurface::rough, model);
      scene.surface.summit_plane_offset = offset;
      scene.supply = {};
      stribeck_curve(MixedContact<double>(scene), 1e-10, 1e300, 50, OutputSet::all(),
                     [&](const OperatingPoint<double>& p) {
                       EXPECT_TRUE(is_within(p.asperity_load_share, 0.5, 0.5))
                           << describe({{"u", p.speed}, {"offset", offset}});
                       EXPECT_TRUE(is_within(p.fluid_load_share, 0.5, 0.5))
                           << describe({{"u", p.speed}, {"offset", offset}});
                     });
    }
}

// d ln λ/d ln u and ds/d ln u against differences of the walk in 50 digits.
TEST(StribeckWalk, SlopesAreThoseOfTheFilm) {
  for (const Scene& scene : scenes()) {
    if (scene.supply.kind == SupplyKind::inlet_film || scene.surface.summit_height_sd < 5e-8)
      continue;
    const MixedContact<Reference> contact(scene);
    const StribeckWalk<Reference> walk(contact);
    const Reference h("1e-14");
    for (const char* speed : {"1e-4", "0.02", "0.3"}) {
      const Reference s = walk.walk_to(walk.near(Reference(speed)), log(Reference(speed)), h);
      const WalkPoint<Reference> here = walk.at(s), left = walk.at(s - h), right = walk.at(s + h);
      const auto log_change = [](const Reference& a, const Reference& b) -> Reference {
        return log1p((a - b) / b);
      };
      const Reference du = log_change(right.flooded.speed, left.flooded.speed);
      const Reference dlambda =
          log_change(right.flooded.shares.film_parameter, left.flooded.shares.film_parameter);
      EXPECT_LT(abs(here.rate * du / (2 * h) - 1), Reference("1e-18"))
          << speed << describe_scene(scene);
      // far down on the floor λ does not change in 50 digits
      if (here.film_slope > Reference("1e-15")) {
        EXPECT_LT(abs(dlambda / du / here.film_slope - 1), Reference("1e-15"))
            << speed << describe_scene(scene);
      }
    }
  }
}

TEST(StribeckWalk, FilmSlopeIsTwoThirdsWhereTheFluidCarriesAllAndNeverMore) {
  for (const Scene& scene : scenes()) {
    const MixedContact<double> contact(scene);
    const StribeckWalk<double> walk(contact);
    double previous = 0;
    for (double u = 1e-5; u < 30; u *= 1.3) {
      const WalkPoint<double> point = walk.at(walk.walk_to(walk.near(u), std::log(u), 1e-6));
      EXPECT_LE(point.film_slope, 0.67 * (1 + 1e-15)) << describe_scene(scene);
      EXPECT_GE(point.film_slope, 0) << describe_scene(scene);
      previous = point.film_slope;
    }
    EXPECT_TRUE(is_within(previous, 0.67, scene.surface.summit_height_sd > 5e-8 ? 1e-2 : 1e-10))
        << describe_scene(scene);
  }
}

// The first step reaches the speed, except for curvature: it may be 2 in ln u, and ln 6 is less.
TEST(StribeckWalk, BeginsBelowTheSpeedAndNoFurtherThanAFactorOfSix) {
  for (const Scene& scene : scenes()) {
    const MixedContact<long double> contact(scene);
    const StribeckWalk<long double> walk(contact);
    for (long double u = 1e-5L; u < 30; u *= 1.1L) {
      const long double begins = walk.at(walk.near(u)).flooded.speed;
      EXPECT_LE(begins, u * (1 + 1e-15L)) << static_cast<double>(u) << describe_scene(scene);
      EXPECT_GT(begins, u / 6) << static_cast<double>(u) << describe_scene(scene);
    }
  }
}

}  // namespace
}  // namespace tribo::verification
