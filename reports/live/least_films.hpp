// SPDX-License-Identifier: Apache-2.0
// The solved least films of lines and circles, rounded so that the page has room for them.
#pragma once

#include "tribo/solved_films.hpp"

namespace tribo::live {

// ln Ĥ of the least film, within 1e-4 of the table that film_table() gives in the program, because
// make_live.py rounds the value and the slopes of each film to steps of that size (UNIT).
const FilmTable& least_film_table(bool is_of_lines);

}  // namespace tribo::live
