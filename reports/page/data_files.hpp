// SPDX-License-Identifier: Apache-2.0
// The numbers of the paper's figures as tab-separated files, from which gnuplot draws them.
#pragma once

#include <vector>

#include "page/comparison.hpp"
#include "page/data_file.hpp"
#include "page/two_slopes.hpp"

namespace tribo::report {

std::vector<DataFile> data_files(const std::vector<SolvedCase>& solved, const TwoSlopes& slopes,
                                 const std::vector<reproduction::Item>& claims,
                                 const std::vector<ComparisonRow>& rows);

}  // namespace tribo::report
