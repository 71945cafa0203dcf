// SPDX-License-Identifier: Apache-2.0
// A natural cubic spline, as GSL's users keep one.
#pragma once

#include <gsl/gsl_spline.h>

#include <memory>
#include <vector>

namespace tribo::benchmarks {

class SplineTable {
 public:
  SplineTable(const std::vector<double>& x, const std::vector<double>& y)
      : spline_(gsl_spline_alloc(gsl_interp_cspline, x.size()), gsl_spline_free),
        place_(gsl_interp_accel_alloc(), gsl_interp_accel_free) {
    gsl_spline_init(spline_.get(), x.data(), y.data(), x.size());
  }
  double operator()(double x) const { return gsl_spline_eval(spline_.get(), x, place_.get()); }

 private:
  std::shared_ptr<gsl_spline> spline_;
  std::shared_ptr<gsl_interp_accel> place_;
};

}  // namespace tribo::benchmarks
