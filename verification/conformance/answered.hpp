// SPDX-License-Identifier: Apache-2.0
// The numbers that a subject answered for one function, each beside what is expected.
#pragma once

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
  double allowed;  // error, absolute
  bool is_wrong;
  bool is_explained = false;  // by a mistake that was named

  double error() const { return (got - expected->high) - expected->low; }
};

struct AnsweredCase {
  Question question;
  // The branch of the function that the case is of, as one may be wrong alone: "order 1.5",
  // "greenwood_tripp". Empty: the function has no branches.
  std::string branch;
  std::vector<AnsweredNumber> numbers;
};

// Without the cases that were not answered, and without fields that are no finite number.
std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<Case>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance);

}  // namespace tribo::conformance
