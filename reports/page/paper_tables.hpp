// SPDX-License-Identifier: Apache-2.0
// What is computed beside what the paper reports, and the inputs, as tables of the report.
#pragma once

#include <vector>

#include "page/comparison.hpp"
#include "page/solved_case.hpp"
#include "page/text_table.hpp"

namespace tribo::report {

TextTable text_table(const ComparisonTable& comparison);
TextTable inputs_table(const std::vector<SolvedCase>& solved);

}  // namespace tribo::report
