// SPDX-License-Identifier: Apache-2.0
// The numbers that a subject answered for one function, each beside what is expected.
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
  std::size_t place;  // in Numbers
  double got;
  double allowed;  // absolute error
  bool is_wrong;
  bool is_explained = false;  // by a mistake that was named

  bool is_left() const { return is_wrong && !is_explained; }  // to be told
  // How far from `given` an answer may be. Where `given` is far smaller than the right number, as
  // if Pa were read as GPa, the error that is allowed of the right number would be too much.
  double allowed_of(double given) const {
    const double own = std::abs(given), right = std::abs(expected->high);
    return 10 * own < right ? allowed / right / expected->condition * own : allowed;
  }
  double error() const { return (got - expected->high) - expected->low; }
};

struct AnsweredCase {
  Question question;
  Question asked;  // as it was asked, without what wrong functions below change (follow.hpp)
  // The case's branch of the function, because one branch may be wrong alone: "order 1.5",
  // "greenwood_tripp". Empty: the function has no branches.
  std::string branch;
  std::vector<AnsweredNumber> numbers;
};

// The answered cases of a function, without fields that are no finite number.
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
  std::vector<const AnsweredNumber*> wrong = {};  // those that a sentence is about

  const std::string& quantity() const { return wrong.front()->expected->quantity; }
  // The function that was asked; null for operating points.
  const catalogue::Function* function() const { return all.front().of->question.function; }
};

// The numbers of a part that are wrong and not explained yet.
std::vector<Part::Number> wrong_of(const Part& part);
// At most `most` of these numbers, evenly spread, the first and the last among them; `most` ≥ 2.
std::vector<Part::Number> far_apart(const std::vector<Part::Number>& numbers, std::size_t most);

// The parts with wrong answers that are still to be told. After a named mistake a few wrong
// answers, such as near a border, are not told.
std::vector<Part> parts_left(const std::vector<AnsweredCase>& cases);

// The branch of its function that a question is of; empty: it has none.
std::string branch_of(const Question& question);

inline constexpr std::size_t fewest_cases = 8;  // for a pattern to be told

// Whether every answer has at most nine digits, or is a number of single precision. False where
// there are fewer than `fewest_cases` numbers.
bool is_single_precision(const std::vector<AnsweredCase>& cases);

}  // namespace tribo::conformance
