// SPDX-License-Identifier: Apache-2.0
// Condition number of the load-sharing root, and the same root found by GSL as people write it.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>

#include <cmath>

#include "support/judge.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::verification {

// |d ln λ/d ln λ₀| + |d ln λ/d ln K| + |d ln λ/d ln δ|, at least 1: from
// g = ln λ − ln λ₀ + 0.14 ln(1 − A), with a = d ln A/d ln λ and m = 0.14 A/(1 − A):
// (1 − m a) d ln λ = d ln λ₀ + m (q d ln K − a (δ/λ) d ln δ).
inline double root_condition(AsperityModel model, double stiffness, double offset,
                             double flooded_film_parameter) {
  const LoadSharing<double> sharing(model, stiffness, offset);
  const LoadShares<double> at = sharing.solve(flooded_film_parameter);
  const double slope = -sharing.asperity_share_slope(at.film_parameter);
  const double weight = 0.14 * at.asperity / at.fluid;
  if (!std::isfinite(weight)) {  // at the floor: λ_b of K and δ alone
    return std::max(1.0, sharing_exponent<double>(model) / slope + offset / at.film_parameter);
  }
  return std::max(1.0, (1 + weight * (sharing_exponent<double>(model) +
                                      slope * (offset + at.film_parameter) / at.film_parameter)) /
                           (1 + weight * slope));
}

// GSL: QAGIU for F_p written with pow, Brent for the root.
class GslLoadSharing {
 public:
  GslLoadSharing(AsperityModel model, double stiffness, double offset)
      : model_(model), stiffness_(stiffness), offset_(offset) {
    gsl_set_error_handler_off();
    workspace_ = gsl_integration_workspace_alloc(2000);
  }
  ~GslLoadSharing() { gsl_integration_workspace_free(workspace_); }
  GslLoadSharing(const GslLoadSharing&) = delete;
  GslLoadSharing& operator=(const GslLoadSharing&) = delete;

  double moment(double order, double d) const {
    double parameters[] = {order, d};
    gsl_function integrand{[](double s, void* p) {
                             const double* n_and_d = static_cast<const double*>(p);
                             return std::pow(s - n_and_d[1], n_and_d[0]) * std::exp(-s * s / 2) /
                                    std::sqrt(2 * M_PI);
                           },
                           parameters};
    double value = 0, error = 0;
    gsl_integration_qagiu(&integrand, d, 0, 1e-11, 2000, workspace_, &value, &error);
    return value;
  }

  double asperity_share(double lambda) const {
    const bool tripp = model_ == AsperityModel::greenwood_tripp;
    const double load = stiffness_ * moment(tripp ? 2.5 : 1.5, lambda - offset_);
    return tripp ? std::sqrt(load) : load;
  }

  // ln λ − ln λ₀ + 0.14 ln(1 − A), −∞ where A ≥ 1.
  double residual(double lambda, double lambda0) const {
    const double share = asperity_share(lambda);
    if (share >= 1) return -1e3;
    return std::log(lambda) - std::log(lambda0) + 0.14 * std::log1p(-share);
  }

  double solve(double lambda0) const {
    struct Problem {
      const GslLoadSharing* self;
      double lambda0;
    } problem{this, lambda0};
    gsl_function function{[](double x, void* p) {
                            const Problem* q = static_cast<const Problem*>(p);
                            return q->self->residual(x, q->lambda0);
                          },
                          &problem};
    double high = lambda0 * 2;
    while (residual(high, lambda0) < 0) high *= 2;
    gsl_root_fsolver* solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &function, lambda0 / 2, high);
    for (int i = 0; i < 200; ++i) {
      gsl_root_fsolver_iterate(solver);
      if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver),
                                 0, 1e-13) == GSL_SUCCESS)
        break;
    }
    const double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return root;
  }

 private:
  AsperityModel model_;
  double stiffness_, offset_;
  gsl_integration_workspace* workspace_;
};

}  // namespace tribo::verification
