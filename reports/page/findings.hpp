// SPDX-License-Identifier: Apache-2.0
// All that the report tells of.
#pragma once

#include <string_view>
#include <vector>

#include "page/reported.hpp"
#include "page/two_slopes.hpp"

namespace tribo::report {

// What was computed, and what it is held against.
struct Findings {
  std::vector<SolvedCase> solved;
  TwoSlopes slopes;
  ReportedValues reported;

  const SolvedCase& gt(std::string_view surface) const {
    return find_solved(solved, surface, AsperityModel::greenwood_tripp);
  }
  const SolvedCase& gw(std::string_view surface) const {
    return find_solved(solved, surface, AsperityModel::greenwood_williamson);
  }
};

}  // namespace tribo::report
