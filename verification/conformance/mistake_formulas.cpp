// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/starvation.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using catalogue::Results;
using Constants = std::span<const double>;
using Value = std::optional<double>;

// Of a function with one result.
template <Value (*formula)(const Arguments&, Constants)>
std::optional<Results> only(const Arguments& a, Constants numbers) {
  const Value value = formula(a, numbers);
  return value ? std::optional(Results{*value}) : std::nullopt;
}

// --- Effective modulus: arguments E₁, ν₁, E₂ and ν₂

Value modulus_by_one_minus_ratio(const Arguments& a, Constants) {
  return 1 / ((1 - a[1]) / a[0] + (1 - a[3]) / a[2]);
}
Value modulus_added(const Arguments& a, Constants factor) {
  return factor[0] * (a[0] / (1 - a[1] * a[1]) + a[2] / (1 - a[3] * a[3]));
}
Value modulus_of_one_ratio(const Arguments& a, Constants) {
  return effective_modulus(a[0], a[1], a[2], a[1]);
}
Value modulus_of_first_twice(const Arguments& a, Constants) {
  return effective_modulus(a[0], a[1], a[0], a[1]);
}

// --- Reduced radius: arguments R₁x, R₂x, R₁y and R₂y. What is wrong may be below 0.

double in_parallel(double a, double b) { return 1 / (1 / a + 1 / b); }
Results radii(double x, double y) { return {x, y, in_parallel(x, y)}; }
Results right_radii(const Arguments& a) {
  return radii(in_parallel(a[0], a[1]), in_parallel(a[2], a[3]));
}

std::optional<Results> radii_of_difference(const Arguments& a, Constants) {
  return radii(in_parallel(a[0], -a[1]), in_parallel(a[2], -a[3]));
}
std::optional<Results> radii_added(const Arguments& a, Constants factor) {
  return radii(factor[0] * (a[0] + a[1]), factor[0] * (a[2] + a[3]));
}
std::optional<Results> radii_of_first(const Arguments& a, Constants) { return radii(a[0], a[2]); }
std::optional<Results> radii_exchanged(const Arguments& a, Constants) {
  return right_radii({a[2], a[3], a[0], a[1]});
}
std::optional<Results> radii_without_sign(const Arguments& a, Constants) {
  return right_radii({std::abs(a[0]), std::abs(a[1]), std::abs(a[2]), std::abs(a[3])});
}
// Of R_x and R_y, which are right.
std::optional<Results> radius_as_mean(const Arguments& a, Constants) {
  Results right = right_radii(a);
  right[2] = (right[0] + right[1]) / 2;
  return right;
}
std::optional<Results> radius_as_geometric_mean(const Arguments& a, Constants) {
  Results right = right_radii(a);
  right[2] = std::sqrt(right[0]) * std::sqrt(right[1]);
  return right;
}
std::optional<Results> radius_along_x(const Arguments& a, Constants) {
  Results right = right_radii(a);
  right[2] = right[0];
  return right;
}

// --- Ellipse: arguments F, E*, R_x and R_y

// α ≥ 1, the greater radius over the smaller one.
double radii_ratio(const Arguments& a) { return std::max(a[2], a[3]) / std::min(a[2], a[3]); }

// K and E of the parameter 1 − 1/k².
EllipseShape<double> shape_of(double k) {
  const auto [b, d] = detail::associated_integrals(k);
  return {k, b + d, b + d / k / k};
}

// The results of a shape, right or wrong, with this R.
Results ellipse_with(const Arguments& a, const EllipseShape<double>& shape, double reduced) {
  const double k = shape.ellipticity, pi = std::numbers::pi;
  const double minor = std::cbrt(3 * shape.second_integral * a[0] * reduced / (pi * k * a[1]));
  const bool is_exchanged = a[3] < a[2];
  const double mean = a[0] / (pi * k * minor * minor);
  return {is_exchanged ? k * minor : minor,
          is_exchanged ? minor : k * minor,
          is_exchanged ? 1 / k : k,
          mean,
          1.5 * mean,
          minor * minor * shape.first_integral / (2 * reduced * shape.second_integral)};
}
Results ellipse_with(const Arguments& a, const EllipseShape<double>& shape) {
  return ellipse_with(a, shape, in_parallel(a[2], a[3]));
}
Results right_ellipse(const Arguments& a) { return ellipse_with(a, ellipse_shape(radii_ratio(a))); }

