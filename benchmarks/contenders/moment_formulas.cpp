// SPDX-License-Identifier: Apache-2.0
// F_n by formulas: closed forms in Bessel functions, in Kummer's functions and, for n = 2, in the
// error function; and published fits.
#include <gsl/gsl_sf_hyperg.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {
namespace {

namespace policies = boost::math::policies;
// With this policy Boost returns NaN or ∞ and throws no exception.
using Quiet = policies::policy<policies::domain_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::pole_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>>;

double bessel_k(double order, double x) { return boost::math::cyl_bessel_k(order, x, Quiet()); }
double bessel_i(double order, double x) { return boost::math::cyl_bessel_i(order, x, Quiet()); }

struct WeberPair {
  double zeroth, first;  // Weber's U(0, d) and U(1, d)
};

WeberPair weber(double d) {
  const double x = std::abs(d);
  const double z = x * x / 4;
  const double root = std::sqrt(x);
  if (d >= 0) {
    const double scale = 1 / std::sqrt(2 * std::numbers::pi);
    const double quarter = bessel_k(0.25, z);
    return {scale * root * quarter, scale * x * root * (bessel_k(0.75, z) - quarter)};
  }
  const double scale = std::sqrt(std::numbers::pi) / 2;
  const double quarters = bessel_i(0.25, z) + bessel_i(-0.25, z);
  const double three_quarters = bessel_i(0.75, z) + bessel_i(-0.75, z);
  return {scale * root * quarters, scale * x * root * (three_quarters + quarters)};
}

// With Kummer's functions U and M, a = (n+1)/2, x = d²/2 and φ = e^{−x}/√(2π),
//   F_n(d) = φ Γ(n+1) 2^{−a} U(a, 1/2, x)                                       d ≥ 0
//   F_n(d) = φ 2^{a−1} (Γ(a) M(a, 1/2, x) + √2 |d| Γ(a+1/2) M(a+1/2, 3/2, x))   d < 0
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

double bessel_moment(double d) {
  const WeberPair u = weber(d);
  const double second = (u.zeroth - d * u.first) * 2 / 3;
  const double third = (u.first - d * second) * 2 / 5;
  const double gamma = 15.0 / 8 / std::numbers::inv_sqrtpi;  // Γ(7/2)
  return gamma / std::sqrt(2 * std::numbers::pi) * std::exp(-d * d / 4) * third;
}

std::vector<MomentContender> bessel_forms() {
  return {closed_form("Boost", "Bessel K and I", Order::five_halves, bessel_moment)};
}

std::vector<MomentContender> gsl_special_functions() {
  return {closed_form("GSL", "hyperg_U and 1F1", Order::five_halves,
                      [](double d) { return kummer_moment(2.5, d); }),
          closed_form("closed form", "erfc", Order::two, erfc_moment_two)};
}

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
