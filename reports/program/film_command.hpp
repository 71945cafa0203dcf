// SPDX-License-Identifier: Apache-2.0
// The command `film`, which two programs have. The one that is linked with HDF5 writes fields.
#pragma once

#include <string>

#include "command.hpp"
#include "film_case.hpp"

namespace tribo::cli {

// Writes the fields of a case to the file `path`, as CSV or as HDF5. Throws std::runtime_error
// where it cannot be written.
using WriteFields = void (*)(const FilmCase& film, const std::string& path, bool is_csv);

// `write`: null in the program that does not write fields.
Command film_command(CLI::App& program, WriteFields write);
Command add_film_with_fields(CLI::App& program);

}  // namespace tribo::cli
