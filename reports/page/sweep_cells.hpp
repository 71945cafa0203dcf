// SPDX-License-Identifier: Apache-2.0
// The results of a sweep that crosses grids with distributions, separately for each set of grid
// values; the summaries of a scene are over all sets together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sweep/result_file.hpp"

namespace tribo::report {

// One set of grid values.
struct SweepCell {
  std::string where;                         // "load 50 N, friction.fluid eyring"
  std::vector<sweep::ColumnResult> columns;  // as the scene's, but of these cases only
};

struct SweepCells {
  std::uint64_t count = 1;       // sets of grid values that the scene's summaries are over
  std::vector<SweepCell> cells;  // empty: one set, too many, or the cases are not kept
};

inline constexpr std::uint64_t most_sweep_cells = 50;

// From the kept cases of the result. Throws std::runtime_error, as ResultFile does.
SweepCells cells_of(const sweep::SceneResult& scene, const sweep::ResultFile& file);

}  // namespace tribo::report
