// SPDX-License-Identifier: Apache-2.0
// Mistakes with a number, or a row of a table, that is found by the wrong answers.
#pragma once

#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// An integral that ends too early, at one number or at one distance, and a table of which another
// row is taken: those that give some of the wrong answers of these cases, all of one function.
std::vector<Mistake> solved_mistakes(const std::vector<AnsweredCase>& cases);

}  // namespace tribo::conformance
