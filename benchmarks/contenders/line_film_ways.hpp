// SPDX-License-Identifier: Apache-2.0
// Methods for the film of a line contact: our solver, a solver as in textbooks, and formulas.
#pragma once

#include <vector>

#include "contenders/film_way.hpp"
#include "ehl/solved_film.hpp"

namespace tribo::benchmarks {

using LineFilmWay = FilmWay<ehl::LineContact>;

// The film numbers of a solved film; NaN if it is not solved.
FilmAnswer film_numbers(const ehl::LineContact& contact, const ehl::SolvedFilm& solved);

// All methods, each from coarse to fine. Our own come last.
std::vector<LineFilmWay> line_film_ways();

// The coarse film from which our solver and the others begin.
ehl::CoarseFilm coarse_film(const ehl::LineContact& contact);

}  // namespace tribo::benchmarks
