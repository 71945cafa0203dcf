// SPDX-License-Identifier: Apache-2.0
// The layout of a sweep, from its settings: its columns, and how its cases are cut into chunks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "sweep/plan.hpp"

namespace tribo::sweep {

// The outcome of a film that was to be solved: the words of the column `outcome`.
enum class SolvedOutcome : std::uint8_t { solved, tolerance_missed, not_solved };
inline constexpr std::array<std::string_view, 3> solved_outcome_words{"solved", "tolerance_missed",
                                                                      "not_solved"};

// The columns of a solved film, in their order; `solved_film.` stands before their names.
struct SolvedColumn {
  std::string_view name, unit, meaning;
  bool is_of_words = false;  // solved_outcome_words
};
inline constexpr std::array<SolvedColumn, 7> solved_columns{{
    {"load_number", "", "M = W(2U)^(-1/2)"},
    {"material_number", "", "L = G(2U)^(1/4)"},
    {"central", "m", "film in the middle of the contact, solved; undefined where that failed"},
    {"central_error", "m", "what the solved central film may be off by"},
    {"minimum", "m", "least film, solved; undefined where that failed"},
    {"minimum_error", "m", "what the solved least film may be off by"},
    {"outcome", "",
     "whether the film was solved to the tolerance of 1e-4, to a larger error, or not at all; "
     "`tribocheck film` says why of one contact",
     true},
}};

// Fills columns, grid_cells, groups, chunk_groups and chunks.
void lay_out(SceneSweep& sweep);

}  // namespace tribo::sweep
