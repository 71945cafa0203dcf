// SPDX-License-Identifier: Apache-2.0
// Fixed rules of 32 points in u = s − d: with the weight e^{−u}, and with u^{5/2} e^{−u}, which
// takes up the root of the integrand.
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

constexpr std::size_t points = 32;

using Rule = std::shared_ptr<gsl_integration_fixed_workspace>;
Rule laguerre(double exponent) {
  return {gsl_integration_fixed_alloc(gsl_integration_fixed_laguerre, points, 0, 1, exponent, 0),
          gsl_integration_fixed_free};
}

template <class Count>
struct Plain {
  Rule rule = laguerre(0);
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
  Rule rule = laguerre(2.5);
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

std::vector<MomentContender> gauss_laguerre_rules() {
  constexpr Order order = Order::five_halves;
  return {quadrature<Plain>("fixed rule", "Gauss-Laguerre 32", order),
          quadrature<Generalised>("fixed rule", "generalised Gauss-Laguerre 32", order)};
}

}  // namespace tribo::benchmarks
