// SPDX-License-Identifier: Apache-2.0
// The report's part on the paper's claims: verification/reproduction.
#pragma once

#include <vector>

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

// Claims and verdicts; readings and what identifies them; what would have to be true; how sure;
// misprints and independent numbers. Excused where its data cannot be read.
std::vector<Section> ledger_sections(const ReportPlaces& places);

}  // namespace tribo::report
