// SPDX-License-Identifier: Apache-2.0
// Mistakes with a number, or a row of a table, that is solved for from the wrong answers.
#pragma once

#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// Mistakes that give some of the wrong answers of these cases, which are all of one function. For a
// moment: an integral that ends too early, at one s or at one distance from d, or a quadrature with
// too few points. For the viscosity index: another row of the table.
std::vector<Mistake> solved_mistakes(const std::vector<AnsweredCase>& cases);

// Mistakes of solvers that keep state from earlier questions: a part of the answer, as in a cache
// whose key lacks an input or in a static variable, or options that a question leaves out.
// `order`: all questions whose parts the solver may keep, in the order in which it was asked.
std::vector<Mistake> kept_parts(const std::vector<AnsweredCase>& answered,
                                const std::vector<Question>& order);

// ∫ (s − d)ⁿ φ(s) ds from d to the end.
double moment_to(double order, double d, double end);

}  // namespace tribo::conformance
