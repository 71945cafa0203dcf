// SPDX-License-Identifier: Apache-2.0
// The tables that are measured.
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

// Contacts from a nearly rigid one of constant viscosity to a heavy one of a very viscous liquid,
// each with the extrapolated film of our solver on up to 16384 cells. Throws std::runtime_error.
std::vector<JudgedFilm<ehl::LineContact>> judged_contacts(double tolerance = 1e-9);

// Films of line or of point contacts: job, family, series, name, ns, steps, max_relative,
// mean_relative, no_numbers, judged; a point is a contact. Formulas are not judged where the
// viscosity is constant.
template <class Contact>
Rows film_errors(const std::string& job, const std::vector<FilmWay<Contact>>& ways,
                 const std::vector<JudgedFilm<Contact>>& contacts, const Effort& effort);

// solver, cells, kernel_ns to fill the matrix of influences, step_ns for the linear equations of
// one Newton step, bytes of both matrices.
Rows line_film_growth(const Effort& effort);

// Flooded circles, (M, L) = (20, 5) and (200, 10), each with the extrapolated film of our solver on
// up to `greatest_nodes`, which it checks against the row of reference/ehl/point_films.csv within
// the sum of both errors. Throws std::runtime_error.
std::vector<JudgedFilm<ehl::PointContact>> judged_points(Eigen::Index greatest_nodes = 300'000);

// The same columns as film_errors(); each series names the contact.
Rows point_film_errors(const std::vector<JudgedFilm<ehl::PointContact>>& contacts,
                       const Effort& effort);

// The columns of line_film_growth() for point contacts, with the cells of the half plane. Our
// solver is measured on grids of up to `greatest_nodes`, and its bytes are the most that it added
// to the memory of this process; the bytes of the textbooks' solver are those of its matrices.
Rows point_film_growth(Eigen::Index greatest_nodes = 80'000);

// The columns threads, ns: the time on the clock divided by the number of circles that the threads
// solve beside each other, to 1e-3 at M = 20 and L = 5; on 1, 2, 4, … threads, up to the number of
// cores.
Rows point_films_on_threads(int films_a_thread = 4);

// The columns solver, quantity, exponent, uncertainty, from_cells, to_cells: each exponent is the
// slope of a least-squares fit of ln(quantity) over ln(cells), from 512 cells on, and the
// uncertainty is its standard error.
Rows film_exponents(const Rows& growth);

}  // namespace tribo::benchmarks
