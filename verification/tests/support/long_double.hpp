// SPDX-License-Identifier: Apache-2.0
// Doubles held against long double, for checks that look at too many points for fifty digits. The
// model's templates in long double are themselves held by `model_stress` and the certified tables.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/condition.hpp"
#include "support/judge.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::verification {

// |got − expected| in units in the last place of the expected, one subnormal unit at least; 0 where
// both are NaN, or both past the largest.
inline double ulps_off(double got, long double expected) {
  const auto nearest = static_cast<double>(expected);
  if (got == nearest && !std::isfinite(got)) return 0;
  if (std::isnan(got) && std::isnan(nearest)) return 0;
  if (!std::isfinite(got) || !std::isfinite(nearest))
    return std::numeric_limits<double>::infinity();
  const int exponent = nearest == 0 ? -1074 : std::max(std::ilogb(nearest) - 52, -1074);
  return static_cast<double>(
      std::ldexp(std::fabs(static_cast<long double>(got) - expected), -exponent));
}

// The error in ulp, and what is allowed of it.
inline testing::AssertionResult is_within_ulp(double got, long double expected, double allowed,
                                              std::initializer_list<Input> inputs) {
  const double error = ulps_off(got, expected);
  record_part_of_bound(error == 0 ? 0 : error / allowed);
  if (error <= allowed) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << describe(inputs)
         << fmt::format(
                "\n  expected {:.24g}\n  got      {} ({:a})\n  error {:.4g} ulp, allowed "
                "{:.4g}; missed by a factor {:.3g}",
                expected, got, got, error, allowed, error / allowed);
}

// Compares a root with the root in long double; load_sharing_contract and a further relative error
// `beside` are allowed.
inline testing::AssertionResult is_root(double got, AsperityModel model, double stiffness,
                                        double offset, double flooded,
                                        const LoadShares<long double>& truth, double beside = 0) {
  const auto expected = truth.film_parameter;
  const double own =
      beside == 0 ? 0
                  : static_cast<double>(std::ldexp(beside * expected, 52 - std::ilogb(expected)));
  double allowed = std::max(load_sharing_contract.ulp, load_sharing_contract.ulp_per_condition);
  // The condition, at least 1, takes more time than the root.
  if (!(ulps_off(got, expected) <= load_sharing_contract.ulp) && std::isfinite(got))
    allowed *= root_condition(model, static_cast<long double>(offset), truth);
  return is_within_ulp(got, expected, allowed + own,
                       {{"model", static_cast<double>(model)},
                        {"K", stiffness},
                        {"delta", offset},
                        {"lambda0", flooded}});
}

// The root in long double from a double near it, by Newton's steps on the convex A + w − 1. The
// relative error of the first step is about that of `near`, and the third step is below the
// resolution of long double.
inline LoadShares<long double> refined_root(const LoadSharing<long double>& sharing,
                                            double flooded_film_parameter, double near) {
  const auto lambda0 = static_cast<long double>(flooded_film_parameter);
  constexpr long double p = 50.0L / 7;
  long double lambda = near, share = 0, fluid = 0;
  for (int i = 0; i < 3; ++i) {
    share = sharing.asperity_share(lambda);
    const long double less_one = std::expm1(p * std::log(lambda0 / lambda));
    fluid = 1 + less_one;
    const long double slope = p * fluid - share * sharing.asperity_share_slope(lambda);
    const long double step = (share + less_one) / slope;
    lambda += lambda * step;
    if (std::fabs(step) < 1e-11L) break;
  }
  return {lambda, share, fluid, 0};
}

}  // namespace tribo::verification
