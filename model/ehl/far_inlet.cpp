// SPDX-License-Identifier: Apache-2.0
#include "ehl/far_inlet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tribo::ehl {
namespace {

// g and dg/dφ, and cos φ/g², which is Kapitza's f over λ̄/(3 + 2R_x/R_y), and its slope.
struct Gap {
  double ratio;

  double value(double phi) const {
    return (std::cos(phi) * std::cos(phi) + ratio * std::sin(phi) * std::sin(phi)) / 2;
  }
  double slope(double phi) const { return (ratio - 1) * std::sin(phi) * std::cos(phi); }
  double kapitza(double phi) const { return std::cos(phi) / (value(phi) * value(phi)); }
  double kapitza_slope(double phi) const {
    const double g = value(phi);
    return (-std::sin(phi) - 2 * std::cos(phi) * slope(phi) / g) / (g * g);
  }
};

// Takes u and g³u′ a step further by the classical Runge–Kutta method; (g³u′)′ = 9g³u.
std::array<double, 2> step_of(const Gap& gap, double phi, const std::array<double, 2>& at,
                              double step) {
  const auto slopes = [&](double angle, double u, double flux) -> std::array<double, 2> {
    const double g = gap.value(angle), cube = g * g * g;
    return {flux / cube, 9 * cube * u};
  };
  const auto a = slopes(phi, at[0], at[1]);
  const auto b = slopes(phi + step / 2, at[0] + step / 2 * a[0], at[1] + step / 2 * a[1]);
  const auto c = slopes(phi + step / 2, at[0] + step / 2 * b[0], at[1] + step / 2 * b[1]);
  const auto d = slopes(phi + step, at[0] + step * c[0], at[1] + step * c[1]);
  return {at[0] + step / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]),
          at[1] + step / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])};
}

}  // namespace

FarInlet::FarInlet(const PointContact& contact)
    : curvature_ratio_(1 / contact.radius_ratio), exponent_(contact.fluid.exponent) {
  const PointNumbers numbers = numbers_of(contact);
  deflection_of_load_ = numbers.deflection * numbers.load;
  const Gap gap{curvature_ratio_};
  const double step = pi<double>() / angles;
  std::vector<double> free{1};
  std::array<double, 2> at{1, 0};
  double before = 0, share = 0;
  for (int i = 0; i < angles; ++i) {
    const double phi = step * i, next_phi = phi + step;
    const std::array<double, 2> next = step_of(gap, phi, at, step);
    const double g = gap.value(next_phi);
    const double wronskian =
        gap.kapitza_slope(next_phi) * next[0] - gap.kapitza(next_phi) * next[1] / (g * g * g);
    // If the film broke at a smaller angle, the slope of the pressure there would be negative; at a
    // greater angle it would be positive.
    if (wronskian > 0) {
      const double part = before / (before - wronskian);
      break_angle_ = phi + step * part;
      share = -gap.kapitza(break_angle_) / (at[0] + part * (next[0] - at[0]));
      break;
    }
    free.push_back(next[0]);
    before = wronskian;
    at = next;
  }
  const double size = numbers.wedge / (3 + 2 * curvature_ratio_);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double phi = step * static_cast<double>(i), g = gap.value(phi);
    shape_.push_back(size * (std::cos(phi) + share * free[i] * g * g));
  }
  shape_.push_back(0);
  shape_.push_back(0);
}

double FarInlet::pressure(double x, double y, double film) const {
  const double phi = std::atan2(y, -x);
  if (phi >= break_angle_) return 0;
  // The cubic through four of the shape's values.
  const double place = phi * angles / pi<double>();
  const auto last = static_cast<double>(shape_.size() - 4);
  const double first = std::clamp(std::floor(place) - 1, 0., last), t = place - first;
  const double* f = &shape_[static_cast<std::size_t>(first)];
  const double shape = -f[0] * (t - 1) * (t - 2) * (t - 3) / 6 + f[1] * t * (t - 2) * (t - 3) / 2 -
                       f[2] * t * (t - 1) * (t - 3) / 2 + f[3] * t * (t - 1) * (t - 2) / 6;
  const double thin = std::fmax(shape, 0) * std::hypot(x, y) / (film * film);
  // `thin` is ∫ dP/η̄, the pressure at constant viscosity. Outside the grid it is far below 1/ᾱ.
  if (exponent_ == 0) return thin;
  return -std::log1p(-std::fmin(exponent_ * thin, 0.5)) / exponent_;
}

double FarInlet::load_outside(const PlaneGrid& grid, double separation) const {
  // The nodes at the grid's edge already carry the load of half a cell outside.
  const double left = -grid.x(0) + grid.dx / 2, side = grid.y(grid.count_y() - 1) + grid.dy / 2;
  const double spread = -1 / std::tan(break_angle_);  // x/y where the film breaks
  const auto at = [&](double x, double y) {
    const double film = separation + x * x / 2 + curvature_ratio_ * y * y / 2 +
                        deflection_of_load_ / std::hypot(x, y);
    return pressure(x, y, film);
  };
  constexpr int count = 64;
  double load = 0;
  for (int m = 0; m < count; ++m)
    for (int n = 0; n < count; ++n) {
      const double s = (m + 0.5) / count, t = (n + 0.5) / count;
      // Ahead of the grid x is −left/s, and y is side (1 − t)/t; beside it y is side/t.
      load += at(-left / s, side * (1 - t) / t) * left * side / (s * s * t * t);
      const double y = side / t, breadth = left + spread * y;
      load += at(-left + s * breadth, y) * breadth * side / (t * t);
    }
  return 2 * load / (count * count);
}

}  // namespace tribo::ehl
