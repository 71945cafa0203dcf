// SPDX-License-Identifier: Apache-2.0
// Extremes, parts and crossings of a function that is known at nodes and can be computed anywhere
// between them, each with its numerical error. The nodes alone give bounds between them: if the
// curvature keeps its sign, the line through two neighbouring nodes bounds the function in the next
// cell. Only cells in which such bounds leave a question open are searched.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tribo/bracketed_root.hpp"

namespace tribo::reproduction {

struct Estimate {
  double value;
  double error;  // absolute; the number itself lies within it
};

enum class Effort : std::uint8_t {
  grid,     // from the nodes alone; the error covers values between them
  refined,  // to rounding
};

// `x` ascends, `y` are the values there; `at(x)` computes one; `noise` is the rounding error of a
// value. The function has to be continuous, and to change its curvature at most once in a cell.
template <class Function>
class SampledCurve {
 public:
  SampledCurve(std::vector<double> x, std::vector<double> y, Function at, double noise)
      : x_(std::move(x)), y_(std::move(y)), at_(std::move(at)), noise_(noise) {}

  Estimate least(Effort effort) const { return extreme(1, effort); }
  Estimate greatest(Effort effort) const {
    const Estimate found = extreme(-1, effort);
    return {-found.value, found.error};
  }

  // The part of the length of x at which the function is above 0.
  Estimate part_above_zero() const {
    if (x_.size() < 2) return {y_.front() > 0 ? 1.0 : 0.0, std::abs(y_.front()) > noise_ ? 0.0 : 1};
    double above = 0, error = 0;
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      const double side = y_[i] > 0 ? 1 : -1;
      double inside = y_[i] > 0 ? x_[i + 1] - x_[i] : 0;
      const auto cross_at = [&](double from, double to, double sign) {
        const Estimate root = root_between(from, to, {0, 0});
        inside -= sign * (x_[i + 1] - root.value);
        error += root.error;
      };
      if ((y_[i] > 0) != (y_[i + 1] > 0)) {
        cross_at(x_[i], x_[i + 1], side);
      } else if (lowest_possible(i, side) < noise_) {
        const auto [x, y] = minimum_in(i, side);
        if (std::abs(y) <= noise_) error += x_[i + 1] - x_[i];
        if (y < -noise_) {
          cross_at(x_[i], x, side);
          cross_at(x, x_[i + 1], -side);
        }
      }
      above += inside;
    }
    const double length = x_.back() - x_.front();
    return {std::clamp(above / length, 0.0, 1.0), std::min(error / length, 1.0)};
  }

  // The first x at which the function has fallen to a level; none if it starts there or below, or
  // never falls to it.
  std::optional<Estimate> first_fall_to(Estimate level) const {
    if (!(y_.front() > level.value)) return std::nullopt;
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      double end = x_[i + 1];
      if (y_[i + 1] > level.value) {
        if (!(lowest_possible(i, 1) < level.value)) continue;
        const auto [x, y] = minimum_in(i, 1);
        if (y > level.value) continue;
        end = x;
      }
      return root_between(x_[i], end, level);
    }
    return std::nullopt;
  }

 private:
  // A lower bound of sign·f within cell i. It is twice as far below the lower node as the higher of
  // the lines through the two nodes on the left and on the right, as the curvature may change.
  double lowest_possible(std::size_t i, double sign) const {
    const auto extended = [&](std::size_t from, std::size_t through, std::size_t to) {
      const double slope = (y_[through] - y_[from]) / (x_[through] - x_[from]);
      return sign * (y_[through] + slope * (x_[to] - x_[through]));
    };
    const double lower_end = std::min(sign * y_[i], sign * y_[i + 1]);
    double bound = -std::numeric_limits<double>::infinity();
    if (i > 0) bound = std::max(bound, std::min(lower_end, extended(i - 1, i, i + 1)));
    if (i + 2 < x_.size()) bound = std::max(bound, std::min(lower_end, extended(i + 2, i + 1, i)));
    return lower_end - 2 * (lower_end - bound);
  }

  // x and sign·f(x) at the least of sign·f within cell i.
  std::pair<double, double> minimum_in(std::size_t i, double sign) const {
    return boost::math::tools::brent_find_minima([&](double x) { return sign * at_(x); }, x_[i],
                                                 x_[i + 1], minimum_bits);
  }

  Estimate extreme(double sign, Effort effort) const {
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < y_.size(); ++i)
      if (sign * y_[i] < sign * y_[lowest] || std::isnan(y_[lowest])) lowest = i;
    double best_x = x_[lowest], best = sign * y_[lowest], bound = best;
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      const double possible = lowest_possible(i, sign);
      bound = std::min(bound, possible);
      if (effort == Effort::grid || !(possible < best - noise_)) continue;
      const auto [x, y] = minimum_in(i, sign);
      if (y < best) best_x = x, best = y;
    }
    return {best, noise_ + (effort == Effort::grid ? best - bound : flatness(best_x, best, sign))};
  }

  // The error of an extremum: how far sign·f may fall below y close to x. Estimated from its rise
  // to both sides or, at an end, from its curvature.
  double flatness(double x, double y, double sign) const {
    const double step = std::ldexp(2 + 2 * std::abs(x), -minimum_bits);
    const auto rise = [&](double to) { return sign * at_(to) - y; };
    if (x_.back() - x_.front() < 4 * step) return 0;
    if (x - x_.front() < step) return std::abs(rise(x + 2 * step) - 2 * rise(x + step));
    if (x_.back() - x < step) return std::abs(rise(x - 2 * step) - 2 * rise(x - step));
    return std::max({rise(x - step), rise(x + step), 0.0});
  }

  // The place where the function passes a level. Its error is the sum of the errors of function and
  // level, over the slope.
  Estimate root_between(double from, double to, Estimate level) const {
    const double x = bracketed_root([&](double where) { return at_(where) - level.value; }, from,
                                    to, root_width);
    // If the ends are within the noise, the place of the root in the cell is unknown.
    if (std::isnan(x)) return {(from + to) / 2, (to - from) / 2};
    const double step = std::min(1e-5, (to - from) / 4);
    const double left = std::max(x - step, from), right = std::min(x + step, to);
    const double slope = std::abs(at_(right) - at_(left)) / (right - left);
    return {x, root_width + (noise_ + level.error) / slope};
  }

  static constexpr int minimum_bits = 22;  // of x at an extremum: f is flat there
  static constexpr double root_width = 1e-13;

  std::vector<double> x_, y_;
  Function at_;
  double noise_;
};

}  // namespace tribo::reproduction
