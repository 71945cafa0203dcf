// SPDX-License-Identifier: Apache-2.0
// What follows from a sweep's settings: its columns, and how its cases are cut into chunks.
#pragma once

#include "sweep/plan.hpp"

namespace tribo::sweep {

// Fills columns, grid_cells, groups, chunk_groups and chunks.
void lay_out(SceneSweep& sweep);

}  // namespace tribo::sweep
