// SPDX-License-Identifier: Apache-2.0
// Numbers that may be given in place of a function's own arguments, as solvers take them: the two
// bodies for their effective modulus, both radii for the ellipse of contact. No adapter has to
// invent them.
#pragma once

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

struct WayToAsk {
  std::string_view name;                          // "bodies"; a word of `verify`
  std::span<const Parameter> given;               // "first_modulus", …
  std::span<const std::string_view> in_place_of;  // arguments of the function: "effective_modulus"
  // The argument of in_place_of at `place`, from numbers in the order of `given`, each in range.
  double (*value)(const Arguments& given, std::size_t place);
  // The numbers that give these arguments, which stand in the order of in_place_of: exactly, or to
  // some roundings.
  Arguments (*numbers)(const Arguments& arguments);
};

// All ways; a function that has all arguments of in_place_of can be asked by it.
std::span<const WayToAsk> ways_to_ask();
bool has_way(const Function& function, const WayToAsk& way);

// The place of a name in a list of parameters; their number where it is none of them.
std::size_t place_in(std::span<const Parameter> parameters, std::string_view name);

}  // namespace tribo::catalogue
