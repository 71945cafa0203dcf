// SPDX-License-Identifier: Apache-2.0
// Ways to the film of a line contact: our solver, a solver as in textbooks, and formulas.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ehl/solved_film.hpp"

namespace tribo::benchmarks {

// Film numbers (h/R)(2U)^{−1/2}; NaN: no number. A formula gives one of these numbers.
struct LineFilmAnswer {
  double central = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double at_greatest_pressure = std::numeric_limits<double>::quiet_NaN();
  int steps = 0;  // Newton steps
};

// The numbers of a film; NaN where it is not solved.
LineFilmAnswer film_numbers(const ehl::LineContact& contact, const ehl::SolvedFilm& solved);

struct LineFilmWay {
  std::string family;
  std::string series;  // a diagram joins the ways of a series by a line
  std::string name;
  // The number that a formula stands for; null: a solver, judged by the first two numbers.
  double LineFilmAnswer::*quantity;
  std::function<LineFilmAnswer(const ehl::LineContact& contact)> run;
};

// All ways, from coarse to fine; our own last.
std::vector<LineFilmWay> line_film_ways();

// The coarse film from which our solver and the others begin.
ehl::CoarseFilm coarse_film(const ehl::LineContact& contact);

}  // namespace tribo::benchmarks