// Integrals of the parameter q^power in place of q = 1 − 1/k²; 1/2: the modulus, 2: the other way.
EllipseShape<double> integrals_of_power(double k, double power) {
  const double q = (k - 1) * (k + 1) / (k * k), wrong = std::pow(q, power);
  // 1 − q^p without the cancellation of long ellipses
  const double complement = power == 0.5 ? 1 / (k * k * (1 + wrong))
                            : power == 2 ? (1 + q) / (k * k)
                                         : 1 - wrong;
  EllipseShape<double> shape = shape_of(1 / std::sqrt(complement));
  shape.ellipticity = k;
  return shape;
}
std::optional<Results> ellipse_of_parameter_power(const Arguments& a, Constants power) {
  const double ratio = radii_ratio(a);
  if (!(ratio > 1)) return std::nullopt;  // 0/0
  double low = 1, high = 4 * ratio;
  for (double middle = 0; (middle = std::sqrt(low * high)) > low && middle < high;) {
    const EllipseShape<double> shape = integrals_of_power(middle, power[0]);
    const double first = shape.first_integral, second = shape.second_integral;
    const bool is_below = middle * middle * second - first < ratio * (first - second);
    (is_below ? low : high) = middle;
  }
  return ellipse_with(a, integrals_of_power(high, power[0]));
}
std::optional<Results> ellipse_of_parameter_power_at_right_k(const Arguments& a, Constants power) {
  const double k = ellipse_shape(radii_ratio(a)).ellipticity;
  if (!(k > 1)) return std::nullopt;
  return ellipse_with(a, integrals_of_power(k, power[0]));
}

// cos τ = (α − 1)/(α + 1), times a factor.
std::optional<Results> ellipse_of_auxiliary_angle(const Arguments& a, Constants factor) {
  const double ratio = radii_ratio(a), cosine = factor[0] * (ratio - 1) / (ratio + 1);
  if (!(cosine < 1)) return std::nullopt;
  return ellipse_with(a, ellipse_shape((1 + cosine) / (1 - cosine)));
}

// k = c α^e, K = f + g ln α, E = h + i/α.
std::optional<Results> ellipse_of_fits(const Arguments& a, Constants fit) {
  const double ratio = radii_ratio(a);
  return ellipse_with(a, {fit[0] * std::pow(ratio, fit[1]), fit[2] + fit[3] * std::log(ratio),
                          fit[4] + fit[5] / ratio});
}
std::optional<Results> ellipse_of_fitted_ratio(const Arguments& a, Constants fit) {
  return ellipse_with(a, shape_of(fit[0] * std::pow(radii_ratio(a), fit[1])));
}
// a³ = E·3FR/(πkE*) with E = (π/2)/k² · (1 + 2(k² − 1)/π + ¼ ln k).
std::optional<Results> ellipse_of_logarithms(const Arguments& a, Constants) {
  const double ratio = radii_ratio(a);
  const double k = 1 + std::sqrt(std::log(16 * ratio) * ratio / 2) - std::sqrt(std::log(4)) -
                   0.16 * std::log(ratio);
  const double pi = std::numbers::pi;
  const double second = pi / 2 / (k * k) * (1 + 2 * (k * k - 1) / pi + 0.25 * std::log(k));
  EllipseShape<double> shape = shape_of(k);
  shape.second_integral = second;
  return ellipse_with(a, shape);
}

