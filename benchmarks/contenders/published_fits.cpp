// SPDX-License-Identifier: Apache-2.0
#include "contenders/published_fits.hpp"

#include <cmath>
#include <numbers>

#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {

const std::array<PublishedFit, 6>& all_published_fits() {
  // F_{5/2}(0) = Γ(7/4) 2^{1/4}/√π
  static const double at_zero = std::tgamma(1.75) * std::pow(2, 0.25) * std::numbers::inv_sqrtpi;
  static const std::array<PublishedFit, 6> fits{{
      {"4.4086e-5 (4-d)^6.804",
       Order::five_halves,
       {0, 4},
       [](double d) { return d < 4 ? 4.4086e-5 * std::pow(4 - d, 6.804) : 0; }},
      {"4.4068e-5 (4-d)^6.804",
       Order::five_halves,
       {0, 4},
       [](double d) { return d < 4 ? 4.4068e-5 * std::pow(4 - d, 6.804) : 0; }},
      {"0.6189 exp(-1.973 d)",
       Order::five_halves,
       {0, 3},
       [](double d) { return 0.6189 * std::exp(-1.973 * d); }},
      {"F(0) (1 - erf d)",
       Order::five_halves,
       {0, 4},
       [](double d) { return at_zero * (1 - std::erf(d)); }},
      {"3.5e-5 (4-d)^6.9",
       Order::two,
       {0, 4},
       [](double d) { return d < 4 ? 3.5e-5 * std::pow(4 - d, 6.9) : 0; }},
      {"0.5025 exp(-1.844 d)",
       Order::two,
       {0, 3},
       [](double d) { return 0.5025 * std::exp(-1.844 * d); }},
  }};
  return fits;
}

std::vector<MomentContender> published_fits() {
  std::vector<MomentContender> all;
  for (const PublishedFit& fit : all_published_fits())
    all.push_back(
        closed_form("published fit", std::string(fit.name), fit.order, fit.value, fit.claimed));
  return all;
}

}  // namespace tribo::benchmarks
