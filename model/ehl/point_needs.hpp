// SPDX-License-Identifier: Apache-2.0
// Grids, memory and time that a point contact will take, estimated before it is solved.
#pragma once

#include <string>

#include "ehl/solved_point.hpp"

namespace tribo::ehl {

struct PointNeeds {
  std::string reason;  // why solve_point_film() refuses the contact; else empty
  // An error needs three grids at least; the tolerance may ask for the others.
  int least_grids = 3, most_grids = 3;
  PlaneGrid coarsest{};
  Eigen::Index most_nodes = 0;  // of a finest grid, which may have to be longer than the first

  PlaneGrid finest(int grids) const;  // the last of `grids` grids
};
PointNeeds needs_of(const PointContact& contact, const PointOptions& options = {});

// The greatest memory, in bytes, of a solution whose finest grid has so many nodes, as measured by
// `make point-survey`. Nearly all of it is the preconditioner's factors, whose bytes for each node
// grow a little with the grid; small grids take less.
double point_memory(Eigen::Index nodes);
// Seconds of one core; for a starved contact they include its flooded film. On the machine that ran
// `make point-survey`, nine in ten of its 200 contacts took 0.6 to 1.7 times as long, and all took
// 0.25 to 3.5 times as long.
double point_seconds(const PointContact& contact, Eigen::Index nodes);

}  // namespace tribo::ehl
