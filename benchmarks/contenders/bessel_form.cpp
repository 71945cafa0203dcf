// SPDX-License-Identifier: Apache-2.0
#include "contenders/bessel_form.hpp"

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

#include "contenders/moment_families.hpp"

namespace tribo::benchmarks {
namespace {

namespace policies = boost::math::policies;
// NaN and ∞ instead of exceptions.
using Quiet = policies::policy<policies::domain_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::pole_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>>;

double bessel_k(double order, double x) { return boost::math::cyl_bessel_k(order, x, Quiet()); }
double bessel_i(double order, double x) { return boost::math::cyl_bessel_i(order, x, Quiet()); }

struct WeberPair {
  double zeroth, first;  // U(0, d), U(1, d)
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

}  // namespace tribo::benchmarks
