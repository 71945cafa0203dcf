// SPDX-License-Identifier: Apache-2.0
// A function of the catalogue at many points, by columns: argument[k][i] is argument k of point i,
// in the order of the parameters, of a word its place; result[k][i] likewise. Where step[k] is 0
// and not 1, argument[k][0] is that of all points; a null `step` is 1 for each.
#pragma once

#include <cstddef>
#include <optional>

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

// Whether the results of a point were computed; the numbers are those of tribocheck_plugin.h.
inline constexpr int point_done = 0, point_refused = 3;

// The first thing that is wrong with the arguments of a point; empty: they are legal. A NaN or an
// infinity never is.
struct ArgumentFault {
  std::string_view parameter;  // its name
  std::string message;         // "-3 is not allowed; allowed: a number above 0, in N"
};
std::optional<ArgumentFault> fault_in(const Function& function, const Arguments& arguments);

// Computes the results of `count` points, writes the status of each unless `status` is null, and
// returns how many are refused. The results of a point that is refused are NaN; an infinity is a
// result that no double holds. Each point has the bits that it has alone. Columns of results
// overlap no others. Nothing is allocated, and any thread may call.
std::size_t values_at(const Function& function, std::size_t count, const double* const* argument,
                      const std::size_t* step, double* const* result, int* status);

}  // namespace tribo::catalogue
