// SPDX-License-Identifier: Apache-2.0
// Wrong numbers in words: how far off they are, where, and by which powers of the inputs.
#pragma once

#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

inline constexpr double rounding = 1e-5;  // of logarithms: single precision too

// The numbers of one result in one branch of the function.
struct Part {
  std::size_t place;
  std::string branch;
  std::vector<const AnsweredNumber*> wrong;  // and unexplained
  std::size_t answered = 0;

  const std::string& quantity() const { return wrong.front()->expected->quantity; }
};

// The parts with wrong answers that are still to be told. After a named mistake a few wrong
// answers, such as near a border, are not told.
std::vector<Part> parts_left(const std::vector<AnsweredCase>& cases);

// "27.5 % low everywhere": how the wrong numbers are off.
std::string pattern(const Part& part);

struct Description {
  std::string text;
  bool is_cause;  // it says what the numbers are, not only where and how far they are off
};
// The pattern of a part that no known mistake gives, where it is wrong, and its law if it has one.
Description described(const Part& part, const std::vector<AnsweredCase>& cases,
                      const std::vector<Mistake>& mistakes);

}  // namespace tribo::conformance
