// SPDX-License-Identifier: Apache-2.0
// The wrong formulas that reference/mistakes.toml has by name: what is no change of an argument, of
// a result or of the film's numbers.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "conformance/question.hpp"

namespace tribo::conformance {

// The results of a function at its arguments, from the numbers of the entry; empty: the formula
// says nothing of these arguments.
using FunctionFormula = std::optional<Numbers> (*)(const catalogue::Arguments& arguments,
                                                   std::span<const double> numbers);

// Null where there is no formula of this name for the function that takes so many numbers.
FunctionFormula find_formula(std::string_view function, std::string_view name, std::size_t numbers);

}  // namespace tribo::conformance
