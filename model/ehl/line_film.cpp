// SPDX-License-Identifier: Apache-2.0
#include "ehl/line_film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "ehl/film_kernel.hpp"
#include "ehl/jacobian.hpp"
#include "ehl/reynolds.hpp"

namespace tribo::ehl {
namespace {

using Eigen::VectorXd;

constexpr double greatest_change = 0.5;   // of P in one step, as a share of the greatest P
constexpr double least_part = 1e-3;       // the least part of a Newton step that is worth making
constexpr double rounding_change = 1e-7;  // of P, at most

// For a film that is followed in time: 1/ΔT of its steps, for a contact of half-width 1.
constexpr double first_rate = 100, last_rate = 0.05, greatest_rate = 1e9;
constexpr double greatest_change_in_time = 0.3;
constexpr int most_steps_in_time = 80;
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

struct State {
  VectorXd pressure, film;
  double separation = 0;
};

// The change of a state's pressure and separation.
struct Change {
  VectorXd pressure;
  double separation = 0;

  // Not finite where any number of the change is not.
  double greatest() const {
    if (!pressure.allFinite()) return std::numeric_limits<double>::infinity();
    return std::max(pressure.cwiseAbs().maxCoeff(), std::fabs(separation));
  }
};

class Newton {
 public:
  Newton(const LineContact& contact, const Numbers& x, const VectorXd& guess, double separation)
      : contact_(contact), kernel_(x), weights_(load_weights(x)), parabola_(parabola(x)) {
    result_.x = x;
    now_ = state_of(guess, separation);
  }

  // Lifts the film of the guess, so that its least value is `least`.
  void lift_to(double least) {
    now_ = state_of(now_.pressure, now_.separation + least - now_.film.minCoeff());
  }

  const State& state() const { return now_; }
  void return_to(const State& state) { now_ = state; }

  // Newton's method; where a whole step leads too far, a part of it is made.
  void converge(const NewtonLimits& limits, const Watch& watch) {
    result_.outcome = Outcome::not_converged;
    for (int step = 0; step < limits.steps && goes_on(watch); ++step) {
      const double before = result_.last_change;
      const double part = make_step();
      if (part == 0) return;
      // Steps that no longer shrink are rounding.
      const bool is_rounding =
          result_.last_change < rounding_change && step > 0 && result_.last_change > before / 2;
      if (part == 1 && (change_left_ < limits.change || is_rounding)) {
        result_.outcome = Outcome::solved;
        return;
      }
    }
  }

  // Follows the film in time, as it is squeezed and filled, in steps that grow until it is steady;
  // then Newton's method. `reach`: how far pressure reaches from the middle, in half-widths.
  void settle(double reach, const NewtonLimits& limits, const Watch& watch) {
    result_.outcome = Outcome::not_converged;
    double rate = first_rate / reach;
    for (int step = 0; rate > last_rate / reach; ++step) {
      if (step == most_steps_in_time || rate > greatest_rate || !goes_on(watch)) return;
      if (make_step_in_time(rate, greatest_change_in_time / reach))
        rate /= std::clamp(greatest_change_in_time / reach / result_.last_change, 2., 8.);
      else
        rate *= 4;
    }
    converge(limits, watch);
  }

  LineFilm result() {
    result_.mass_flow = flow_at_peak();
    result_.pressure = std::move(now_.pressure);
    result_.film = std::move(now_.film);
    result_.separation = now_.separation;
    return std::move(result_);
  }

  Outcome outcome() const { return result_.outcome; }

 private:
  // The equations at a state, to first order.
  struct Linear {
    Balance balance;
    std::vector<char> is_free;
    Jacobian jacobian;
    VectorXd by_separation;  // the changes of the pressures for a change of 1 of H₀
  };

  State state_of(VectorXd pressure, double separation) const {
    State state{std::move(pressure), {}, separation};
    state.film = kernel_ * state.pressure + parabola_;
    state.film.array() += separation;
    return state;
  }

  bool goes_on(const Watch& watch) {
    if (!watch ||
        watch({static_cast<int>(result_.x.size()) - 1, result_.steps, result_.last_change}))
      return true;
    result_.outcome = Outcome::stopped;
    return false;
  }

  // How much the pressure at a node changes the balance there: it drives liquid, and it lifts the
  // film. Where the liquid is too viscous to be driven, only the second part is left.
  double own_part(const Balance& balance, Eigen::Index row, double rate) const {
    const int node = static_cast<int>(row);
    return balance.diffusion[row] + (1 + rate * weights_[row]) * kernel_.entry(node, node);
  }

  // A node is free if a Newton step of this node alone would leave pressure there.
  static bool is_free(const State& at, const Balance& balance, Eigen::Index row, double own) {
    return at.pressure[row] > balance.surplus[row] / own;
  }

