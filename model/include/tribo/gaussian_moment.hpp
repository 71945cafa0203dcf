// SPDX-License-Identifier: Apache-2.0
// Moments of the Gaussian tail (model/README.md, section 2; paper, F_n of eqs 1.2 to 1.6):
//
//   F_n(d) = ∫_d^∞ (s−d)ⁿ φ(s) ds,   φ(s) = e^{−s²/2}/√(2π),   n = 0, 1/2, 1, 3/2, 2, 5/2.
//
// Source: J. A. Greenwood, J. H. Tripp (1970; see asperity_contact.hpp), their F_n.
//
// No digits cancel. The forms give S_n(d) = e^{d²/2} F_n(d) for d ≥ 0, and F_n(d) for d < 0:
//   |d| large        asymptotic series, cut where its terms fall below ε
//   half-integer n   F_n = (1/√2π) ∫_{−∞}^{∞} x^{2n+1} e^{−(x²+d)²/2} dx (s = x² + d), by the
//                    trapezoidal rule: the integrand is entire, so the error falls as
//                    exp(−2πy/h + 4y⁴ − 2dy²) for every y > 0 (shift of the contour by iy)
//   integer n        the continued fraction of F_{n+1}/F_n (F is the minimal solution of
//                    F_{n+1} + d F_n − n F_{n−1} = 0); for |d| < 1 the Taylor series about d = 1;
//                    reflection
//
// Error bound in double: gaussian_moment_contract, and one unit where the result is subnormal. In
// other types: 500 ε on [−40, 37]. F_n(+∞) = 0, F_n(−∞) = ∞ (1 for n = 0), NaN gives NaN.
//
// The templates serve every number type but double. For double the functions are polynomials in
// pieces (src/gaussian_moment-inl.hpp); they are declared near the end of this file.
#pragma once

#include <array>
#include <cstddef>

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract gaussian_moment_contract{1, 0};

// The order n, held as 2n.
enum class Order : int { zero = 0, half = 1, one = 2, three_halves = 3, two = 4, five_halves = 5 };

constexpr int twice(Order n) { return static_cast<int>(n); }
template <class T>
T value_of(Order n) {
  return ratio<T>(twice(n), 2);
}
constexpr bool is_integer(Order n) { return twice(n) % 2 == 0; }
constexpr Order lower(Order n) { return static_cast<Order>(twice(n) - 2); }  // n − 1, for n ≥ 1

