// SPDX-License-Identifier: Apache-2.0
// Films behind a starved inlet (model/README.md, section 7; paper, eqs 1.10 to 1.14, corrected).
// With r = h_ff/h_oil, y = h*/h_ff and Wolveridge's y = (2/π) arctan(2.7ψ), ψ the dimensionless
// inlet length from Crook's line-contact gap, c = 3/(4√2):
//
//   flooded_inlet      1/r = 1 + ψ^{3/2}/c              Crook at the flooded film; y = 0 for r ≥ 1
//   starved_inlet      1/r = y + ψ^{3/2}/c              Crook at the starved film
//   printed_exponents  1/r = y + ψ^{3/2} y^{−5/4}/c     the exponents as printed (a reading)
//   damiens            y = (1 + r^γ)^{−1/γ}
//   solved             Damiens' y with a γ of M, L and r from solved films (solved_inlet.hpp): no
//                      function of r alone, so that InletLaw does not have it
//
// Source: A. W. Crook: The lubrication of rollers. Phil. Trans. R. Soc. Lond. A 250 (1958) 387;
// P. E. Wolveridge, K. P. Baglin, J. F. Archard: The starved lubrication of cylinders in line
// contact. Proc. Inst. Mech. Eng. 185 (1970) 1159; B. Damiens, C. H. Venner, P. M. E. Cann, A. A.
// Lubrecht: Starved lubrication of elliptical EHD contacts. J. Tribol. 126 (2004) 105,
// doi 10.1115/1.1631020.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "tribo/bracketed_root.hpp"
#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

enum class StarvationClosure : std::uint8_t {
  flooded_inlet,
  starved_inlet,
  printed_exponents,
  damiens,
  solved
};
// The words of a scene; those of closures that are functions of r alone come first.
inline constexpr auto starvation_words = std::to_array<std::string_view>(
    {"flooded_inlet", "starved_inlet", "printed_exponents", "damiens", "solved"});
inline constexpr auto starvation_closure_words = [] {
  std::array<std::string_view, starvation_words.size() - 1> words;
  std::copy_n(starvation_words.begin(), words.size(), words.begin());
  return words;
}();

inline constexpr Contract starvation_ratio_contract{16, 0};

// c = 3/(4√2)
template <class T>
T crook_constant() {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(0.5303300858899106433006332715786368L);
  } else {
    using std::sqrt;
    return 3 / (4 * sqrt(T(2)));
  }
}

// 2.7 of Wolveridge's fit (paper, 1.14).
template <class T>
T wolveridge_factor() {
  return ratio<T>(27, 10);
}

// Does the closure tie y to r through ψ, so that y(r) needs a scalar root?
constexpr bool is_implicit(StarvationClosure closure) {
  return closure == StarvationClosure::starved_inlet ||
         closure == StarvationClosure::printed_exponents;
}

// y(ψ) = (2/π) arctan(2.7ψ). Error: 5 ε.
template <class T>
T wolveridge_film_ratio(const T& inlet_length) {
  using std::atan;
  return two_over_pi<T>() * atan(T(wolveridge_factor<T>() * inlet_length));
}

// ψ at which y = (2/π) arctan(2.7ψ), 0 < y < 1.
template <class T>
T wolveridge_inlet_length(const T& film_ratio) {
  using std::tan;
  return tan(T(pi<T>() * film_ratio / 2)) / wolveridge_factor<T>();
}

// d ln y/d ln ψ: 1 for short inlets, 0 for long ones.
template <class T>
T wolveridge_slope(const T& inlet_length) {
  using std::atan;
  const T v = wolveridge_factor<T>() * inlet_length;
  if (!(v > epsilon<T>() * epsilon<T>())) return T(1);
  return 1 / ((v + 1 / v) * atan(v));
}

// The inlet of an arctan closure as a function of t = ln ψ, in logarithms: nothing underflows.
template <class T>
struct InletCurve {
  StarvationClosure closure;
  T constant_factor = T(1);  // factor of c: π/4 for the gap of a circular contact

  template <class Real = T>
  Real crook() const {
    return crook_constant<Real>() * Real(constant_factor);
  }

