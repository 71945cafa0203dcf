// SPDX-License-Identifier: Apache-2.0
// The verdict on a subject, quantity by quantity, and the evidence for it that people need.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conformance/conversation.hpp"

namespace tribo::conformance {

// How far off an answer may be.
struct Tolerance {
  std::string name;                        // "strict", "engineering", or the file
  bool is_strict = false;                  // the certified contract of each function
  double relative = 0;                     // if not strict: relative error, times the condition
  std::map<std::string, double> quantity;  // other relative errors, by quantity
};
Tolerance strict_tolerance();
// 1e-6 of the value or 1e-30, and nothing asked that is beyond engineering (TestCase::is_extreme):
// for code that uses quadrature or fits.
Tolerance engineering_tolerance();
// Lines "quantity relative", # before comments; "default" for all that are not named. Throws
// std::runtime_error with one line.
Tolerance read_tolerance(const std::string& path, const std::vector<TestCase>& cases);

// How far off an answer to this may be, absolute.
double allowed_error(const TestCase& asked, const Expected& expected, const Tolerance& tolerance);

enum class Verdict : std::uint8_t {
  held,  // every case
  // Every case of contacts on earth (Expected::is_physical), but not all others. Never with the
  // strict tolerance, which asks for all of them.
  held_physically,
  partly_held,  // every case that was answered, but some were skipped
  failed,
  not_offered,  // no case was answered: all skipped, or the field is never there
};
std::string_view name(Verdict status);

// How a case failed, from the least to the worst.
enum class Failure : std::uint8_t {
  number,     // a finite number that is too far off
  wrong,      // NaN, an infinity, null, text where a number is wanted, or another word
  no_answer,  // none came, or none for this field
};

struct FailedCase {
  std::string id;
  Failure how = Failure::no_answer;
  double error = 0;  // of a number: relative, or absolute where 0 is expected
};

struct HeldCase {
  std::string id;
  double error;  // relative, over the condition; 0 where the value is too small to play a part
};

struct QuantityVerdict {
  std::string quantity;
  Verdict status = Verdict::not_offered;
  std::size_t asked = 0, held = 0, failed = 0, skipped = 0;
  std::size_t held_physical = 0, failed_physical = 0;  // of these, in the physical range
  double worst_part_of_bound = 0, worst_relative = 0;
  std::vector<HeldCase> held_cases;
  std::vector<FailedCase> failed_cases;
  std::string worst_case;    // its id
  std::string first_reason;  // of the first failure, or of the first skip
};

// physical: nothing failed but beyond the physical range.
enum class Overall : std::uint8_t { complete, partial, physical, failed, nothing };
std::string_view name(Overall overall);

struct ConformanceResult {
  std::string subject;
  Tolerance tolerance;
  std::size_t sample = 0;  // cases of each function at most; 0: all were asked
  Overall overall = Overall::nothing;
  std::vector<QuantityVerdict> quantities;
  std::size_t violation_count = 0;
  std::vector<std::string> violations;
  std::string last_errors;
  int starts = 0;
  bool answers_at_end_of_input = false;
};

ConformanceResult judge(std::string subject, const std::vector<TestCase>& cases,
                        const Conversation& conversation, const Tolerance& tolerance);

// The cases that a tolerance asks for: all but the strict one leave out the extreme cases.
std::vector<TestCase> cases_for(std::vector<TestCase> cases, const Tolerance& tolerance);

// One quantity of one case: its question, the expected answer, and the given one.
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

Example example_of(const TestCase& asked, const Expected& expected, const Reply& answer,
                   const Tolerance& tolerance);

// The worst case of each quantity that failed; with `of_all`: of each that was asked for.
std::vector<Example> worst_examples(const ConformanceResult& result,
                                    const std::vector<TestCase>& cases,
                                    const Conversation& conversation, const Tolerance& tolerance,
                                    bool of_all = false);

// Notes on the answers for the user: lines between them, and fields that are no results, as
// misspelt ones. Each note is one line.
std::vector<std::string> notes_on(const std::vector<TestCase>& cases,
                                  const Conversation& conversation);

// The end of what the subject wrote to stderr: all of an error message, where cases have no answer.
std::vector<std::string> last_error_lines(const Conversation& conversation);

}  // namespace tribo::conformance
