// SPDX-License-Identifier: Apache-2.0
// Scenes whose numbers lie anywhere in the range of double. Intermediate results may then overflow
// a double, or underflow and lose digits. Every output still keeps its contract, or overflows
// itself.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "support/condition.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "support/threshold.hpp"
#include "tribo/mixed_contacts.hpp"

namespace tribo::verification {
namespace {

// A random scene of which some or all numbers are multiplied by 10^x, |x| ≤ `decades`.
Scene extreme_scene(Sampler& sampler) {
  Scene scene = random_scene(sampler);
  const double decades = sampler.pick({5.0, 20.0, 60.0, 150.0, 300.0});
  const int one_in = sampler.pick({1, 3, 8});
  const auto move = [&](double& number) {
    const double by = sampler.uniform(-decades, decades);
    if (sampler.uniform(0, one_in) >= 1) return;
    const double exponent = std::clamp(std::log10(number) + by, -323.0, 308.0);
    number = std::pow(10, exponent);
  };
  for (double* number : {&scene.load, &scene.speeds.list[0], &scene.surface.summit_density,
                         &scene.surface.summit_radius, &scene.surface.summit_height_sd,
                         &scene.bodies.effective_modulus, &scene.lubricant.viscosity,
                         &scene.lubricant.pressure_viscosity, &*scene.lubricant.eyring_stress,
                         &scene.supply.value, &scene.friction.slide_roll_ratio})
    move(*number);
  const ContactShape shape = scene.bodies.shape();
  move(shape == ContactShape::circle ? scene.bodies.reduced_radius : scene.bodies.radius_x);
  if (shape == ContactShape::line) move(scene.bodies.length);
  if (scene.lubricant.viscosity < 1e-4) scene.friction.viscosity = ViscosityLaw::barus;
  return scene;
}

struct Judged {
  int beyond_double = 0, next_to_zero = 0, compared = 0, by_engine = 0, ill_conditioned = 0;
};

void judge(const Scene& scene, const OperatingPoint<double>& got, Judged& judged) {
  const double u = scene.speeds[0];
  const OperatingPoint<Reference> exact = MixedContact<Reference>(scene).solve(Reference(u));
  const auto values = numbers_of(got);
  const auto expected = numbers_of(exact);
  Conditions conditions{};
  bool has_conditions = false;
  for (std::size_t k = 0; k < number_count; ++k) {
    if (isnan(expected[k])) {
      EXPECT_TRUE(std::isnan(values[k]) && got.regime == Regime::collapsed)
          << info(output_infos[k].output).name;
      continue;
    }
    const auto nearest = static_cast<double>(expected[k]);
    if (!std::isfinite(nearest)) {
      ++judged.beyond_double;
      EXPECT_FALSE(std::isfinite(values[k])) << output_infos[k].name << describe_scene(scene);
      continue;
    }
    if (nearest != 0 && std::fabs(nearest) < DBL_MIN) ++judged.next_to_zero;
    ++judged.compared;
    if (values[k] == nearest) continue;
    if (!has_conditions) conditions = conditions_at(scene, u);
    has_conditions = true;
    const double allowed =
        allowed_by(operating_point_contract, nearest == 0 ? Reference(DBL_MIN) : expected[k],
                   std::isfinite(conditions[k]) ? conditions[k] : 1e300, 1);
    if (allowed > 1e-3 && nearest != 0) {  // the inputs do not determine any digit
      ++judged.ill_conditioned;
      continue;
    }
    const Reference error = abs(Reference(values[k]) - expected[k]);
    EXPECT_LE(static_cast<double>(error),
              allowed * std::max(std::fabs(nearest), DBL_MIN * DBL_EPSILON))
        << output_infos[k].name << ": " << values[k] << " for " << expected[k].str(20)
        << ", condition " << conditions[k] << describe_scene(scene) << describe({{"u", u}});
  }
}

TEST(ExtremeScenes, AreRightOrBeyondDouble) {
  Sampler sampler(2711);
  Judged judged;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = extreme_scene(sampler);
    const double u = scene.speeds[0];
    const OperatingPoint<double> got = MixedContact<double>(scene).solve(u);
    judge(scene, got, judged);
    judged.by_engine +=
        std::isnan(MixedContact<double>(scene).numbers().surface.film_at_unit_speed) ? 0 : 1;
    MixedContacts contacts;
    Scene flooded = scene;  // is prepared together with a scene that has a supply
    flooded.supply = {};
    contacts.add(flooded);
    contacts.add(scene);
    contacts.prepare();
    OperatingPoints points;
    points.resize(2, OutputSet::all());
    const std::vector<std::uint64_t> index{0, 1};
    const std::vector<double> speeds{u, u};
    contacts.solve(index, speeds, OutputSet::all(), points);
    EXPECT_EQ(bits_of(points[0]), bits_of(MixedContact<double>(flooded).solve(u)));
    EXPECT_EQ(bits_of(points[1]), bits_of(got)) << describe_scene(scene);
  }
  EXPECT_GT(judged.by_engine, 1000);
  EXPECT_LT(judged.by_engine, 2500);
  EXPECT_GT(judged.compared, 20000);
  EXPECT_LT(judged.ill_conditioned, judged.compared / 100);
  EXPECT_GT(judged.beyond_double, 50);
  EXPECT_GT(judged.next_to_zero, 40);
}

// A scene's numbers, two products of them, and the speed, each at the ends of the engine's range.
TEST(ExtremeScenes, TheEngineComputesUpToItsLimitsAndNotBeyond) {
  Scene ordinary = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  ordinary.load = 1;
  ordinary.surface = {1e-10, 1, 1, 0, 1};  // so that no product comes near to 1e24
  ordinary.bodies = {1, 1, 1};
  ordinary.lubricant = {1, 1, 1};
  ordinary.speeds.list = {1};
  const auto is_left = [](const Scene& scene) {
    return std::isnan(MixedContact<double>(scene).numbers().surface.film_at_unit_speed);
  };
  std::vector<Threshold> limits;
  const auto names = numbers_of(ordinary);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name(names[k].first);
    if (name == "speed" || name == "summit_plane_offset" || name == "boundary_coefficient" ||
        name == "damiens_exponent")
      continue;
    const auto is_left_at = [=](double at) {
      Scene scene = ordinary;
      *numbers_of(scene)[k].second = at;
      return is_left(scene);
    };
    limits.push_back({name, 1e-20, True::below, is_left_at});
    limits.push_back({name, 1e20, True::above, is_left_at});
  }
  const auto of_density = [&](Scene scene) {
    return [=](double density) mutable {
      scene.surface.summit_density = density;
      return is_left(scene);
    };
  };
  Scene stiff = ordinary, wide = ordinary;
  stiff.bodies.effective_modulus = 1e15;
  wide.load = 1e18;
  wide.surface.summit_radius = 1e-19;
  const auto of_stiff = MixedContact<double>(stiff).numbers();
  const auto of_wide = MixedContact<double>(wide).numbers();
  limits.push_back(
      {"K", 1e24 * 1e-10 / of_stiff.surface.stiffness, True::above, of_density(stiff), 1e-14});
  limits.push_back(
      {"summits", 1e24 * 1e-10 / of_wide.count_factor, True::above, of_density(wide), 1e-14});
  const auto is_slow_or_fast = [contact = MixedContact<double>(ordinary)](double speed) {
    OperatingPoints points;
    points.resize(1, OutputSet::all());
    WorkCounts work;
    solve(contact, std::span(&speed, 1), OutputSet::all(), points, work);
    return work[Work::root_by_newton] == 1;
  };
  limits.push_back({"speed", 1e-60, True::below, is_slow_or_fast});
  limits.push_back({"speed", 1e60, True::above, is_slow_or_fast});
  for (const Threshold& one : limits) EXPECT_TRUE(changes_at_its_limit(one));
}

