// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tribo/film_regimes.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/liquids.hpp"
#include "tribo/spectral_moments.hpp"
#include "tribo/starvation.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using catalogue::Results;
using Constants = std::span<const double>;
using Value = std::optional<double>;

// Makes Results of a formula's one result.
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

// --- Reduced radius: arguments R₁x, R₂x, R₁y and R₂y. Wrong results may be below 0.

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
// Wrong ways to make R of R_x and R_y, which are right.
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

// Integrals of q^power, not of q = 1 − 1/k². 1/2: the modulus √q was taken for q; 2: q for √q.
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

// The ellipse with `radius` in place of R.
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

// --- Regimes: arguments regime, g_V, g_E, α and k

double right_regime(const Arguments& a) {
  return regime_film(static_cast<FilmRegime>(static_cast<int>(a[0])), a[1], a[2], a[3], a[4]);
}
Value regime_with_inverse_in_phi(const Arguments& a, Constants) {
  const double ratio = (1 + 2 / (3 * a[3])) / (1 + 2 * a[3] / 3);
  return right_regime(a) * ratio * ratio;
}
Value regime_with_side(const Arguments& a, Constants decay) {
  return right_regime(a) * std::expm1(-decay[0] * a[4]) / std::expm1(-0.68 * a[4]);
}

// --- Heated inlet: arguments p₀, E*, S, β, η₀, u and k_f

double heating(const Arguments& a, double speeds) { return a[3] * a[4] * speeds / a[6]; }
double thermal(const Arguments& a, double l, double above, double below) {
  return (1 - 6.6 * a[0] / a[1] * std::pow(l, above)) /
         (1 + 0.213 * (1 + 2.23 * std::pow(a[2], 0.83)) * std::pow(l, below));
}
Value thermal_with_speed_once(const Arguments& a, Constants) {
  return thermal(a, heating(a, a[5]), 0.42, 0.64);
}
Value thermal_with_exponents(const Arguments& a, Constants numbers) {
  return thermal(a, heating(a, a[5] * a[5]), numbers[0], numbers[1]);
}
Value thermal_of_murch_and_wilson(const Arguments& a, Constants) {
  const double l = heating(a, a[5] * a[5]);
  return 1 / (1 + 0.1 * (1 + 14.8 * std::pow(a[2], 0.83)) * std::pow(l, 0.64));
}

// --- Liquids

Value density_of_numbers(const Arguments& a, Constants numbers) {
  return 1 + numbers[0] * a[0] / (1 + numbers[1] * a[0]);
}
Value barus_linear(const Arguments& a, Constants) { return a[0] * (1 + a[1] * a[2]); }
// Numbers: p_R, what ln η₀ is multiplied by, and z over αp_R/(ln η₀ + 9.67).
Value roelands_of_numbers(const Arguments& a, Constants numbers) {
  const double scale = std::log(a[0]) * numbers[1] + 9.67;
  const double z = numbers[2] * a[1] * numbers[0] / scale;
  return a[0] * std::exp(scale * (std::pow(1 + a[2] / numbers[0], z) - 1));
}
Value roelands_in_millipascal(const Arguments& a, Constants) {
  return viscosity_at(ViscosityLaw::roelands, 1e3 * a[0], a[1], a[2]) / 1e3;
}
Value roelands_as_barus(const Arguments& a, Constants) {
  return viscosity_at(ViscosityLaw::barus, a[0], a[1], a[2]);
}

// Arguments T₁, ν₁, T₂, ν₂ and T. A straight line of y(ν) over x(T); ν in mm²/s.
template <class Of, class OfTemperature, class Inverse>
Value d341(const Arguments& a, const Of& y, const OfTemperature& x, const Inverse& viscosity) {
  const double first = y(1e6 * a[1]), second = y(1e6 * a[3]);
  const double part = (x(a[4]) - x(a[0])) / (x(a[2]) - x(a[0]));
  const double found = 1e-6 * viscosity(first + part * (second - first));
  return std::isfinite(found) ? Value(found) : std::nullopt;
}
double natural_log(double x) { return std::log(x); }
double log_log(double viscosity) { return std::log(std::log(viscosity + 0.7)); }
double without_log_log(double y) { return std::exp(std::exp(y)) - 0.7; }
Value d341_with_offset(const Arguments& a, Constants offset) {
  return d341(
      a, [&](double viscosity) { return std::log(std::log(viscosity + offset[0])); }, natural_log,
      [&](double y) { return std::exp(std::exp(y)) - offset[0]; });
}
Value d341_with_sum(const Arguments& a, Constants) {
  return d341(a, log_log, natural_log, [](double y) { return std::exp(std::exp(y)); });
}
Value d341_in_celsius(const Arguments& a, Constants) {
  return d341(
      a, log_log, [](double t) { return std::log(t - 273.15); }, without_log_log);
}
Value d341_over_temperature(const Arguments& a, Constants) {
  return d341(
      a, log_log, [](double t) { return t; }, without_log_log);
}
Value d341_with_one_logarithm(const Arguments& a, Constants) {
  return d341(
      a, [](double viscosity) { return std::log(viscosity + 0.7); }, natural_log,
      [](double y) { return std::exp(y) - 0.7; });
}

