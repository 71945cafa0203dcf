// SPDX-License-Identifier: Apache-2.0
// The summaries of a sweep: for people, as tables; for machines, unrounded.
#pragma once

#include <string>
#include <vector>

#include "page/text_table.hpp"
#include "sweep/result_file.hpp"

namespace tribo::report {

// Of each scene: its numbers, its words, its Sobol indices.
std::vector<TextTable> sweep_tables(const sweep::SweepResult& result);

// A row for each scene, column and speed; what is undefined is empty.
std::string sweep_csv(const sweep::SweepResult& result);

// All there is but the cases themselves; what is undefined, and an unbounded end, is null.
std::string sweep_json(const sweep::SweepResult& result);

}  // namespace tribo::report
