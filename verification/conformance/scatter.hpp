// SPDX-License-Identifier: Apache-2.0
// Errors of numerics: in no order, as of digits that cancel, or in one, as of a series cut off.
#pragma once

#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "The errors are of both signs and in no order, and grow where U is small …", or that they are
// small everywhere, of one size, or anything up to a tolerance. Empty: they are nothing of this.
std::string scatter_of(const Part& part);

// Errors that are nearly 0 for small values of a variable and grow smoothly beyond, or errors that
// are all small beside 1. `cause` may be that of other results, too. `text` is empty where the
// errors are neither. `is_numerics`: the law has a root, an integral or a series, and the errors
// grow as a high power, as the errors of such a method do.
struct Growth {
  std::string text, cause;
  bool is_numerics = true;
};
Growth growth_of(const Part& part);

// "No error is above 0.00098 of the value …": errors of an iteration that stops at a tolerance or
// after some steps, which are anything up to it, in no order. Empty: they are larger, of one size,
// or in an order, or the function has no iteration.
std::string ended_early(const Part& part);

// Errors of the last digits of 1 where the right answers are far less: "No error is above 1.1e-16
// …". Empty: some are greater, or the answers do not reach 1.
std::string digits_lost_below_one(const Part& part);

// Answers that are whole steps from each other, as of a bisection that ends early, or of rounding:
// "75 wrong answers are whole steps of 3.052e-05 from each other …". Empty: they are not.
std::string grid_of(const Part& part);

}  // namespace tribo::conformance
