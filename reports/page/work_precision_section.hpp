// SPDX-License-Identifier: Apache-2.0
// The report's part on speed beside true error, from reference/baselines/work_precision.json.
#pragma once

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

Section work_precision_section(const ReportPlaces& places);

}  // namespace tribo::report
