// SPDX-License-Identifier: Apache-2.0
// The factor between wrong answers and right ones, if it is a function of one input or of one group
// of inputs alone.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

struct Dependence {
  std::string text;  // "The factor depends on k alone: 0.998 at k = 0.9, …"
  // The factor at any question, interpolated between the cases. NaN outside of their range.
  std::function<double(const Question&)> factor;
};

// "All 36 wrong answers are 3 x − 1.5.": a simple form of one variable with two numbers of few
// digits. Or that the factor is such a form. Empty: neither is one.
std::string form_of(const Part& part);

// "All 36 wrong answers are 1 over the right ones."; also 1 less the right ones, their roots,
// powers or logarithms. Empty: the wrong answers are no such form.
std::string form_of_right(const Part& part);

// The one variable on which the factor depends. Empty if there are too few cases, or if for each
// variable cases with the same value have different factors, or the factors are not a smooth curve.
std::optional<Dependence> dependence_of(const Part& part);

}  // namespace tribo::conformance