namespace detail {

// xⁿ for x ≥ 0.
template <class T>
T power(const T& x, Order n) {
  using std::sqrt;
  const T whole = twice(n) >= 4 ? T(x * x) : twice(n) >= 2 ? x : T(1);
  return is_integer(n) ? whole : T(whole * sqrt(x));
}

// Γ(n+1).
template <class T>
T gamma_of_order_plus_one(Order n) {
  using std::sqrt;
  if (is_integer(n)) return n == Order::two ? T(2) : T(1);
  T value = sqrt(pi<T>());
  for (int k = 1; k <= twice(n); k += 2) value *= ratio<T>(k, 2);
  return value;
}

// e^{−d²/2} as first · second. No factor underflows where the product does not. d is split as high
// + low with high² exact, so that the rounding of d² costs nothing.
template <class T>
struct GaussianFactor {
  T first, second;
};

template <class T>
GaussianFactor<T> gaussian_factor(const T& d) {
  using std::exp;
  using std::trunc;
  if (!(d < T(100000))) return {T(0), T(0)};
  const T high = trunc(d * 16) / 16;
  const T root = exp(-(high * high) / 4);
  return {root, root * exp(-(d - high) * (d + high) / 2)};
}

// From this |d| on, e^{−d²/2} ≪ ε, and the terms of the asymptotic series fall below ε before they
// begin to grow.
template <class T>
T asymptotic_from() {
  using std::sqrt;
  static const T value = sqrt(2 * resolved_exponent<T>()) + ratio<T>(3, 2);
  return value;
}

// S_n(d) ~ Γ(n+1)/√2π d^{−n−1} Σ (−1)^k (n+1)_{2k}/(k! (2d²)^k).
template <class T>
T far_above(Order n, const T& d) {
  using std::abs;
  const T inverse = 1 / d;
  const T step = inverse * inverse / 2;
  T term = 1;
  T sum = 1;
  for (int k = 1; k < 1000; ++k) {
    const T next =
        -term * (value_of<T>(n) + T(2 * k - 1)) * (value_of<T>(n) + T(2 * k)) * step / T(k);
    if (abs(next) >= abs(term)) break;
    term = next;
    sum += term;
    if (abs(term) < epsilon<T>() / 4) break;
  }
  return gamma_of_order_plus_one<T>(n) / sqrt_two_pi<T>() * power(inverse, n) * inverse * sum;
}

// F_n(−D) ~ Dⁿ Σ n(n−1)…(n−2k+1)/(k! (2D²)^k). For integer n the sum is finite.
template <class T>
T far_below(Order n, const T& distance) {
  using std::abs;
  const T inverse = 1 / distance;
  const T step = inverse * inverse / 2;
  T term = 1;
  T sum = 1;
  for (int k = 1; k < 1000; ++k) {
    const T next =
        term * (value_of<T>(n) - T(2 * k - 2)) * (value_of<T>(n) - T(2 * k - 1)) * step / T(k);
    if (next == 0 || abs(next) >= abs(term)) break;
    term = next;
    sum += term;
    if (abs(term) < epsilon<T>() / 4) break;
  }
  return power(distance, n) * sum;
}

// S_n(d) for half-integer n and |d| < asymptotic_from(), by the trapezoidal rule. The step h keeps
// its error below ε: the bound above has y = π/(h·(2|d| + 2.3√L)), with L = ln(1/ε) + 4.
template <class T>
T half_integer_moment(Order n, const T& d) {
  using std::exp;
  using std::sqrt;
  const T exponent = resolved_exponent<T>() + 4;
  const T step =
      pi<T>() / sqrt(exponent * ((d < 0 ? -2 * d : 2 * d) + ratio<T>(8, 5) * sqrt(exponent)));
  const T step_squared = step * step;
  T sum = 0;
  for (int k = 1;; ++k) {
    const T t = step_squared * T(k * k);  // x²
    const T s = t + d;
    const T power_of_t = twice(n) == 1 ? t : twice(n) == 3 ? T(t * t) : T(t * t * t);  // x^{2n+1}
    const T term = d < 0 ? T(power_of_t * exp(-s * s / 2)) : T(power_of_t * exp(-t * (t / 2 + d)));
    sum += term;
    // Past the peak the terms fall faster than geometrically.
    if (s > 1 && t > 1 && term < sum * epsilon<T>() / 16) break;
    if (t * (t / 2 + (d < 0 ? T(0) : d)) > 2 * exponent && s > 0 && term < sum * epsilon<T>() / 16)
      break;
  }
  return 2 * step * sum / sqrt_two_pi<T>();
}

// S_0, S_1 and S_2 for 1 ≤ d < asymptotic_from(). I_n = √2π S_n obeys I_{n+1} = n I_{n−1} − d I_n
// and 1 = d I_0 + I_1. The recurrence runs backward, I_n/I_{n−1} = n/(d + I_{n+1}/I_n). If it
// starts at n = N, the error of I_1/I_0 is about exp(−2d√N).
template <class T>
T integer_moment_above_one(Order n, const T& d) {
  using std::sqrt;
  const T root = resolved_exponent<T>() / (2 * d) + 3;
  const int start = static_cast<int>(root * root);
  T tail = (sqrt(d * d + T(4 * start)) - d) / 2;
  T second = 0;
  for (int k = start; k >= 1; --k) {
    second = k == 1 ? tail : second;
    tail = T(k) / (d + tail);
  }
  const T zeroth = 1 / (d + tail);
  const T integral = n == Order::zero  ? zeroth
                     : n == Order::one ? T(zeroth * tail)
                                       : T(zeroth * tail * second);
  return integral / sqrt_two_pi<T>();
}

// The ratios I_k/I_{k−1} at d = 1 for k = 1, 2, …, by the same recurrence; element 0 is I_0. The √k
// of its start is that of the last ratio plus the √k that the first ratio alone needs.
inline constexpr std::size_t ratios_at_one = 256;
template <class T>
std::array<T, ratios_at_one> integral_ratios_at_one() {
  using std::sqrt;
  std::array<T, ratios_at_one> ratios;
  const T root = resolved_exponent<T>() / 2 + 3 + T(16);
  const int start = static_cast<int>(root * root);
  T tail = (sqrt(T(1 + 4 * start)) - 1) / 2;
  for (int k = start; k >= 1; --k) {
    tail = T(k) / (1 + tail);
    const auto index = static_cast<std::size_t>(k);
    if (index < ratios_at_one) ratios[index] = tail;
  }
  ratios[0] = 1 / (1 + tail);
  return ratios;
}

// S_0, S_1 or S_2 for |d| < 1 (F for d < 0). I_n = ∫_0^∞ uⁿ e^{−u²/2−ud} du has a Taylor series
// about d = 1: its coefficients in powers of 1 − d are I_{n+k}(1)/k!, all positive.
template <class T>
T integer_moment_near_zero(Order n, const T& d) {
  using std::exp;
  static const std::array<T, ratios_at_one> ratios = integral_ratios_at_one<T>();
  const T away = 1 - d;
  const auto order = static_cast<std::size_t>(twice(n) / 2);
  T term = ratios[0];
  for (std::size_t k = 1; k <= order; ++k) term *= ratios[k];
  T sum = term;
  for (std::size_t k = 1; order + k < ratios_at_one; ++k) {
    term *= ratios[order + k] * away / T(static_cast<int>(k));
    sum += term;
    if (term < epsilon<T>() / 8 * sum) break;
  }
  const T scaled = sum / sqrt_two_pi<T>();
  return d < 0 ? T(scaled * exp(-d * d / 2)) : scaled;
}

}  // namespace detail

