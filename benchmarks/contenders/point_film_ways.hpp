// SPDX-License-Identifier: Apache-2.0
// Methods for the film of a flooded circular contact: our solver, and two methods of textbooks.
#pragma once

#include <vector>

#include "contenders/film_way.hpp"
#include "ehl/solved_point.hpp"

namespace tribo::benchmarks {

// The film numbers of a solved film; NaN if it is not solved.
FilmAnswer film_numbers(const ehl::PointContact& contact, const ehl::SolvedPoint& solved);

// All methods, each from coarse to fine. Our own come last. The textbooks' methods start from our
// film on a coarse grid. For relaxation, with up to 3000 sweeps, this is our coarsest grid. For
// Newton's method, on grids of up to 2500 nodes, it is a grid with half the cells of our coarsest.
std::vector<FilmWay<ehl::PointContact>> point_film_ways(const ehl::PointContact& contact);

// The number of cells `cells` for which ehl::grid_for() makes our coarsest grid.
int coarsest_cells(const ehl::PointContact& contact);

}  // namespace tribo::benchmarks
