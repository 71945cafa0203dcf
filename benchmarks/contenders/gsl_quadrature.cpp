// SPDX-License-Identifier: Apache-2.0
#include "contenders/gsl_quadrature.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

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

std::vector<MomentContender> gsl_quadratures() {
  gsl_set_error_handler_off();  // the default one aborts
  constexpr Order order = Order::five_halves;
  const double n = value_of<double>(order);
  std::vector<MomentContender> all;
  for (const double tolerance : {1e-8, 1e-10, 1e-13}) {
    all.push_back(quadrature<Qagiu<PowIntegrand>::Method>(
        "GSL", fmt::format("QAGIU {:.0e} pow", tolerance), order, n, tolerance));
    all.push_back(quadrature<Qagiu<RootIntegrand>::Method>(
        "GSL", fmt::format("QAGIU {:.0e} sqrt", tolerance), order, n, tolerance));
  }
  all.push_back(quadrature<Qags<PowIntegrand>::Method>("GSL", "QAGS 1e-08 pow", order, n, 1e-8));
  all.push_back(quadrature<Qags<RootIntegrand>::Method>("GSL", "QAGS 1e-08 sqrt", order, n, 1e-8));
  all.push_back(quadrature<Cquad<PowIntegrand>::Method>("GSL", "CQUAD 1e-08 pow", order, n, 1e-8));
  all.push_back(
      quadrature<Cquad<RootIntegrand>::Method>("GSL", "CQUAD 1e-08 sqrt", order, n, 1e-8));
  return all;
}

}  // namespace tribo::benchmarks
