// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "reproduction/reading_model.hpp"
#include "tribo/bracketed_root.hpp"

namespace tribo::reproduction {
namespace {

// The circular contact's gap is greater by 4/π than the line contact's, and c less.
InletCurve<double> curve_of(const Reading& reading) {
  const StarvationClosure closure = reading.inlet() == InletRule::as_printed
                                        ? StarvationClosure::flooded_inlet
                                        : static_cast<StarvationClosure>(reading.inlet());
  return {closure, reading.is(Switch::gap, 1) ? std::numbers::pi / 4 : 1};
}

// E11: with 1.12 to 1.14 as they stand, h*/h_oil = (2/π) arctan(2.7ψ) and h_oil/h* = 1 + ψ^{3/2}/c,
// and no film enters.
double printed_constant(const InletCurve<double>& curve) {
  const double length =
      bracketed_root([&](double t) { return curve.log_film_ratio(t) + curve.log_inverse_r(t); },
                     -20.0, 20.0, epsilon<double>());
  return wolveridge_film_ratio(std::exp(length));
}

}  // namespace

ReadInlet::ReadInlet(const Reading& reading) : rule_(reading.inlet()), curve_(curve_of(reading)) {
  if (rule_ == InletRule::as_printed)
    constant_film_ = printed_constant(curve_);
  else if (const double r = curve_.at_film_maximum(); r == r)
    maximum_ = r;
}

double ReadInlet::film_ratio(double flooded_over_inlet) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / flooded_over_inlet;
  return curve_.film_ratio(flooded_over_inlet);
}

double ReadInlet::slope(double flooded_over_inlet) const {
  return rule_ == InletRule::as_printed ? -1 : curve_.slope(flooded_over_inlet);
}

double ReadInlet::departure(double departure) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / (1 - departure);
  return curve_.at_departure(departure);
}

}  // namespace tribo::reproduction
