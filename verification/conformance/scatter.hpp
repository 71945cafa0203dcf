// SPDX-License-Identifier: Apache-2.0
// Errors of numerics: in no order, as of digits that cancel, or in one, as of a series cut off.
#pragma once

#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "The errors are of both signs and in no order, and grow where U is small …", or that they are
// small everywhere. Empty where there is an order, or neither of these.
std::string scatter_of(const Part& part);

// Errors that are nearly 0 for small values of a variable, and grow smoothly beyond, or that are
// all small beside 1; with a cause that other results may have, too. Empty: they are neither.
struct Growth {
  std::string text, cause;
};
Growth growth_of(const Part& part);

}  // namespace tribo::conformance
