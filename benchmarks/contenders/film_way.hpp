// SPDX-License-Identifier: Apache-2.0
// Methods that compute the film of a line contact or of a point contact.
#pragma once

#include <functional>
#include <limits>
#include <string>

namespace tribo::benchmarks {

// Numbers (h/R)(2U)^{−1/2} of a film. A number that the method does not give is NaN; a formula
// gives only one of the three.
struct FilmAnswer {
  double central = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double at_greatest_pressure = std::numeric_limits<double>::quiet_NaN();
  int steps = 0;  // Newton steps, or sweeps of a relaxation
};

template <class Contact>
struct FilmWay {
  std::string family;
  std::string series;  // a diagram joins the methods of a series by a line
  std::string name;
  // The member of FilmAnswer that a formula gives. Null for a solver, which is judged by `central`
  // and `minimum`.
  double FilmAnswer::*quantity;
  std::function<FilmAnswer(const Contact& contact)> run;
};

}  // namespace tribo::benchmarks
