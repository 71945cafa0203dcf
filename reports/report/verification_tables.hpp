// SPDX-License-Identifier: Apache-2.0
// The report's part on verification: the model against the certified tables, computed anew, and
// what the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include <vector>

#include "report/project_files.hpp"
#include "report/text_table.hpp"

namespace tribo::report {

// One table each. A result that is not there, or cannot be read, is a table without rows whose note
// says how to make it.
std::vector<TextTable> verification_tables(const ReportPlaces& places);

}  // namespace tribo::report
