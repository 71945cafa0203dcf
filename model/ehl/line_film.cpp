// SPDX-License-Identifier: Apache-2.0
#include "ehl/line_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ehl/film_kernel.hpp"
#include "ehl/jacobian.hpp"
#include "ehl/reynolds.hpp"

namespace tribo::ehl {
namespace {

using Eigen::VectorXd;

constexpr double greatest_change = 0.5;   // of P in one step: Hertz' peak is 1
constexpr double rounding_change = 1e-7;  // of P, at most

// What a grid's nodes weigh in ∫ P dX.
VectorXd load_weights(const Numbers& x) {
  VectorXd weights = VectorXd::Zero(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 1; i + 1 < x.size(); ++i)
    weights[static_cast<Eigen::Index>(i)] = (x[i + 1] - x[i - 1]) / 2;
  return weights;
}

VectorXd parabola(const Numbers& x) {
  VectorXd gap(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) gap[static_cast<Eigen::Index>(i)] = x[i] * x[i] / 2;
  return gap;
}

class Newton {
 public:
  Newton(const LineContact& contact, const Numbers& x, const VectorXd& guess, double separation)
      : contact_(contact), kernel_(x), weights_(load_weights(x)), parabola_(parabola(x)) {
    result_.x = x;
    result_.pressure = guess;
    result_.separation = separation;
    result_.film = film_of(guess, separation);
  }

  LineFilm run(const NewtonLimits& limits, const Watch& watch) {
    for (int step = 0; step < limits.steps; ++step) {
      if (watch &&
          !watch({contact_, static_cast<int>(result_.x.size()) - 1, step, result_.last_change})) {
        result_.outcome = Outcome::stopped;
        return std::move(result_);
      }
      const double before = result_.last_change;
      const double part = make_step();
      ++result_.steps;
      if (!(result_.last_change < 1e6) || part == 0) break;
      // Steps that no longer shrink are rounding.
      const bool is_rounding =
          result_.last_change < rounding_change && step > 0 && result_.last_change > before / 2;
      if (part == 1 && (result_.last_change < limits.change || is_rounding)) {
        result_.outcome = Outcome::solved;
        break;
      }
    }
    result_.mass_flow = flow_at_peak();
    return std::move(result_);
  }

 private:
  VectorXd film_of(const VectorXd& pressure, double separation) const {
    VectorXd film = kernel_ * pressure + parabola_;
    film.array() += separation;
    return film;
  }

  // A node is free if a step of its own would leave pressure there.
  std::vector<char> free_nodes(const Balance& balance) const {
    std::vector<char> is_free(result_.x.size(), 0);
    for (std::size_t i = 1; i + 1 < is_free.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      // Where the liquid is so viscous that pressure drives none of it, the film that the pressure
      // lifts still does.
      const double own =
          balance.diffusion[row] + kernel_.entry(static_cast<int>(i), static_cast<int>(i));
      is_free[i] = result_.pressure[row] > balance.surplus[row] / own ? 1 : 0;
    }
    return is_free;
  }

  // Makes the part of a step that leaves the film positive; gives this part.
  double make_step() {
    const Balance balance = balance_of(contact_, result_.x, result_.pressure, result_.film);
    const std::vector<char> is_free = free_nodes(balance);
    const auto size = static_cast<Eigen::Index>(result_.x.size());
    // Left: what the step has to remove. Right: how it changes with H₀.
    Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(size, 2);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto node = static_cast<std::size_t>(i);
      if (is_free[node] == 0) {
        sides(i, 0) = -result_.pressure[i];
        continue;
      }
      sides(i, 0) = -balance.surplus[i];
      for (const double slope : balance.slopes[node].by_film) sides(i, 1) += slope;
    }
    const Jacobian jacobian(kernel_, balance.slopes, is_free);
    result_.bytes = std::max(result_.bytes, kernel_.bytes() + jacobian.bytes());
    sides = jacobian.solve(std::move(sides));
    const double missing_load =
        std::numbers::pi / 2 - weights_.dot(result_.pressure + sides.col(0));
    const double rise = -missing_load / weights_.dot(sides.col(1));
    const VectorXd change = sides.col(0) - rise * sides.col(1);
    result_.last_change = std::max(change.cwiseAbs().maxCoeff(), std::fabs(rise));
    if (!std::isfinite(result_.last_change)) return 0;

