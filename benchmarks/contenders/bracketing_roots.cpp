// SPDX-License-Identifier: Apache-2.0
// Brent's method of GSL and TOMS 748 of Boost on the load balance.
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_equation.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int most_iterations = 200;

template <bool over_roughness>
struct BrentIn {
  double tolerance;
  std::shared_ptr<gsl_root_fsolver> solver{gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                           gsl_root_fsolver_free};

  template <class Residual>
  double operator()(const RootCase& root_case, const Residual& residual) const {
    const Bracket bracket = over_roughness ? bracket_over_roughness(root_case, residual)
                                           : bracket_above(root_case, residual);
    if (std::isnan(bracket.at_low) || std::isnan(bracket.at_high)) return nan;  // no moment
    if (bracket.at_low == 0 || bracket.low == bracket.high) return bracket.low;
    if ((bracket.at_low > 0) == (bracket.at_high > 0)) return bracket.low;  // λ = λ₀ is the root
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

using Brent = BrentIn<false>;

constexpr int full_bits = std::numeric_limits<double>::digits - 1;

struct Toms748 {
  int bits;
  template <class Residual>
  double operator()(const RootCase& root_case, const Residual& residual) const {
    const Bracket bracket = bracket_above(root_case, residual);
    if (std::isnan(bracket.at_low) || std::isnan(bracket.at_high)) return nan;  // no moment
    if (bracket.at_low == 0 || bracket.low == bracket.high) return bracket.low;
    if (!(bracket.at_low > 0 && bracket.at_high <= 0)) return nan;
    std::uintmax_t iterations = most_iterations;
    const auto [low, high] = boost::math::tools::toms748_solve(
        residual, bracket.low, bracket.high, bracket.at_low, bracket.at_high,
        boost::math::tools::eps_tolerance<double>(bits), iterations);
    return low + (high - low) / 2;
  }
};

}  // namespace

std::vector<RootContender> bracketing_roots(Settings settings) {
  gsl_set_error_handler_off();  // the default handler ends the program
  std::vector<RootContender> all;
  const auto add_slow = [&](RootContender contender) {
    contender.is_slow = true;
    all.push_back(std::move(contender));
  };
  // The quadrature has the same tolerance as the root.
  for (const double tolerance : chosen(settings, {1e-10}, {1e-3, 1e-6, 1e-8, 1e-10, 1e-12})) {
    const Qagiu<PowIntegrand>::Method<Uncounted> by_pow{2.5, tolerance};
    const Qagiu<RootIntegrand>::Method<Uncounted> by_root{2.5, tolerance};
    add_slow(on_load_balance("GSL", fmt::format("Brent + QAGIU {:.0e} pow", tolerance), by_pow,
                             Brent{tolerance}));
    add_slow(on_load_balance("GSL", fmt::format("Brent + QAGIU {:.0e} sqrt", tolerance), by_root,
                             Brent{tolerance}));
  }
  // These contenders solve the equation as the paper writes it, which is the form that many users
  // would try first. The root's tolerance is a hundredth of that of the quadrature.
  for (const double tolerance : chosen(settings, {1e-10}, {1e-3, 1e-6, 1e-8, 1e-10})) {
    const Qagiu<PowIntegrand>::Method<Uncounted> by_pow{2.5, tolerance};
    add_slow(on_film(
        "GSL",
        fmt::format("Brent {:.0e} on the film + QAGIU {:.0e} pow", tolerance / 100, tolerance),
        by_pow, BrentIn<true>{tolerance / 100}));
  }
  add_slow(on_load_balance("Boost", "TOMS 748 + Bessel form", bessel_moment, Toms748{full_bits}));
  for (const int bits : chosen(settings, {full_bits}, {8, 16, 24, 32, 40, full_bits}))
    all.push_back(on_load_balance("Boost", fmt::format("TOMS 748 {} bits + our F", bits),
                                  fast_moment, Toms748{bits}));
  for (const double tolerance :
       chosen(settings, {1e-15}, {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15}))
    all.push_back(on_load_balance("GSL", fmt::format("Brent {:.0e} + our F", tolerance),
                                  fast_moment, Brent{tolerance}));
  return all;
}

}  // namespace tribo::benchmarks
