// SPDX-License-Identifier: Apache-2.0
// What is computed beside what the paper reports.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/reported.hpp"
#include "page/solved_case.hpp"

namespace tribo::report {

struct ComparisonRow {
  std::string_view surface;
  std::string_view model;      // GT, GW
  std::string_view criterion;  // of onset; empty where there is none
  std::optional<double> computed;
  std::optional<Reported> reported;
  std::string in_words;

  std::optional<double> factor() const;  // computed/reported
  bool agrees() const;                   // inside half a unit of the last printed digit
};

struct ComparisonTable {
  std::string_view quantity;  // as in claims.tsv
  std::string title;
  std::string computed_heading;  // "computed, m/s"
  std::string note;
  int digits;  // significant ones of the computed numbers
  bool has_criteria;
  std::vector<ComparisonRow> rows;
};

// Onset speeds, film parameters at the onset, asperity shares at the lowest speed.
std::vector<ComparisonTable> compare(const std::vector<SolvedCase>& solved,
                                     const ReportedValues& reported);

}  // namespace tribo::report
