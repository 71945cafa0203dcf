// SPDX-License-Identifier: Apache-2.0
// The verdict on a subject, quantity by quantity, with the evidence that lets people check it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conformance/conversation.hpp"
#include "conformance/unsteady.hpp"

namespace tribo::conformance {

// How far off an answer may be.
struct Tolerance {
  std::string name;                        // "strict", "engineering", or the file
  bool is_strict = false;                  // the certified contract of each function
  double relative = 0;                     // if not strict: relative error, times the condition
  std::map<std::string, double> quantity;  // other relative errors, by quantity
};
Tolerance strict_tolerance();
// For code that uses quadrature or fits. Allows a relative error of 1e-6 times the condition, but
// at least an error of 1e-30. Leaves out cases beyond engineering (TestCase::is_extreme).
Tolerance engineering_tolerance();
// The tolerance "strict", "engineering", or that of the file with this path. A line of the file has
// a quantity, or "default" for all quantities that are not named, and a relative error above 0 and
// below 1; # begins a comment. Throws std::runtime_error with one line.
Tolerance tolerance_of(const std::string& text, const std::vector<TestCase>& cases);

// How far off the answer may be, in the unit of the value.
double allowed_error(const TestCase& asked, const Expected& expected, const Tolerance& tolerance);

enum class Verdict : std::uint8_t {
  held,  // every case
  // Every case of contacts on earth (Expected::is_physical), but not all others. With the strict
  // tolerance this is a failure.
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
  no_answer,  // no answer came, or it lacks this field
};

struct FailedCase {
  std::string id;
  Failure how = Failure::no_answer;
  double error = 0;  // of a number: relative, or absolute where 0 is expected
  // The subject ended or was late at this case, or had done so before and was given up (Loss).
  bool is_lost = false;
};

struct HeldCase {
  std::string id;
  double error;  // relative, over the condition; 0 if the value is too small to matter
};

// One quantity of one case: its question, the expected answer, and the given one.
struct Example {
  std::string id;          // of the case
  nlohmann::json request;  // the line that asked, as it was sent
  Expected expected;
  double allowed = 0;                 // how far off it may be, absolute
  std::optional<nlohmann::json> got;  // in the answer's field; empty: no such field
  std::string reason;                 // why there is no answer, or no such field
  double part_of_bound = 0;  // error over the bound; infinite: no number; 0: nothing was judged
};

// "3.2e-08 m, give or take 3.2e-14", or the expected word.
std::string expected_text(const Expected& expected, double allowed);
// "2.3e-08 m", or "nothing" and the reason.
std::string got_text(const Example& example);
// "99.2 times as far off as is allowed", or "0.5 of the error that is allowed"; empty if there is
// no number.
std::string error_text(const Example& example);

struct QuantityVerdict {
  std::string quantity;
  Verdict status = Verdict::not_offered;
  std::size_t asked = 0, held = 0, failed = 0, skipped = 0;
  std::size_t held_physical = 0, failed_physical = 0;  // of these, in the physical range
  double worst_relative = 0;
  Example worst{};  // of the cases that held or failed; the first case if all were skipped
  std::vector<HeldCase> held_cases;
  std::vector<FailedCase> failed_cases;
  std::string first_reason;   // of the first (physical) failure, else of the first skip
  std::string first_skipped;  // the first case that was skipped, and why: "h0012: no root"
  // The greatest change of an answer when its case was asked again: relative, over the condition;
  // infinite if one of the two answers is no number. For this quantity, and for all quantities of
  // its function.
  double change_asked_again = 0, change_of_function = 0;

  std::size_t judged() const { return held + failed; }
  // Whether cases failed, and all of them because the subject ended or was silent.
  bool fails_by_losses_alone() const;
};

// "hertz_point" for "hertz_point.radius". A function's only quantity has the function's name.
std::string function_of(const std::string& quantity);

// A case at which the subject ended, or gave no answer in time; or the first of the cases that were
// given up for one reason. It is one fault of the subject, however many quantities the case has.
struct Loss {
  std::string id;        // of the case
  std::string function;  // that was asked
  std::string reason;    // "it is killed by signal 11 (SIGSEGV, Segmentation fault)"
  // Whether a quantity of the case is physical (Expected), or the tolerance is the strict one.
  bool is_physical = true;
};
// "at case m0499 (gaussian_moment) and at 8 more: it is killed by signal 11 (SIGSEGV, Segmentation
// fault); lost by this: gaussian_moment; --show m0499 asks it alone".
std::string loss_text(const std::vector<Loss>& losses, const std::vector<std::string>& quantities);

// physical: all failures are beyond the physical range.
enum class Overall : std::uint8_t { complete, partial, physical, failed, nothing };
std::string_view name(Overall overall);

struct ConformanceResult {
  std::string subject;
  Tolerance tolerance;
  std::size_t sample = 0;  // cases of each function at most; 0: all were asked
  Overall overall = Overall::nothing;
  std::vector<QuantityVerdict> quantities;
  std::vector<Loss> losses;        // in the order of the cases
  std::vector<Unsteady> unsteady;  // the quantities whose answers change
  // Where a case was asked twice, its answer is the worse of both.
  Conversation conversation;
  // Notes for the user, one line each: on lines that are no answers, on a subject that did not end,
  // and on fields that are no results, for example misspelt ones.
  std::vector<std::string> notes;
};

ConformanceResult judge(std::string subject, const std::vector<TestCase>& cases,
                        Conversation conversation, const Tolerance& tolerance);

// The cases that a tolerance asks for. Only the strict one asks for the extreme cases. If `sample`
// is not 0, at most so many cases of each function remain: the first one, and others that are
// spread evenly.
std::vector<TestCase> cases_for(std::vector<TestCase> cases, const Tolerance& tolerance,
                                std::size_t sample = 0);

// The first of these names that is no quantity of the cases. A function's name stands for each of
// its quantities, here and below.
std::optional<std::string> unknown_of(const std::vector<std::string>& required,
                                      const std::vector<TestCase>& cases);

// The message on one quantity.
struct QuantityNote {
  std::string quantity;  // or "protocol", "subject", "anything"
  std::string text;      // "required, but FAILED: hertz_point.radius"
};
// The quantities that were asked for by name and are not held.
std::vector<QuantityNote> missing_of(const std::vector<std::string>& required,
                                     const ConformanceResult& result);

}  // namespace tribo::conformance
