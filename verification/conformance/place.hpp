// SPDX-License-Identifier: Apache-2.0
// Where answers are wrong: at one word or number of the question, where two inputs are alike, or in
// a range of one input or of one group of inputs.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

struct WrongPlace {
  std::string text;                            // "right up to d = 5, wrong from 5.2 on"
  std::function<bool(const Question&)> holds;  // whether a question lies there; may be empty
};

// Empty where nothing divides wrong answers from right ones. Wrong answers that are explained are
// left out. A border stands between the last right case and the first wrong one. At most 2 % of the
// cases, and 10 % of the right or the wrong ones, whichever are fewer, may lie on its wrong side.
std::optional<WrongPlace> place_of_wrong(const Part& part);

}  // namespace tribo::conformance
