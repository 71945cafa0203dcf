// SPDX-License-Identifier: Apache-2.0
// F_n by GSL's adaptive quadrature. The integrand has the two forms that programs use: (s−d)ⁿ by
// pow, and u·u·√u for n = 5/2, where u is s − d.
#pragma once

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "contenders/contender.hpp"

namespace tribo::benchmarks {

inline double normal_density(double s) {
  return std::exp(-0.5 * s * s) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}

template <class Count>
struct PowIntegrand {
  double d;
  double n;
  double operator()(double s) const {
    Count::one();
    return std::pow(s - d, n) * normal_density(s);
  }
};

template <class Count>
struct RootIntegrand {  // n = 5/2
  double d;
  double n = 2.5;
  double operator()(double s) const {
    Count::one();
    const double u = s - d;
    return u * u * std::sqrt(u) * normal_density(s);
  }
};

// Makes the function that GSL calls from an integrand object, which it does not copy.
template <class Integrand>
gsl_function gsl_view(Integrand& integrand) {
  return {[](double s, void* object) { return (*static_cast<Integrand*>(object))(s); }, &integrand};
}

inline constexpr std::size_t gsl_intervals = 1000;
// The upper end of the integral. The integral beyond this end is less than 1e-20 times F_n(d).
inline double finite_end(double d) { return std::max(d, 0.0) + 10; }

class GslWorkspace {
 public:
  gsl_integration_workspace* get() const { return workspace_.get(); }

 private:
  std::shared_ptr<gsl_integration_workspace> workspace_{
      gsl_integration_workspace_alloc(gsl_intervals), gsl_integration_workspace_free};
};

// QAGIU, or QAGS with a finite end.
template <template <class> class Integrand, bool is_endless>
struct Adaptive {
  template <class Count>
  struct Method {
    double n;
    double tolerance;  // relative
    GslWorkspace workspace{};
    double operator()(double d) const {
      Integrand<Count> integrand{d, n};
      gsl_function f = gsl_view(integrand);
      double result = 0;
      double error = 0;
      if (is_endless)
        gsl_integration_qagiu(&f, d, 0, tolerance, gsl_intervals, workspace.get(), &result, &error);
      else
        gsl_integration_qags(&f, d, finite_end(d), 0, tolerance, gsl_intervals, workspace.get(),
                             &result, &error);
      return result;
    }
  };
};

template <template <class> class Integrand>
using Qagiu = Adaptive<Integrand, true>;
template <template <class> class Integrand>
using Qags = Adaptive<Integrand, false>;

}  // namespace tribo::benchmarks
