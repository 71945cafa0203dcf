// SPDX-License-Identifier: Apache-2.0
// Measures the tables of tribocheck_work_precision.
#pragma once

#include <string>
#include <vector>

#include "cases/jobs.hpp"
#include "contenders/line_film_ways.hpp"
#include "contenders/point_film_ways.hpp"
#include "work_precision/table.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {

// True error against CPU time and evaluations, for the contenders that can run here. The columns:
// job, family, series, name, ns, evaluations, max_ulp, p99_ulp, mean_ulp, failures, no_numbers,
// judged.
Rows errors_against_work(std::vector<Measured> offered, const Effort& effort);

// The greatest error in ulp and the number of failures of each way to F_{5/2}, by ranges of d. Ways
// that run in another process are left out.
Rows errors_by_range();

template <class Contact>
struct JudgedFilm {
  Contact contact;
  FilmAnswer exact;
};

// Contacts from M = 1 at constant viscosity to M = 200 and L = 20, each with the extrapolated film
// of our solver on up to 16384 cells. Throws std::runtime_error if a film is not solved.
std::vector<JudgedFilm<ehl::LineContact>> judged_contacts(double tolerance = 1e-9);

// Films of line or point contacts. The columns: job, family, series, name, ns (per contact), steps,
// max_relative, mean_relative, no_numbers, judged. Formulas are not judged where the viscosity is
// constant.
template <class Contact>
Rows film_errors(const std::string& job, const std::vector<FilmWay<Contact>>& ways,
                 const std::vector<JudgedFilm<Contact>>& contacts, const Effort& effort);

// The columns: solver, cells, kernel_ns (to fill the matrix of influences), step_ns (for the linear
// equations of one Newton step), bytes (of both matrices).
Rows line_film_growth(const Effort& effort);

// Flooded circles, (M, L) = (20, 5) and (200, 10), each with the extrapolated film of our solver on
// up to `greatest_nodes`. Throws std::runtime_error if a film is not solved, or if it differs from
// its row of reference/ehl/point_films.csv by more than the sum of both errors.
std::vector<JudgedFilm<ehl::PointContact>> judged_points(Eigen::Index greatest_nodes = 300'000);

// The same columns as film_errors(); each series names the contact.
Rows point_film_errors(const std::vector<JudgedFilm<ehl::PointContact>>& contacts,
                       const Effort& effort);

// The columns of line_film_growth() for point contacts. `cells` counts those of the half plane. Our
// solver is measured on grids of up to `greatest_nodes`. Its `bytes` are the most memory that it
// added to this process; those of the textbooks' solver are the bytes of its matrices.
Rows point_film_growth(Eigen::Index greatest_nodes = 80'000);

// The columns threads, ns: the real time per circle on 1, 2, 4, … threads, up to the number of
// cores. Each thread solves `films_a_thread` circles on average, to 1e-3 at M = 20 and L = 5.
Rows point_films_on_threads(int films_a_thread = 4);

// The columns solver, quantity, exponent, uncertainty, from_cells, to_cells: each exponent is the
// slope of a least-squares fit of ln(quantity) over ln(cells), from 512 cells on, and the
// uncertainty is its standard error.
Rows film_exponents(const Rows& growth);

}  // namespace tribo::benchmarks
