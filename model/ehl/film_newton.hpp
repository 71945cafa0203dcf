// SPDX-License-Identifier: Apache-2.0
// Newton's method for the pressures of all nodes and the separation H₀ at once, and the way to a
// solution by following the film in time. A problem, of lines or of points, gives its equations.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ehl/solve_step.hpp"

namespace tribo::ehl {

// `missing`: in a gap that is filled in part, the liquid that each node lacks; empty for a flooded
// contact.
struct FilmState {
  Eigen::VectorXd pressure, film;
  double separation = 0;
  Eigen::VectorXd missing = {};
};

struct FilmChange {
  Eigen::VectorXd pressure;
  double separation = 0;
  Eigen::VectorXd missing = {};
};

// A problem has:
//   FilmState state_of(pressure, separation)       the film that belongs to a pressure
//   FilmState state_after(state, part, change)     the state after a part of a change
//   Linear linear_at(state, rate)                  the equations at a state, to first order, with
//                                                  the liquid stored in a step of time 1/rate
//   FilmChange change_for(linear, state, rate)     the change that removes the state's residual
//   FilmChange change_left(linear, state)          roughly the same, by the equations of an earlier
//                                                  state: tells whether a step leads nearer
//   double size_of(change)
//   double size_asked(linear, state, change)   the size of change_left() at the state of `linear`,
//                                              where change_for() returned `change`
//   int cells()
//   double reach()               how far pressure reaches from the middle
//   double pressure()            the size of the pressure: Hertz' peak is 1
//   double pressure_in_time()    the same for steps in time
//   double separation_weight()   the weight of a change of H₀ beside one of pressure
//   bool must_lead_nearer()      whether a step is halved until a smaller change is left
template <class Problem>
class FilmNewton {
 public:
  FilmNewton(const Problem& problem, Eigen::VectorXd guess, double separation)
      : problem_(problem), now_(problem.state_of(std::move(guess), separation)) {}

  const FilmState& state() const { return now_; }
  Outcome outcome() const { return outcome_; }
  int steps() const { return steps_; }
  double last_change() const { return last_change_; }

  // Lifts the film of the guess, so that its least value is `least`.
  void lift_to(double least) {
    const double separation = now_.separation + least - now_.film.minCoeff();
    now_ = problem_.state_of(std::move(now_.pressure), separation);
  }

  // Newton's method; where a whole step leads too far, a part of it is made.
  void converge(const NewtonLimits& limits, const Watch& watch) {
    outcome_ = Outcome::not_converged;
    const double most_left = limits.change * problem_.pressure();
    for (int step = 0; step < limits.steps && goes_on(watch); ++step) {
      const double before = last_change_;
      const double part = make_step(most_left);
      if (part == 0) return;
      // Small changes that no longer shrink from step to step are rounding.
      const bool is_rounding = last_change_ < rounding_change * problem_.pressure() && step > 0 &&
                               last_change_ > before / 2;
      if (part == 1 && (greatest_of(left_) < most_left || is_rounding)) {
        outcome_ = Outcome::solved;
        return;
      }
    }
  }

  // Follows the film in time, as it is squeezed and filled, in steps that grow until it is steady;
  // then Newton's method.
  void settle(const NewtonLimits& limits, const Watch& watch) {
    outcome_ = Outcome::not_converged;
    const double most = greatest_change_in_time * problem_.pressure_in_time();
    double rate = first_rate / problem_.reach();
    for (int step = 0; rate > last_rate / problem_.reach(); ++step) {
      if (step == most_steps_in_time || rate > greatest_rate || !goes_on(watch)) return;
      if (make_step_in_time(rate, most))
        rate /= std::clamp(most / last_change_, 2., 8.);
      else
        rate *= 4;
    }
    converge(limits, watch);
  }

  // Newton's method, or, where that does not converge, the film in time from the same guess.
  void converge_or_settle(const NewtonLimits& limits, const Watch& watch) {
    const FilmState start = now_;
    converge(limits, watch);
    if (outcome_ != Outcome::not_converged) return;
    now_ = start;
    settle(limits, watch);
  }

 private:
  // Not finite where any number of the change is not.
  double greatest_of(const FilmChange& change) const {
    if (!change.pressure.allFinite() || !std::isfinite(change.separation))
      return std::numeric_limits<double>::infinity();
    return std::max(change.pressure.cwiseAbs().maxCoeff(),
                    problem_.separation_weight() * std::fabs(change.separation));
  }

