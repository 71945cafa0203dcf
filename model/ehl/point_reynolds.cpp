// SPDX-License-Identifier: Apache-2.0
#include "ehl/point_reynolds.hpp"

#include <cmath>

#include "ehl/liquid_flow.hpp"

namespace tribo::ehl {
namespace {

// The weights, in the middle between node i and the next one, of nodes i − 1, i and i + 1.
std::array<double, 3> upstream_weights(int i) {
  if (i == 0) return {0, 0.5, 0.5};
  return {-0.5, 1.5, 0};
}

}  // namespace

PlaneBalance balance_of(const PointContact& contact, const PlaneGrid& grid,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& film,
                        const Eigen::VectorXd& missing, bool with_slopes) {
  const double wedge = numbers_of(contact).wedge;
  const int nx = grid.count_x(), ny = grid.count_y();
  std::vector<LiquidAtNode> liquid(static_cast<std::size_t>(grid.size()));
  for (Eigen::Index n = 0; n < grid.size(); ++n)
    liquid[static_cast<std::size_t>(n)] = liquid_at(contact.fluid, pressure[n]);
  const auto at = [&](Eigen::Index n) -> const LiquidAtNode& {
    return liquid[static_cast<std::size_t>(n)];
  };
  PlaneBalance balance{.surplus = Eigen::VectorXd::Zero(grid.size()),
                       .diffusion = Eigen::VectorXd::Zero(grid.size()),
                       .slopes = {}};
  if (with_slopes) balance.slopes.resize(static_cast<std::size_t>(grid.size()));

  for (int j = 0; j + 1 < ny; ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      // Along X, out of node (i, j) into the next one.
      const Eigen::Index here = grid.node(i, j), next = here + 1;
      const std::array<double, 3> weight = upstream_weights(i);
      const DrivenFlow driven = driven_flow(at(here), at(next), film[here], film[next],
                                            pressure[next] - pressure[here], grid.dx, wedge);
      double flow = driven.value;
      std::array<double, 3> by_film{0, driven.by_film[0], driven.by_film[1]},
          by_pressure{0, driven.by_pressure[0], driven.by_pressure[1]};
      for (int k = 0; k < 3; ++k) {
        const auto place = static_cast<std::size_t>(k);
        if (weight[place] == 0) continue;
        const Eigen::Index node = here + k - 1;
        flow += weight[place] * at(node).density * film[node];
        by_film[place] += weight[place] * at(node).density;
        by_pressure[place] += weight[place] * at(node).density_slope * film[node];
      }
      for (const bool is_out : {true, false}) {
        const int column = is_out ? i : i + 1;
        const bool is_inlet = column == 0 && contact.is_starved();
        if (!grid.is_inside(column, j) && !is_inlet) continue;
        const Eigen::Index node = is_out ? here : next;
        const double sign = is_out ? 1 : -1;
        balance.surplus[node] += sign * flow;
        balance.diffusion[node] += driven.diffusion;
        if (!with_slopes) continue;
        PlaneSlopes& slopes = balance.slopes[static_cast<std::size_t>(node)];
        for (std::size_t k = 0; k < 3; ++k) {
          slopes.by_film[k + (is_out ? 1 : 0)] += sign * by_film[k];
          slopes.by_pressure[k + (is_out ? 1 : 0)] += sign * by_pressure[k];
        }
      }
    }

  // Along Y, out of node (i, j) into (i, j + 1), for 1 of breadth.
  const double breadth = grid.dx / grid.dy;
  for (int j = 0; j + 1 < ny; ++j)
    for (int i = 1; i + 1 < nx; ++i) {
      const Eigen::Index here = grid.node(i, j), next = grid.node(i, j + 1);
      const DrivenFlow driven = driven_flow(at(here), at(next), film[here], film[next],
                                            pressure[next] - pressure[here], grid.dy, wedge);
      for (const bool is_out : {true, false}) {
        if (!grid.is_inside(i, is_out ? j : j + 1)) continue;
        const Eigen::Index node = is_out ? here : next;
        // As much flows out of the nodes on Y = 0 on the other side.
        const double factor = breadth * (is_out ? (j == 0 ? 2 : 1) : -1);
        balance.surplus[node] += factor * driven.value;
        balance.diffusion[node] += std::fabs(factor) * driven.diffusion;
        if (!with_slopes) continue;
        PlaneSlopes& slopes = balance.slopes[static_cast<std::size_t>(node)];
        const std::size_t of_here = is_out ? 2 : 4, of_next = is_out ? 5 : 2;
        slopes.by_film[of_here] += factor * driven.by_film[0];
        slopes.by_film[of_next] += factor * driven.by_film[1];
        slopes.by_pressure[of_here] += factor * driven.by_pressure[0];
        slopes.by_pressure[of_next] += factor * driven.by_pressure[1];
      }
    }
  if (contact.source)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = contact.is_starved() ? 0 : 1; i + 1 < nx; ++i)
        balance.surplus[grid.node(i, j)] -= contact.source(grid.x(i), grid.y(j));
  if (!contact.is_starved()) return balance;
  for (int j = 0; j + 1 < ny; ++j) {
    balance.surplus[grid.node(0, j)] -= contact.inlet_film + missing[grid.node(0, j)];
    for (int i = 1; i + 1 < nx; ++i)
      balance.surplus[grid.node(i, j)] += missing[grid.node(i - 1, j)] - missing[grid.node(i, j)];
  }
  return balance;
}

Eigen::VectorXd missing_in(const PlaneGrid& grid, const Eigen::VectorXd& pressure,
                           const PlaneBalance& balance_of_full_gap, Eigen::VectorXd missing) {
  for (int j = 0; j + 1 < grid.count_y(); ++j) {
    double before = 0;
    for (int i = 0; i + 1 < grid.count_x(); ++i) {
      const Eigen::Index node = grid.node(i, j);
      if (!(pressure[node] > 0))
        missing[node] = std::fmax(balance_of_full_gap.surplus[node] + before, 0);
      before = missing[node];
    }
  }
  return missing;
}

}  // namespace tribo::ehl