    const double least = result_.film.minCoeff();
    double part = std::fmin(1, greatest_change / change.cwiseAbs().maxCoeff());
    for (int halving = 0; halving < 12; ++halving, part /= 2) {
      VectorXd pressure = (result_.pressure + part * change).cwiseMax(0);
      const double separation = result_.separation + part * rise;
      VectorXd film = film_of(pressure, separation);
      if (film.minCoeff() <= 0.2 * least) continue;
      result_.pressure = std::move(pressure);
      result_.separation = separation;
      result_.film = std::move(film);
      return part;
    }
    return 0;
  }

  // The flow is the same between all free nodes; where pressure is greatest it has no part that
  // the pressure drives.
  double flow_at_peak() const {
    Eigen::Index peak;
    result_.pressure.maxCoeff(&peak);
    const Balance balance = balance_of(contact_, result_.x, result_.pressure, result_.film, false);
    return balance.flow[std::min(peak, balance.flow.size() - 1)];
  }

  LineContact contact_;
  FilmKernel kernel_;
  VectorXd weights_, parabola_;
  LineFilm result_;
};

// The same liquid between bodies under another load, and with another rise of its viscosity.
LineContact with_numbers(LineContact contact, double load_number, double material_number) {
  const double pressure = std::sqrt(load_number / contact.load_number);  // as p₀
  contact.fluid.exponent =
      contact.material_number == 0
          ? 0
          : contact.fluid.exponent * pressure * (material_number / contact.material_number);
  contact.fluid.roelands_pressure *= pressure;
  contact.fluid.density_pressure *= pressure;
  contact.load_number = load_number;
  contact.material_number = material_number;
  return contact;
}

}  // namespace

LineFilm solve_from(const LineContact& contact, const Numbers& x, const VectorXd& guess,
                    double separation, const NewtonLimits& limits, const Watch& watch) {
  return Newton(contact, x, guess, separation).run(limits, watch);
}

LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch) {
  const std::span<const double> values(film.pressure.data(), film.x.size());
  Numbers pressure = interpolated(film.x, values, x);
  pressure.front() = pressure.back() = 0;
  LineFilm solved = solve_from(
      contact, x, Eigen::Map<const VectorXd>(pressure.data(), static_cast<Eigen::Index>(x.size())),
      film.separation, {}, watch);
  solved.steps += film.steps;
  return solved;
}

LineFilm solve_from_nothing(const LineContact& contact, int cells, const Scales& scales,
                            const Watch& watch) {
  const NewtonLimits limits{.steps = 25, .change = 1e-8};
  const Numbers x = first_density(scales).nodes(cells);
  VectorXd guess(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    guess[static_cast<Eigen::Index>(i)] = std::sqrt(std::fmax(0, 1 - x[i] * x[i]));
  double load_number = std::fmin(contact.load_number, 1);
  LineContact now = with_numbers(contact, load_number, 0);
  LineFilm film = solve_from(now, x, guess, expected_film(now) / now.film_number(1),
                             {.steps = 60, .change = 1e-8}, watch);
  if (film.outcome != Outcome::solved) return film;
  int steps = film.steps;
  // Each way is walked in strides that are halved where one fails and doubled where one succeeds.
  const auto walk = [&](double& place, double end, double stride, auto&& next_of,
                        auto&& contact_at) {
    const double least = stride / 1024;
    while (place != end) {
      const double next = next_of(place, stride);
      const LineContact there = contact_at(next);
      LineFilm trial = solve_from(there, x, film.pressure, film.separation, limits, watch);
      steps += trial.steps;
      if (trial.outcome == Outcome::stopped ||
          (trial.outcome != Outcome::solved && stride < least)) {
        film.outcome = trial.outcome;
        film.last_change = trial.last_change;
        return false;
      }
      if (trial.outcome != Outcome::solved) {
        stride /= 2;
        continue;
      }
      film = std::move(trial);
      place = next;
      stride *= 2;
    }
    return true;
  };
  double material_number = 0;
  const bool is_there = walk(
      load_number, contact.load_number, 1,
      [&](double m, double stride) { return std::fmin(contact.load_number, m * (1 + stride)); },
      [&](double m) { return with_numbers(contact, m, 0); });
  if (is_there)
    walk(
        material_number, contact.material_number, 1,
        [&](double l, double stride) { return std::fmin(contact.material_number, l + stride); },
        [&](double l) { return with_numbers(contact, contact.load_number, l); });
  film.steps = steps;
  return film;
}

}  // namespace tribo::ehl
