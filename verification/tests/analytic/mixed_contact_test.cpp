// SPDX-License-Identifier: Apache-2.0
// Whole operating points: a second implementation on GSL, load balance, selected outputs, and
// states in which an output is NaN without an error.
#include "tribo/mixed_contact.hpp"

#include <gtest/gtest.h>

#include "support/condition.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "support/textbook.hpp"
#include "support/threshold.hpp"
#include "tribo/operating_points.hpp"

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
    // With a fluid share below 1e-6 Brent's bracket on QAGIU's shares has no finite end.
    if (got.regime == Regime::collapsed || shares.fluid < 1e-6) continue;
    ++compared;
    const textbook::Point other = textbook::solve(scene, u);
    const Conditions condition = conditions_at(scene, u);
    const auto close = [&](double value, double expected, Output output) {
      EXPECT_TRUE(is_close(value, expected, 1e-9, {},
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

// The regime is `boundary` where the fluid carries under 1 %, and `elastohydrodynamic` where the
// asperities do. The inlet is `flooded` where h* ≥ 0.95 h_ff.
template <class T>
void hold_limits_of_regimes(double slack) {
  Scene scene = paper_scene(PaperSurface::rough);
  const MixedContact<T> starved(scene);
  scene.supply = {};
  const MixedContact<T> contact(scene);
  const auto regime = [&](double asperity, double fluid) {
    const FloodedFilm<T> film{T(1), {T(2), T(asperity), T(fluid), 0}};
    return contact.complete(film, {T(1), T(0), false}, OutputSet::all()).regime;
  };
  const auto inlet = [&](double film_ratio) {
    const FloodedFilm<T> film{T(1), {T(2), T(0.5), T(0.5), 0}};
    return starved.complete(film, {T(film_ratio), T(0.5), false}, OutputSet::all()).inlet;
  };
  for (const Threshold& one : std::initializer_list<Threshold>{
           {"boundary", 0.01, True::below,
            [&](double fluid) { return regime(1 - fluid, fluid) == Regime::boundary; }, slack},
           {"elastohydrodynamic", 0.01, True::below,
            [&](double share) { return regime(share, 1 - share) == Regime::elastohydrodynamic; },
            slack},
           {"flooded", 0.95, True::from, [&](double y) { return inlet(y) == Inlet::flooded; },
            slack}})
    EXPECT_TRUE(changes_at_its_limit(one));
}
TEST(MixedContact, RegimesAndInletsChangeAtTheirLimits) {
  hold_limits_of_regimes<double>(0);
  hold_limits_of_regimes<long double>(3e-16);
}

TEST(MixedContact, SharesAreAPartitionAndFilmsAreOrdered) {
  Sampler sampler(64);
  for (int i = 0; i < 5000; ++i) {
    const Scene scene = random_scene(sampler);
    const OperatingPoint<double> p = MixedContact<double>(scene).solve(scene.speeds.list[0]);
    EXPECT_LE(p.film, p.film_flooded) << describe_scene(scene);
    EXPECT_GE(p.separation, p.film) << describe_scene(scene);
    EXPECT_EQ(p.regime == Regime::collapsed, p.separation == 0) << describe_scene(scene);
    if (p.regime == Regime::collapsed) continue;
    EXPECT_TRUE(is_within(p.asperity_load_share + p.fluid_load_share, 1, 1e-12))
        << describe_scene(scene);
    EXPECT_TRUE(is_within(p.asperity_load_share, 0.5, 0.5)) << describe_scene(scene);
    EXPECT_GT(p.friction, 0) << describe_scene(scene);
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
      if (row.is_of_smooth_contact) continue;  // a point does not hold it
      OutputSet only;
      only.insert(row.output);
      const OperatingPoint<double> one = contact.solve(u, only);
      if (row.output == Output::regime) {
        EXPECT_EQ(one.regime, all.regime);
      } else if (row.output == Output::inlet) {
        EXPECT_EQ(one.inlet, all.inlet);
      } else {
        const std::size_t place = 1 + static_cast<std::size_t>(row.output);  // the speed is first
        EXPECT_EQ(bits_of(one)[place], bits_of(all)[place]) << row.name << describe_scene(scene);
      }
    }
  }
}

// The state where h_ff has reached h_oil: a film is left, the faces are on the floor, or neither.
enum class Left { film, floor, nothing };

void expect_left(Left left, const MixedContact<double>& contact, const OperatingPoint<double>& p) {
  const double floor = contact.sharing().floor() * contact.summit_height_sd();
  EXPECT_EQ(p.film > 0, left == Left::film);
  EXPECT_EQ(p.film_parameter > 0, left == Left::film);
  EXPECT_EQ(p.inlet == Inlet::collapsed, left != Left::film);
  EXPECT_EQ(p.separation, std::max(p.film, floor));
  EXPECT_GT(p.film_flooded, 0);
  const double apart = p.separation / contact.summit_height_sd();
  EXPECT_TRUE(
      is_within(p.real_area_ratio / real_area_ratio(contact.asperities(), apart), 1, 1e-12));
  EXPECT_TRUE(is_within(p.summit_count / summit_count(contact.asperities(), apart), 1, 1e-12));
  EXPECT_EQ(p.regime == Regime::collapsed, left == Left::nothing);
  EXPECT_EQ(p.asperity_load_share == 1 && p.fluid_load_share == 0 && p.regime == Regime::boundary,
            p.separation == floor && floor > 0);
  if (left == Left::nothing) {
    EXPECT_TRUE(std::isnan(p.asperity_load_share) && std::isnan(p.fluid_load_share) &&
                std::isnan(p.friction));
  } else {
    EXPECT_TRUE(is_within(p.asperity_load_share + p.fluid_load_share, 1, 1e-12));
    // Oil is still sheared beside the summits, at the floor's separation.
    EXPECT_GT(p.friction, 0.13 * p.asperity_load_share);
    EXPECT_LT(p.friction, 1);
  }
}

TEST(MixedContact, OfEachClosureIsLeftWhatTheTableSays) {
  struct Row {
    StarvationClosure closure;
    Left without_floor, with_floor;  // at r = 1 and beyond; just below 1 a film is left
  };
  for (const auto model : asperity_models)
    for (const auto& [closure, without_floor, with_floor] :
         {Row{StarvationClosure::flooded_inlet, Left::nothing, Left::floor},
          Row{StarvationClosure::starved_inlet, Left::film, Left::film},
          Row{StarvationClosure::printed_exponents, Left::film, Left::film},
          Row{StarvationClosure::damiens, Left::film, Left::film}})
      for (const bool has_floor : {false, true}) {
        Scene scene =
            starved_scene(PaperSurface::rough, closure, SupplyKind::inlet_film_ratio, model);
        scene.surface.offset_planes = has_floor ? 2 : 0;
        const Left left = has_floor ? with_floor : without_floor;
        const MixedContact<double> contact(scene);
        ASSERT_EQ(contact.sharing().floor() > 0, has_floor);
        double below = 1e-4, at = 100;  // neighbours about r = 1
        while (std::nextafter(below, at) < at) {
          const double middle = below + (at - below) / 2;
          const double r = contact.inlet(contact.flooded(middle)).flooded_over_inlet;
          (r >= 1 ? at : below) = middle;
        }
        const std::array speeds{below, at, 10 * at};
        OperatingPoints batch;
        batch.resize(speeds.size(), OutputSet::all());
        solve(contact, speeds, OutputSet::all(), batch);
        for (std::size_t i = 0; i < speeds.size(); ++i) {
          SCOPED_TRACE(describe_scene(scene) + describe({{"u", speeds[i]}}));
          const OperatingPoint<double> alone = contact.solve(speeds[i]);
          expect_left(i == 0 ? Left::film : left, contact, alone);
          EXPECT_EQ(bits_of(batch[i]), bits_of(alone));
        }
        const auto wide = detail::in_double(
            MixedContact<long double>(scene).solve(static_cast<long double>(speeds[2])));
        EXPECT_EQ(wide.regime, batch.regime[2]);
        EXPECT_EQ(wide.inlet, batch.inlet[2]);
        EXPECT_EQ(std::isnan(wide.asperity_load_share), left == Left::nothing);
        EXPECT_EQ(std::isnan(wide.fluid_load_share), left == Left::nothing);
        EXPECT_EQ(std::isnan(wide.friction), left == Left::nothing);
      }
}

// The lower the floor, the greater the shear rate of the oil beside the summits. Where A(0) is just
// above 1, friction is far above μ_b, because of the part τ(1 − A_r)/p̄ alone.
TEST(MixedContact, FrictionOnALowFloorIsTheShearOfTheOilBesideTheSummits) {
  Scene scene = paper_scene(PaperSurface::rough);
  for (int i = 0; i < 60; ++i) {  // moves K until A(0) = 1
    const MixedContact<long double> contact(scene);
    const long double share = contact.sharing().asperity_share(0.0L);
    scene.surface.summit_density *= static_cast<double>(1 / share);
  }
  scene.surface.summit_density *= 1 + 1e-13;
  const MixedContact<double> contact(scene);
  const double floor = contact.sharing().floor();
  ASSERT_TRUE(floor > 0 && floor < 1e-10) << floor;
  const OperatingPoint<double> p = contact.solve(5.0);
  ASSERT_EQ(p.regime, Regime::boundary);
  const double rate = 5.0 / p.separation, viscosity = scene.lubricant.viscosity;
  const double tau0 = *scene.lubricant.eyring_stress;
  const double oil = tau0 * std::asinh(viscosity * rate / tau0) * (1 - p.real_area_ratio) /
                     contact.hertz().mean_pressure;
  EXPECT_TRUE(is_within(p.friction / (0.13 + oil), 1, 1e-12));
  EXPECT_GT(p.friction, 0.2);
}

}  // namespace
}  // namespace tribo::verification
