// SPDX-License-Identifier: Apache-2.0
// The root over the whole range of double: the iteration ends, and no valid input gives NaN.
#include <gtest/gtest.h>

#include <array>

#include "support/judge.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::verification {
namespace {

TEST(LoadSharingStress, ExtremeInputsGiveAFilmBetweenItsBounds) {
  Sampler sampler(31);
  int most_iterations = 0;
  for (int i = 0; i < 30000; ++i) {
    const auto model =
        sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson});
    const double stiffness = sampler.log_uniform(1e-300, 1e300);
    const double offset = sampler.uniform(0, 10);
    const double lambda0 = sampler.log_uniform(1e-300, 1e300);
    const LoadSharing<double> sharing(model, stiffness, offset);
    const LoadShares<double> got = sharing.solve(lambda0);
    const std::string inputs =
        describe({{"K", stiffness}, {"delta", offset}, {"lambda0", lambda0}});
    ASSERT_TRUE(std::isfinite(got.film_parameter)) << inputs;
    ASSERT_GE(got.film_parameter, std::max(lambda0, sharing.floor())) << inputs;
    // At `upper`, w ≤ 1/2 and A ≤ 1/2, as F_p(d) ≤ F_p(0) e^{−d²/2}. So the root lies below.
    const double load = stiffness * gaussian_moment(load_order(model), 0.0) *
                        (model == AsperityModel::greenwood_tripp ? 4 : 2);
    const double upper = std::max(offset + std::sqrt(2 * std::max(0.0, std::log(load))),
                                  std::pow(2, 0.14) * lambda0);
    ASSERT_LE(got.film_parameter, upper * (1 + 1e-13)) << inputs;
    ASSERT_TRUE(is_within(got.asperity, 0.5, 0.5)) << inputs;
    ASSERT_TRUE(is_within(got.fluid, 0.5, 0.5)) << inputs;
    // Next to K F_p(−δ) = 1 the rounding of A may keep the kernels from converging. Newton's method
    // then gives the root.
    const bool is_critical =
        std::abs(stiffness * gaussian_moment(load_order(model), -offset) - 1) < 1e-6;
    const bool is_in_range = lambda0 >= 1e-280 && lambda0 <= 1e280;
    ASSERT_LE(got.iterations, is_in_range && !is_critical ? max_sharing_steps : 80) << inputs;
    most_iterations = std::max(most_iterations, got.iterations);
  }
  RecordProperty("most_iterations", most_iterations);
}

// The offset is so large that λ − δ has no digits left. The shares still lie between 0 and 1.
TEST(LoadSharingStress, AbsurdOffsetsGiveSharesBetweenZeroAndOne) {
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const double offset : {1e10, 1e16, 1e30, 1e150})
      for (double distance = 1e-20; distance < 1e40; distance *= 1e3) {
        const LoadSharing<double> sharing(model, 0.3, offset);
        for (const LoadShares<double>& shares :
             {sharing.shares_above_floor(distance), sharing.solve(distance)}) {
          const std::string inputs = describe({{"delta", offset}, {"distance", distance}});
          ASSERT_TRUE(is_within(shares.asperity, 0.5, 0.5)) << inputs;
          ASSERT_TRUE(is_within(shares.fluid, 0.5, 0.5)) << inputs;
        }
      }
}

TEST(LoadSharingStress, InputsOutsideTheNumbersGiveWhatTheContractSays) {
  const double infinity = std::numeric_limits<double>::infinity();
  const LoadSharing<double> ordinary(AsperityModel::greenwood_tripp, 10.0, 1.0);
  using All = std::array<double, 4>;
  const auto all = [](const auto& got) {
    return All{static_cast<double>(got.film_parameter), static_cast<double>(got.asperity),
               static_cast<double>(got.fluid), static_cast<double>(got.iterations)};
  };
  EXPECT_EQ(all(ordinary.solve(infinity)), (All{infinity, 0, 1, 0}));
  EXPECT_TRUE(std::isnan(ordinary.solve(std::nan("")).film_parameter));
  const LoadSharing<double> endless(AsperityModel::greenwood_tripp, infinity, 1.0);
  EXPECT_EQ(all(endless.solve(1.0)), (All{infinity, 1, 0, 0}));
  const LoadSharing<long double> wide(AsperityModel::greenwood_tripp, infinity, 1.0L);
  EXPECT_EQ(all(wide.solve(1.0L)), (All{infinity, 1, 0, 0}));
  EXPECT_EQ(all(wide.solve(infinity)), (All{infinity, 0, 1, 0}));
  const LoadSharing<double> unknown(AsperityModel::greenwood_tripp, std::nan(""), 1.0);
  EXPECT_TRUE(std::isnan(unknown.solve(1.0).film_parameter));
  const LoadSharing<double> none(AsperityModel::greenwood_tripp, 0.0, 1.0);
  EXPECT_EQ(none.solve(0.3).film_parameter, 0.3);
  for (const double least : {std::numeric_limits<double>::denorm_min(), 1e-310}) {
    const LoadShares<double> shares =
        LoadSharing<double>(AsperityModel::greenwood_williamson, 0.1, 0.0).solve(least);
    EXPECT_TRUE(shares.film_parameter >= least && shares.film_parameter < 2 * least);
  }
}

}  // namespace
}  // namespace tribo::verification
