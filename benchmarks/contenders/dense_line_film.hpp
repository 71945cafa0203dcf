// SPDX-License-Identifier: Apache-2.0
// The film of a line contact as textbooks program it: the equations of model/ehl, with a full
// matrix of how the pressure at each node changes the film at each node, and Newton's linear
// equations solved by Eigen's PartialPivLU in N³ operations a step.
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
  // Makes a step, damped as in model/ehl. Gives the change of the pressure; NaN: no step is made.
  double step();
  // Makes steps until one changes the pressure by less than 1e-8, but at most 60.
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
