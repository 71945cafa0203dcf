// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <limits>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <template <class> class Integrand>
struct GaussKronrod {
  template <class Count>
  struct Method {
    double tolerance;
    double operator()(double d) const {
      using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
      return value_or_nan([&] {
        return Rule::integrate(Integrand<Count>{d, 2.5}, d, infinity, 15, tolerance);
      });
    }
  };
};

// The integral has a finite upper end. On an infinite range this rule has so large abscissas that
// u·u·√u overflows.
template <class Count>
struct TanhSinh {
  double tolerance;
  mutable boost::math::quadrature::tanh_sinh<double> rule{};
  double operator()(double d) const {
    return value_or_nan(
        [&] { return rule.integrate(RootIntegrand<Count>{d}, d, finite_end(d), tolerance); });
  }
};

// The integral is over u = s − d > 0, because the rule's abscissas are dense near 0.
template <class Count>
struct ExpSinh {
  double tolerance;
  mutable boost::math::quadrature::exp_sinh<double> rule{};
  double operator()(double d) const {
    return value_or_nan([&] {
      return rule.integrate(
          [d](double u) {
            Count::one();
            return u * u * std::sqrt(u) * normal_density(u + d);
          },
          tolerance);
    });
  }
};

}  // namespace

std::vector<MomentContender> boost_quadratures(Settings settings) {
  constexpr Order order = Order::five_halves;
  std::vector<MomentContender> all;
  for (const double tolerance :
       chosen(settings, {1e-8, 1e-13}, {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13})) {
    all.push_back(quadrature<GaussKronrod<PowIntegrand>::Method>(
        "Boost", fmt::format("Gauss-Kronrod 31 {:.0e} pow", tolerance), order, tolerance));
    all.push_back(quadrature<GaussKronrod<RootIntegrand>::Method>(
        "Boost", fmt::format("Gauss-Kronrod 31 {:.0e} sqrt", tolerance), order, tolerance));
  }
  for (const double tolerance : chosen(settings, {1e-8}, {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})) {
    all.push_back(quadrature<TanhSinh>("Boost", fmt::format("tanh-sinh {:.0e}", tolerance), order,
                                       tolerance));
    all.push_back(
        quadrature<ExpSinh>("Boost", fmt::format("exp-sinh {:.0e}", tolerance), order, tolerance));
  }
  return all;
}

}  // namespace tribo::benchmarks
