// SPDX-License-Identifier: Apache-2.0
// F_n by GSL's adaptive quadrature.
#pragma once

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include "contenders/integrand.hpp"

namespace tribo::benchmarks {

// The function that GSL calls, made from an integrand that is an object.
template <class Integrand>
gsl_function gsl_view(Integrand& integrand) {
  return {[](double s, void* object) { return (*static_cast<Integrand*>(object))(s); }, &integrand};
}

inline constexpr std::size_t gsl_intervals = 1000;
// Far enough that what is cut off is below 1e-20 of F.
inline double finite_end(double d) { return std::max(d, 0.0) + 10; }

class GslWorkspace {
 public:
  gsl_integration_workspace* get() const { return workspace_.get(); }

 private:
  std::shared_ptr<gsl_integration_workspace> workspace_{
      gsl_integration_workspace_alloc(gsl_intervals), gsl_integration_workspace_free};
};

template <template <class> class Integrand>
struct Qagiu {
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
      gsl_integration_qagiu(&f, d, 0, tolerance, gsl_intervals, workspace.get(), &result, &error);
      return result;
    }
  };
};

template <template <class> class Integrand>
struct Qags {
  template <class Count>
  struct Method {
    double n;
    double tolerance;
    GslWorkspace workspace{};
    double operator()(double d) const {
      Integrand<Count> integrand{d, n};
      gsl_function f = gsl_view(integrand);
      double result = 0;
      double error = 0;
      gsl_integration_qags(&f, d, finite_end(d), 0, tolerance, gsl_intervals, workspace.get(),
                           &result, &error);
      return result;
    }
  };
};

}  // namespace tribo::benchmarks
