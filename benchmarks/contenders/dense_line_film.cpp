// SPDX-License-Identifier: Apache-2.0
#include "contenders/dense_line_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ehl/influence.hpp"
#include "ehl/reynolds.hpp"

namespace tribo::benchmarks {

using Eigen::Index;
using Eigen::VectorXd;

DenseNewton::DenseNewton(const ehl::LineContact& contact, const ehl::Numbers& x)
    : contact_(contact) {
  const auto size = static_cast<Index>(x.size());
  now_.x = x;
  kernel_ = Eigen::MatrixXd::Zero(size, size);
  jacobian_ = Eigen::MatrixXd(size, size);
  weights_ = VectorXd::Zero(size);
  parabola_ = VectorXd(size);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto column = static_cast<Index>(j);
    parabola_[column] = x[j] * x[j] / 2;
    if (j == 0 || j + 1 == x.size()) continue;
    weights_[column] = (x[j + 1] - x[j - 1]) / 2;
    for (std::size_t i = 0; i < x.size(); ++i)
      kernel_(static_cast<Index>(i), column) =
          ehl::film_of_hat(x[i] - x[j], x[j] - x[j - 1], x[j + 1] - x[j]);
  }
}

void DenseNewton::start_from(const ehl::LineFilm& film) {
  const ehl::Numbers pressure =
      ehl::interpolated(film.x, {film.pressure.data(), film.x.size()}, now_.x);
  now_.pressure = Eigen::Map<const VectorXd>(pressure.data(), kernel_.rows());
  now_.pressure[0] = now_.pressure[kernel_.rows() - 1] = 0;
  now_.separation = film.separation;
  now_.film = film_of(now_.pressure, now_.separation);
  now_.steps = film.steps;
}

VectorXd DenseNewton::film_of(const VectorXd& pressure, double separation) const {
  VectorXd film = kernel_ * pressure + parabola_;
  film.array() += separation;
  return film;
}

double DenseNewton::step() {
  const Index size = kernel_.rows();
  const ehl::Balance balance = ehl::balance_of(contact_, now_.x, now_.pressure, now_.film);
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(size, 2);
  std::vector<char> is_free(now_.x.size(), 0);
  for (Index i = 0; i < size; ++i) {
    const auto node = static_cast<std::size_t>(i);
    const bool is_inside = i > 0 && i + 1 < size;
    is_free[node] =
        is_inside && now_.pressure[i] > balance.surplus[i] / (balance.diffusion[i] + kernel_(i, i))
            ? 1
            : 0;
    sides(i, 0) = is_free[node] == 1 ? -balance.surplus[i] : -now_.pressure[i];
    if (is_free[node] == 1)
      for (const double slope : balance.slopes[node].by_film) sides(i, 1) += slope;
  }
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i) {
      const auto node = static_cast<std::size_t>(i);
      double entry = i == j ? 1 : 0;
      if (is_free[node] == 1) {
        entry = 0;
        for (Index k = 0; k < 4; ++k) {
          const Index row = i - 2 + k;
          if (row < 0 || row >= size) continue;
          entry += balance.slopes[node].by_film[static_cast<std::size_t>(k)] * kernel_(row, j);
          if (row == j) entry += balance.slopes[node].by_pressure[static_cast<std::size_t>(k)];
        }
      }
      jacobian_(i, j) = entry;
    }
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factored(jacobian_);
  sides = factored.solve(sides).eval();
  const double missing = std::numbers::pi / 2 - weights_.dot(now_.pressure + sides.col(0));
  const double rise = -missing / weights_.dot(sides.col(1));
  return damped_step(
      now_, sides.col(0) - rise * sides.col(1), rise,
      [&](const VectorXd& pressure, double separation) { return film_of(pressure, separation); });
}

ehl::LineFilm DenseNewton::run() {
  now_.outcome = ehl::Outcome::not_converged;
  for (int made = 0; made < 60; ++made) {
    const double change = step();
    if (!std::isfinite(change)) break;
    if (change < 1e-8) {
      now_.outcome = ehl::Outcome::solved;
      break;
    }
  }
  // The flow is taken at the greatest pressure. The pressure drives no flow there: its slope is 0.
  Index peak;
  now_.pressure.maxCoeff(&peak);
  const ehl::Balance balance = ehl::balance_of(contact_, now_.x, now_.pressure, now_.film, false);
  now_.mass_flow = balance.flow[std::min(peak, balance.flow.size() - 1)];
  return now_;
}

std::size_t DenseNewton::bytes() const {
  return static_cast<std::size_t>(kernel_.size() + jacobian_.size()) * sizeof(double);
}

}  // namespace tribo::benchmarks