// S_n(d) = e^{d²/2} F_n(d) for d ≥ 0, F_n(d) for d < 0. It does not underflow on [−40, 1e100].
template <class T>
T scaled_gaussian_moment(Order n, const T& d) {
  if (d != d) return d;
  if (d >= detail::asymptotic_from<T>()) return detail::far_above(n, d);
  if (d <= -detail::asymptotic_from<T>()) return detail::far_below(n, T(-d));
  if (!is_integer(n)) return detail::half_integer_moment(n, d);
  if (d >= 1) return detail::integer_moment_above_one(n, d);
  if (d > -1) return detail::integer_moment_near_zero(n, d);
  const T distance = -d;
  const detail::GaussianFactor<T> factor = detail::gaussian_factor(distance);
  const T beyond = detail::integer_moment_above_one(n, distance) * (factor.first * factor.second);
  if (n == Order::zero) return 1 - beyond;
  if (n == Order::one) return distance + beyond;
  return 1 + distance * distance - beyond;
}

// c·F_n(d) from S_n(d), for c ≥ 0, as two factors that underflow only where the square root of
// their product would.
template <class T>
detail::GaussianFactor<T> factored_product(const T& c, const T& scaled, const T& d) {
  if (!(d > 0)) return {c, scaled};
  const detail::GaussianFactor<T> factor = detail::gaussian_factor(d);
  return {c * factor.first, scaled * factor.second};
}

// c·F_n(d) from S_n(d). It does not underflow where F_n alone would and the product does not.
template <class T>
T unscaled_product(const T& c, const T& scaled, const T& d) {
  const detail::GaussianFactor<T> product = factored_product(c, scaled, d);
  return product.first * product.second;
}

// c·F_n(d) from d, with the same property.
template <class T>
T moment_product(const T& c, Order n, const T& d) {
  return unscaled_product(c, scaled_gaussian_moment(n, d), d);
}

// F_n(d).
template <class T>
T gaussian_moment(Order n, const T& d) {
  return moment_product(T(1), n, d);
}

// S_n(d) and F_n(d) in double, for every d.
double scaled_gaussian_moment(Order n, double d);
double gaussian_moment(Order n, double d);

// ln F_n(d), without underflow. It is −∞ only at d = +∞ or where d² overflows.
template <class T>
T log_gaussian_moment(Order n, const T& d) {
  using std::log;
  const T logarithm = log(scaled_gaussian_moment(n, d));
  return d > 0 ? T(logarithm - d * d / 2) : logarithm;
}

}  // namespace tribo
