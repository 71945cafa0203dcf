// SPDX-License-Identifier: Apache-2.0
// The numbers that a subject answered for one function, each with the number that is expected.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/question.hpp"

namespace tribo::conformance {

struct AnsweredNumber {
  const Expected* expected;
  std::size_t place;  // the index of the result in Numbers
  double got;
  double allowed;  // absolute error
  bool is_wrong;
  bool is_explained = false;  // a mistake that was named explains it

  bool is_left() const { return is_wrong && !is_explained; }  // still to be reported
  // The error that is allowed if `given` is taken for the right number. If `given` is less than a
  // tenth of the right number, as if Pa were read as GPa, it is the allowed relative error of
  // `given`.
  double allowed_of(double given) const {
    const double own = std::abs(given), right = std::abs(expected->high);
    return 10 * own < right ? allowed / right / expected->condition * own : allowed;
  }
  double error() const { return (got - expected->high) - expected->low; }
};

struct AnsweredCase {
  Question question;
  Question asked;  // as it was sent; wrong inner functions may change `question` (follow.hpp)
  // The case's branch of the function, because one branch may be wrong alone: "order 1.5",
  // "greenwood_tripp". It is empty for operating points, and if the function has no branches.
  std::string branch;
  std::vector<AnsweredNumber> numbers;
};

// The cases of a function that were answered. Only fields with finite numbers are kept, and only
// cases that have such a field.
std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<TestCase>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance);

// The numbers of one result, in one branch of the function or in all.
struct Part {
  struct Number {
    const AnsweredCase* of;
    const AnsweredNumber* answered;

    double input(std::size_t parameter) const { return of->question.arguments[parameter]; }
  };

  std::size_t place = 0;
  std::string branch = {};
  std::vector<Number> all = {};
  std::vector<const AnsweredNumber*> wrong = {};  // those that the report has to explain

  const std::string& quantity() const { return wrong.front()->expected->quantity; }
  // The function that was asked; null for operating points.
  const catalogue::Function* function() const { return all.front().of->question.function; }
};

// The numbers of a part that are wrong and not explained yet.
std::vector<Part::Number> wrong_of(const Part& part);
// At most `most` of these numbers, evenly spread, the first and the last among them; `most` ≥ 2.
std::vector<Part::Number> far_apart(const std::vector<Part::Number>& numbers, std::size_t most);

// The parts with wrong answers that are not reported yet. If a named mistake explains nearly all
// wrong answers of a branch, the few others, for example near a border, are not reported.
std::vector<Part> parts_left(const std::vector<AnsweredCase>& cases);

// The branch of the function that the question belongs to; empty if it has no branch.
std::string branch_of(const Question& question);

inline constexpr std::size_t fewest_cases = 8;  // fewer cases are too few to report a pattern

// A sentence if every answer has at most nine digits, or is a number of single precision, and
// this explains the greatest relative error. Empty if it does not, or there are fewer than
// `fewest_cases` numbers.
std::string few_digits(const std::vector<AnsweredCase>& cases, double greatest);

}  // namespace tribo::conformance
