// SPDX-License-Identifier: Apache-2.0
// Wrong numbers in words: how far off they are, where, and by which powers of the inputs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

inline constexpr double rounding = 1e-5;  // of logarithms; so much counts as rounding

// "27.5 % low everywhere": how the wrong numbers are off.
std::string pattern(const Part& part);

struct Description {
  std::string text;
  bool is_cause;           // it says what the numbers are, not only where and how far they are off
  std::string cause = {};  // what other functions may have, too; empty: nothing of this kind
  // For questions in the place where answers are wrong; empty: no place is told.
  std::function<bool(const Question&)> is_in_place = {};
  std::function<void(Question&)> change = {};  // what is misread; empty: nothing of a question is
};
// The pattern of a part that no known mistake gives, where it is wrong, and its law if it has one.
// Where the function rests on a wrong one, its errors tell nothing of its own numerics.
Description described(const Part& part, const std::vector<Mistake>& mistakes, bool rests_on_wrong);

// The factor of the wrong answers, where it is a product of powers of the inputs, or a constant;
// empty where it is none.
std::function<double(const Question&)> power_factor(const Part& part);

}  // namespace tribo::conformance
