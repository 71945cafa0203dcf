// SPDX-License-Identifier: Apache-2.0
#include "ehl/reynolds.hpp"

#include <cstddef>

#include "ehl/liquid_flow.hpp"

namespace tribo::ehl {
namespace {

// The flow between nodes i and i + 1, and its derivatives by film and pressure at the nodes i − 1,
// i and i + 1.
struct Flow {
  double value = 0, diffusion = 0;
  std::array<double, 3> by_film{}, by_pressure{};
};

// The weights of the nodes i − 1, i and i + 1 for a value in the middle between i and i + 1. It is
// extrapolated from the two nodes before it; between the first two nodes it is their mean.
std::array<double, 3> upstream_weights(std::span<const double> x, std::size_t i) {
  if (i == 0) return {0, 0.5, 0.5};
  const double ahead = (x[i + 1] - x[i]) / 2 / (x[i] - x[i - 1]);
  return {-ahead, 1 + ahead, 0};
}

}  // namespace

Balance balance_of(const LineContact& contact, std::span<const double> x,
                   const Eigen::VectorXd& pressure, const Eigen::VectorXd& film, bool with_slopes) {
  const std::size_t count = x.size();
  const double theta = contact.theta();
  std::vector<LiquidAtNode> liquid(count);
  for (std::size_t i = 0; i < count; ++i)
    liquid[i] = liquid_at(contact.fluid, pressure[static_cast<Eigen::Index>(i)]);

  std::vector<Flow> flows(count - 1);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const auto at = [&](std::size_t k) { return static_cast<Eigen::Index>(k); };
    Flow& flow = flows[i];
    const std::array<double, 3> weight = upstream_weights(x, i);
    for (std::size_t k = 0; k < 3; ++k) {
      if (weight[k] == 0) continue;
      const std::size_t j = i + k - 1;
      flow.value += weight[k] * liquid[j].density * film[at(j)];
      flow.by_film[k] = weight[k] * liquid[j].density;
      flow.by_pressure[k] = weight[k] * liquid[j].density_slope * film[at(j)];
    }
    const DrivenFlow driven =
        driven_flow(liquid[i], liquid[i + 1], film[at(i)], film[at(i + 1)],
                    pressure[at(i + 1)] - pressure[at(i)], x[i + 1] - x[i], theta);
    flow.value += driven.value;
    flow.diffusion = driven.diffusion;
    for (std::size_t k = 0; k < 2; ++k) {
      flow.by_film[k + 1] += driven.by_film[k];
      flow.by_pressure[k + 1] += driven.by_pressure[k];
    }
  }

  const auto size = static_cast<Eigen::Index>(count);
  Balance balance{.surplus = Eigen::VectorXd::Zero(size),
                  .flow = Eigen::VectorXd(size - 1),
                  .diffusion = Eigen::VectorXd::Zero(size),
                  .slopes = {}};
  for (std::size_t i = 0; i + 1 < count; ++i)
    balance.flow[static_cast<Eigen::Index>(i)] = flows[i].value;
  if (with_slopes) balance.slopes.resize(count);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Flow &in = flows[i - 1], &out = flows[i];
    const auto row = static_cast<Eigen::Index>(i);
    balance.surplus[row] = out.value - in.value;
    balance.diffusion[row] = out.diffusion + in.diffusion;
    if (!with_slopes) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      balance.slopes[i].by_film[k + 1] += out.by_film[k];
      balance.slopes[i].by_film[k] -= in.by_film[k];
      balance.slopes[i].by_pressure[k + 1] += out.by_pressure[k];
      balance.slopes[i].by_pressure[k] -= in.by_pressure[k];
    }
  }
  return balance;
}

}  // namespace tribo::ehl
