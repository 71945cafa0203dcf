// SPDX-License-Identifier: Apache-2.0
// Two results of sweeps side by side: each number of one beside the same number of the other.
//
// Kept cases are compared if both results have them: the varied fields and each output. If one has
// only summaries, these are compared: counts, moments, quantiles and histograms. Sensitivity
// indices are compared if the results have them. Two undefined numbers are equal: a result keeps no
// reason for them, except as a word of a column (`regime`, `inlet`, `solved_film.outcome`). Words
// are compared as words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/result_file.hpp"

namespace tribo::sweep {

enum class ComparedKind : std::uint8_t { speed, input, output, summary, sensitivity };
inline constexpr auto compared_kind_names =
    std::to_array<std::string_view>({"speed", "input", "output", "summary", "sensitivity"});
constexpr std::string_view name(ComparedKind kind) {
  return compared_kind_names[static_cast<std::size_t>(kind)];
}

// The numbers of one kind of one column.
struct ComparedColumn {
  std::string scene;
  ComparedKind kind = ComparedKind::output;
  std::string name;  // of the column, or the path of the input
  std::string unit;
  std::vector<std::string> words;  // not empty: numbers are places in this list
  std::uint64_t compared = 0, differing = 0;
  double worst = 0;  // the greatest Difference::size of the numbers that differ
};

struct Difference {
  std::size_t column = 0;      // in ComparedResults::columns
  std::uint64_t one_case = 0;  // of inputs and outputs
  double speed = 0;            // NaN: of no single speed
  std::string statistic;       // of summaries and sensitivities: "mean", "0.5 quantile"
  double first = 0, second = 0;
  // |a − b| over the greater of |a| and |b|; of sensitivity indices, which are parts of 1, |a − b|.
  // Infinite where one number is undefined or infinite, or where two words differ.
  double size = 0;
};

struct ComparedResults {
  std::vector<std::string> notes;       // other versions, arithmetic or sweep files; one line each
  std::vector<ComparedColumn> columns;  // in the order of the first result
  std::vector<Difference> worst;        // the greatest first, equal ones in the files' order

  std::uint64_t compared() const;
  std::uint64_t differing() const;
};

// Numbers differ where Difference::size exceeds the tolerance; with a tolerance of 0 they differ
// where any bit does. At most `most` differences are listed; all are counted. Throws
// std::invalid_argument where the results have different scenes, numbers of cases or columns, and
// std::runtime_error where one cannot be read. Memory does not grow with the number of cases.
ComparedResults compare_results(const ResultFile& first, const ResultFile& second, double tolerance,
                                std::size_t most);

}  // namespace tribo::sweep
