// SPDX-License-Identifier: Apache-2.0
// The load-sharing root under the default film law and under others, h = h₀ (1 − A)^{b−a}: from λ₀
// to λ and back, the floor, films near the floor, the signs of the residual, and the exponent. The
// tests in certified and contract check the root's value.
#include "tribo/load_sharing.hpp"

#include <gtest/gtest.h>

#include "support/condition.hpp"
#include "support/film_laws.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

constexpr double contract = 1e-13;  // load_sharing.hpp, at a condition below 2

struct Problem {
  AsperityModel model;
  double stiffness, offset, flooded;
  const FilmLaw* law = &hamrock_dowson_central_law;

  template <class T = double>
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
  return {sampler.pick(asperity_models), sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3),
          sampler.log_uniform(1e-4, 100)};
}
Problem problem_of_another_law(Sampler& sampler) {
  const FilmLaw* const law = sampler.pick(other_film_laws);
  Problem problem = random_problem(sampler);
  problem.law = law;
  return problem;
}

TEST(LoadSharing, FilmToFloodedFilmAndBackIsTheSame) {
  Sampler sampler(24);
  for (int i = 0; i < 3000; ++i) {
    Problem p = random_problem(sampler);
    const LoadSharing<double> sharing = p.sharing();
    const LoadShares<double> start =
        sharing.shares_above_floor(sampler.log_uniform(1e-6, 50) * (1 + sharing.floor()));
    if (start.fluid < 1e-12) continue;
    p.flooded = sharing.flooded_film_parameter(start.film_parameter, start.fluid);
    // the way back has the error that its condition allows
    const double condition = p.condition();
    EXPECT_TRUE(is_close(sharing.solve(p.flooded).film_parameter, start.film_parameter,
                         condition < 2 ? contract : contract / 2, {},
                         condition < 2 ? 1 : condition))
        << p.text();
  }
}

TEST(LoadSharing, AsperitiesCarryAllAtTheFloorAndLessAbove) {
  Sampler sampler(25);
  int floors = 0;
  for (int i = 0; i < 300; ++i) {
    const Problem p = random_problem(sampler);
    const LoadSharing<double> sharing = p.sharing();
    EXPECT_EQ(sharing.has_floor(), sharing.asperity_share(0) >= 1);
    if (!sharing.has_floor()) {
      EXPECT_EQ(sharing.floor(), 0);
      continue;
    }
    ++floors;
    EXPECT_TRUE(is_close(sharing.asperity_share(sharing.floor()), 1, contract, {})) << p.text();
    EXPECT_LT(sharing.asperity_share(sharing.floor() + 1e-3), 1);
    EXPECT_TRUE(is_close(sharing.floor(), p.sharing<Reference>().floor(), contract, {},
                         1 + (p.offset + 1) / sharing.floor()))
        << p.text();
  }
  EXPECT_GT(floors, 60);
}

// The fluid share is a Taylor series near the floor, and 1 − A beyond, without a step between.
TEST(LoadSharing, FluidShareAboveTheFloorKeepsItsDigits) {
  for (const auto model : asperity_models)
    for (const double stiffness : {2.0, 10.0, 1e6, 1e300}) {
      const LoadSharing<double> sharing(model, stiffness, 1.146);
      const LoadSharing<Reference> exact(model, Reference(stiffness), Reference(1.146));
      for (double distance = 1e-300; distance < 3; distance *= distance < 1e-6 ? 1e5 : 1.07) {
        const LoadShares<double> got = sharing.shares_above_floor(distance);
        // Beyond the series, the share is 1 − A(λ) at the rounded λ = λ_b + distance.
        const double slope = -sharing.asperity_share_slope(got.film_parameter);
        const double condition = got.asperity < 0.75 ? 1 + slope * got.asperity / got.fluid : 1;
        EXPECT_TRUE(is_close(got.fluid, exact.shares_above_floor(Reference(distance)).fluid,
                             contract / 10, {{"K", stiffness}, {"distance", distance}}, condition));
      }
    }
}

// K around 1/F(−δ), where A(0) = 1: ill-conditioned, but a root is always found.
TEST(LoadSharing, CriticalStiffnessIsSolvedOnBothSides) {
  const double critical = 1 / gaussian_moment(Order::five_halves, -1.146);
  for (const double distance : {-1e-3, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-3})
    for (const double lambda0 : {1e-300, 1e-20, 1e-6, 1e-3, 0.1}) {
      const LoadSharing<double> sharing(AsperityModel::greenwood_tripp, critical * (1 + distance),
                                        1.146);
      const LoadShares<double> shares = sharing.solve(lambda0);
      EXPECT_GE(shares.film_parameter, lambda0);
      EXPECT_TRUE(std::isfinite(shares.film_parameter));
      EXPECT_LE(shares.asperity, 1);
      EXPECT_LE(shares.iterations, 100) << describe({{"lambda0", lambda0}, {"off by", distance}});
    }
}

TEST(FilmLaw, RootInDoubleAgreesWithFiftyDigits) {
  Sampler sampler(71);
  for (int i = 0; i < 400; ++i) {
    const Problem p = problem_of_another_law(sampler);
    const LoadShares<double> got = p.sharing().solve(p.flooded);
    const LoadShares<Reference> exact = p.sharing<Reference>().solve(Reference(p.flooded));
    EXPECT_TRUE(is_close(got.film_parameter, exact.film_parameter,
                         load_sharing_contract.ulp_per_condition * 0x1p-52, {}, p.condition()))
        << p.text();
    // w = (λ₀/λ)^{1/(a−b)} has 1/(a−b) times the error of λ; with a − b = 0.01 it may underflow
    if (exact.fluid < Reference("1e-300")) {
      EXPECT_LT(got.fluid, 1e-300) << p.text();
      continue;
    }
    EXPECT_TRUE(is_close(got.fluid, exact.fluid, 1e-14 + 4e-15 / p.law->sharing_power.value, {},
                         p.condition()))
        << p.text();
  }
}

// The residual is ln λ − ln λ₀ + (a−b) ln(1 − A), or −1 where A ≥ 1.
TEST(FilmLaw, ResidualChangesSignAtTheRootAlone) {
  Sampler sampler(72);
  for (int i = 0; i < 200; ++i) {
    Problem p = problem_of_another_law(sampler);
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

// Two surfaces with the same film give the exponent, d ln λ₀/d ln(1−A). λ₀ gives that film.
TEST(FilmLaw, ExponentOfTheFluidShareIsTheLaws) {
  Sampler sampler(75);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    Problem p = problem_of_another_law(sampler);
    const auto soft = p.sharing();
    const double lambda = soft.floor() + sampler.log_uniform(0.01, 3);
    Problem stiffer = p;
    stiffer.stiffness *= 0.5;
    const auto hard = stiffer.sharing();
    const auto fluid = [&](const LoadSharing<double>& s) {
      return s.shares_above_floor(lambda - s.floor()).fluid;
    };
    const double change = std::log(fluid(hard) / fluid(soft));
    if (!(change > 0.01)) continue;
    ++compared;
    p.flooded = soft.flooded_film_parameter(lambda, fluid(soft));
    const double of_hard = hard.flooded_film_parameter(lambda, fluid(hard));
    EXPECT_TRUE(
        is_within(std::log(of_hard / p.flooded) / change, p.law->sharing_power.value, 1e-12))
        << p.text();
    EXPECT_TRUE(is_close(soft.film_parameter(p.flooded), lambda, 1e-14, {},
                         p.condition() / std::min(1.0, p.law->sharing_power.value * 10)))
        << p.text();
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace tribo::verification
