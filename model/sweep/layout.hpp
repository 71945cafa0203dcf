// SPDX-License-Identifier: Apache-2.0
// What follows from a sweep's settings: its columns, and how its cases are cut into chunks.
#pragma once

#include <array>
#include <string_view>

#include "sweep/plan.hpp"

namespace tribo::sweep {

// The columns of a solved film, in their order; `solved_film.` stands before their names.
struct SolvedColumn {
  std::string_view name, unit, meaning;
};
inline constexpr std::array<SolvedColumn, 6> solved_columns{{
    {"load_number", "", "M = W(2U)^(-1/2)"},
    {"material_number", "", "L = G(2U)^(1/4)"},
    {"central", "m", "film in the middle of the contact, solved; undefined where that failed"},
    {"central_error", "m", "what the solved central film may be off by"},
    {"minimum", "m", "least film, solved; undefined where that failed"},
    {"minimum_error", "m", "what the solved least film may be off by"},
}};

// Fills columns, grid_cells, groups, chunk_groups and chunks.
void lay_out(SceneSweep& sweep);

}  // namespace tribo::sweep