std::optional<Results> ellipse_exchanged(const Arguments& a, Constants) {
  return right_ellipse({a[0], a[1], a[3], a[2]});
}
std::optional<Results> ellipse_of_greater_ratio(const Arguments& a, Constants) {
  Results right = right_ellipse(a);
  right[2] = std::max(right[2], 1 / right[2]);
  return right;
}
std::optional<Results> ellipse_eccentricity(const Arguments& a, Constants) {
  Results right = right_ellipse(a);
  const double k = std::max(right[2], 1 / right[2]);
  right[2] = std::sqrt((k - 1) * (k + 1)) / k;
  return right;
}

// With another R.
std::optional<Results> ellipse_with_radius(const Arguments& a, double radius) {
  return ellipse_with(a, ellipse_shape(radii_ratio(a)), radius);
}
std::optional<Results> ellipse_with_radius_x(const Arguments& a, Constants) {
  return ellipse_with_radius(a, a[2]);
}
std::optional<Results> ellipse_with_smaller_radius(const Arguments& a, Constants) {
  return ellipse_with_radius(a, std::min(a[2], a[3]));
}
std::optional<Results> ellipse_with_multiple_of_radius(const Arguments& a, Constants factor) {
  return ellipse_with_radius(a, factor[0] * in_parallel(a[2], a[3]));
}
// The power mean of R_x and R_y: −1 harmonic, 0 geometric, 1 arithmetic.
double mean_radius(const Arguments& a, double power) {
  return power < 0   ? 2 * in_parallel(a[2], a[3])
         : power > 0 ? (a[2] + a[3]) / 2
                     : std::sqrt(a[2]) * std::sqrt(a[3]);
}
std::optional<Results> ellipse_with_mean_radius(const Arguments& a, Constants power) {
  return ellipse_with_radius(a, mean_radius(a, power[0]));
}

// As a circle.
std::optional<Results> circle(const Arguments& a, double radius) {
  const HertzPoint<double> hertz = hertz_point(a[0], a[1], radius);
  return Results{hertz.radius,        hertz.radius,        1,
                 hertz.mean_pressure, hertz.peak_pressure, hertz.approach};
}
std::optional<Results> ellipse_as_circle_of_mean_radius(const Arguments& a, Constants power) {
  return circle(a, mean_radius(a, power[0]));
}
std::optional<Results> ellipse_as_circle_of_reduced_radius(const Arguments& a, Constants) {
  return circle(a, in_parallel(a[2], a[3]));
}
std::optional<Results> ellipse_as_circle_of_radius_x(const Arguments& a, Constants) {
  return circle(a, a[2]);
}
std::optional<Results> ellipse_with_approach_of_circle(const Arguments& a, Constants power) {
  Results right = right_ellipse(a);
  right[5] = hertz_point(a[0], a[1], mean_radius(a, power[0])).approach;
  return right;
}

// --- Moments: arguments n and d

double gaussian(double s) { return std::exp(-s * s / 2) / std::sqrt(2 * std::numbers::pi); }

// Simpson's rule for ∫ (s−d)ⁿ φ(s) ds over [d, to].
double simpson(double order, double d, double to, int intervals) {
  if (!(to > d)) return 0;
  const double h = (to - d) / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2;
    const double s = d + i * h;
    sum += weight * (i == 0 && order == 0 ? 1 : std::pow(s - d, order)) * gaussian(s);
  }
  return sum * h / 3;
}

// F of any order from 0 to 3.5; those past 5/2 by Simpson's rule.
Value moment_of(double order, double d) {
  if (order < 0 || order > 3.5) return std::nullopt;
  if (order > 2.5) return simpson(order, d, std::max(d, 0.0) + 14, 4000);
  return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order)), d);
}

Value moment_of_order(const Arguments& a, Constants shift) {
  return moment_of(a[0] + shift[0], a[1]);
}

