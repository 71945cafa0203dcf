// SPDX-License-Identifier: Apache-2.0
// Numbers computed of the published scenes beside those that the paper reports.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/solved_case.hpp"
#include "reproduction/claims.hpp"

namespace tribo::report {

struct ComparisonRow {
  reproduction::Quantity quantity;
  std::string_view surface;
  std::string_view model;           // GT, GW
  std::string_view criterion;       // criterion of onset, or empty
  std::optional<double> computed;   // empty: there is no such onset
  std::string_view none;            // why there is no number
  const reproduction::Item* claim;  // the paper's claim; null: the paper has no number

  std::optional<double> factor() const;  // computed/reported
  std::optional<reproduction::Verdict> verdict() const;
};

// Onset speeds, film parameters at the onset, asperity shares at the lowest speed. The rows point
// into `claims`.
std::vector<ComparisonRow> compare(const std::vector<SolvedCase>& solved,
                                   const std::vector<reproduction::Item>& claims);

// The number that the paper prints of this quantity; null where it prints none.
const reproduction::Item* reported(const std::vector<reproduction::Item>& claims,
                                   reproduction::Quantity quantity, const Case& source);

}  // namespace tribo::report
