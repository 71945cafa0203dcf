// SPDX-License-Identifier: Apache-2.0
// The baseline: a file with the verdicts on a subject in an earlier run. The subject's authors
// commit it, and their CI compares later runs with it.
//
// The file holds for each quantity how many cases were asked, held and skipped, the worst error of
// those that held ("worst_error": relative, over the condition), and under "failed" each case that
// failed with its error: a number (relative; absolute where 0 is expected), "wrong" (NaN, null,
// another word …) or "no answer". "losses" are the cases at which the subject ended or was late.
// "unsteady" stands where answers of the quantity's function changed by more than rounding when
// they were asked again.
// Each of these is a line of its own, so that a diff can be read. The head of the file says which
// program wrote it, and when. A file of schema 2 has no such head and no "losses"; it is read, too.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/conformance.hpp"

namespace tribo::conformance {

// How a run uses a baseline.
struct BaselineUse {
  std::string file;     // empty: none
  bool update = false;  // better results are written to it
  bool force = false;   // with `update`: worse results, too; and over any file
  // Commands that messages name: `renewal` makes the file anew, `restoration` gets it back.
  std::string renewal = {}, restoration = {};
};

// The file's content, read before the subject is asked. Null where no file is named, and where
// there is no file yet but `update` will write it. Throws std::invalid_argument with one line where
// there is no file otherwise, and where it is no JSON or `check` throws a std::runtime_error; in
// the two latter cases `force` makes it null.
nlohmann::json usable_baseline(const BaselineUse& use,
                               const std::function<void(const nlohmann::json&)>& check);

// "the baseline was written by tribocheck 0.9.0, which is newer than this 0.2.0: what it adds is
// not judged"; empty where it is not newer, or does not tell its version.
std::string newer_version_text(const nlohmann::json& baseline);

// "it is a baseline of schema 4, and this program has 3", and whether a newer program wrote it.
std::string other_schema_text(const nlohmann::json& baseline, const nlohmann::json& schema,
                              int known);

// A case that failed then or now. Its errors are as in the file; null: it did not fail.
struct CaseChange {
  std::string id;
  nlohmann::json before, after;
};

struct BaselineChange {
  std::string quantity;  // or "protocol", "subject", "anything"
  std::string text;      // "hertz_point.radius: was held, is FAILED"
  // The fact of the file that the text tells: "status", "held" or "worst_error", with its two
  // values; empty where cases alone changed.
  std::string fact = {};
  nlohmann::json before = {}, after = {};
  std::vector<CaseChange> cases = {};
};

struct BaselineChanges {
  // New failures, failures that grew, lost coverage, accuracy beyond the ratchet; or that nothing
  // could be compared. Each makes the gate red.
  std::vector<BaselineChange> worse;
  std::vector<BaselineChange> better;  // worth writing down
  std::vector<BaselineChange> fresh;   // quantities that the file does not have, and do not fail
  // Quantities of the file that are not asked any more, where another version of this program wrote
  // the file. Where this version wrote it, such quantities are in `worse`.
  std::vector<BaselineChange> gone;
  std::vector<std::string> failed_already;  // quantities that failed then, and fail no worse now
  std::vector<std::string> lost;  // quantities that are worse by the subject's end or silence alone
};

// The verdicts as a baseline. Where `before` is not null, the baseline stays as that is, but takes
// over what improved and new quantities that do not fail, and leaves out quantities that are gone.
nlohmann::json baseline_of(const ConformanceResult& result, const nlohmann::json& before);

// Do two baselines hold a subject to the same?
bool hold_the_same(const nlohmann::json& one, const nlohmann::json& other);

// The file's text. `date` is a day, as 2026-11-26.
std::string baseline_text(const nlohmann::json& baseline, std::string_view commit,
                          const std::string& date);

// Throws std::runtime_error with one line where the file is no baseline, or one of another schema,
// of other tolerances or of another sample. A file of tolerances counts by its content.
void check_comparable(const nlohmann::json& baseline, const Tolerance& tolerance,
                      std::size_t sample);

// The greatest error that is no worse than this one of a baseline.
double greatest_as_before(double error);

// Neither the worst error of what held, nor the error of any case that failed, may be worse than
// greatest_as_before() of it: 4·max(4ε, what it was). Throws as check_comparable() does.
BaselineChanges compare(const ConformanceResult& result, const nlohmann::json& baseline);

// Compares with the content that usable_baseline() gave. Empty where that is null, or where it
// cannot be compared and `force` is set; without `force` throws std::invalid_argument with one
// line.
std::optional<BaselineChanges> changes_since(const nlohmann::json& before, const BaselineUse& use,
                                             const ConformanceResult& result);

}  // namespace tribo::conformance