// ∫ sⁿ φ(s) ds over s > d; half orders have no power of s < 0.
Value moment_about_zero(const Arguments& a, Constants) {
  const double order = a[0], d = a[1];
  if (order == 0) return gaussian_moment(Order::zero, d);
  if (order == 1) return gaussian(d);
  if (order == 2) return d * gaussian(d) + gaussian_moment(Order::zero, d);
  if (d <= 0) return moment_of(order, 0);
  const int count = 8000;
  const double h = 16.0 / count;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double s = d + (i + 0.5) * h;
    sum += std::pow(s, order) * gaussian(s);
  }
  return sum * h;
}

// Constants: where the integral ends, and how many intervals Simpson's rule has.
Value moment_cut_at(const Arguments& a, Constants numbers) {
  return simpson(a[0], a[1], numbers[0], static_cast<int>(numbers[1]));
}
Value moment_cut_at_distance(const Arguments& a, Constants numbers) {
  return simpson(a[0], a[1], a[1] + numbers[0], static_cast<int>(numbers[1]));
}

Value moment_zero_beyond(const Arguments& a, Constants numbers) {
  return a[1] > numbers[0] ? 0 : *moment_of(a[0], a[1]);
}
Value moment_over_root(const Arguments& a, Constants) {
  return a[1] > 0 ? Value(*moment_of(a[0], a[1]) / std::sqrt(a[1])) : std::nullopt;
}

// Fits say nothing outside of the arguments that they were made for.
Value moment_power_fit(const Arguments& a, Constants numbers) {  // c (d₁ − d)^e
  if (a[1] < 0 || a[1] > numbers[1]) return std::nullopt;
  return numbers[0] * std::pow(numbers[1] - a[1], numbers[2]);
}
Value moment_exponential_fit(const Arguments& a, Constants numbers) {  // c e^{−bd}
  if (a[1] < 0 || a[1] > 40) return std::nullopt;
  return numbers[0] * std::exp(-numbers[1] * a[1]);
}
Value moment_error_function_fit(const Arguments& a, Constants) {
  if (a[1] < 0 || a[1] > 4) return std::nullopt;
  return *moment_of(a[0], 0) * std::erfc(a[1]);
}

// --- Inlet: arguments closure, r and γ

// With Crook's constant of a circular contact.
Value inlet_with_circular_gap(const Arguments& a, Constants) {
  const auto closure = static_cast<StarvationClosure>(static_cast<int>(a[0]));
  return InletCurve<double>{closure, std::numbers::pi / 4}.film_ratio(a[1]);
}

Value inlet_with_inverse_exponent(const Arguments& a, Constants) {
  if (a[1] >= 1) return std::nullopt;
  return wolveridge_film_ratio(std::pow((1 / a[1] - 1) * crook_constant<double>(), 1.5));
}

