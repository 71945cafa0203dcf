// SPDX-License-Identifier: Apache-2.0
#include "contenders/moment_families.hpp"
#include "contenders/scipy_way.hpp"

namespace tribo::benchmarks {

std::vector<MomentContender> moment_contenders() {
  std::vector<MomentContender> all;
  for (const auto family :
       {gsl_quadratures, gsl_special_functions, boost_quadratures, bessel_forms,
        gauss_laguerre_rules, splines, published_fits, scipy_moments, own_moments})
    for (MomentContender& contender : family()) all.push_back(std::move(contender));
  return all;
}

}  // namespace tribo::benchmarks
