// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "reproduction/reading_model.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/starvation.hpp"

namespace tribo::reproduction {
namespace {

double log_film_ratio(double log_length) {
  return std::log(wolveridge_film_ratio(std::exp(log_length)));
}
double slope_of_log_film_ratio(double log_length) { return wolveridge_slope(std::exp(log_length)); }

// E11: with 1.12 to 1.14 as they stand, h*/h_oil = (2/π) arctan(2.7ψ) and h_oil/h* = 1 + ψ^{3/2}/c,
// and no film enters.
double printed_constant(double crook) {
  const double length = bracketed_root(
      [&](double t) { return log_film_ratio(t) + std::log1p(std::exp(1.5 * t) / crook); }, -20.0,
      20.0, epsilon<double>());
  return wolveridge_film_ratio(std::exp(length));
}

}  // namespace

ReadInlet::ReadInlet(const Reading& reading)
    : rule_(reading.inlet()),
      // The circular contact's gap is greater by 4/π than the line contact's.
      crook_(crook_constant<double>() * (reading.is(Switch::gap, 1) ? std::numbers::pi / 4 : 1)) {
  if (rule_ == InletRule::as_printed) constant_film_ = printed_constant(crook_);
  if (rule_ == InletRule::flooded_inlet || rule_ == InletRule::printed_exponents) {
    const double t = bracketed_root(
        [&](double x) { return slope_of_log_film_ratio(x) - slope_of_log_inverse_r(x); }, -10.0,
        10.0, epsilon<double>());
    maximum_ = std::exp(-log_inverse_r(t));
  }
}

// 1/r = other + ψ^{3/2} (y^{−5/4} with the printed exponents)/c, other = 1 or y.
double ReadInlet::log_inverse_r(double log_length) const {
  const double log_y = log_film_ratio(log_length);
  double crook = 1.5 * log_length - std::log(crook_);
  if (rule_ == InletRule::printed_exponents) crook -= 1.25 * log_y;
  const double other = rule_ == InletRule::flooded_inlet ? 0 : log_y;
  return crook > other ? crook + std::log1p(std::exp(other - crook))
                       : other + std::log1p(std::exp(crook - other));
}

double ReadInlet::slope_of_log_inverse_r(double log_length) const {
  const double log_y = log_film_ratio(log_length);
  const double y_slope = slope_of_log_film_ratio(log_length);
  double crook = 1.5 * log_length - std::log(crook_);
  double crook_slope = 1.5;
  if (rule_ == InletRule::printed_exponents) {
    crook -= 1.25 * log_y;
    crook_slope -= 1.25 * y_slope;
  }
  const bool flooded = rule_ == InletRule::flooded_inlet;
  const double weight = 1 / (1 + std::exp((flooded ? 0 : log_y) - crook));
  return weight * crook_slope + (flooded ? 0 : (1 - weight) * y_slope);
}

double ReadInlet::log_length(double flooded_over_inlet) const {
  if (rule_ == InletRule::flooded_inlet)
    return 2.0 / 3 * std::log((1 - flooded_over_inlet) / flooded_over_inlet * crook_);
  const double log_r = std::log(flooded_over_inlet);
  return bracketed_root([&](double t) { return log_inverse_r(t) + log_r; },
                        -4 * std::max(log_r, 0.0) - 20, std::max(-log_r, 0.0) + 5,
                        epsilon<double>());
}

double ReadInlet::film_ratio(double flooded_over_inlet) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / flooded_over_inlet;
  if (rule_ == InletRule::flooded_inlet && flooded_over_inlet >= 1) return 0;
  return wolveridge_film_ratio(std::exp(log_length(flooded_over_inlet)));
}

double ReadInlet::slope(double flooded_over_inlet) const {
  if (rule_ == InletRule::as_printed) return -1;
  const double t = log_length(flooded_over_inlet);
  return -slope_of_log_film_ratio(t) / slope_of_log_inverse_r(t);
}

double ReadInlet::departure(double departure) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / (1 - departure);
  return std::exp(-log_inverse_r(std::log(wolveridge_inlet_length(1 - departure))));
}

}  // namespace tribo::reproduction
