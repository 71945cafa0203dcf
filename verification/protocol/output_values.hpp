// SPDX-License-Identifier: Apache-2.0
// An output of an operating point as every format shows it: a number, a word, or undefined.
#pragma once

#include <string_view>

#include "tribo/mixed_contact.hpp"

namespace tribo::protocol {

inline constexpr std::string_view beyond_double = "outside the range of double precision";
inline constexpr std::string_view film_collapsed =
    "the film has collapsed: nothing balances the load";

// Exactly one of the three: a reason why there is none, a word, or else a finite number.
struct OutputValue {
  std::string_view undefined;
  std::string_view word;
  double number = 0;
};

OutputValue value_of(const OperatingPoint<double>& point, Output output);

// The outputs to compute so that value_of() can tell a word that rests on an overflow.
OutputSet needed_for(OutputSet asked);

}  // namespace tribo::protocol
