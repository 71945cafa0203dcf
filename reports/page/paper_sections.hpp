// SPDX-License-Identifier: Apache-2.0
// The report's parts on the paper: its figures redrawn, its numbers beside ours, and the scenes.
#pragma once

#include <vector>

#include "page/comparison.hpp"
#include "page/findings.hpp"
#include "page/section.hpp"

namespace tribo::report {

Section figures_section(const Findings& findings, const std::vector<ComparisonTable>& comparisons);
Section comparison_section(const Findings& findings,
                           const std::vector<ComparisonTable>& comparisons);
Section inputs_section(const Findings& findings);

}  // namespace tribo::report
