// SPDX-License-Identifier: Apache-2.0
#include "contenders/gsl_quadrature.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "contenders/moment_families.hpp"

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

}  // namespace

std::vector<MomentContender> gsl_quadratures(Settings settings) {
  gsl_set_error_handler_off();  // the default one aborts
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

}  // namespace tribo::benchmarks
