// SPDX-License-Identifier: Apache-2.0
// The report's part on the paper's claims: verification/reproduction.
#pragma once

#include <vector>

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

// Sections on claims and verdicts; on readings and what identifies them; on what would have to be
// true; on how sure the numbers are, with independent numbers; on misprints. One excused section if
// the data cannot be read.
std::vector<Section> ledger_sections(const ReportPlaces& places);

}  // namespace tribo::report
