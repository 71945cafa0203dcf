// SPDX-License-Identifier: Apache-2.0
// The baseline: a file with the verdicts on a subject in an earlier run. The subject's authors
// commit it, and their CI compares later runs with it.
//
// For each quantity the file has the number of cases that were asked, held and skipped.
// "worst_error" is the worst error of those that held: relative, over the condition. "failed" has
// each case that failed, with its error: a number (relative; absolute if 0 is expected), "wrong"
// (NaN, null, another word …) or "no answer". "unsteady" is there if answers of the quantity's
// function changed by more than rounding when they were asked again. "losses" are the cases at
// which the subject ended or was late. Each member has a line of its own, so that a diff can be
// read. The head of the file says which program wrote it, and when. Files of schema 2, which have
// no such head and no "losses", are read, too.
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
  bool force = false;   // with `update`: worse results, too, and over any file
  // Commands that messages name: `renewal` makes the file anew, `restoration` gets it back.
  std::string renewal = {}, restoration = {};
};

// The file's content, read before the subject is asked. Null if no file is named, or if the file
// does not exist and `update` will write it. With `force` it is null, too, if the file is no JSON
// or `check` throws a std::runtime_error. Other failures throw std::invalid_argument with one line.
nlohmann::json usable_baseline(const BaselineUse& use,
                               const std::function<void(const nlohmann::json&)>& check);

// "the baseline was written by tribocheck 0.9.0, which is newer than this 0.2.0: what it adds is
// not judged"; empty if it is not newer, or has no version.
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
  // The member of the file that the text is about, "status", "held" or "worst_error", with its two
  // values. Empty if only cases changed.
  std::string fact = {};
  nlohmann::json before = {}, after = {};
  std::vector<CaseChange> cases = {};
};

struct BaselineChanges {
  // New failures, failures that grew, lost coverage, errors beyond the ratchet, a broken protocol,
  // or that nothing could be compared. Each of them fails the gate.
  std::vector<BaselineChange> worse;
  std::vector<BaselineChange> better;  // for a new baseline
  std::vector<BaselineChange> fresh;   // do not fail, and a file of another version lacks them
  // Quantities of the file that are not asked any more, if another version of this program wrote
  // the file. Otherwise such quantities are in `worse`.
  std::vector<BaselineChange> gone;
  std::vector<std::string> failed_already;  // quantities that failed then, and fail no worse now
  std::vector<std::string> lost;            // worse only because the subject ended or was late
};

// The verdicts as a baseline. If `before` is not null, the result is `before` with the rows that
// improved and those of `fresh` (BaselineChanges), and without those of `gone` and mended losses.
nlohmann::json baseline_of(const ConformanceResult& result, const nlohmann::json& before);

// Whether two baselines demand the same of a subject.
bool hold_the_same(const nlohmann::json& one, const nlohmann::json& other);

// The file's text. `date` is a day, as 2026-11-26.
std::string baseline_text(const nlohmann::json& baseline, std::string_view commit,
                          const std::string& date);

// Throws std::runtime_error with one line if the file is no baseline, or one of another schema, of
// other tolerances or of another sample. A file of tolerances is compared by its content.
void check_comparable(const nlohmann::json& baseline, const Tolerance& tolerance,
                      std::size_t sample);

// The greatest error that is no worse than this error of a baseline: 4·max(4ε, error).
double greatest_as_before(double error);

// The worst error of the cases that held, and the error of each case that failed, may be at most
// greatest_as_before() of that in the baseline. Throws as check_comparable() does.
BaselineChanges compare(const ConformanceResult& result, const nlohmann::json& baseline);

// Compares with the content that usable_baseline() gave. Empty if that is null. If it cannot be
// compared, the result is empty with `force`; without it throws std::invalid_argument with one
// line.
std::optional<BaselineChanges> changes_since(const nlohmann::json& before, const BaselineUse& use,
                                             const ConformanceResult& result);

}  // namespace tribo::conformance