  T log_film_ratio(const T& t) const {  // ln y
    using std::exp;
    using std::log;
    if (t < least_log_length()) return log(T(2 * wolveridge_factor<T>() / pi<T>())) + t;
    return log(wolveridge_film_ratio(T(exp(t))));
  }
  T log_crook_term(const T& t, const T& log_y) const {  // ln of the term with c
    using std::log;
    const T term = ratio<T>(3, 2) * t - log(crook());
    return closure == StarvationClosure::printed_exponents ? T(term - ratio<T>(5, 4) * log_y)
                                                           : term;
  }
  T log_inverse_r(const T& t) const {  // ln(1/r)
    using std::exp;
    using std::log1p;
    const T log_y = log_film_ratio(t);
    const T crook = log_crook_term(t, log_y);
    const T other = closure == StarvationClosure::flooded_inlet ? T(0) : log_y;
    return crook > other ? T(crook + log1p(exp(T(other - crook))))
                         : T(other + log1p(exp(T(crook - other))));
  }
  T slope_of_log_y(const T& t) const {  // d ln y/dt
    using std::exp;
    return wolveridge_slope(T(exp(t)));
  }
  T slope_of_log_inverse_r(const T& t) const {  // d ln(1/r)/dt
    using std::exp;
    const T log_y = log_film_ratio(t);
    const T crook = log_crook_term(t, log_y);
    const T y_slope = slope_of_log_y(t);
    const T crook_slope = closure == StarvationClosure::printed_exponents
                              ? T(ratio<T>(3, 2) - ratio<T>(5, 4) * y_slope)
                              : ratio<T>(3, 2);
    const bool flooded = closure == StarvationClosure::flooded_inlet;
    const T weight = 1 / (1 + exp(T((flooded ? T(0) : log_y) - crook)));
    return weight * crook_slope + (flooded ? T(0) : T((1 - weight) * y_slope));
  }

  // ψ at r > 0 (r < 1 for flooded_inlet), and ln ψ, which stays finite at great r, where ψ itself
  // underflows. Error: 20 ε.
  T inlet_length(const T& flooded_over_inlet) const {
    using std::exp;
    using std::pow;
    if (closure == StarvationClosure::flooded_inlet)
      return pow(T((1 - flooded_over_inlet) / flooded_over_inlet * crook()), ratio<T>(2, 3));
    const T t = rough_log_inlet_length(flooded_over_inlet);
    if (t < least_log_length()) return least_inlet_length(flooded_over_inlet);
    // The error is now the rounding of t and of ln r. A Newton step on 1/r = G(ψ) removes it.
    return exp(t) * (1 + correction(flooded_over_inlet, t));
  }
  T log_inlet_length(const T& flooded_over_inlet) const {
    using std::log;
    if (closure == StarvationClosure::flooded_inlet) return log(inlet_length(flooded_over_inlet));
    const T t = rough_log_inlet_length(flooded_over_inlet);
    return t + correction(flooded_over_inlet, t);
  }

  // y at r > 0; exactly 0 where the film has collapsed. Error: 20 ε × condition.
  T film_ratio(const T& r) const {
    if (closure == StarvationClosure::flooded_inlet && r >= 1) return T(0);
    return wolveridge_film_ratio(inlet_length(r));
  }
  // d ln y/d ln r
  T slope(const T& r) const {
    const T t = log_inlet_length(r);
    return -slope_of_log_y(t) / slope_of_log_inverse_r(t);
  }
  // The r at which y = 1 − ε, 0 < ε < 1. Error: 20 ε.
  T at_departure(const T& departure) const {
    using std::sqrt;
    const T y = 1 - departure;
    const T psi = wolveridge_inlet_length(y);
    const T term = psi * sqrt(psi) / crook();
    if (closure == StarvationClosure::flooded_inlet) return 1 / (1 + term);
    if (closure == StarvationClosure::starved_inlet) return 1 / (y + term);
    return 1 / (y + term / (y * sqrt(sqrt(y))));
  }
  // The r at which r y(r) is greatest; NaN for starved_inlet, which has no maximum. Error: 20 ε.
  T at_film_maximum() const {
    using std::exp;
    if (closure == StarvationClosure::starved_inlet) return quiet_nan<T>();
    const T t =
        bracketed_root([&](const T& x) { return slope_of_log_y(x) - slope_of_log_inverse_r(x); },
                       T(-10), T(10), epsilon<T>());
    return exp(T(-log_inverse_r(t)));
  }

 private:
  // ln ψ below which the powers of ψ come near underflow, and arctan v = v to every digit of T.
  static T least_log_length() { return ratio<T>(1, 4) * T(std::numeric_limits<T>::min_exponent); }

  // ψ where t is below least_log_length(): y = κψ, and 1/r is its greater term alone. The other
  // term is less than ε/2 times the greater one, in float less than 2 ε times.
  T least_inlet_length(const T& flooded_over_inlet) const {
    using std::sqrt;
    const T kappa = 2 * wolveridge_factor<T>() / pi<T>();
    if (closure == StarvationClosure::printed_exponents) {
      const T root = crook() * kappa * sqrt(sqrt(kappa)) / flooded_over_inlet;
      return root * root * (root * root);
    }
    return 1 / (kappa * flooded_over_inlet);
  }

