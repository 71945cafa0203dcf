// SPDX-License-Identifier: Apache-2.0
// Fixed rules in u = s − d: with the weight e^{−u}, and with u^{5/2} e^{−u}, which
// takes up the root of the integrand.
#include <fmt/format.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

using Rule = std::shared_ptr<gsl_integration_fixed_workspace>;
Rule laguerre(double exponent, std::size_t points) {
  return {gsl_integration_fixed_alloc(gsl_integration_fixed_laguerre, points, 0, 1, exponent, 0),
          gsl_integration_fixed_free};
}

template <class Count>
struct Plain {
  std::size_t points;
  Rule rule = laguerre(0, points);
  double operator()(double d) const {
    auto integrand = [d](double u) {
      Count::one();
      return u * u * std::sqrt(u) * std::exp(u) * normal_density(u + d);
    };
    gsl_function f = gsl_view(integrand);
    double result = 0;
    gsl_integration_fixed(&f, &result, rule.get());
    return result;
  }
};

template <class Count>
struct Generalised {
  std::size_t points;
  Rule rule = laguerre(2.5, points);
  double operator()(double d) const {
    auto integrand = [d](double u) {
      Count::one();
      return std::exp(u) * normal_density(u + d);
    };
    gsl_function f = gsl_view(integrand);
    double result = 0;
    gsl_integration_fixed(&f, &result, rule.get());
    return result;
  }
};

}  // namespace

std::vector<MomentContender> gauss_laguerre_rules(Settings settings) {
  constexpr Order order = Order::five_halves;
  std::vector<MomentContender> all;
  for (const std::size_t points : chosen<std::size_t>(settings, {32}, {4, 8, 16, 32, 64, 128})) {
    all.push_back(
        quadrature<Plain>("fixed rule", fmt::format("Gauss-Laguerre {}", points), order, points));
    all.push_back(quadrature<Generalised>(
        "fixed rule", fmt::format("generalised Gauss-Laguerre {}", points), order, points));
  }
  return all;
}

}  // namespace tribo::benchmarks
