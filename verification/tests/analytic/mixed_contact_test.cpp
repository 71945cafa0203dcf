// SPDX-License-Identifier: Apache-2.0
// Whole operating points: a second implementation on GSL, load balance, selected outputs, states
// that are not errors.
#include "tribo/mixed_contact.hpp"

#include <gtest/gtest.h>

#include "support/condition.hpp"
#include "support/scenes.hpp"
#include "support/textbook.hpp"

namespace tribo::verification {
namespace {

TEST(MixedContact, AgreesWithASecondImplementationOnGsl) {
  Sampler sampler(62);
  int compared = 0;
  while (compared < 120) {
    const Scene scene = random_scene(sampler);
    const double u = scene.speeds.list[0];
    const OperatingPoint<double> got = MixedContact<double>(scene).solve(u);
    const LoadShares<double> shares = MixedContact<double>(scene).flooded(u).shares;
    // Brent's bracket on QAGIU's shares has no finite end where the asperities carry all but 1e-6.
    if (got.friction_undefined || shares.fluid < 1e-6) continue;
    ++compared;
    const textbook::Point other = textbook::solve(scene, u);
    const Conditions condition = conditions_at(scene, u);
    const auto close = [&](double value, double expected, Output output) {
      EXPECT_TRUE(is_close(value, Reference(expected), 1e-9, {},
                           std::max(1.0, condition[static_cast<std::size_t>(output)] / 10)))
          << info(output).name << describe_scene(scene);
    };
    close(got.film_flooded, other.film_flooded, Output::film_flooded);
    close(got.film, other.film, Output::film);
    close(got.friction, other.friction, Output::friction);
    const double d = got.separation / scene.surface.summit_height_sd -
                     scene.surface.offset_planes * scene.surface.summit_plane_offset;
    if (d > 37) continue;  // QAGIU gives 0 there
    close(got.asperity_load_share, other.asperity_share, Output::asperity_load_share);
    close(got.real_area_ratio, other.real_area_ratio, Output::real_area_ratio);
    close(got.summit_count, other.summit_count, Output::summit_count);
  }
}

// boundary where the fluid carries under 1 %, elastohydrodynamic where the asperities do; flooded
// where h* ≥ 0.95 h_ff. The sweeps pass each threshold in steps of 1e-3 of it.
TEST(MixedContact, RegimeAndInletChangeAtTheirThresholds) {
  double nearest_boundary = 1, nearest_film = 1, nearest_flooded = 1;
  for (const PaperSurface surface : paper_surfaces) {
    Scene scene = paper_scene(surface);
    scene.surface.summit_density *= 1.3;  // a floor, so that the fluid's share falls to 0
    scene.supply = {SupplyKind::inlet_film_ratio, 60};
    const MixedContact<double> contact(scene);
    for (double u = 1e-12; u < 30; u *= 1.002) {
      const OperatingPoint<double> p = contact.solve(u);
      const double kept = p.film / p.film_flooded;
      EXPECT_EQ(p.regime, p.fluid_load_share < 0.01      ? Regime::boundary
                          : p.asperity_load_share < 0.01 ? Regime::elastohydrodynamic
                                                         : Regime::mixed)
          << describe({{"u", u}, {"A", p.asperity_load_share}, {"1-A", p.fluid_load_share}});
      if (std::abs(kept - 0.95) > 1e-12) {
        EXPECT_EQ(p.inlet, p.film == 0   ? Inlet::collapsed
                           : kept > 0.95 ? Inlet::flooded
                                         : Inlet::starved)
            << describe({{"u", u}, {"h*/h_ff", kept}});
      }
      nearest_boundary = std::min(nearest_boundary, std::abs(p.fluid_load_share / 0.01 - 1));
      nearest_film = std::min(nearest_film, std::abs(p.asperity_load_share / 0.01 - 1));
      nearest_flooded = std::min(nearest_flooded, std::abs(kept / 0.95 - 1));
    }
  }
  EXPECT_LT(nearest_boundary, 1e-2);
  EXPECT_LT(nearest_film, 1e-2);
  EXPECT_LT(nearest_flooded, 1e-3);
}

TEST(MixedContact, SharesAreAPartitionAndFilmsAreOrdered) {
  Sampler sampler(64);
  for (int i = 0; i < 5000; ++i) {
    const Scene scene = random_scene(sampler);
    const OperatingPoint<double> p = MixedContact<double>(scene).solve(scene.speeds.list[0]);
    EXPECT_TRUE(is_within(p.asperity_load_share + p.fluid_load_share, 1, 1e-12))
        << describe_scene(scene);
    EXPECT_TRUE(is_within(p.asperity_load_share, 0.5, 0.5)) << describe_scene(scene);
    EXPECT_LE(p.film, p.film_flooded) << describe_scene(scene);
    EXPECT_GE(p.separation, p.film) << describe_scene(scene);
    EXPECT_TRUE(p.friction_undefined || p.friction > 0) << describe_scene(scene);
    EXPECT_EQ(p.friction_undefined, p.separation == 0) << describe_scene(scene);
    EXPECT_EQ(p.regime == Regime::boundary, p.fluid_load_share < 0.01) << describe_scene(scene);
  }
}

TEST(MixedContact, EachOutputAskedAloneIsTheSameToTheLastBit) {
  Sampler sampler(65);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random_scene(sampler);
    const MixedContact<double> contact(scene);
    const double u = scene.speeds.list[0];
    const OperatingPoint<double> all = contact.solve(u);
    for (const OutputInfo& row : output_infos) {
      OutputSet only;
      only.insert(row.output);
      const OperatingPoint<double> one = contact.solve(u, only);
      if (row.output == Output::regime) {
        EXPECT_EQ(one.regime, all.regime);
      } else if (row.output == Output::inlet) {
        EXPECT_EQ(one.inlet, all.inlet);
      } else {
        EXPECT_EQ(numbers_of(one)[static_cast<std::size_t>(row.output)],
                  numbers_of(all)[static_cast<std::size_t>(row.output)])
            << row.name << describe_scene(scene);
      }
    }
  }
}

TEST(MixedContact, CollapseWithoutAFloorIsAStateAndFrictionIsUndefined) {
  const MixedContact<double> contact(paper_scene(PaperSurface::smooth));
  const OperatingPoint<double> p = contact.solve(1.0);
  EXPECT_EQ(p.inlet, Inlet::collapsed);
  EXPECT_EQ(p.film, 0);
  EXPECT_EQ(p.separation, 0);
  EXPECT_EQ(p.film_parameter, 0);
  EXPECT_TRUE(p.friction_undefined);
  EXPECT_EQ(p.asperity_load_share, contact.sharing().asperity_share(0));
  EXPECT_EQ(p.real_area_ratio, real_area_ratio(contact.asperities(), 0.0));
  EXPECT_GT(p.film_flooded, 0);
}

TEST(MixedContact, CollapseOntoAFloorLeavesTheAsperitiesWithTheLoad) {
  Scene scene = paper_scene(PaperSurface::rough);
  scene.surface.offset_planes = 2;
  const MixedContact<double> contact(scene);
  ASSERT_GT(contact.sharing().floor(), 0);
  const OperatingPoint<double> p = contact.solve(5.0);
  EXPECT_EQ(p.inlet, Inlet::collapsed);
  EXPECT_EQ(p.film, 0);
  EXPECT_EQ(p.separation, contact.sharing().floor() * 1e-7);
  EXPECT_EQ(p.asperity_load_share, 1);
  EXPECT_EQ(p.regime, Regime::boundary);
  EXPECT_FALSE(p.friction_undefined);
  EXPECT_GT(p.friction, 0.13);
}

}  // namespace
}  // namespace tribo::verification
