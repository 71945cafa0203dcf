// SPDX-License-Identifier: Apache-2.0
// The report's part on what a scene does not ask for, counted anew by the model's work counters.
#pragma once

#include <vector>

#include "page/section.hpp"
#include "page/solved_case.hpp"

namespace tribo::report {

Section skipped_work_section(const std::vector<SolvedCase>& solved);

}  // namespace tribo::report
