// SPDX-License-Identifier: Apache-2.0
// The film of a line contact as textbooks program it: the same equations as model/ehl, with the
// whole matrix of the films that each pressure raises, and Newton's linear equations solved by
// Eigen's PartialPivLU: N³ operations a step.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "ehl/line_film.hpp"

namespace tribo::benchmarks {

class DenseNewton {
 public:
  // Fills the matrix, N² entries.
  DenseNewton(const ehl::LineContact& contact, const ehl::Numbers& x);

  void start_from(const ehl::LineFilm& film);
  // Makes a step, damped as ours. Gives the change of the pressure; NaN: no step could be made.
  double step();
  // Makes steps until one changes less than 1e-8, but at most 60.
  ehl::LineFilm run();
  std::size_t bytes() const;  // size of both matrices

 private:
  Eigen::VectorXd film_of(const Eigen::VectorXd& pressure, double separation) const;

  ehl::LineContact contact_;
  Eigen::MatrixXd kernel_, jacobian_;
  Eigen::VectorXd weights_, parabola_;
  ehl::LineFilm now_;
};

}  // namespace tribo::benchmarks
