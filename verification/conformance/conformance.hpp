// SPDX-License-Identifier: Apache-2.0
// The verdict on a subject, quantity by quantity.
#pragma once

#include <cstdint>
#include <map>
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
// 1e-6 of the value or 1e-30, and nothing asked that is beyond engineering (Case::is_extreme): for
// code that uses quadrature or fits.
Tolerance engineering_tolerance();
// Lines "quantity relative", # before comments; "default" for all that are not named. Throws
// std::runtime_error with one line.
Tolerance read_tolerance(const std::string& path, const std::vector<Case>& cases);

// How far off an answer to this may be, absolute.
double allowed_error(const Case& asked, const Expected& expected, const Tolerance& tolerance);

enum class Status : std::uint8_t {
  held,  // every case
  // Every case of contacts on earth (Expected::is_physical), but not all others. Never with the
  // strict tolerance, which asks for all of them.
  held_physically,
  partly_held,  // every case that was answered, but some were skipped
  failed,
  not_offered,  // no case was answered: all skipped, or the field is never there
};
std::string_view name(Status status);

// One number that was asked for.
struct Judged {
  std::size_t of_case;   // its index
  std::size_t expected;  // the index of the field
  double got;            // NaN where there is none
  double part_of_bound;  // error/bound; infinite where there is no number; above 1: failed
};

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
  Status status = Status::not_offered;
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
  std::vector<Judged> judged;  // all numbers that failed, for the diagnosis
  std::size_t violation_count = 0;
  std::vector<std::string> violations;
  std::string last_errors;
  int starts = 0;
  bool answers_at_end_of_input = false;
};

ConformanceResult judge(std::string subject, const std::vector<Case>& cases,
                        const Conversation& conversation, const Tolerance& tolerance);

// The cases that a tolerance asks for: all but the strict one leave out the extreme cases.
std::vector<Case> cases_for(std::vector<Case> cases, const Tolerance& tolerance);

}  // namespace tribo::conformance
