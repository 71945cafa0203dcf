// SPDX-License-Identifier: Apache-2.0
// Ways to the film of a flooded circle: our solver, and two as in textbooks.
#pragma once

#include <vector>

#include "contenders/film_way.hpp"
#include "ehl/solved_point.hpp"

namespace tribo::benchmarks {

// The numbers of a film; NaN where it is not solved.
FilmAnswer film_numbers(const ehl::PointContact& contact, const ehl::SolvedPoint& solved);

// All ways, from coarse to fine; our own last. The textbooks' ways begin with a coarse film of
// ours: relaxation, with up to 3000 sweeps, with the film on our coarsest grid; Newton's method, on
// grids of up to 2500 nodes, with the film on a grid of half as many cells.
std::vector<FilmWay<ehl::PointContact>> point_film_ways(const ehl::PointContact& contact);

// The number of cells that our coarsest grid has on the length that pressure reaches.
int coarsest_cells(const ehl::PointContact& contact);

}  // namespace tribo::benchmarks
