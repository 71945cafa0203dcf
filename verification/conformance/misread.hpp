// SPDX-License-Identifier: Apache-2.0
// Answers that are right, but of something else: of another value of one input, of another result,
// or of nothing that changes.
#pragma once

#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "u/2 in place of u": with this the right formula gives all wrong answers. It is solved for each
// input where an answer is wrong; what comes is a multiple of the input, a number, a sum, another
// input, or cut off, and has to give all other answers. Empty: no input does.
std::string misread_input(const Part& part);

// "All of these answers are 1e-09." or "… are the right semi_axis_y." Empty: they are neither one
// number, nor one number times an input, nor an input or another result.
std::string other_value(const Part& part);

// "2 u", "u/2", "1.23 u": a symbol times a factor, by the name of the factor where people know it.
std::string times_in_words(double factor, const std::string& symbol);

}  // namespace tribo::conformance
