// SPDX-License-Identifier: Apache-2.0
#include "ehl/reynolds.hpp"

#include <cmath>
#include <cstddef>

namespace tribo::ehl {
namespace {

// The mean of e^{−y} for y from a to b, and its derivatives.
struct MeanFluidity {
  double value, by_first, by_second;
};

MeanFluidity mean_fluidity(double a, double b) {
  const double half = (b - a) / 2;
  const double middle = std::exp(-(a + b) / 2);
  double s, slope;  // sinh(d)/d and its derivative
  if (std::fabs(half) < 1e-2) {
    const double square = half * half;
    s = 1 + square / 6 * (1 + square / 20);
    slope = half / 3 * (1 + square / 10);
  } else {
    s = std::sinh(half) / half;
    slope = (std::cosh(half) - s) / half;
  }
  return {middle * s, -middle * (s + slope) / 2, -middle * (s - slope) / 2};
}

// The liquid at a node.
struct Liquid {
  double log_viscosity, log_viscosity_slope, density, density_slope;
};

Liquid liquid_at(const Fluid& fluid, double p) {
  return {fluid.log_viscosity(p), fluid.log_viscosity_slope(p), fluid.density(p),
          fluid.density_slope(p)};
}

// The flow between nodes i and i + 1, and its derivatives by film and pressure at the nodes i − 1,
// i and i + 1.
struct Flow {
  double value = 0, diffusion = 0;
  std::array<double, 3> by_film{}, by_pressure{};
};

// The weights, in the middle between two nodes, of the two nodes before it and of the next one.
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
  std::vector<Liquid> liquid(count);
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
    const Liquid &here = liquid[i], &next = liquid[i + 1];
    const double cell = x[i + 1] - x[i];
    const double middle_film = (film[at(i)] + film[at(i + 1)]) / 2;
    const double density = (here.density + next.density) / 2;
    const MeanFluidity fluidity = mean_fluidity(here.log_viscosity, next.log_viscosity);
    const double cube = middle_film * middle_film * middle_film / theta;
    const double slope = (pressure[at(i + 1)] - pressure[at(i)]) / cell;
    const double conductance = density * cube * fluidity.value;
    flow.value -= conductance * slope;
    flow.diffusion = conductance / cell;
    const double by_film = 1.5 * conductance / middle_film * slope;
    flow.by_film[1] -= by_film;
    flow.by_film[2] -= by_film;
    const double by_fluidity = density * cube * slope, by_density = cube * fluidity.value * slope;
    flow.by_pressure[1] += flow.diffusion -
                           by_fluidity * fluidity.by_first * here.log_viscosity_slope -
                           by_density * here.density_slope / 2;
    flow.by_pressure[2] -= flow.diffusion +
                           by_fluidity * fluidity.by_second * next.log_viscosity_slope +
                           by_density * next.density_slope / 2;
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
