// SPDX-License-Identifier: Apache-2.0
// Films of line contacts solved over the numbers of load and of material: those of
// reference/ehl/line_films.csv, and those between, of line_films_between.csv, that a smooth map
// needs besides.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
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

// The rows that have all three films, and this word in the column `role`, if one is given. Throws
// std::runtime_error where the file cannot be read.
std::vector<SolvedNumbers> read_solved_films(const std::string& path, std::string_view role = {});

// A surface for each quantity, over the table's range with L > 0.
struct FilmMap {
  std::vector<double> load_numbers, material_numbers;  // numbers of the films at its nodes
  std::vector<FilmSurface> surfaces;

  // Throws std::runtime_error where the table lacks a load number with a material number.
  explicit FilmMap(const std::vector<SolvedNumbers>& table);
};

}  // namespace tribo::report