  // Where the rate is above 0, liquid is stored in the film that a step in time adds: ∂(ρ̄H)/∂T.
  Linear linear_at(const State& at, double rate) {
    Balance balance = balance_of(contact_, result_.x, at.pressure, at.film);
    const auto size = static_cast<Eigen::Index>(result_.x.size());
    std::vector<char> free(result_.x.size(), 0);
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
    VectorXd by_separation = jacobian.solve(std::move(side));
    return {std::move(balance), std::move(free), std::move(jacobian), std::move(by_separation)};
  }

  // The change that removes, to first order, the residual of a state: its pressure where the film
  // has broken, else its surplus. The linear equations may be those of another state.
  Change change_for(const Linear& linear, const State& at, const Balance& balance,
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
    Change change{linear.jacobian.solve(side)};
    const double missing_load = std::numbers::pi / 2 - weights_.dot(at.pressure + change.pressure);
    change.separation = missing_load / weights_.dot(linear.by_separation);
    change.pressure += change.separation * linear.by_separation;
    // The change is 0 at the ends, but for rounding.
    change.pressure[0] = change.pressure[side.size() - 1] = 0;
    return change;
  }

  double size_of(const Change& change) const {
    return std::sqrt(weights_.dot(change.pressure.cwiseAbs2()) +
                     change.separation * change.separation);
  }

  // The state after a part of a change; nothing where hardly any film would be left.
  std::optional<State> state_after(double part, const Change& change) const {
    State next = state_of((now_.pressure + part * change.pressure).cwiseMax(0),
                          now_.separation + part * change.separation);
    if (!(next.film.minCoeff() > 0.2 * now_.film.minCoeff())) return {};
    return next;
  }

  // Halves a step until the same linear equations ask for a lesser change after it, and makes this
  // part. Returns the part; 0: no part will do. The test is P. Deuflhard's: Newton methods for
  // nonlinear problems (2004), section 3.3: it does not depend on the scale of an equation. After
  // a whole step, the change that is asked for is the one still left, to second order.
  double make_step() {
    ++result_.steps;
    const Linear linear = linear_at(now_, 0);
    const Change change = change_for(linear, now_, linear.balance, 0);
    result_.last_change = change.greatest();
    if (!std::isfinite(result_.last_change)) return 0;
    // A spike may be many times as high as Hertz' peak, which is 1.
    const double most = greatest_change * std::fmax(1, now_.pressure.maxCoeff());
    double part = std::fmin(1, most / change.pressure.cwiseAbs().maxCoeff());
    for (; part > least_part; part /= 2) {
      std::optional<State> next = state_after(part, change);
      if (!next) continue;
      const Balance balance = balance_of(contact_, result_.x, next->pressure, next->film, false);
      const Change left = change_for(linear, *next, balance, 0);
      if (result_.last_change > rounding_change &&
          !(size_of(left) <= (1 - part / 4) * size_of(change)))
        continue;
      change_left_ = left.greatest();
      now_ = std::move(*next);
      return part;
    }
    return 0;
  }

  // Returns false, and makes no step, where the step would change the pressure too much.
  bool make_step_in_time(double rate, double most) {
    ++result_.steps;
    const Linear linear = linear_at(now_, rate);
    const Change change = change_for(linear, now_, linear.balance, rate);
    result_.last_change = change.greatest();
    if (!std::isfinite(result_.last_change) || change.pressure.cwiseAbs().maxCoeff() > most)
      return false;
    std::optional<State> next = state_after(1, change);
    if (!next) return false;
    now_ = std::move(*next);
    return true;
  }

  // The flow is the same between all free nodes; where pressure is greatest, pressure drives no
  // part of it.
  double flow_at_peak() const {
    Eigen::Index peak;
    now_.pressure.maxCoeff(&peak);
    const Balance balance = balance_of(contact_, result_.x, now_.pressure, now_.film, false);
    return balance.flow[std::min(peak, balance.flow.size() - 1)];
  }

  LineContact contact_;
  FilmKernel kernel_;
  VectorXd weights_, parabola_;
  State now_;
  double change_left_ = 0;  // asked for after the last Newton step, by its equations
  LineFilm result_;
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
  Newton newton(contact, x, guess, separation);
  newton.converge(limits, watch);
  return newton.result();
}

LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch) {
  const std::span<const double> values(film.pressure.data(), film.x.size());
  Numbers pressure = interpolated(film.x, values, x);
  pressure.front() = pressure.back() = 0;
  Newton newton(contact, x,
                Eigen::Map<const VectorXd>(pressure.data(), static_cast<Eigen::Index>(x.size())),
                film.separation);
  const State start = newton.state();
  newton.converge({}, watch);
  if (newton.outcome() == Outcome::not_converged) {
    newton.return_to(start);
    newton.settle(scales_of(contact).reach, {}, watch);
  }
  LineFilm solved = newton.result();
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
    Newton newton(with_share_of_rise(contact, next), x, guess, 0);
    newton.lift_to(expected_film(contact) / contact.film_number(1));
    newton.settle(scales.reach, {}, watch);
    film = newton.result();
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
