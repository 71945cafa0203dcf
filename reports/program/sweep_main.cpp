// SPDX-License-Identifier: Apache-2.0
// tribocheck_sweep: the command `tribocheck sweep`, and `tribocheck film --fields`. main.cpp says
// why it is a program of its own.
#include <array>

#include "command.hpp"
#include "film_command.hpp"

int main(int count, char** arguments) {
  return tribo::cli::run_program(
      std::array{&tribo::cli::add_sweep, &tribo::cli::add_film_with_fields}, count, arguments);
}
