// SPDX-License-Identifier: Apache-2.0
// A point contact solved to a stated error: like a line in solved_film.hpp, on plane grids.
#pragma once

#include <string>

#include "ehl/film_features.hpp"
#include "ehl/point_film.hpp"
#include "ehl/solved_film.hpp"

namespace tribo::ehl {

struct PointOptions {
  // Relative, of the central film. The error of the least film, which lies where the film bends
  // most, may be three times as great. No tolerance applies to the film at the greatest pressure:
  // where that pressure is a spike's, it moves with the grid.
  double tolerance = 1e-3;
  Eigen::Index greatest_nodes = 900'000;  // of the finest grid
  Integrand integrand = {};
};

struct SolvedPoint {
  Outcome outcome = Outcome::not_converged;
  // Empty where the film is solved to the tolerance. Else it says what failed, where, and how far
  // the solver came, without a capital and a full stop.
  std::string reason;
  PointFilm film;  // on the finest grid that was solved
  int grids = 0;
  Estimate central, minimum, at_greatest_pressure;  // H
  Estimate integral;  // of PointOptions::integrand; no tolerance applies to it
  // The relative error from the ends of the grid: the greatest of the three films'. The errors
  // above include their own.
  double domain_error = 0;
  int steps = 0;  // of Newton's method and in time, on the way to the finest grid
};

// The solver was tried from the first to the second number, and refuses contacts below the first.
inline constexpr double least_point_load_number = 1, greatest_tried_point_load_number = 5000;
// The range of H_oil that is solved, over expected_film() of the flooded contact. A thicker layer
// nearly floods the contact; with a thinner layer the film is nearly as thick as the layer.
inline constexpr double least_layer = 0.05, greatest_layer = 6;

// A grid that is too short is made longer by the first factor, as often as needed, while it stays
// below the second number times the length that is tried first.
inline constexpr double length_step = 1.25, greatest_length = 4;

// The nodes for a contact, with `cells` cells on the length that pressure reaches. `longer`: its
// length over that which solve_point_film() tries first.
PlaneGrid grid_for(const PointContact& contact, int cells, double longer = 1);

// So many coarsest grids are tried at most.
inline constexpr int most_coarsest_grids = 3;

// The cells of the next coarsest grid, to try where one of `cells` led to no film or its three
// grids left too great an error: half as many again, or fewer, so that three grids stay within the
// greatest number of nodes. 0 where there is no room for a tenth more cells.
int more_cells(const PointContact& contact, int cells, const PointOptions& options);

// Error of each film: its Estimate, from three grids or more and from a larger one. Where the
// tolerance was not met, or a grid after the third one failed or was stopped, the outcome is
// `solved` all the same, the films hold with their errors, and `reason` says which error was
// reached.
SolvedPoint solve_point_film(const PointContact& contact, const PointOptions& options = {},
                             const Watch& watch = {});

}  // namespace tribo::ehl
