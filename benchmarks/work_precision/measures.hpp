// SPDX-License-Identifier: Apache-2.0
// The tables that are measured.
#pragma once

#include <vector>

#include "cases/jobs.hpp"
#include "work_precision/table.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {

// True error against CPU time and evaluations, every contender from coarse to fine, and others
// besides: job, family, series, name, ns, evaluations, max_ulp, p99_ulp, mean_ulp, failures,
// no_numbers, judged.
Rows errors_against_work(const Effort& effort, std::vector<Measured> others = {});

// Greatest error of each way to F_{5/2} in ulp, by ranges of d.
Rows errors_by_range();

// Films of line contacts: job, family, series, name, ns, steps, max_relative, mean_relative,
// no_numbers, judged. Judged against ours on up to 16384 cells, extrapolated; a point is a contact.
Rows line_film_errors(const Effort& effort);

// solver, cells, kernel_ns, step_ns, bytes: of the matrix of influences, of one step of Newton's
// method, and of both matrices.
Rows line_film_growth(const Effort& effort);

// solver, quantity, exponent, uncertainty, from_cells, to_cells: least squares of the logarithms of
// a growth over the cells, from 512 cells on; the uncertainty is its standard error.
Rows line_film_exponents(const Rows& growth);

}  // namespace tribo::benchmarks
