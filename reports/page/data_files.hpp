// SPDX-License-Identifier: Apache-2.0
// The report's data as tab-separated text: units and provenance in a commented header, every number
// written so that it reads back to the same double, no dates.
#pragma once

#include <vector>

#include "page/comparison.hpp"
#include "page/data_file.hpp"
#include "page/findings.hpp"

namespace tribo::report {

std::vector<DataFile> data_files(const Findings& findings,
                                 const std::vector<ComparisonTable>& tables);

}  // namespace tribo::report