  // ln ψ above which the powers of ψ come near overflow, and y = 1 to every digit of T.
  static T greatest_log_length() {
    return -ratio<T>(9, 20) * T(std::numeric_limits<T>::min_exponent);
  }

  T rough_log_inlet_length(const T& flooded_over_inlet) const {
    using std::log;
    const T log_r = log(flooded_over_inlet);
    // 1/r lies between the greater of its two terms and twice that; the slope in t is at least 1/4.
    const T low = -4 * (log_r > 0 ? log_r : T(0)) - 20;
    const T high = (log_r < 0 ? T(-log_r) : T(0)) + 5;
    return bracketed_root([&](const T& x) { return log_inverse_r(x) + log_r; }, low, high,
                          epsilon<T>());
  }

  // (1 − r G(ψ))/(d ln G/dt) at ψ = e^t. The difference is in a wider type, because its rounding
  // moves ψ by up to four times as much where the inlet is short.
  T correction(const T& r, const T& t) const {
    using std::exp;
    using std::sqrt;
    if (t < least_log_length() || t > greatest_log_length()) return T(0);
    using Wide = WiderType<T>;
    const Wide psi = Wide(T(exp(t)));
    const Wide y = wolveridge_film_ratio(psi);
    Wide term = psi * sqrt(psi) / crook<Wide>();
    if (closure == StarvationClosure::printed_exponents) term /= y * sqrt(sqrt(y));
    return T(1 - Wide(r) * (y + term)) / slope_of_log_inverse_r(t);
  }
};

// A closure of the starved inlet with its number. r = h_ff/h_oil > 0.
template <class T>
struct InletLaw {
  StarvationClosure closure;
  T exponent;  // γ > 0 of damiens; the other closures do not use it

  // y = h*/h_ff at r; 0 ≤ y ≤ 1. Error: 20 ε × condition. flooded_inlet gives exactly 0 for r ≥ 1:
  // the film has collapsed.
  T film_ratio(const T& r) const {
    using std::exp;
    using std::log1p;
    using std::pow;
    if (closure != StarvationClosure::damiens) return curve().film_ratio(r);
    if (r <= 1) return exp(T(-log1p(pow(r, exponent)) / exponent));
    return exp(T(-log1p(pow(T(1 / r), exponent)) / exponent)) / r;
  }
  // 1 − y, without the cancellation where the inlet is nearly flooded. Error: 20 ε.
  T deficit(const T& r) const {
    using std::atan;
    using std::expm1;
    using std::log;
    using std::log1p;
    using std::pow;
    if (closure == StarvationClosure::damiens) {
      if (r <= 1) return -expm1(T(-log1p(pow(r, exponent)) / exponent));
      return -expm1(T(-log1p(pow(T(1 / r), exponent)) / exponent - log(r)));
    }
    if (closure == StarvationClosure::flooded_inlet && r >= 1) return T(1);
    const T psi = curve().inlet_length(r);
    return two_over_pi<T>() * atan(T(1 / (wolveridge_factor<T>() * psi)));
  }
  // d ln y/d ln r at r (r < 1 for flooded_inlet): 0 where flooded, −1 where h* = h_oil.
  T slope(const T& r) const {
    using std::pow;
    if (closure == StarvationClosure::damiens) return -1 / (1 + pow(r, T(-exponent)));
    return curve().slope(r);
  }
  // The r at which y = 1 − ε, 0 < ε < 1 (model/README.md, section 9, film_departure). Error: 20 ε.
  T at_departure(const T& departure) const {
    using std::pow;
    const T y = 1 - departure;
    if (closure == StarvationClosure::damiens)
      return pow(T(1 - pow(y, exponent)), T(1 / exponent)) / y;
    return curve().at_departure(departure);
  }
  // The r at which h*/h_oil = r y(r) is greatest at constant h_oil: flooded_inlet 0.6327757634209,
  // printed_exponents 0.6962389029717; NaN for the closures that have no maximum. Error: 20 ε.
  T at_film_maximum() const {
    if (closure == StarvationClosure::damiens) return quiet_nan<T>();
    return curve().at_film_maximum();
  }

  // The inlet of an arctan closure.
  InletCurve<T> curve() const { return {closure}; }

  friend bool operator==(const InletLaw&, const InletLaw&) = default;
};

// InletLaw::film_ratio as a function of the catalogue.
template <class T>
T starvation_ratio(StarvationClosure closure, const T& flooded_over_inlet, const T& exponent) {
  return InletLaw<T>{closure, exponent}.film_ratio(flooded_over_inlet);
}

}  // namespace tribo