struct NamedFormula {
  std::string_view function, name;
  std::size_t numbers;
  FunctionFormula formula;
};
constexpr std::array formulas{
    NamedFormula{"effective_modulus", "modulus_by_one_minus_ratio", 0,
                 only<modulus_by_one_minus_ratio>},
    NamedFormula{"effective_modulus", "modulus_added", 1, only<modulus_added>},
    NamedFormula{"effective_modulus", "modulus_of_one_ratio", 0, only<modulus_of_one_ratio>},
    NamedFormula{"effective_modulus", "modulus_of_first_twice", 0, only<modulus_of_first_twice>},
    NamedFormula{"reduced_radius", "radii_of_difference", 0, radii_of_difference},
    NamedFormula{"reduced_radius", "radii_added", 1, radii_added},
    NamedFormula{"reduced_radius", "radii_of_first", 0, radii_of_first},
    NamedFormula{"reduced_radius", "radii_exchanged", 0, radii_exchanged},
    NamedFormula{"reduced_radius", "radii_without_sign", 0, radii_without_sign},
    NamedFormula{"reduced_radius", "radius_as_mean", 0, radius_as_mean},
    NamedFormula{"reduced_radius", "radius_as_geometric_mean", 0, radius_as_geometric_mean},
    NamedFormula{"reduced_radius", "radius_along_x", 0, radius_along_x},
    NamedFormula{"hertz_ellipse", "ellipse_of_parameter_power", 1, ellipse_of_parameter_power},
    NamedFormula{"hertz_ellipse", "ellipse_of_parameter_power_at_right_k", 1,
                 ellipse_of_parameter_power_at_right_k},
    NamedFormula{"hertz_ellipse", "ellipse_of_auxiliary_angle", 1, ellipse_of_auxiliary_angle},
    NamedFormula{"hertz_ellipse", "ellipse_of_fits", 6, ellipse_of_fits},
    NamedFormula{"hertz_ellipse", "ellipse_of_fitted_ratio", 2, ellipse_of_fitted_ratio},
    NamedFormula{"hertz_ellipse", "ellipse_of_logarithms", 0, ellipse_of_logarithms},
    NamedFormula{"hertz_ellipse", "ellipse_exchanged", 0, ellipse_exchanged},
    NamedFormula{"hertz_ellipse", "ellipse_of_greater_ratio", 0, ellipse_of_greater_ratio},
    NamedFormula{"hertz_ellipse", "ellipse_eccentricity", 0, ellipse_eccentricity},
    NamedFormula{"hertz_ellipse", "ellipse_with_radius_x", 0, ellipse_with_radius_x},
    NamedFormula{"hertz_ellipse", "ellipse_with_smaller_radius", 0, ellipse_with_smaller_radius},
    NamedFormula{"hertz_ellipse", "ellipse_with_multiple_of_radius", 1,
                 ellipse_with_multiple_of_radius},
    NamedFormula{"hertz_ellipse", "ellipse_with_mean_radius", 1, ellipse_with_mean_radius},
    NamedFormula{"hertz_ellipse", "ellipse_as_circle_of_mean_radius", 1,
                 ellipse_as_circle_of_mean_radius},
    NamedFormula{"hertz_ellipse", "ellipse_as_circle_of_reduced_radius", 0,
                 ellipse_as_circle_of_reduced_radius},
    NamedFormula{"hertz_ellipse", "ellipse_as_circle_of_radius_x", 0,
                 ellipse_as_circle_of_radius_x},
    NamedFormula{"hertz_ellipse", "ellipse_with_approach_of_circle", 1,
                 ellipse_with_approach_of_circle},
    NamedFormula{"gaussian_moment", "moment_of_order", 1, only<moment_of_order>},
    NamedFormula{"gaussian_moment", "moment_about_zero", 0, only<moment_about_zero>},
    NamedFormula{"gaussian_moment", "moment_cut_at", 2, only<moment_cut_at>},
    NamedFormula{"gaussian_moment", "moment_cut_at_distance", 2, only<moment_cut_at_distance>},
    NamedFormula{"gaussian_moment", "moment_zero_beyond", 1, only<moment_zero_beyond>},
    NamedFormula{"gaussian_moment", "moment_over_root", 0, only<moment_over_root>},
    NamedFormula{"gaussian_moment", "moment_power_fit", 3, only<moment_power_fit>},
    NamedFormula{"gaussian_moment", "moment_exponential_fit", 2, only<moment_exponential_fit>},
    NamedFormula{"gaussian_moment", "moment_error_function_fit", 0,
                 only<moment_error_function_fit>},
    NamedFormula{"starvation_ratio", "inlet_with_circular_gap", 0, only<inlet_with_circular_gap>},
    NamedFormula{"starvation_ratio", "inlet_with_inverse_exponent", 0,
                 only<inlet_with_inverse_exponent>},
};

}  // namespace

FunctionFormula find_formula(std::string_view function, std::string_view name,
                             std::size_t numbers) {
  for (const NamedFormula& one : formulas)
    if (one.function == function && one.name == name && one.numbers == numbers) return one.formula;
  return nullptr;
}

}  // namespace tribo::conformance
