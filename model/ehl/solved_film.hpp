// SPDX-License-Identifier: Apache-2.0
// A line contact solved to a stated error: on grids of which each halves the cells of the one
// before, with the observed order, Richardson's value and an estimate of the error that is left.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ehl/film_features.hpp"
#include "ehl/line_film.hpp"

namespace tribo::ehl {

// A number and its error. NaN: there is no such number.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  // absolute
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN: not regular

  double relative_error() const { return error / std::fabs(value); }
};

// The value on one more grid, beside a sequence, with fewer cells than its last grid.
struct Beside {
  double value = std::numeric_limits<double>::quiet_NaN();  // NaN: there is no such grid
  double cells_ratio = 1;                                   // cells of the last grid over its own
};

// An error is the greatest of some differences, each times its share. of_last: the last change of
// Richardson's value from grid to grid (where errors are regular, a fifteenth of it is left). The
// two changes of this value before count less, each by the factor `falling`. of_change: the last
// change of the value itself. of_waver: the difference between the value on the grid beside and the
// value that the second order predicts there; it shows how much an unresolved spike makes the
// values waver. The shares of films (solved_film.cpp) are chosen, not derived: with them the error
// held on each grid of 220 random contacts. `make film-survey` judges them by 300 others.
struct Caution {
  double of_last = 0.5, falling = 0.125, of_change = 0.022, of_waver = 0;
  // The value is Richardson's where the observed order lies between these.
  double least_order = 1.5, greatest_order = 2.6;
  // Used where the order does not lie between these and there is a grid beside: the error is at
  // least this share of the last change of the value, and a quarter of this share of the change
  // before. 0: the grid beside is not used then.
  double of_irregular = 0;
};

// From the values on at least three grids, each of which halves the cells; with fewer values all
// numbers are NaN. Where the observed order is within its limits, the value is Richardson's and the
// error the greatest of the shares; of_last counts three times where there are only three values
// and no grid beside. Else the value is the last one, and the error 1.5 times the sum of its last
// two changes; or, with a grid beside and of_irregular > 0, the value is Richardson's with shares
// of these changes.
Estimate estimate_of(const std::vector<double>& values, const Caution& caution = {},
                     const Beside& beside = {});

// Contacts whose M or film H is below the first two numbers are refused. The solver was tried up to
// the other two; beyond them it may converge, and says so where it does not.
inline constexpr double least_load_number = 1e-3;
inline constexpr double least_film = 1e-8;
inline constexpr double greatest_tried_load_number = 1e4;
inline constexpr double greatest_tried_material_number = 50;

struct SolveOptions {
  double tolerance = 1e-4;  // relative, of the three films
  // Relative, of the spike's pressure.
  double spike_tolerance = std::numeric_limits<double>::infinity();
  int greatest_cells = 8192;  // of the finest
  double at_edge = 0.05;      // share of the nodes in the constriction: more resolve sharper spikes
  Integrand integrand = {};
};

struct SolvedFilm {
  Outcome outcome = Outcome::not_converged;
  // Empty where the film is solved to the tolerance. Else it says what failed, where, and how far
  // the solver came, without a capital and a full stop.
  std::string reason;
  LineFilm film;  // on the finest grid that was solved
  int grids = 0;
  // H and P of film_features.hpp.
  Estimate central, minimum, at_greatest_pressure, spike_pressure, spike_place;
  Estimate integral;  // of SolveOptions::integrand; no tolerance applies to it
  // The films' relative error from the finite length of the inlet; the errors above include it.
  double domain_error = 0;
  int steps = 0;  // of Newton's method, on the way to the finest grid
};

// The places of the nodes of all grids of a contact, and the film on the coarsest grid.
struct CoarseFilm {
  LineFilm film;
  NodeDensity density;  // follows the film, if that is solved
};
CoarseFilm solve_coarse_film(const LineContact& contact, int cells, const Scales& scales,
                             double at_edge, const Watch& watch);

// Error of each number: its Estimate. Where the tolerance was not met, or a finer grid failed or
// was stopped, the outcome is `solved` all the same, the numbers hold with their errors, and
// `reason` says which error was reached.
SolvedFilm solve_line_film(const LineContact& contact, const SolveOptions& options = {},
                           const Watch& watch = {});

}  // namespace tribo::ehl
