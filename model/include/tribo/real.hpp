// SPDX-License-Identifier: Apache-2.0
// What the formulas ask of a number type: float, double, long double, a multiprecision type, an
// interval or an automatic-differentiation type. Mathematical functions are found by
// argument-dependent lookup beside std.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace tribo {

// p/q in the precision of T: the exponents 0.67, 0.53, 0.14 … are decimal, not binary, fractions.
template <class T>
T ratio(int p, int q) {
  return T(p) / T(q);
}

// π in the precision of T.
template <class T>
T pi() {
  if constexpr (std::is_floating_point_v<T>) {
    return std::numbers::pi_v<T>;
  } else {
    using std::acos;
    static const T value = acos(T(-1));
    return value;
  }
}

// √(2π) in the precision of T.
template <class T>
T sqrt_two_pi() {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(2.50662827463100050241576528481104525301L);
  } else {
    using std::sqrt;
    static const T value = sqrt(2 * pi<T>());
    return value;
  }
}

// Relative spacing of T at 1.
template <class T>
T epsilon() {
  return T(std::numeric_limits<T>::epsilon());
}

// ln(1/ε), the number of e-foldings that T resolves.
template <class T>
T resolved_exponent() {
  using std::log;
  static const T value = -log(epsilon<T>());
  return value;
}

template <class T>
T quiet_nan() {
  return T(std::numeric_limits<T>::quiet_NaN());
}

template <class T>
bool is_finite(const T& x) {
  return x - x == T(0);
}

template <class T>
T cube_root(const T& x) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::cbrt(x);
  } else {
    using std::pow;
    return pow(x, ratio<T>(1, 3));
  }
}

}  // namespace tribo
