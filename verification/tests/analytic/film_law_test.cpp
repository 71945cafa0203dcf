// SPDX-License-Identifier: Apache-2.0
// Other film laws than the default one, in load sharing and in whole contacts: h = h₀ γ^{a−b} with
// the numbers of the law, in 50 digits and in double.
#include <gtest/gtest.h>

#include "support/condition.hpp"
#include "support/film_laws.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "support/textbook.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

struct Problem {
  const FilmLaw* law;
  AsperityModel model;
  double stiffness, offset, flooded;

  template <class T>
  LoadSharing<T> sharing() const {
    return {model, T(stiffness), T(offset), *law};
  }
  double condition() const { return root_condition(model, stiffness, offset, flooded, *law); }
  std::string text() const {
    return describe({{"a - b", law->sharing_power.value},
                     {"K", stiffness},
                     {"delta", offset},
                     {"lambda0", flooded}});
  }
};

Problem random_problem(Sampler& sampler) {
  return {sampler.pick({&hamrock_dowson_minimum_law, &least_exponent_law, &small_exponent_law,
                        &greatest_exponent_law}),
          sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson}),
          sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3), sampler.log_uniform(1e-4, 100)};
}

TEST(FilmLaw, RootInDoubleAgreesWithFiftyDigits) {
  Sampler sampler(71);
  for (int i = 0; i < 400; ++i) {
    const Problem p = random_problem(sampler);
    const LoadShares<double> got = p.sharing<double>().solve(p.flooded);
    const LoadShares<Reference> exact = p.sharing<Reference>().solve(Reference(p.flooded));
    EXPECT_TRUE(is_close(got.film_parameter, exact.film_parameter,
                         load_sharing_contract.ulp_per_condition * 0x1p-52,
                         {{"a - b", p.law->sharing_power.value},
                          {"K", p.stiffness},
                          {"delta", p.offset},
                          {"lambda0", p.flooded}},
                         p.condition()));
    // w = (λ₀/λ)^{1/(a−b)} has 1/(a−b) times the error of λ; with a − b = 0.01 it may underflow
    if (exact.fluid < Reference("1e-300")) {
      EXPECT_LT(got.fluid, 1e-300) << p.text();
      continue;
    }
    EXPECT_TRUE(is_close(got.fluid, exact.fluid, 1e-14 + 4e-15 / p.law->sharing_power.value,
                         {{"a - b", p.law->sharing_power.value},
                          {"K", p.stiffness},
                          {"delta", p.offset},
                          {"lambda0", p.flooded}},
                         p.condition()));
  }
}

// ln λ − ln λ₀ + (a−b) ln(1 − A), −1 where A ≥ 1.
TEST(FilmLaw, ResidualChangesSignAtTheRootAlone) {
  Sampler sampler(72);
  for (int i = 0; i < 200; ++i) {
    Problem p = random_problem(sampler);
    if (i % 2 == 0) p.law = &hamrock_dowson_central_law;
    const auto sharing = p.sharing<Reference>();
    const Reference lambda = sharing.solve(Reference(p.flooded)).film_parameter;
    const Reference exponent =
        ratio<Reference>(p.law->speed_exponent) - ratio<Reference>(p.law->material_exponent);
    const auto residual = [&](const Reference& x) -> Reference {
      const Reference share = sharing.asperity_share(x);
      if (share >= 1) return -1;
      return log(x) - log(Reference(p.flooded)) + log1p(-share) * exponent;
    };
    for (const char* distance : {"1e-30", "1e-10", "0.01", "0.5"}) {
      EXPECT_LT(residual(Reference(lambda * (1 - Reference(distance)))), 0) << p.text();
      EXPECT_GT(residual(Reference(lambda * (1 + Reference(distance)))), 0) << p.text();
    }
  }
}

TEST(FilmLaw, RootOfTheMinimumFilmAgreesWithGsl) {
  Sampler sampler(73);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    Problem p = random_problem(sampler);
    p.law = &hamrock_dowson_minimum_law;
    const LoadShares<double> got = p.sharing<double>().solve(p.flooded);
    if (got.fluid < 1e-6) continue;  // as in load_sharing_test.cpp
    ++compared;
    const double other =
        textbook::LoadSharing(p.model, p.stiffness, p.offset, 0.19).solve(p.flooded);
    EXPECT_TRUE(is_close(got.film_parameter, Reference(other), 1e-9,
                         {{"K", p.stiffness}, {"delta", p.offset}, {"lambda0", p.flooded}},
                         p.condition()));
  }
  EXPECT_GT(compared, 40);
}

