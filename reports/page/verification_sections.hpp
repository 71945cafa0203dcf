// SPDX-License-Identifier: Apache-2.0
// The report's parts on verification: the model against the certified tables, computed anew, and
// what the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

Section certified_section(const ReportPlaces& places);
Section worst_inputs_section(const ReportPlaces& places);
Section planted_faults_section(const ReportPlaces& places);

}  // namespace tribo::report
