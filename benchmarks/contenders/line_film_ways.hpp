// SPDX-License-Identifier: Apache-2.0
// Ways to the film of a line contact: solved by ours, solved as textbooks do, and by formulas.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ehl/solved_film.hpp"

namespace tribo::benchmarks {

// Film numbers (h/R)(2U)^{−1/2}; NaN: no number. A formula gives one of them.
struct LineFilmAnswer {
  double central = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double at_greatest_pressure = std::numeric_limits<double>::quiet_NaN();
  int steps = 0;  // Newton steps
};

struct LineFilmWay {
  std::string family;
  std::string series;  // a diagram joins its ways by a line
  std::string name;
  // The one number that a formula stands for; none: a solver, judged by the first two.
  double LineFilmAnswer::*quantity;
  std::function<LineFilmAnswer(const ehl::LineContact& contact)> run;
};

// Every one, from coarse to fine; ours last.
std::vector<LineFilmWay> line_film_ways();

// Where ours begins, too.
ehl::CoarseFilm coarse_film(const ehl::LineContact& contact);

}  // namespace tribo::benchmarks
