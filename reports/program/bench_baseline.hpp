// SPDX-License-Identifier: Apache-2.0
// What `tribocheck bench` measured before, in a file that somebody commits: a gate for their CI.
// Work and accuracy are compared on any machine. Times are divided by the control's time of the
// same run, and compared only if processor and compiler are the same as in the baseline.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench_rows.hpp"

namespace tribo::cli {

struct BenchChanges {
  std::vector<std::string> worse;    // red
  std::vector<std::string> slower;   // red if a second run says so too
  std::vector<std::string> better;   // worth writing down
  std::vector<std::string> remarks;  // why something is not compared
};

// Throws nlohmann::json::exception where it is no such baseline.
BenchChanges compare(const BenchResults& results, const nlohmann::json& baseline);

// As a baseline. With `before` not null only what improved on it is taken over.
nlohmann::json bench_baseline(const BenchResults& results, const nlohmann::json& before);

}  // namespace tribo::cli
