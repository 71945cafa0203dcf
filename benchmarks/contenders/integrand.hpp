// SPDX-License-Identifier: Apache-2.0
// The integrand of F_n in the two spellings that are met: (s−d)ⁿ by pow, and for n = 5/2 by u·u·√u.
#pragma once

#include <cmath>
#include <numbers>

#include "contenders/counting.hpp"
#include "tribo/gaussian_moment.hpp"

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

}  // namespace tribo::benchmarks
