// SPDX-License-Identifier: Apache-2.0
// A way to the film of a contact, of lines or of points.
#pragma once

#include <functional>
#include <limits>
#include <string>

namespace tribo::benchmarks {

// Film numbers, (h/R)(2U)^{−1/2}; NaN: no number. A formula gives one of these numbers.
struct FilmAnswer {
  double central = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double at_greatest_pressure = std::numeric_limits<double>::quiet_NaN();
  int steps = 0;  // Newton steps, or sweeps of a relaxation
};

template <class Contact>
struct FilmWay {
  std::string family;
  std::string series;  // a diagram joins the ways of a series by a line
  std::string name;
  // The number of FilmAnswer that a formula gives. Null for a solver, which is judged by `central`
  // and `minimum`.
  double FilmAnswer::*quantity;
  std::function<FilmAnswer(const Contact& contact)> run;
};

}  // namespace tribo::benchmarks
