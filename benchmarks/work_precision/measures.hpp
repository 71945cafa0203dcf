// SPDX-License-Identifier: Apache-2.0
// The tables that are measured.
#pragma once

#include <vector>

#include "cases/jobs.hpp"
#include "contenders/line_film_ways.hpp"
#include "work_precision/table.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {

// True error against CPU time and evaluations, of contenders that can run here: job, family,
// series, name, ns, evaluations, max_ulp, p99_ulp, mean_ulp, failures, no_numbers, judged.
Rows errors_against_work(std::vector<Measured> offered, const Effort& effort);

// Greatest error of each way to F_{5/2} in ulp, by ranges of d.
Rows errors_by_range();

struct JudgedContact {
  ehl::LineContact contact;
  LineFilmAnswer exact;
};

// Contacts from a nearly rigid one of constant viscosity to a heavy one of a very viscous liquid,
// each with the extrapolated film of our solver on up to 16384 cells. Throws std::runtime_error.
std::vector<JudgedContact> judged_contacts(double tolerance = 1e-9);

// Films of line contacts: job, family, series, name, ns, steps, max_relative, mean_relative,
// no_numbers, judged; a point is a contact. Formulas are not judged where the viscosity is
// constant.
Rows line_film_errors(const std::vector<LineFilmWay>& ways,
                      const std::vector<JudgedContact>& contacts, const Effort& effort);

// solver, cells, kernel_ns to fill the matrix of influences, step_ns for the linear equations of
// one Newton step, bytes of both matrices.
Rows line_film_growth(const Effort& effort);

// solver, quantity, exponent, uncertainty, from_cells, to_cells: least squares of the logarithms of
// a growth over the cells, from 512 cells on; the uncertainty is its standard error.
Rows line_film_exponents(const Rows& growth);

}  // namespace tribo::benchmarks
