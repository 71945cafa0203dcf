// SPDX-License-Identifier: Apache-2.0
#include "ehl/line_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "ehl/film_kernel.hpp"
#include "ehl/film_newton.hpp"
#include "ehl/jacobian.hpp"
#include "ehl/reynolds.hpp"

namespace tribo::ehl {
namespace {

using Eigen::VectorXd;

constexpr double least_stride = 1e-3;  // a share of the viscosity's rise

// The weights of a grid's nodes in ∫ P dX.
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

// FilmNewton's problem.
class LineProblem {
 public:
  // The equations at a state, to first order.
  struct Linear {
    Balance balance;
    std::vector<char> is_free;
    Jacobian jacobian;
    VectorXd by_separation;  // the changes of the pressures for a change of 1 of H₀
  };

  // `reach`: how far pressure reaches from the middle, in half-widths.
  LineProblem(const LineContact& contact, const Numbers& x, double reach)
      : contact_(contact),
        x_(x),
        kernel_(x),
        weights_(load_weights(x)),
        parabola_(parabola(x)),
        reach_(reach) {}

  int cells() const { return static_cast<int>(x_.size()) - 1; }
  double reach() const { return reach_; }
  double pressure() const { return 1; }
  double pressure_in_time() const { return 1 / reach_; }
  double separation_weight() const { return 1; }
  static bool must_lead_nearer() { return true; }
  double size_of(const FilmChange& change) const {
    return std::sqrt(weights_.dot(change.pressure.cwiseAbs2()) +
                     change.separation * change.separation);
  }
  double size_asked(const Linear&, const FilmState&, const FilmChange& change) const {
    return size_of(change);
  }

  FilmState state_of(VectorXd pressure, double separation) const {
    FilmState state{std::move(pressure), {}, separation};
    state.film = kernel_ * state.pressure + parabola_;
    state.film.array() += separation;
    return state;
  }

  FilmState state_after(const FilmState& state, double part, const FilmChange& change) const {
    return state_of((state.pressure + part * change.pressure).cwiseMax(0),
                    state.separation + part * change.separation);
  }

  // Where the rate is above 0, liquid is stored in the film that a step in time adds: ∂(ρ̄H)/∂T.
  Linear linear_at(const FilmState& at, double rate) const {
    Balance balance = balance_of(contact_, x_, at.pressure, at.film);
    const auto size = static_cast<Eigen::Index>(x_.size());
    std::vector<char> free(x_.size(), 0);
    VectorXd side = VectorXd::Zero(size);
    for (Eigen::Index i = 1; i + 1 < size; ++i) {
      const auto node = static_cast<std::size_t>(i);
      if (!is_free(at, balance, i, own_part(balance, i, rate))) continue;
      free[node] = 1;
      BalanceSlopes& slopes = balance.slopes[node];
      for (const double slope : slopes.by_film) side[i] -= slope;
      const double stored = rate * weights_[i], pressure = at.pressure[i];
      side[i] -= stored * contact_.fluid.density(pressure);
      slopes.by_film[2] += stored * contact_.fluid.density(pressure);
      slopes.by_pressure[2] += stored * contact_.fluid.density_slope(pressure) * at.film[i];
    }
    Jacobian jacobian(kernel_, balance.slopes, free);
    VectorXd by_separation = jacobian.solve(side);
    return {std::move(balance), std::move(free), std::move(jacobian), std::move(by_separation)};
  }

  FilmChange change_for(const Linear& linear, const FilmState& at, double rate) const {
    return change_by(linear, at, linear.balance, rate);
  }
  FilmChange change_left(const Linear& linear, const FilmState& at) const {
    return change_by(linear, at, balance_of(contact_, x_, at.pressure, at.film, false), 0);
  }

  LineFilm film_of(const FilmNewton<LineProblem>& newton) const {
    const FilmState& at = newton.state();
    return {.outcome = newton.outcome(),
            .x = x_,
            .pressure = at.pressure,
            .film = at.film,
            .mass_flow = flow_at_peak(at),
            .separation = at.separation,
            .steps = newton.steps(),
            .last_change = newton.last_change()};
  }

 private:
  // How much the pressure at a node changes the balance there: it drives liquid, and it lifts the
  // film. Where the liquid is too viscous to be driven, only the second part is left.
  double own_part(const Balance& balance, Eigen::Index row, double rate) const {
    const int node = static_cast<int>(row);
    return balance.diffusion[row] + (1 + rate * weights_[row]) * kernel_.entry(node, node);
  }

  // A node is free if a Newton step of this node alone would leave pressure there.
  static bool is_free(const FilmState& at, const Balance& balance, Eigen::Index row, double own) {
    return at.pressure[row] > balance.surplus[row] / own;
  }

