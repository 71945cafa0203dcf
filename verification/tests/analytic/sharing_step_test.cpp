// SPDX-License-Identifier: Apache-2.0
// The step by which the engine reaches the root of load sharing, written anew in 50 digits
// (model/src/load_sharing-inl.hpp has it in double). The step is of fourth order, and its error is
// never greater than the estimate that tells the engine to stop.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/judge.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::verification {
namespace {

struct Problem {
  AsperityModel model;
  double stiffness, offset, flooded;
};

struct Step {
  Reference log_rise;  // ln(λ/λ₀) after the step
  Reference estimate;  // of the step's error
  bool is_trusted;     // is it short enough for the estimate to hold?
};

// The step from y = ln(λ/λ₀).
Step step_from(const Problem& problem, const Reference& y) {
  const Order order = load_order(problem.model);
  const Reference q = sharing_exponent<Reference>(problem.model), p = Reference(50) / 7;
  const Reference lambda = problem.flooded * exp(y), d = lambda - problem.offset;
  const Reference n = Reference(twice(order)) / 2;
  const Reference moment = gaussian_moment(order, d);
  const Reference h =
      n * gaussian_moment(order == Order::five_halves ? Order::three_halves : Order::half, d) /
      moment;
  const Reference slope = h * h - d * h - n, bend = (2 * h - d) * slope - h;
  const Reference share = pow(problem.stiffness * moment, q), w = exp(-p * y);
  const Reference a = q * h * lambda, b = a + q * slope * lambda * lambda;
  const Reference c = a + 3 * (b - a) + q * bend * lambda * lambda * lambda;
  const bool by_floor = share > w && a * share > p * (1 - share);
  const Reference r = by_floor ? w / (1 - w) : share / (1 - share);
  // g = ln(1 − e^−V) + W. V and W are −ln A and py, or by the floor py and −ln A
  const Reference v1 = by_floor ? p : a, v2 = by_floor ? 0 : b, v3 = by_floor ? 0 : c;
  const Reference w1 = by_floor ? a : p, w2 = by_floor ? b : 0, w3 = by_floor ? c : 0;
  const Reference s = v1 * (1 + r);
  const Reference g = by_floor ? log((1 - w) / share) : p * y + log(1 - share);
  const Reference g1 = w1 + r * v1, g2 = w2 + r * (v2 - s * v1);
  const Reference g3 = w3 + r * (v3 - 3 * s * v2 + (1 + 2 * r) * s * v1 * v1);
  const Reference newton = -g / g1, t = newton * g2 / (2 * g1);
  const Reference reach = newton * (1 + s);
  return {y + newton * (1 - t + 2 * t * t - newton * newton * g3 / (6 * g1)),
          reach * reach * newton * newton * (w2 + r * (v2 + s * v1)) / g1,
          reach * reach < Reference(1) / 16};
}

// Steps from both sides of roots, near and far, on ordinary surfaces and on extreme ones.
TEST(SharingStep, IsOffByLessThanItsEstimateSays) {
  Sampler sampler(61);
  int trusted = 0;
  for (int i = 0; i < 500; ++i) {
    const bool ordinary = i % 2 == 0;
    const Problem problem{
        sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson}),
        ordinary ? sampler.log_uniform(1e-6, 10) : sampler.log_uniform(1e-30, 1e30),
        ordinary ? sampler.uniform(0, 3) : sampler.uniform(0, 40), sampler.log_uniform(1e-4, 50)};
    const LoadSharing<Reference> sharing(problem.model, Reference(problem.stiffness),
                                         Reference(problem.offset));
    const Reference root =
        log(Reference(sharing.solve(Reference(problem.flooded)).film_parameter / problem.flooded));
    for (int k = 0; k < 8; ++k) {
      const double distance = sampler.log_uniform(1e-6, 0.5) * sampler.pick({-1, 1});
      if (root + distance < 0) continue;
      const Step step = step_from(problem, Reference(root + distance));
      if (!step.is_trusted || step.estimate < Reference("1e-40")) continue;
      ++trusted;
      EXPECT_TRUE(is_within(static_cast<double>((step.log_rise - root) / step.estimate), 0, 1))
          << describe({{"K", problem.stiffness},
                       {"delta", problem.offset},
                       {"lambda0", problem.flooded},
                       {"distance", distance}});
    }
  }
  EXPECT_GT(trusted, 1000);
}

}  // namespace
}  // namespace tribo::verification
