// SPDX-License-Identifier: Apache-2.0
// The solved least films of lines and circles, rounded so that the page has room for them.
#pragma once

#include "tribo/solved_films.hpp"

namespace tribo::live {

// Relative error of its films against those of the program's table.
inline constexpr double least_film_rounding = 1e-4;

// ln Ĥ of the least film, as film_table() has it for the program.
const FilmTable& least_film_table(bool is_of_lines);

}  // namespace tribo::live
