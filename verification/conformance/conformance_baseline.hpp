// SPDX-License-Identifier: Apache-2.0
// The verdicts on a subject in an earlier run, in a file that the subject's authors commit: a gate
// for their CI.
//
// The file holds for each quantity how many cases were asked, held and skipped, the worst error of
// those that held ("worst_error": relative, over the condition), and under "failed" each case that
// failed with its error: a number (relative; absolute where 0 is expected), "wrong" (NaN, null,
// another word …) or "no answer". Each of these is a line, so that a diff can be read.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"

namespace tribo::conformance {

// The message on one quantity.
struct QuantityNote {
  std::string quantity;  // or "protocol", "anything"
  std::string text;      // "hertz_point.radius: was held, is FAILED"
};

struct BaselineChanges {
  // New failures, failures that grew, lost coverage, accuracy beyond the ratchet; or that nothing
  // could be compared.
  std::vector<QuantityNote> worse;
  std::vector<QuantityNote> better;         // worth writing down
  std::vector<std::string> failed_already;  // quantities that failed then, and fail no worse now
};

// The verdicts as a baseline. With `before` not null only what improved on it is taken over.
nlohmann::json baseline_of(const ConformanceResult& result, const nlohmann::json& before);

// Throws std::runtime_error with one line where the file is no baseline, or one of another schema,
// of other tolerances or of another sample. A file of tolerances counts by its content.
void check_comparable(const nlohmann::json& baseline, const Tolerance& tolerance,
                      std::size_t sample);

// Neither the worst error of what held, nor the error of any case that failed, may be worse than
// 4·max(ε, what it was). Throws as check_comparable does.
BaselineChanges compare(const ConformanceResult& result, const nlohmann::json& baseline);

// The file's content; null where there is no such file. Throws std::runtime_error with one line.
nlohmann::json read_conformance_baseline(const std::string& path);

}  // namespace tribo::conformance
