// SPDX-License-Identifier: Apache-2.0
// The balance of the liquid's mass between nodes: what flows out of each node's surroundings, less
// what flows in, and its derivatives. It is 0 where there is pressure. Where the film has broken
// there is no pressure, and more flows out than in.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <span>
#include <vector>

#include "ehl/line_contact.hpp"

namespace tribo::ehl {

// How the balance at a node changes with the film and with the pressure at the two nodes before it,
// at itself and at the next one.
struct BalanceSlopes {
  std::array<double, 4> by_film{}, by_pressure{};
};

struct Balance {
  Eigen::VectorXd surplus;            // of each node; 0 at both ends
  Eigen::VectorXd flow;               // of mass between a node and the next: one fewer than nodes
  Eigen::VectorXd diffusion;          // the surplus that 1 of pressure at the node drives out of it
  std::vector<BalanceSlopes> slopes;  // of each node
};

// Second order on grids whose spacing changes slowly. The film that is dragged between two nodes is
// extrapolated from the two nodes before, so that films do not waver where the liquid is so viscous
// that pressure drives none of it. The mean of 1/η̄ between nodes is that of a linear ln η̄. `slopes`
// stay empty if they are not asked for.
Balance balance_of(const LineContact& contact, std::span<const double> x,
                   const Eigen::VectorXd& pressure, const Eigen::VectorXd& film,
                   bool with_slopes = true);

}  // namespace tribo::ehl
