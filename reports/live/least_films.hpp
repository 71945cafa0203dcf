// SPDX-License-Identifier: Apache-2.0
// The solved least films of lines and circles, rounded so that the page has room for them.
#pragma once

#include "tribo/solved_films.hpp"

namespace tribo::live {

// ln Ĥ of the least film, within 1e-4 of the table that film_table() has for the program: so much
// is a step of make_live.py (UNIT) in a film's value and slopes.
const FilmTable& least_film_table(bool is_of_lines);

}  // namespace tribo::live
