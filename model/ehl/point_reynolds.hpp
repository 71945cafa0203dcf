// SPDX-License-Identifier: Apache-2.0
// The balance of the liquid's mass around the nodes of a plane grid: what flows out of each node's
// surroundings, less what flows in, for 1 of breadth along Y, and its derivatives.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "ehl/plane_grid.hpp"
#include "ehl/point_contact.hpp"

namespace tribo::ehl {

// How the balance at node (i, j) changes with film and pressure at the nodes (i − 2, j), (i − 1,
// j), (i, j), (i + 1, j), (i, j − 1) and (i, j + 1). The nodes below Y = 0 mirror those above.
struct PlaneSlopes {
  std::array<double, 6> by_film{}, by_pressure{};
};

struct PlaneBalance {
  Eigen::VectorXd surplus;          // of each node; 0 at the ends, but for a starved inlet
  Eigen::VectorXd diffusion;        // the surplus that 1 of pressure at the node drives out of it
  std::vector<PlaneSlopes> slopes;  // of each node
};

// Second order. The film that is dragged between two nodes is extrapolated from the two nodes
// before, so that films do not waver where pressure drives nothing (reynolds.hpp). `slopes` stay
// empty if they are not asked for. At the inlet end of a starved contact the balance is what leaves
// the node less H_oil. `missing`, for starved contacts: what each node lacks of the liquid that a
// full gap would drag to the next one.
PlaneBalance balance_of(const PointContact& contact, const PlaneGrid& grid,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& film,
                        const Eigen::VectorXd& missing, bool with_slopes = true);

// The liquid that is missing in a gap: `missing` where there is pressure, elsewhere so much that no
// surplus is left.
Eigen::VectorXd missing_in(const PlaneGrid& grid, const Eigen::VectorXd& pressure,
                           const PlaneBalance& balance_of_full_gap, Eigen::VectorXd missing);

}  // namespace tribo::ehl
