// SPDX-License-Identifier: Apache-2.0
// The evidence that people need on a case: its question, the expected answer, and the given one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conformance/conformance.hpp"

namespace tribo::conformance {

// One quantity of one case.
struct Example {
  std::string quantity;
  std::string id;          // of the case
  nlohmann::json request;  // the line that asked, as it was sent
  Expected expected;
  double allowed;    // how far off it may be, absolute
  std::string unit;  // empty: dimensionless
  std::optional<nlohmann::json>
      got;               // what the answer has in the field; none: there is no such field
  std::string reason;    // why there is no answer, or no such field
  double part_of_bound;  // error over the bound; infinite where there is no number; 0 if unknown
};

// "3.2e-08 m, give or take 3.2e-14", or the word, or that it is undefined there.
std::string expected_text(const Example& example);
// "2.3e-08 m", or "nothing" and why.
std::string got_text(const Example& example);
// "99.2 times as far off as is allowed"; empty where there is no number.
std::string error_text(const Example& example);

Example example_of(const Case& asked, const Expected& expected, const Answer& answer,
                   const Tolerance& tolerance);

// The worst case of each quantity that failed; with `of_all`: of each that was asked for.
std::vector<Example> worst_examples(const ConformanceResult& result, const std::vector<Case>& cases,
                                    const Conversation& conversation, const Tolerance& tolerance,
                                    bool of_all = false);

// Notes on the answers for the user: lines between them, and fields that are no results, as
// misspelt ones. Each note is one line.
std::vector<std::string> notes_on(const std::vector<Case>& cases, const Conversation& conversation);

// The end of what the subject wrote to stderr: all of an error message, where cases have no answer.
std::vector<std::string> last_error_lines(const Conversation& conversation);

}  // namespace tribo::conformance
