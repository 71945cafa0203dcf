// SPDX-License-Identifier: Apache-2.0
// The factor between wrong answers and right ones, where it is a function of one input alone, or of
// one group of inputs.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

struct Dependence {
  std::string text;  // "The factor depends on k alone: 0.998 at k = 0.9, …"
  // The factor at a question of the function, between those of the cases. NaN: beyond them all.
  std::function<double(const Question&)> factor;
};

// "All 36 wrong answers are 3 x − 1.5.", or that the factor is such a form of one variable with two
// numbers of few digits. Empty: neither is so.
std::string form_of(const Part& part);

// "All 36 wrong answers are 1 over the right ones."; also 1 less the right ones, their roots,
// powers or logarithms. Empty: the wrong answers are no such form.
std::string form_of_right(const Part& part);

// The one variable on which the factor depends. Empty where no variable alone determines it: where
// two cases with the same value have different factors, or where the factor of a case lies far from
// the line between its neighbours.
std::optional<Dependence> dependence_of(const Part& part);

}  // namespace tribo::conformance
