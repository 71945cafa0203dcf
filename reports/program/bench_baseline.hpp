// SPDX-License-Identifier: Apache-2.0
// Earlier numbers of `tribocheck bench` in a file that users commit: a gate for their CI.
// Work and accuracy are compared on any machine. Times are divided by the control's time of the
// same run, and compared only if processor and compiler are the same as in the baseline.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench_rows.hpp"

namespace tribo::cli {

// The rows that were asked for, by "job/family/name".
using IsAsked = std::function<bool(const std::string& key)>;

struct BenchChanges {
  std::vector<std::string> worse;    // red; also rows that are gone, or that nothing was compared
  std::vector<std::string> slower;   // red if a second run says so too
  std::vector<std::string> better;   // worth writing down
  std::vector<std::string> remarks;  // why something is not compared
  std::size_t rows = 0, compared = 0, timed = 0;  // this run's; compared at all; compared in times
};

// Throws std::runtime_error with one line where it is no such baseline, or one of another schema.
void check_bench_baseline(const nlohmann::json& baseline);

// Throws nlohmann::json::exception where a row is not as it should be.
BenchChanges compare(const BenchResults& results, const nlohmann::json& baseline,
                     const IsAsked& is_asked);

// Writes what became better into the baseline, number by number, unless the row got worse in
// anything. Returns a line for each change, and for each row that is not written as it got worse.
std::vector<std::string> improve(nlohmann::json& baseline, const BenchResults& results);

// The rows of this run as a baseline. Rows that were not asked for are taken over from `before`,
// without their times where these are of another machine; null: there is none.
nlohmann::json new_bench_baseline(const BenchResults& results, const nlohmann::json& before,
                                  const IsAsked& is_asked);

}  // namespace tribo::cli