// --- Summits: arguments m₀, m₂ and m₄

Results right_summits(const Arguments& a) {
  const Summits<double> s = summits_from_spectral_moments(a[0], a[1], a[2]);
  return {s.bandwidth, s.summit_density, s.summit_radius, s.summit_height_sd,
          s.summit_plane_offset};
}
// Numbers: of which moments the root is taken.
std::optional<Results> summits_of_roots(const Arguments& a, Constants are_roots) {
  Arguments misread = a;
  for (std::size_t i = 0; i < 3; ++i)
    if (are_roots[i] != 0) misread[i] = std::sqrt(a[i]);
  const Results results = right_summits(misread);
  return results[0] > 0 ? std::optional(results) : std::nullopt;
}
// Numbers: whether √m₀ is answered for σ_s, and whether the offset is over it.
std::optional<Results> summits_of_all_heights(const Arguments& a, Constants where) {
  Results results = right_summits(a);
  const double sd = std::sqrt(a[0]);
  if (where[1] != 0) results[4] *= results[3] / sd;
  if (where[0] != 0) results[3] = sd;
  return results;
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
    NamedFormula{"regime_film", "regime_with_inverse_in_phi", 0, only<regime_with_inverse_in_phi>},
    NamedFormula{"regime_film", "regime_with_side", 1, only<regime_with_side>},
    NamedFormula{"gupta_thermal_reduction", "thermal_with_speed_once", 0,
                 only<thermal_with_speed_once>},
    NamedFormula{"gupta_thermal_reduction", "thermal_with_exponents", 2,
                 only<thermal_with_exponents>},
    NamedFormula{"gupta_thermal_reduction", "thermal_of_murch_and_wilson", 0,
                 only<thermal_of_murch_and_wilson>},
    NamedFormula{"dowson_higginson_density", "density_of_numbers", 2, only<density_of_numbers>},
    NamedFormula{"barus_viscosity", "barus_linear", 0, only<barus_linear>},
    NamedFormula{"roelands_viscosity", "roelands_of_numbers", 3, only<roelands_of_numbers>},
    NamedFormula{"roelands_viscosity", "roelands_in_millipascal", 0, only<roelands_in_millipascal>},
    NamedFormula{"roelands_viscosity", "roelands_as_barus", 0, only<roelands_as_barus>},
    NamedFormula{"astm_d341_viscosity", "d341_with_offset", 1, only<d341_with_offset>},
    NamedFormula{"astm_d341_viscosity", "d341_with_sum", 0, only<d341_with_sum>},
    NamedFormula{"astm_d341_viscosity", "d341_in_celsius", 0, only<d341_in_celsius>},
    NamedFormula{"astm_d341_viscosity", "d341_over_temperature", 0, only<d341_over_temperature>},
    NamedFormula{"astm_d341_viscosity", "d341_with_one_logarithm", 0,
                 only<d341_with_one_logarithm>},
    NamedFormula{"summits_from_spectral_moments", "summits_of_roots", 3, summits_of_roots},
    NamedFormula{"summits_from_spectral_moments", "summits_of_all_heights", 2,
                 summits_of_all_heights},
};

}  // namespace

FunctionFormula find_formula(std::string_view function, std::string_view name,
                             std::size_t numbers) {
  for (const NamedFormula& one : formulas)
    if (one.function == function && one.name == name && one.numbers == numbers) return one.formula;
  return nullptr;
}

}  // namespace tribo::conformance
