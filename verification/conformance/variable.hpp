// SPDX-License-Identifier: Apache-2.0
// Numbers that may decide whether an answer is right: the inputs of a question, the groups of
// inputs in which its law is written, and the right results.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/question.hpp"

namespace tribo::conformance {

struct Variable {
  std::string symbol;                            // "k", "αp", "surface.offset_planes"
  bool is_input;                                 // not a group of inputs, and not a result
  std::function<double(const Question&)> value;  // NaN: this question has none
  bool is_result = false;
};

// "F" of "F, of both bodies": the symbol at the beginning of a meaning.
std::string symbol_of(std::string_view meaning);

// The variables of the function, or, where it is null, of operating points. Inputs come first, then
// groups, then results.
std::vector<Variable> variables_of(const catalogue::Function* function);

// The question to the film law of a scene, at its numbers and its first speed.
Question film_question(const Scene& scene);

}  // namespace tribo::conformance
