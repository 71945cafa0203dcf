// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "tribo/solved_films.hpp"
#include "tribo/solved_inlet.hpp"

namespace tribo {
namespace {

constexpr double no_film = std::numeric_limits<double>::quiet_NaN();
#include "film_tables.inc"

}  // namespace

const FilmTable& film_table(const FilmLaw& law) {
  if (law.form == FilmForm::solved_minimum) return law.is_of_lines ? line_minimum : point_minimum;
  return law.is_of_lines ? line_central : point_central;
}

const InletTable& inlet_table() { return inlet_exponents; }

}  // namespace tribo
