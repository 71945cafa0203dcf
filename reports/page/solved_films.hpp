// SPDX-License-Identifier: Apache-2.0
// Films of line contacts solved over the numbers of load and of material: those of
// reference/ehl/line_films.csv, and those between that a smooth map needs besides.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ehl/line_formulas.hpp"
#include "page/film_surface.hpp"

namespace tribo::report {

// Film numbers (h/R)(2U)^{−1/2} in the order of FilmQuantity, with what each may be off by.
struct SolvedNumbers {
  double load_number, material_number;
  std::array<double, 3> film, error;

  double film_of(const ehl::LineFormula& formula) const {
    return film[static_cast<std::size_t>(formula.quantity)];
  }
};

// The rows that have all three films. Throws std::runtime_error where the file cannot be read.
std::vector<SolvedNumbers> read_solved_films(const std::string& path);

// Solved here. Throws std::runtime_error where it cannot be.
SolvedNumbers solved_numbers(double load_number, double material_number);

// A surface for each quantity, over the table's range with L > 0.
struct FilmMap {
  std::vector<double> load_numbers, material_numbers;  // of the films that it goes through
  std::vector<FilmSurface> surfaces;
  std::size_t solved_here = 0;  // films that the table lacks

  // The films that stand between those of the table are solved; several at a time.
  explicit FilmMap(const std::vector<SolvedNumbers>& table);
};

}  // namespace tribo::report
