// SPDX-License-Identifier: Apache-2.0
// What a subject did before, in a file that somebody commits: a gate for their CI.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"

namespace tribo::conformance {

// What is said of one quantity.
struct Finding {
  std::string quantity;  // or "protocol"
  std::string text;      // "hertz_point.radius: was held, is FAILED"
};

struct BaselineChanges {
  std::vector<Finding> worse;   // new failures, lost coverage, accuracy beyond the ratchet
  std::vector<Finding> better;  // worth writing down
  std::vector<std::string> failed_already;  // quantities that failed then, and fail no worse now
};

// The verdicts as a baseline. With `before` not null only what improved on it is taken over.
nlohmann::json baseline_of(const ConformanceResult& result, const nlohmann::json& before);

// Accuracy may not be worse than 4·max(ε, what it was). Throws std::runtime_error with one line,
// where the file is no baseline.
BaselineChanges compare(const ConformanceResult& result, const nlohmann::json& baseline);

// The file's content; null where there is no such file. Throws std::runtime_error with one line.
nlohmann::json read_conformance_baseline(const std::string& path);

}  // namespace tribo::conformance
