// SPDX-License-Identifier: Apache-2.0
// The report's part on speed: what the paper's scenes need not compute, counted anew, and the
// fastest way of each family as `make work-precision` measured it.
#pragma once

#include <vector>

#include "report/project_files.hpp"
#include "report/solved_case.hpp"
#include "report/text_table.hpp"

namespace tribo::report {

std::vector<TextTable> performance_tables(const ReportPlaces& places,
                                          const std::vector<SolvedCase>& solved);

}  // namespace tribo::report
