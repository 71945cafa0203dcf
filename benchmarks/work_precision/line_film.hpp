// SPDX-License-Identifier: Apache-2.0
// Films of line contacts: error against time of every way, and how time and memory grow with the
// cells of the grid.
#pragma once

#include "work_precision/effort.hpp"
#include "work_precision/table.hpp"

namespace tribo::benchmarks {

// job, family, series, name, ns, steps, max_relative, mean_relative, no_numbers, judged. Judged
// against ours on up to 16384 cells, extrapolated; a point is a contact.
Rows line_film_errors(const Effort& effort);

// solver, cells, kernel_ns, step_ns, bytes: of the matrix of influences, of one step of Newton's
// method, and of both matrices.
Rows line_film_growth(const Effort& effort);

// solver, quantity, exponent, uncertainty, from_cells, to_cells: least squares of the logarithms of
// a growth over the cells, from 512 cells on; the uncertainty is its standard error.
Rows line_film_exponents(const Rows& growth);

}  // namespace tribo::benchmarks
