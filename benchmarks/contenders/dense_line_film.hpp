// SPDX-License-Identifier: Apache-2.0
// The film of a line contact as textbooks program it. The equations are those of model/ehl.
// Newton's linear equations have a full matrix, because the pressure at each node changes the film
// at each node. Eigen's PartialPivLU solves them in about N³ operations a step.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "ehl/line_film.hpp"

namespace tribo::benchmarks {

// Adds a change of pressure and separation, or a part of it, to the film `now`, as model/ehl does.
// The first part tried is the whole change, or less where the whole would move the pressure by more
// than 0.5. The part is halved until the least film is more than a fifth of what it was. Returns
// the greatest change if the whole was added, and 1 if a part was added. Returns NaN and adds
// nothing if the change is not finite or no part above 1e-4 will do.
template <class Film, class FilmOf>
double damped_step(Film& now, const Eigen::VectorXd& change, double rise, const FilmOf& film_of) {
  const double greatest = change.cwiseAbs().maxCoeff();
  ++now.steps;
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(greatest)) return nothing;
  const double least = now.film.minCoeff();
  for (double part = std::fmin(1, 0.5 / greatest); part > 1e-4; part /= 2) {
    Eigen::VectorXd pressure = (now.pressure + part * change).cwiseMax(0);
    Eigen::VectorXd film = film_of(pressure, now.separation + part * rise);
    if (film.minCoeff() <= 0.2 * least) continue;
    now.pressure = std::move(pressure);
    now.film = std::move(film);
    now.separation += part * rise;
    return part == 1 ? std::fmax(greatest, std::fabs(rise)) : 1;
  }
  return nothing;
}

class DenseNewton {
 public:
  // Fills the kernel, a matrix of N² entries.
  DenseNewton(const ehl::LineContact& contact, const ehl::Numbers& x);

  void start_from(const ehl::LineFilm& film);
  // Makes a step, damped by damped_step(), and returns what that function returns.
  double step();
  // Makes at most 60 steps, until step() returns less than 1e-8. If that does not happen, or a step
  // returns NaN, the outcome of the film is not_converged.
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
