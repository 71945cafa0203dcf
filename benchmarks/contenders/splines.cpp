// SPDX-License-Identifier: Apache-2.0
// ln F_{5/2} in knots, made once with GSL's quadrature.
#include <fmt/format.h>

#include <cmath>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/gsl_spline_table.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

constexpr Range knots_range{-5, 12};

SplineTable log_table(int knots) {
  const Qagiu<PowIntegrand>::Method<Uncounted> moment{2.5, 1e-13};
  std::vector<double> d;
  std::vector<double> logarithm;
  for (int i = 0; i < knots; ++i) {
    d.push_back(knots_range.from + (knots_range.to - knots_range.from) * i / (knots - 1));
    logarithm.push_back(std::log(moment(d.back())));
  }
  return {d, logarithm};
}

}  // namespace

std::vector<MomentContender> splines(Settings settings) {
  std::vector<MomentContender> all;
  for (const int knots : chosen(settings, {400}, {25, 50, 100, 200, 400, 800, 1600, 6400}))
    all.push_back(closed_form(
        "table", fmt::format("spline of ln F {} knots", knots), Order::five_halves,
        [table = log_table(knots)](double d) { return std::exp(table(d)); }, knots_range));
  return all;
}

}  // namespace tribo::benchmarks