// d ln λ₀/d ln(1−A) at one film, from surfaces of different stiffness; and back from λ₀ to λ.
TEST(FilmLaw, ExponentOfTheFluidShareIsTheLaws) {
  Sampler sampler(75);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    Problem p = random_problem(sampler);
    const auto soft = p.sharing<double>();
    const double lambda = soft.floor() + sampler.log_uniform(0.01, 3);
    Problem stiffer = p;
    stiffer.stiffness *= 0.5;
    const auto hard = stiffer.sharing<double>();
    const auto fluid = [&](const LoadSharing<double>& s) {
      return s.shares_above_floor(lambda - s.floor()).fluid;
    };
    const double change = std::log(fluid(hard) / fluid(soft));
    if (!(change > 0.01)) continue;
    ++compared;
    const double film0 = soft.flooded_film_parameter(lambda, fluid(soft));
    const double of_hard = hard.flooded_film_parameter(lambda, fluid(hard));
    EXPECT_TRUE(is_within(std::log(of_hard / film0) / change, p.law->sharing_power.value, 1e-12))
        << p.text();
    p.flooded = film0;
    EXPECT_TRUE(is_close(soft.film_parameter(film0), Reference(lambda), 1e-14,
                         {{"K", p.stiffness}, {"delta", p.offset}, {"lambda0", film0}},
                         p.condition() / std::min(1.0, p.law->sharing_power.value * 10)));
  }
  EXPECT_GT(compared, 100);
}

// The exponents come from differences of the contact's own numbers: h₀ by u and α, h by 1 − A.
TEST(FilmLaw, SceneThatNamesTheMinimumFilmHasItsExponents) {
  Scene scene = paper_scene(PaperSurface::rough);
  scene.supply = {};
  scene.closures.film = FilmFormula::hamrock_dowson_minimum;
  const MixedContact<double> contact(scene);
  EXPECT_EQ(&contact.film(), &hamrock_dowson_minimum_law);
  const double slope =
      std::log(contact.flooded_film_parameter(2) / contact.flooded_film_parameter(1)) / std::log(2);
  EXPECT_TRUE(is_within(slope, 0.68, 1e-14));
  scene.lubricant.pressure_viscosity *= 2;
  const double with_twice = MixedContact<double>(scene).flooded_film_parameter(1);
  scene.lubricant.pressure_viscosity /= 2;
  EXPECT_TRUE(is_within(std::log(with_twice / contact.flooded_film_parameter(1)) / std::log(2),
                        0.49, 1e-14));
  for (const double u : {0.003, 0.03, 0.3}) {
    const OperatingPoint<double> point = contact.solve(u);
    ASSERT_LT(point.fluid_load_share, 0.99);
    EXPECT_TRUE(is_within(std::log(contact.flooded_film_parameter(u) / point.film_parameter) /
                              std::log(point.fluid_load_share),
                          0.19, 1e-12));
    EXPECT_LT(point.film,
              MixedContact<double>(paper_scene(PaperSurface::rough)).solve(u).film_flooded);
  }
}

// A walk's point is explicit, the engine's a root: the same film at the same speed, and the onset.
TEST(FilmLaw, WalkAndOnsetAgreeWithTheRootUnderTheMinimumFilm) {
  Sampler sampler(76);
  int onsets = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = random_scene(sampler);
    scene.closures.film = scene.bodies.shape() == ContactShape::line
                              ? FilmFormula::dowson_higginson_minimum
                              : FilmFormula::hamrock_dowson_minimum;
    const MixedContact<Reference> exact(scene);
    const MixedContact<double> contact(scene);
    const StribeckWalk<Reference> walk(exact);
    const Reference log_speed = log(Reference(scene.speeds.list[0]));
    const WalkPoint<Reference> point = walk.at(
        walk.walk_to(walk.near(Reference(scene.speeds.list[0])), log_speed, Reference("0.01")));
    const Reference root = exact.flooded(point.flooded.speed).shares.film_parameter;
    EXPECT_TRUE(abs(root / point.flooded.shares.film_parameter - 1) < Reference("1e-40"));
    const Onset<Reference> here =
        onset(exact, scene, OnsetCriterion::film_departure, ratio<Reference>(5, 100));
    const Onset<double> there = onset(contact, scene, OnsetCriterion::film_departure, 0.05);
    ASSERT_EQ(here.exists, there.exists);
    if (!here.exists || here.film_parameter < 1) continue;
    ++onsets;
    EXPECT_TRUE(is_within(there.speed / static_cast<double>(here.speed), 1, 1e-10));
  }
  EXPECT_GT(onsets, 10);
}

}  // namespace
}  // namespace tribo::verification