  static constexpr double greatest_change = 0.5;   // of P in one step, as a share of the greatest P
  static constexpr double least_part = 1e-3;       // the least part of a step that is worth making
  static constexpr double rounding_change = 1e-7;  // of P, at most
  // A step by old equations has to leave less than this share of what the step before it left: a
  // choice, which decides on the work alone.
  static constexpr double most_left_by_old_equations = 0.25;
  // For a film that is followed in time: 1/ΔT of its steps, for a contact of half-width 1.
  static constexpr double first_rate = 100, last_rate = 0.05, greatest_rate = 1e9;
  static constexpr double greatest_change_in_time = 0.3;
  static constexpr int most_steps_in_time = 80;

  bool goes_on(const Watch& watch) {
    if (!watch || watch({problem_.cells(), steps_, last_change_})) return true;
    outcome_ = Outcome::stopped;
    return false;
  }

  // The state after a part of a change; nothing where hardly any film would be left.
  std::optional<FilmState> state_after(double part, const FilmChange& change) const {
    FilmState next = problem_.state_after(now_, part, change);
    if (!(next.film.minCoeff() > 0.2 * now_.film.minCoeff())) return {};
    return next;
  }

  // Halves a step until the same linear equations ask for a smaller change after it, and makes this
  // part of it. Returns the part; 0: no part will do. The test does not depend on the scale of an
  // equation. After a whole step the change asked for is, to second order, the one still left.
  // Source: P. Deuflhard: Newton methods for nonlinear problems (2004), section 3.3.
  double make_step(double most_left) {
    ++steps_;
    const auto linear = problem_.linear_at(now_, 0);
    const FilmChange change = problem_.change_for(linear, now_, 0);
    last_change_ = greatest_of(change);
    if (!std::isfinite(last_change_)) return 0;
    const double size = problem_.must_lead_nearer() ? problem_.size_asked(linear, now_, change) : 0;
    // A spike may be many times as high as Hertz' peak.
    const double most = greatest_change * std::fmax(problem_.pressure(), now_.pressure.maxCoeff());
    double part = std::fmin(1, most / change.pressure.cwiseAbs().maxCoeff());
    while (part > least_part && !makes_part(part, linear, change, size)) part /= 2;
    if (part == 1 && problem_.must_lead_nearer()) go_on_by(linear, most_left);
    return part > least_part ? part : 0;
  }

  // After a whole step, goes on with the change that is still left, by the equations of that step,
  // which need no new factors. Ends once less than `most_left` is left, or where a further change
  // does not leave much less than the one before.
  template <class Linear>
  void go_on_by(const Linear& linear, double most_left) {
    double size = problem_.size_of(left_);
    while (!(greatest_of(left_) < most_left)) {
      std::optional<FilmState> next = state_after(1, left_);
      if (!next) return;
      FilmChange left = problem_.change_left(linear, *next);
      const double size_left = problem_.size_of(left);
      if (!(size_left < most_left_by_old_equations * size)) return;
      size = size_left;
      left_ = std::move(left);
      now_ = std::move(*next);
    }
  }

  // Makes a part of a step if it leads nearer.
  template <class Linear>
  bool makes_part(double part, const Linear& linear, const FilmChange& change, double size) {
    std::optional<FilmState> next = state_after(part, change);
    if (!next) return false;
    FilmChange left = problem_.change_left(linear, *next);
    if (problem_.must_lead_nearer() && last_change_ > rounding_change * problem_.pressure() &&
        !(problem_.size_of(left) <= (1 - part / 4) * size))
      return false;
    left_ = std::move(left);
    now_ = std::move(*next);
    return true;
  }

  // Returns false, and makes no step, where the step would change the pressure too much.
  bool make_step_in_time(double rate, double most) {
    ++steps_;
    const auto linear = problem_.linear_at(now_, rate);
    const FilmChange change = problem_.change_for(linear, now_, rate);
    last_change_ = greatest_of(change);
    if (!std::isfinite(last_change_) || change.pressure.cwiseAbs().maxCoeff() > most) return false;
    std::optional<FilmState> next = state_after(1, change);
    if (!next) return false;
    now_ = std::move(*next);
    return true;
  }

  const Problem& problem_;
  FilmState now_;
  Outcome outcome_ = Outcome::not_converged;
  int steps_ = 0;
  double last_change_ = 0;
  FilmChange left_;  // asked for after the last step, by the equations of the last Newton step
};

}  // namespace tribo::ehl
