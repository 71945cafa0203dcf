// SPDX-License-Identifier: Apache-2.0
// A function of the catalogue at many points, by columns. For point i, argument[k][i] is argument k
// (in the order of the parameters; a word is given by its place), and result[k][i] is result k.
// step[k] is 1, or 0 if all points have argument[k][0]. A null `step` means 1 for each argument.
#pragma once

#include <cstddef>
#include <optional>

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

// The status of a point: computed or refused. The numbers are those of tribocheck_plugin.h.
inline constexpr int point_done = 0, point_refused = 3;

// The first fault of the arguments of a point; empty if they are legal. NaN and infinities are
// never legal.
struct ArgumentFault {
  std::string_view parameter;  // its name
  std::string message;         // "-3 is not allowed; allowed: a number above 0, in N"
};
std::optional<ArgumentFault> fault_in(const Function& function, const Arguments& arguments);

// Computes the results of `count` points, writes the status of each unless `status` is null, and
// returns how many are refused. The results of a refused point are NaN; a result that no double
// holds is ∞. The bits of a point do not depend on the other points. A column of results must not
// overlap another column. Nothing is allocated, and any thread may call.
std::size_t values_at(const Function& function, std::size_t count, const double* const* argument,
                      const std::size_t* step, double* const* result, int* status);

}  // namespace tribo::catalogue
