// SPDX-License-Identifier: Apache-2.0
// The load-sharing root: from λ₀ to λ and back, the floor, and films near the floor.
// film_law_test.cpp has the signs of the residual; certified and contract hold the root's value.
#include "tribo/load_sharing.hpp"

#include <gtest/gtest.h>

#include "support/condition.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

constexpr double contract = 1e-13;  // load_sharing.hpp, at a condition below 2

struct Problem {
  AsperityModel model;
  double stiffness, offset, flooded;
};

Problem random_problem(Sampler& sampler) {
  return {sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson}),
          sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3), sampler.log_uniform(1e-4, 100)};
}

TEST(LoadSharing, FilmToFloodedFilmAndBackIsTheSame) {
  Sampler sampler(24);
  for (int i = 0; i < 3000; ++i) {
    const Problem p = random_problem(sampler);
    const LoadSharing<double> sharing(p.model, p.stiffness, p.offset);
    const LoadShares<double> start =
        sharing.shares_above_floor(sampler.log_uniform(1e-6, 50) * (1 + sharing.floor()));
    if (start.fluid < 1e-12) continue;
    const double lambda0 = sharing.flooded_film_parameter(start.film_parameter, start.fluid);
    // the way back is as exact as its condition allows
    const double condition = root_condition(p.model, p.stiffness, p.offset, lambda0);
    EXPECT_TRUE(is_close(sharing.solve(lambda0).film_parameter, Reference(start.film_parameter),
                         condition < 2 ? contract : contract / 2,
                         {{"K", p.stiffness}, {"delta", p.offset}, {"lambda0", lambda0}},
                         condition < 2 ? 1 : condition));
  }
}

TEST(LoadSharing, AsperitiesCarryAllAtTheFloorAndLessAbove) {
  Sampler sampler(25);
  int floors = 0;
  for (int i = 0; i < 300; ++i) {
    const Problem p = random_problem(sampler);
    const LoadSharing<double> sharing(p.model, p.stiffness, p.offset);
    EXPECT_EQ(sharing.has_floor(), sharing.asperity_share(0) >= 1);
    if (!sharing.has_floor()) {
      EXPECT_EQ(sharing.floor(), 0);
      continue;
    }
    ++floors;
    EXPECT_TRUE(is_close(sharing.asperity_share(sharing.floor()), Reference(1), contract,
                         {{"K", p.stiffness}, {"delta", p.offset}}));
    EXPECT_LT(sharing.asperity_share(sharing.floor() + 1e-3), 1);
    const LoadSharing<Reference> exact(p.model, Reference(p.stiffness), Reference(p.offset));
    EXPECT_TRUE(is_close(sharing.floor(), exact.floor(), contract,
                         {{"K", p.stiffness}, {"delta", p.offset}},
                         1 + (p.offset + 1) / sharing.floor()));
  }
  EXPECT_GT(floors, 60);
}

// The share comes from a Taylor series near the floor, and from 1 − A beyond: no step between them.
TEST(LoadSharing, FluidShareAboveTheFloorKeepsItsDigits) {
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const double stiffness : {2.0, 10.0, 1e6, 1e300}) {
      const LoadSharing<double> sharing(model, stiffness, 1.146);
      const LoadSharing<Reference> exact(model, Reference(stiffness), Reference(1.146));
      for (double distance = 1e-300; distance < 3; distance *= distance < 1e-6 ? 1e5 : 1.07) {
        const LoadShares<double> got = sharing.shares_above_floor(distance);
        // Beyond the series 1 − A(λ) is taken at the rounded λ = λ_b + distance.
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

}  // namespace
}  // namespace tribo::verification
