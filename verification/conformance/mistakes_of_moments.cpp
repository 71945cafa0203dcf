// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistake.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Value = std::optional<double>;
constexpr double pi = std::numbers::pi;

double number(const json& inputs, const char* name) { return inputs.at(name).get<double>(); }

// Moments: `wrong(n, d)`.
template <class Wrong>
Mistake moment(std::string name, std::string text, Wrong&& wrong) {
  return {"gaussian_moment", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view) -> Value {
            return wrong(number(in, "order"), number(in, "argument"));
          }};
}

double gaussian(double s) { return std::exp(-s * s / 2) / std::sqrt(2 * pi); }

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
std::optional<double> moment_of(double order, double d) {
  if (order < 0 || order > 3.5) return std::nullopt;
  if (order > 2.5) return simpson(order, d, std::max(d, 0.0) + 14, 4000);
  return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order)), d);
}

// ∫ sⁿ φ(s) ds over s > d; half orders have no power of s < 0.
double moment_about_zero(double order, double d) {
  if (order == 0) return gaussian_moment(Order::zero, d);
  if (order == 1) return gaussian(d);
  if (order == 2) return d * gaussian(d) + gaussian_moment(Order::zero, d);
  if (d <= 0) return *moment_of(order, 0);
  const int count = 8000;
  const double h = 16.0 / count;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double s = d + (i + 0.5) * h;
    sum += std::pow(s, order) * gaussian(s);
  }
  return sum * h;
}

// The mistake of a fit for one order, between `from` and `to`; elsewhere it says nothing.
template <class Wrong>
Mistake fit(double order, double from, double to, std::string name, std::string text,
            Wrong&& wrong) {
  return moment(std::move(name), std::move(text), [=](double n, double d) -> Value {
    if (n != order || d < from || d > to) return std::nullopt;
    return wrong(d);
  });
}

}  // namespace

std::vector<Mistake> moment_mistakes() {
  const double zero = gaussian_moment(Order::five_halves, 0.0);
  std::vector<Mistake> all{
      moment("moment-unnormalized", "e^{−s²/2} without its 1/√(2π)",
             [](double n, double d) -> Value {
               const Value right = moment_of(n, d);
               return right ? Value(*right * std::sqrt(2 * pi)) : right;
             }),
      moment("moment-sign", "the argument with its sign changed",
             [](double n, double d) -> Value { return moment_of(n, -d); }),
      moment("moment-order-half-lower", "F of an order lower by 1/2",
             [](double n, double d) -> Value { return moment_of(n - 0.5, d); }),
      moment("moment-order-half-higher", "F of an order higher by 1/2",
             [](double n, double d) -> Value { return moment_of(n + 0.5, d); }),
      moment("moment-order-lower", "F of an order lower by 1",
             [](double n, double d) -> Value { return moment_of(n - 1, d); }),
      moment("moment-order-higher", "F of an order higher by 1",
             [](double n, double d) -> Value { return moment_of(n + 1, d); }),
      moment("moment-about-zero", "∫ sⁿ φ(s) ds, the moment about 0 instead of about d",
             [](double n, double d) -> Value { return moment_about_zero(n, d); }),
      moment("moment-cut-at-4", "the integral cut off at s = 4",
             [](double n, double d) -> Value { return simpson(n, d, 4, 20000); }),
      moment("moment-cut-at-d-plus-5", "the integral cut off at s = d + 5",
             [](double n, double d) -> Value { return simpson(n, d, d + 5, 20000); }),
      moment("moment-simpson-201", "Simpson's rule with 201 points over 20 standard deviations",
             [](double n, double d) -> Value { return simpson(n, d, d + 20, 200); }),
      moment("moment-simpson-cut-4", "Simpson's rule with 200 intervals, cut off at s = d + 4",
             [](double n, double d) -> Value { return simpson(n, d, d + 4, 200); }),
      moment("moment-simpson-cut-4.5", "Simpson's rule with 200 intervals, cut off at s = d + 4.5",
             [](double n, double d) -> Value { return simpson(n, d, d + 4.5, 200); }),
      moment("moment-simpson-cut-5", "Simpson's rule with 200 intervals, cut off at s = d + 5",
             [](double n, double d) -> Value { return simpson(n, d, d + 5, 200); }),
      moment("moment-stray-root", "a Bessel form with a stray 1/√d",
             [](double n, double d) -> Value {
               const Value right = moment_of(n, d);
               return right && d > 0 ? Value(*right / std::sqrt(d)) : std::nullopt;
             }),
      fit(2.5, 0, 4, "moment-fit-6.804", "the published fit 4.4086e-5 (4−d)^6.804 of F_5/2",
          [](double d) { return 4.4086e-5 * std::pow(4 - d, 6.804); }),
      fit(2.5, 0, 4, "moment-fit-4.4068",
          "the fit 4.4068e-5 (4−d)^6.804, its digits swapped in copying",
          [](double d) { return 4.4068e-5 * std::pow(4 - d, 6.804); }),
      fit(2, 0, 4, "moment-fit-6.9", "the published fit 3.5e-5 (4−d)^6.9 of F_2",
          [](double d) { return 3.5e-5 * std::pow(4 - d, 6.9); }),
      fit(2.5, 0, 40, "moment-fit-exponential", "the published fit 0.6189 e^{−1.973 d} of F_5/2",
          [](double d) { return 0.6189 * std::exp(-1.973 * d); }),
      fit(2, 0, 40, "moment-fit-exponential-2", "the published fit 0.5025 e^{−1.844 d} of F_2",
          [](double d) { return 0.5025 * std::exp(-1.844 * d); }),
      fit(2.5, 0, 4, "moment-fit-erf", "the fit F_5/2(0) (1 − erf d)",
          [zero](double d) { return zero * std::erfc(d); })};
  return all;
}

}  // namespace tribo::conformance
