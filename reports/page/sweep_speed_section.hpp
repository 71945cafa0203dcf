// SPDX-License-Identifier: Apache-2.0
// The report's part on the speed of sweeps, from reference/baselines/sweep.json.
#pragma once

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

Section sweep_speed_section(const ReportPlaces& places);

}  // namespace tribo::report
