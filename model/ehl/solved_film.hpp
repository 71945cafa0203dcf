// SPDX-License-Identifier: Apache-2.0
// A line contact solved to a stated error: on grids of which each halves the cells of the one
// before, with the order that is observed, Richardson's value and an estimate of what is left.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "ehl/film_features.hpp"
#include "ehl/line_film.hpp"

namespace tribo::ehl {

// A number and what it may be off by. NaN: there is no such number.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  // absolute
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN: not regular

  double relative_error() const { return error / value; }
};

// From the values on grids that halve the cells: at least three. Where the observed order is the
// second (1.5 to 2.6), the value is Richardson's and the error what Richardson's value changed by,
// or half of what it changed by before, if that is more: where a spike is not resolved these
// changes are irregular. Else the value is the last one and the error what it changed by.
Estimate estimate_of(const std::vector<double>& values);

struct SolveOptions {
  double tolerance = 1e-4;    // relative, of the central and the least film
  int first_cells = 128;      // of the coarsest grid
  int greatest_cells = 8192;  // of the finest
  double at_edge = 0.05;      // share of the nodes in the constriction: more resolve sharper spikes
};

struct SolvedFilm {
  Outcome outcome = Outcome::not_converged;
  // solved: empty. Else a sentence that says what failed, where, and what was reached.
  std::string reason;
  LineFilm film;  // on the finest grid that was solved
  int grids = 0;
  // H and P of film_features.hpp.
  Estimate central, minimum, at_greatest_pressure, spike_pressure, spike_place;
  double domain_error =
      0;          // of films, relative: that of an inlet that is not endless; in the errors
  int steps = 0;  // of Newton's method, in all
};

// Error of each number: its Estimate. `reason` is not empty where the tolerance was not met, too;
// then outcome is solved and the numbers hold with their errors. Range: expected H above 1e-8, M
// from 0.01.
SolvedFilm solve_line_film(const LineContact& contact, const SolveOptions& options = {},
                           const Watch& watch = {});

}  // namespace tribo::ehl
