// SPDX-License-Identifier: Apache-2.0
// Errors in no order: of digits that are lost, or of an iteration that stops too early.
#pragma once

#include <string>

#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "The errors are of both signs and in no order, and grow where U is small …", or that they are
// small everywhere. Empty where there is an order, or neither of these.
std::string scatter_of(const Part& part);

}  // namespace tribo::conformance