  // The change that removes, to first order, the residual of a state. The residual is the pressure
  // where the film has broken, else the surplus. The linear equations may be of another state.
  FilmChange change_by(const Linear& linear, const FilmState& at, const Balance& balance,
                       double rate) const {
    VectorXd side = VectorXd::Zero(at.pressure.size());
    for (Eigen::Index i = 1; i + 1 < side.size(); ++i) {
      const double own = own_part(balance, i, rate);
      const bool is_row_of_balance = linear.is_free[static_cast<std::size_t>(i)] != 0;
      if (is_free(at, balance, i, own))
        side[i] = -balance.surplus[i] / (is_row_of_balance ? 1 : own);
      else
        side[i] = -at.pressure[i] * (is_row_of_balance ? own : 1);
    }
    FilmChange change{linear.jacobian.solve(side)};
    const double missing_load = std::numbers::pi / 2 - weights_.dot(at.pressure + change.pressure);
    change.separation = missing_load / weights_.dot(linear.by_separation);
    change.pressure += change.separation * linear.by_separation;
    // The change is 0 at the ends, but for rounding.
    change.pressure[0] = change.pressure[side.size() - 1] = 0;
    return change;
  }

  // The flow is the same between all free nodes; where pressure is greatest, pressure drives no
  // part of it.
  double flow_at_peak(const FilmState& at) const {
    Eigen::Index peak;
    at.pressure.maxCoeff(&peak);
    const Balance balance = balance_of(contact_, x_, at.pressure, at.film, false);
    return balance.flow[std::min(peak, balance.flow.size() - 1)];
  }

  LineContact contact_;
  Numbers x_;
  FilmKernel kernel_;
  VectorXd weights_, parabola_;
  double reach_;
};

// The contact with a liquid whose viscosity rises by only a share of this liquid's rise.
LineContact with_share_of_rise(LineContact contact, double share) {
  contact.material_number *= share;
  contact.fluid.exponent *= share;
  return contact;
}

}  // namespace

LineFilm solve_from(const LineContact& contact, const Numbers& x, const VectorXd& guess,
                    double separation, const NewtonLimits& limits, const Watch& watch) {
  const LineProblem problem(contact, x, scales_of(contact).reach);
  FilmNewton<LineProblem> newton(problem, guess, separation);
  newton.converge(limits, watch);
  return problem.film_of(newton);
}

LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch) {
  const std::span<const double> values(film.pressure.data(), film.x.size());
  // At a spike a cubic overshoots. With 0.05 and 0.1 films without a spike took more steps.
  constexpr double greatest_bend = 0.5;
  Numbers pressure = interpolated(film.x, values, x, greatest_bend);
  pressure.front() = pressure.back() = 0;
  const LineProblem problem(contact, x, scales_of(contact).reach);
  FilmNewton<LineProblem> newton(
      problem, Eigen::Map<const VectorXd>(pressure.data(), static_cast<Eigen::Index>(x.size())),
      film.separation);
  newton.converge_or_settle({}, watch);
  LineFilm solved = problem.film_of(newton);
  solved.steps += film.steps;
  return solved;
}

LineFilm solve_from_nothing(const LineContact& contact, int cells, const Scales& scales,
                            const Watch& watch) {
  const Numbers x = first_density(scales).nodes(cells);
  VectorXd guess(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double at = x[i] / scales.reach;
    guess[static_cast<Eigen::Index>(i)] = std::sqrt(std::fmax(0, 1 - at * at)) / scales.reach;
  }
  // Seeks the greatest of these shares of the viscosity's rise with which the film comes to rest.
  LineFilm film;
  double share = 1;
  int steps = 0;
  for (const double next : {1., 0.5, 0.25, 0.1, 0.}) {
    const LineProblem problem(with_share_of_rise(contact, next), x, scales.reach);
    FilmNewton<LineProblem> newton(problem, guess, 0);
    newton.lift_to(expected_film(contact) / contact.film_number(1));
    newton.settle({}, watch);
    film = problem.film_of(newton);
    steps += film.steps;
    share = next;
    if (film.outcome != Outcome::not_converged || contact.fluid.exponent == 0) break;
  }
  // Then the share grows in strides that are halved where one fails and doubled where one succeeds.
  for (double stride = 0.1; film.outcome == Outcome::solved && share < 1;) {
    const double next = std::fmin(1, share + stride);
    LineFilm trial = solve_from(with_share_of_rise(contact, next), x, film.pressure,
                                film.separation, {.steps = 25, .change = 1e-8}, watch);
    steps += trial.steps;
    if (trial.outcome == Outcome::solved) {
      film = std::move(trial);
      share = next;
      stride *= 2;
    } else if (trial.outcome == Outcome::stopped || stride < least_stride) {
      film.outcome = trial.outcome;
      film.last_change = trial.last_change;
    } else {
      stride /= 2;
    }
  }
  film.steps = steps;
  return film;
}

}  // namespace tribo::ehl
