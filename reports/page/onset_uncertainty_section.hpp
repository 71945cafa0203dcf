// SPDX-License-Identifier: Apache-2.0
// How sure the paper's onset speeds are: the shipped sweeps, run while the report is made.
#pragma once

#include "page/project_files.hpp"
#include "page/section.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::report {

// Leaves the result in sweep/ of the report's folder.
Section onset_uncertainty_section(const ReportPlaces& places, const reproduction::Ledger& ledger);

}  // namespace tribo::report
