// SPDX-License-Identifier: Apache-2.0
// ln F_{5/2} in 400 knots, made once with GSL's quadrature.
#include <cmath>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/gsl_spline_table.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

constexpr Range knots_range{-5, 12};
constexpr int knots = 400;

SplineTable log_table() {
  const Qagiu<PowIntegrand>::Method<Uncounted> moment{2.5, 1e-10};
  std::vector<double> d;
  std::vector<double> logarithm;
  for (int i = 0; i < knots; ++i) {
    d.push_back(knots_range.from + (knots_range.to - knots_range.from) * i / (knots - 1));
    logarithm.push_back(std::log(moment(d.back())));
  }
  return {d, logarithm};
}

}  // namespace

std::vector<MomentContender> splines() {
  return {closed_form(
      "table", "spline of ln F 400 knots", Order::five_halves,
      [table = log_table()](double d) { return std::exp(table(d)); }, knots_range)};
}

}  // namespace tribo::benchmarks
