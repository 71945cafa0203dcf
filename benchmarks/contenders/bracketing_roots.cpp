// SPDX-License-Identifier: Apache-2.0
// Brent's method of GSL and TOMS 748 of Boost on the load balance, bracketed upward from λ₀.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>
#include <memory>

#include "contenders/bessel_form.hpp"
#include "contenders/gsl_quadrature.hpp"
#include "contenders/root_equation.hpp"
#include "contenders/root_families.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int most_iterations = 200;

struct Brent {
  double tolerance;
  std::shared_ptr<gsl_root_fsolver> solver{gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                           gsl_root_fsolver_free};

  template <class Residual>
  double operator()(const RootCase& root_case, const Residual& residual) const {
    const Bracket bracket = bracket_above(root_case, residual);
    if (bracket.at_low == 0 || bracket.low == bracket.high) return bracket.low;
    Residual copy = residual;
    gsl_function f = gsl_view(copy);
    gsl_root_fsolver* const s = solver.get();
    if (gsl_root_fsolver_set(s, &f, bracket.low, bracket.high) != GSL_SUCCESS) return nan;
    for (int i = 0; i < most_iterations; ++i) {
      if (gsl_root_fsolver_iterate(s) != GSL_SUCCESS) return nan;
      if (gsl_root_test_interval(gsl_root_fsolver_x_lower(s), gsl_root_fsolver_x_upper(s), 0,
                                 tolerance) == GSL_SUCCESS)
        return gsl_root_fsolver_root(s);
    }
    return nan;
  }
};

struct Toms748 {
  template <class Residual>
  double operator()(const RootCase& root_case, const Residual& residual) const {
    const Bracket bracket = bracket_above(root_case, residual);
    if (bracket.at_low == 0 || bracket.low == bracket.high) return bracket.low;
    if (!(bracket.at_low > 0 && bracket.at_high <= 0)) return nan;
    std::uintmax_t iterations = most_iterations;
    const auto [low, high] = boost::math::tools::toms748_solve(
        residual, bracket.low, bracket.high, bracket.at_low, bracket.at_high,
        boost::math::tools::eps_tolerance<double>(), iterations);
    return low + (high - low) / 2;
  }
};

double fast_moment(double d) { return gaussian_moment(Order::five_halves, d); }

}  // namespace

std::vector<RootContender> bracketing_roots() {
  gsl_set_error_handler_off();  // the default one aborts
  const Qagiu<PowIntegrand>::Method<Uncounted> by_pow{2.5, 1e-10};
  const Qagiu<RootIntegrand>::Method<Uncounted> by_root{2.5, 1e-10};
  std::vector<RootContender> all{
      on_load_balance("GSL", "Brent + QAGIU 1e-10 pow", by_pow, Brent{1e-10}),
      on_load_balance("GSL", "Brent + QAGIU 1e-10 sqrt", by_root, Brent{1e-10}),
      on_load_balance("Boost", "TOMS 748 + Bessel form", bessel_moment, Toms748{}),
      on_load_balance("Boost", "TOMS 748 + our F", fast_moment, Toms748{}),
      on_load_balance("GSL", "Brent + our F", fast_moment, Brent{1e-15}),
  };
  for (std::size_t slow = 0; slow < 3; ++slow) all[slow].is_slow = true;
  return all;
}

}  // namespace tribo::benchmarks
