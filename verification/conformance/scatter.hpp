// SPDX-License-Identifier: Apache-2.0
// Numerical errors: without order, as from cancelled digits, or with one, as from a cut-off series.
#pragma once

#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "The errors are of both signs and in no order, and grow where U is small …", or a sentence
// that they are of one size, or small everywhere. Empty: none of these is true.
std::string scatter_of(const Part& part);

// Errors that are nearly 0 at an end of a variable, or where it is 1, and grow smoothly beyond; or
// errors that are all small beside 1. `text` is empty if they are neither. Other results may have
// the same `cause`. `is_numerics`: the law has a root, an integral or a series, and its numerical
// method may leave such errors.
struct Growth {
  std::string text, cause;
  bool is_numerics = true;
};
Growth growth_of(const Part& part);

// "No error is above 0.00098 of the value …": an iteration that stops at a tolerance, or after some
// steps, leaves errors of any size up to a bound, in no order. Empty: they are larger, of one size,
// or in an order, or the function has no iteration. Load sharing: also answers that nearly
// meet λ = λ₀/(1 − A)^e beside others that do not.
std::string ended_early(const Part& part);

// "No error is above 1.1e-16 …": the errors are in the last digits of 1, and the right answers are
// far smaller. Empty: some errors are greater, or the greatest answer is not near 1.
std::string digits_lost_below_one(const Part& part);

// Answers that are whole steps from each other, as of a bisection that ends early, or of rounding:
// "75 wrong answers are whole steps of 3.052e-05 from each other …". Empty: they are not.
std::string grid_of(const Part& part);

}  // namespace tribo::conformance
