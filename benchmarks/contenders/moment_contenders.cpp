// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "contenders/moment_families.hpp"
#include "contenders/scipy_way.hpp"

namespace tribo::benchmarks {

std::vector<MomentContender> moment_contenders(Settings settings) {
  std::vector<MomentContender> all;
  std::vector<std::vector<MomentContender>> families{gsl_quadratures(settings),
                                                     gsl_special_functions(),
                                                     boost_quadratures(settings),
                                                     bessel_forms(),
                                                     gauss_laguerre_rules(settings),
                                                     splines(settings),
                                                     published_fits(),
                                                     scipy_moments(),
                                                     own_moments()};
  for (std::vector<MomentContender>& family : families)
    std::move(family.begin(), family.end(), std::back_inserter(all));
  return all;
}

}  // namespace tribo::benchmarks
