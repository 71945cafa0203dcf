// SPDX-License-Identifier: Apache-2.0
// The report's part on the gates of speed: what they found of the same program twice and of planted
// work, and the baseline that they hold.
#pragma once

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

Section gates_section(const ReportPlaces& places);

}  // namespace tribo::report
