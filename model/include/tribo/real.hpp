// SPDX-License-Identifier: Apache-2.0
// Operations that the formulas need of a number type: float, double, long double, a multiprecision
// type, an interval or an automatic-differentiation type. Mathematical functions are those of std,
// or are found by argument-dependent lookup.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <type_traits>

namespace tribo {

// A type with more digits, for differences that cancel; T itself beyond double.
template <class T>
using WiderType = std::conditional_t<std::is_same_v<T, float>, double,
                                     std::conditional_t<std::is_same_v<T, double>, long double, T>>;

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

// 2/π in the precision of T.
template <class T>
T two_over_pi() {
  if constexpr (std::is_floating_point_v<T>) {
    return 2 * std::numbers::inv_pi_v<T>;
  } else {
    return 2 / pi<T>();
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

// p/q, as the exponents of the fits are given.
struct Fraction {
  int p, q;
};
template <class T>
T ratio(const Fraction& f) {
  return ratio<T>(f.p, f.q);
}
constexpr Fraction inverse(const Fraction& f) { return {f.q, f.p}; }
constexpr Fraction operator-(const Fraction& x, const Fraction& y) {
  const int q = std::lcm(x.q, y.q);
  return {x.p * (q / x.q) - y.p * (q / y.q), q};
}

// f − ratio<T>(f), the rounding error of the ratio; 0 for types other than the built-in
// floating-point types.
template <class T>
T ratio_residual(const Fraction& f) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::fma(-ratio<T>(f), T(f.q), T(f.p)) / T(f.q);
  } else {
    return T(0);
  }
}

// x^exponent, x ≥ 0, without the rounding of the exponent, which costs ε/4·|ln x| and more. Error:
// 2 ε.
template <class T>
T decimal_power(const T& x, const Fraction& exponent) {
  using std::log;
  using std::pow;
  const T power = pow(x, ratio<T>(exponent));
  if constexpr (std::is_floating_point_v<T>) {
    if (!(x > 0) || !(power - power == 0)) return power;
    return power + power * (ratio_residual<T>(exponent) * log(x));
  } else {
    return power;
  }
}

// An exponent p/q, q below 2000, with the numbers that the engine's powers need. They are computed
// once for all points.
struct Exponent {
  double p, q;
  double value, residual;  // p/q rounded, and what the rounding has left out
  double inverse;          // q/p; ∞ where p = 0
  double inverse_q, log_two_over_q;

  constexpr Exponent(const Fraction& f)  // NOLINT(google-explicit-constructor): it is the fraction
      : p(f.p),
        q(f.q),
        value(p / q),
        // exact but for the last quotient: the product has 53 + 11 bits
        residual(
            static_cast<double>(static_cast<long double>(p) - static_cast<long double>(value) * q) /
            q),
        inverse(p == 0 ? std::numeric_limits<double>::infinity() : q / p),
        inverse_q(1 / q),
        log_two_over_q(0.69314718055994530942 / q) {}
};

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
