// SPDX-License-Identifier: Apache-2.0
// Numbers that a solver may be given in place of a function's own arguments: the two bodies for the
// effective modulus, or both radii for the ellipse of contact. No adapter has to invent them.
#pragma once

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

struct WayToAsk {
  std::string_view name;                          // "bodies"; a word of `verify`
  std::span<const Parameter> given;               // "first_modulus", …
  std::span<const std::string_view> in_place_of;  // arguments of the function: "effective_modulus"
  // The argument of in_place_of at `place`, from numbers in the order of `given`, each in range.
  double (*value)(const Arguments& given, std::size_t place);
  // The inverse: numbers that give these arguments, exactly or within a few roundings. The
  // arguments are in the order of in_place_of.
  Arguments (*numbers)(const Arguments& arguments);
};

// All ways. A function can be asked by a way if it has all arguments of the way's in_place_of.
std::span<const WayToAsk> ways_to_ask();
bool has_way(const Function& function, const WayToAsk& way);

// The place of a name in a list of parameters; parameters.size() if no parameter has this name.
std::size_t place_in(std::span<const Parameter> parameters, std::string_view name);

}  // namespace tribo::catalogue
