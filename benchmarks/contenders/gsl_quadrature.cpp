// SPDX-License-Identifier: Apache-2.0
// F_n by GSL's adaptive quadrature rules, and by its fixed Gauss-Laguerre rules.
#include "contenders/gsl_quadrature.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {
namespace {

constexpr Order order = Order::five_halves;
constexpr double n = 2.5;

template <template <class> class Integrand>
struct Cquad {
  template <class Count>
  struct Method {
    double n;
    double tolerance;
    std::shared_ptr<gsl_integration_cquad_workspace> workspace{
        gsl_integration_cquad_workspace_alloc(100), gsl_integration_cquad_workspace_free};
    double operator()(double d) const {
      Integrand<Count> integrand{d, n};
      gsl_function f = gsl_view(integrand);
      double result = 0;
      gsl_integration_cquad(&f, d, finite_end(d), 0, tolerance, workspace.get(), &result, nullptr,
                            nullptr);
      return result;
    }
  };
};

// The fixed rules integrate over u = s − d. The weight of the plain rule is e^{−u}. The weight of
// the generalised rule is u^{5/2} e^{−u}: it contains the integrand's square root, so that the
// remaining factor is smooth.
using Rule = std::shared_ptr<gsl_integration_fixed_workspace>;
Rule laguerre(double exponent, std::size_t points) {
  return {gsl_integration_fixed_alloc(gsl_integration_fixed_laguerre, points, 0, 1, exponent, 0),
          gsl_integration_fixed_free};
}

template <class Integrand>
double by_rule(const Rule& rule, Integrand integrand) {
  gsl_function f = gsl_view(integrand);
  double result = 0;
  gsl_integration_fixed(&f, &result, rule.get());
  return result;
}

template <class Count>
struct Plain {
  std::size_t points;
  Rule rule = laguerre(0, points);
  double operator()(double d) const {
    return by_rule(rule, [d](double u) {
      Count::one();
      return u * u * std::sqrt(u) * std::exp(u) * normal_density(u + d);
    });
  }
};

template <class Count>
struct Generalised {
  std::size_t points;
  Rule rule = laguerre(2.5, points);
  double operator()(double d) const {
    return by_rule(rule, [d](double u) {
      Count::one();
      return std::exp(u) * normal_density(u + d);
    });
  }
};

}  // namespace

std::vector<MomentContender> gsl_quadratures(Settings settings) {
  gsl_set_error_handler_off();  // the default handler ends the program
  std::vector<MomentContender> all;
  const auto add = [&]<template <class> class Pow, template <class> class Root>(
                       const char* rule, std::initializer_list<double> usual) {
    const std::vector<double> tolerances =
        chosen(settings, usual, {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13});
    for (const double tolerance : tolerances) {
      all.push_back(quadrature<Pow>("GSL", fmt::format("{} {:.0e} pow", rule, tolerance), order, n,
                                    tolerance));
      all.push_back(quadrature<Root>("GSL", fmt::format("{} {:.0e} sqrt", rule, tolerance), order,
                                     n, tolerance));
    }
  };
  add.template operator()<Qagiu<PowIntegrand>::Method, Qagiu<RootIntegrand>::Method>(
      "QAGIU", {1e-8, 1e-10, 1e-13});
  add.template operator()<Qags<PowIntegrand>::Method, Qags<RootIntegrand>::Method>("QAGS", {1e-8});
  add.template operator()<Cquad<PowIntegrand>::Method, Cquad<RootIntegrand>::Method>("CQUAD",
                                                                                     {1e-8});
  return all;
}

std::vector<MomentContender> gauss_laguerre_rules(Settings settings) {
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
