// SPDX-License-Identifier: Apache-2.0
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <exception>
#include <limits>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/integrand.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Boost throws where it meets what is not finite.
template <class Integral>
double value_or_nan(const Integral& integral) {
  try {
    return integral();
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

template <class Count>
struct GaussKronrod {
  double tolerance;
  double operator()(double d) const {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    return value_or_nan(
        [&] { return Rule::integrate(RootIntegrand<Count>{d}, d, infinity, 15, tolerance); });
  }
};

template <class Count>
struct GaussKronrodPow {
  double tolerance;
  double operator()(double d) const {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    return value_or_nan([&] {
      return Rule::integrate(PowIntegrand<Count>{d, 2.5}, d, infinity, 15, tolerance);
    });
  }
};

// To a finite end: its abscissas reach far enough out for u·u·√u to overflow.
template <class Count>
struct TanhSinh {
  mutable boost::math::quadrature::tanh_sinh<double> rule{};
  double operator()(double d) const {
    return value_or_nan([&] { return rule.integrate(RootIntegrand<Count>{d}, d, finite_end(d)); });
  }
};

// In u = s − d, as the abscissas crowd at the end of the range.
template <class Count>
struct ExpSinh {
  mutable boost::math::quadrature::exp_sinh<double> rule{};
  double operator()(double d) const {
    return value_or_nan([&] {
      return rule.integrate([d](double u) {
        Count::one();
        return u * u * std::sqrt(u) * normal_density(u + d);
      });
    });
  }
};

}  // namespace

std::vector<MomentContender> boost_quadratures() {
  constexpr Order order = Order::five_halves;
  return {quadrature<GaussKronrod>("Boost", "Gauss-Kronrod 31 1e-08 sqrt", order, 1e-8),
          quadrature<GaussKronrodPow>("Boost", "Gauss-Kronrod 31 1e-08 pow", order, 1e-8),
          quadrature<GaussKronrod>("Boost", "Gauss-Kronrod 31 1e-13 sqrt", order, 1e-13),
          quadrature<TanhSinh>("Boost", "tanh-sinh", order),
          quadrature<ExpSinh>("Boost", "exp-sinh", order)};
}

}  // namespace tribo::benchmarks