// The film ratio of this closure is about r⁻⁴. It may be subnormal or 0 where the film is neither.
TEST(ExtremeScenes, FilmsThatFallAsTheFourthPowerKeepTheirDigits) {
  Judged judged;
  for (const FluidShear fluid : {FluidShear::eyring, FluidShear::limiting})
    for (int decade = -19; decade <= 19; ++decade) {
      Scene scene = paper_scene(PaperSurface::rough);
      scene.closures.starvation = StarvationClosure::printed_exponents;
      scene.friction.fluid = fluid;
      scene.supply = {SupplyKind::inlet_flow, std::pow(10, decade)};
      scene.speeds.list = {1e50};
      judge(scene, MixedContact<double>(scene).solve(1e50), judged);
    }
  EXPECT_EQ(judged.compared, 78 * 9);
}

// F_2(41) is 1e-368 and its factor here 1e61; the engine sets F_n to 0 beyond 40.
TEST(ExtremeScenes, MomentsFarOutAreNotNothingWhereTheirFactorIsLarge) {
  Judged judged;
  Scene scene = paper_scene(PaperSurface::rough);
  scene.supply = {};
  scene.surface.summit_density = 1e20;
  scene.surface.summit_radius = 1e10;
  scene.surface.summit_height_sd = 1;
  for (const double film : {30.0, 39.0, 41.0, 42.0}) {
    scene.speeds.list = {MixedContact<double>(scene).speed_at(film)};
    judge(scene, MixedContact<double>(scene).solve(scene.speeds[0]), judged);
  }
  EXPECT_EQ(judged.ill_conditioned, 0);
}

// nβσ_s is 2e-160 here: its square is subnormal, K is not.
TEST(ExtremeScenes, StiffnessHasAllItsDigitsWhereASquareInItIsSubnormal) {
  Scene scene = paper_scene(PaperSurface::rough);
  scene.surface.summit_radius = 4.3e-164;
  scene.load = 1e112;
  const auto exact = MixedContact<Reference>(scene).solve(Reference(0.1));
  const auto got = MixedContact<double>(scene).solve(0.1);
  EXPECT_TRUE(is_close(got.asperity_load_share, exact.asperity_load_share, 1e-15, {}));
  EXPECT_TRUE(is_close(MixedContact<double>(scene).asperities().stiffness,
                       MixedContact<Reference>(scene).asperities().stiffness, 1e-15, {}));
}

}  // namespace
}  // namespace tribo::verification
