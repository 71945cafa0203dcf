// SPDX-License-Identifier: Apache-2.0
// Wrong numbers in words: how far off they are, where, and by which powers of the inputs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

inline constexpr double rounding = 1e-5;  // an error of a logarithm that counts as rounding

// "27.5 % low everywhere": how the wrong numbers are off.
std::string pattern(const Part& part);

struct Description {
  std::string text;
  bool is_cause;           // it says what the numbers are, not only where and how far they are off
  std::string cause = {};  // a cause that other functions may share; empty: none
  // True of questions in the place where answers are wrong. Empty: the text names no place.
  std::function<bool(const Question&)> is_in_place = {};
  std::function<void(Question&)> change = {};  // misreads a question; empty: no input is misread
};
// Describes a part that no known mistake gives: its pattern, where it is wrong, and its law if any.
// `rests_on_wrong`: a function below is wrong, so the errors say nothing about numerics.
Description described(const Part& part, const std::vector<Mistake>& mistakes, bool rests_on_wrong);

// The factor of the wrong answers, if it is a product of powers of the inputs, or a constant.
// Empty: it is neither.
std::function<double(const Question&)> power_factor(const Part& part);

}  // namespace tribo::conformance
