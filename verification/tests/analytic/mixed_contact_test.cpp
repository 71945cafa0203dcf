// SPDX-License-Identifier: Apache-2.0
// Whole operating points: 50 digits, a second implementation on GSL, change of units, load balance,
// selected outputs, states that are not errors.
#include "tribo/mixed_contact.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/textbook.hpp"

namespace tribo::verification {
namespace {

// max(1e-13, 32 ε × condition): the film formula is good to 10 ε (its decimal exponents are
// rounded, and the logarithms of its numbers are near 20), the moments and the root to as much
// again.
constexpr double contract = 1e-13;
constexpr double contract_per_condition = 32 * 0x1p-52;

template <class T>
std::array<T, 9> numbers(const OperatingPoint<T>& p) {
  return {p.film_flooded,
          p.film,
          p.separation,
          p.film_parameter,
          p.asperity_load_share,
          p.fluid_load_share,
          p.real_area_ratio,
          p.summit_count,
          p.friction};
}

std::string describe_scene(const Scene& scene) {
  return describe({{"load", scene.load},
                   {"speed", scene.speeds.list.empty() ? 0 : scene.speeds.list[0]},
                   {"summit_density", scene.surface.summit_density},
                   {"summit_radius", scene.surface.summit_radius},
                   {"summit_height_sd", scene.surface.summit_height_sd},
                   {"offset", scene.surface.summit_plane_offset},
                   {"planes", static_cast<double>(scene.surface.offset_planes)},
                   {"E*", scene.bodies.effective_modulus},
                   {"R", scene.bodies.reduced_radius},
                   {"supply kind", static_cast<double>(scene.supply.kind)},
                   {"supply", scene.supply.value},
                   {"asperity", static_cast<double>(scene.closures.asperity)},
                   {"starvation", static_cast<double>(scene.closures.starvation)},
                   {"gamma", scene.closures.damiens_exponent}});
}

// Sum over all inputs of |d ln output/d ln input|, from steps of 1e-7.
std::array<double, 9> conditions(const Scene& scene) {
  const auto solve = [](const Scene& s) {
    return numbers(MixedContact<double>(s).solve(s.speeds.list[0]));
  };
  const std::array<double, 9> base = solve(scene);
  std::array<double, 9> sum{};
  const auto add = [&](auto&& change) {
    Scene moved = scene;
    change(moved);
    const std::array<double, 9> there = solve(moved);
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (base[i] != 0) sum[i] += std::abs(there[i] / base[i] - 1) / 1e-7;
  };
  constexpr double f = 1 + 1e-7;
  add([](Scene& s) { s.load *= f; });
  add([](Scene& s) { s.speeds.list[0] *= f; });
  add([](Scene& s) { s.surface.summit_density *= f; });
  add([](Scene& s) { s.surface.summit_radius *= f; });
  add([](Scene& s) { s.surface.summit_height_sd *= f; });
  add([](Scene& s) { s.surface.summit_plane_offset *= f; });
  add([](Scene& s) { s.bodies.effective_modulus *= f; });
  add([](Scene& s) { s.bodies.reduced_radius *= f; });
  add([](Scene& s) { s.lubricant.viscosity *= f; });
  add([](Scene& s) { s.lubricant.pressure_viscosity *= f; });
  add([](Scene& s) { s.supply.value *= f; });
  return sum;
}

TEST(MixedContact, DoubleAgreesWithFiftyDigitsOnRandomScenes) {
  Sampler sampler(61);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random_scene(sampler);
    const double u = scene.speeds.list[0];
    const OperatingPoint<double> got = MixedContact<double>(scene).solve(u);
    const OperatingPoint<Reference> exact = MixedContact<Reference>(scene).solve(Reference(u));
    EXPECT_EQ(got.inlet, exact.inlet);
    EXPECT_EQ(got.regime, exact.regime);
    EXPECT_EQ(got.friction_undefined, exact.friction_undefined);
    const auto condition = conditions(scene);
    for (std::size_t k = 0; k < 9; ++k) {
      // Below 1e-290 a share or an area underflows on its way.
      if (abs(numbers(exact)[k]) < Reference("1e-290")) continue;
      EXPECT_TRUE(is_close(numbers(got)[k], numbers(exact)[k],
                           std::max(contract, contract_per_condition * condition[k]), {}))
          << info(static_cast<Output>(k)).name << " condition " << condition[k]
          << describe_scene(scene);
    }
  }
}

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
    const auto condition = conditions(scene);
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

// Metres, kilograms and seconds replaced by arbitrary other units: dimensionless outputs stay. This
// is what tells the summit density from the viscosity in eqs 1.19 and 1.32. Roelands' constants
// would need rescaling and are left out.
TEST(MixedContact, DimensionlessOutputsDoNotDependOnTheUnits) {
  Sampler sampler(63);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_scene(sampler);
    if (scene.friction.viscosity == ViscosityLaw::roelands)
      scene.friction.viscosity = ViscosityLaw::barus;
    const double m = sampler.log_uniform(0.01, 100), kg = sampler.log_uniform(0.01, 100),
                 s = sampler.log_uniform(0.01, 100);
    const double newton = kg * m / (s * s), pascal = newton / (m * m);
    Scene other = scene;
    other.load *= newton;
    other.speeds.list[0] *= m / s;
    other.surface.summit_density /= m * m;
    other.surface.summit_radius *= m;
    other.surface.summit_height_sd *= m;
    other.bodies.effective_modulus *= pascal;
    other.bodies.reduced_radius *= m;
    other.lubricant.viscosity *= pascal * s;
    other.lubricant.pressure_viscosity /= pascal;
    *other.lubricant.eyring_stress *= pascal;
    if (scene.supply.kind == SupplyKind::inlet_film) other.supply.value *= m;
    if (scene.supply.kind == SupplyKind::inlet_flow) other.supply.value *= m * m / s;
    const OperatingPoint<double> a = MixedContact<double>(scene).solve(scene.speeds.list[0]);
    const OperatingPoint<double> b = MixedContact<double>(other).solve(other.speeds.list[0]);
    const auto condition = conditions(scene);
    const auto same = [&](double x, double y, Output output) {
      if (x < 1e-290) return;
      EXPECT_TRUE(is_close(
          y, Reference(x),
          std::max(contract, contract_per_condition * condition[static_cast<std::size_t>(output)]),
          {}))
          << info(output).name << describe_scene(scene);
    };
    same(a.film_parameter, b.film_parameter, Output::film_parameter);
    same(a.asperity_load_share, b.asperity_load_share, Output::asperity_load_share);
    same(a.fluid_load_share, b.fluid_load_share, Output::fluid_load_share);
    same(a.real_area_ratio, b.real_area_ratio, Output::real_area_ratio);
    same(a.summit_count, b.summit_count, Output::summit_count);
    same(a.friction, b.friction, Output::friction);
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
        EXPECT_EQ(numbers(one)[static_cast<std::size_t>(row.output)],
                  numbers(all)[static_cast<std::size_t>(row.output)])
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

TEST(MixedContact, FloatKeepsItsContract) {
  Sampler sampler(66);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_scene(sampler);
    const double u = static_cast<double>(static_cast<float>(scene.speeds.list[0]));
    scene.speeds.list[0] = u;
    const auto condition = conditions(scene);
    const auto got = numbers(MixedContact<float>(scene).solve(static_cast<float>(u)));
    const auto expected = numbers(MixedContact<double>(scene).solve(u));
    for (const Output output : {Output::film_flooded, Output::film, Output::asperity_load_share}) {
      const auto k = static_cast<std::size_t>(output);
      if (expected[k] < 1e-18) continue;  // K F_{5/2} underflows in float
      EXPECT_TRUE(is_close(got[k], Reference(expected[k]),
                           std::max(200.0, 20 * condition[k]) * 0x1p-23, {}))
          << info(output).name << describe_scene(scene);
    }
  }
}

}  // namespace
}  // namespace tribo::verification
