// SPDX-License-Identifier: Apache-2.0
// Mistakes with a number, or a row of a table, that is solved for from the wrong answers.
#pragma once

#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// Mistakes that give some of the wrong answers of these cases, which are all of one function: an
// integral that ends too early, at one number or at one distance from d, or that is a sum of too
// few points, and another row of a table.
std::vector<Mistake> solved_mistakes(const std::vector<AnsweredCase>& cases);

}  // namespace tribo::conformance
