// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tribo/film_thickness.hpp"
#include "tribo/starvation.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using Constants = std::span<const double>;
using Value = std::optional<double>;

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
    NamedFormula{"gaussian_moment", "moment_of_order", 1, moment_of_order},
    NamedFormula{"gaussian_moment", "moment_about_zero", 0, moment_about_zero},
    NamedFormula{"gaussian_moment", "moment_cut_at", 2, moment_cut_at},
    NamedFormula{"gaussian_moment", "moment_cut_at_distance", 2, moment_cut_at_distance},
    NamedFormula{"gaussian_moment", "moment_over_root", 0, moment_over_root},
    NamedFormula{"gaussian_moment", "moment_power_fit", 3, moment_power_fit},
    NamedFormula{"gaussian_moment", "moment_exponential_fit", 2, moment_exponential_fit},
    NamedFormula{"gaussian_moment", "moment_error_function_fit", 0, moment_error_function_fit},
    NamedFormula{"starvation_ratio", "inlet_with_circular_gap", 0, inlet_with_circular_gap},
    NamedFormula{"starvation_ratio", "inlet_with_inverse_exponent", 0, inlet_with_inverse_exponent},
};

}  // namespace

FunctionFormula find_formula(std::string_view function, std::string_view name,
                             std::size_t numbers) {
  for (const NamedFormula& one : formulas)
    if (one.function == function && one.name == name && one.numbers == numbers) return one.formula;
  return nullptr;
}

}  // namespace tribo::conformance
