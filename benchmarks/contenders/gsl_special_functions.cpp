// SPDX-License-Identifier: Apache-2.0
// Closed forms by GSL's special functions: Kummer's U and M, and for n = 2 the error function. With
// a = (n+1)/2 and x = d²/2,
//   F_n(d) = e^{−x}/√2π Γ(n+1) 2^{−a} U(a, 1/2, x)                                       d ≥ 0
//   F_n(d) = e^{−x}/√2π 2^{a−1} (Γ(a) M(a, 1/2, x) + √2 |d| Γ(a+1/2) M(a+1/2, 3/2, x))   d < 0
#include <gsl/gsl_sf_hyperg.h>

#include <cmath>
#include <numbers>

#include "contenders/integrand.hpp"
#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

double kummer_moment(double n, double d) {
  const double a = (n + 1) / 2;
  const double x = d * d / 2;
  if (d >= 0)
    return normal_density(d) * std::tgamma(n + 1) * std::pow(2, -a) * gsl_sf_hyperg_U(a, 0.5, x);
  return normal_density(d) * std::pow(2, a - 1) *
         (std::tgamma(a) * gsl_sf_hyperg_1F1(a, 0.5, x) -
          std::numbers::sqrt2 * d * std::tgamma(a + 0.5) * gsl_sf_hyperg_1F1(a + 0.5, 1.5, x));
}

double erfc_moment_two(double d) {
  return 0.5 * (1 + d * d) * std::erfc(d / std::numbers::sqrt2) - d * normal_density(d);
}

}  // namespace

std::vector<MomentContender> gsl_special_functions() {
  return {closed_form("GSL", "hyperg_U and 1F1", Order::five_halves,
                      [](double d) { return kummer_moment(2.5, d); }),
          closed_form("closed form", "erfc", Order::two, erfc_moment_two)};
}

}  // namespace tribo::benchmarks
