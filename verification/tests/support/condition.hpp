// SPDX-License-Identifier: Apache-2.0
// Condition numbers (tribo/contract.hpp) by automatic differentiation: the model's templates run on
// a long double that carries its derivatives with respect to the logarithms of all inputs. Where
// the templates avoid a cancellation in a number, they avoid it in its derivatives, too.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

#include "support/judge.hpp"
#include "tribo/contract.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {

struct Dual {
  static constexpr std::size_t inputs = 17;  // inputs of a scene; the first is its speed
  // How often the functions below were called in this thread: tests measure work by it.
  static inline thread_local std::size_t calls = 0;
  long double value = 0;
  std::array<long double, inputs> parts{};

  Dual() = default;
  Dual(long double x) : value(x) {}                       // NOLINT: as numbers convert
  Dual(double x) : value(static_cast<long double>(x)) {}  // NOLINT
  Dual(int x) : value(x) {}                               // NOLINT
  Dual(double x, std::size_t input) : Dual(x) { parts[input] = value; }

  // f(x) with the slope f′(x). A derivative of 0 stays 0 where the slope is infinite, and a slope
  // of 0 makes 0 of a derivative that overflowed.
  friend Dual chain(long double image, long double slope, const Dual& x) {
    Dual result(image);
    for (std::size_t i = 0; i < inputs; ++i)
      if (x.parts[i] != 0 && slope != 0) result.parts[i] = slope * x.parts[i];
    return result;
  }
  friend Dual sum(Dual a, const Dual& b) {
    for (std::size_t i = 0; i < inputs; ++i) a.parts[i] += b.parts[i];
    return a;
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return sum(chain(a.value + b.value, 1, a), b);
  }
  friend Dual operator-(const Dual& a) { return chain(-a.value, -1, a); }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return sum(chain(a.value * b.value, b.value, a), chain(0, a.value, b));
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const long double quotient = a.value / b.value;
    return sum(chain(quotient, 1 / b.value, a), chain(0, -quotient / b.value, b));
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }
  friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

  // The sum of |∂ ln this/∂ ln input|, at least 1; 0 has the condition 1.
  double condition() const {
    long double total = 0;
    for (const long double part : parts) total += std::abs(part / value);
    return value == 0 ? 1 : std::max(1.0, static_cast<double>(total));
  }
};

// f(x) with the slope f′(x), counted in `calls`.
inline Dual called(long double image, long double slope, const Dual& x) {
  ++Dual::calls;
  return chain(image, slope, x);
}
inline Dual exp(const Dual& x) { return called(std::exp(x.value), std::exp(x.value), x); }
inline Dual expm1(const Dual& x) { return called(std::expm1(x.value), std::exp(x.value), x); }
inline Dual log(const Dual& x) { return called(std::log(x.value), 1 / x.value, x); }
inline Dual log1p(const Dual& x) { return called(std::log1p(x.value), 1 / (1 + x.value), x); }
inline Dual sqrt(const Dual& x) { return called(std::sqrt(x.value), 0.5L / std::sqrt(x.value), x); }
inline Dual atan(const Dual& x) {
  return called(std::atan(x.value), 1 / (1 + x.value * x.value), x);
}
inline Dual tan(const Dual& x) {
  const long double tangent = std::tan(x.value);
  return called(tangent, 1 + tangent * tangent, x);
}
inline Dual acos(const Dual& x) {
  return called(std::acos(x.value), -1 / std::sqrt(1 - x.value * x.value), x);
}
inline Dual asinh(const Dual& x) {
  return called(std::asinh(x.value), 1 / std::sqrt(1 + x.value * x.value), x);
}
inline Dual abs(const Dual& x) { return x < 0 ? -x : x; }
inline Dual trunc(const Dual& x) { return std::trunc(x.value); }
inline Dual pow(const Dual& x, const Dual& y) {
  const long double power = std::pow(x.value, y.value);
  return sum(called(power, y.value * power / x.value, x), chain(0, power * std::log(x.value), y));
}

// −F_n′/F_n = n F_{n−1}/F_n = d + F_{n+1}/F_n; φ/F_0 for n = 0.
template <class T>
T moment_hazard(Order order, const T& d) {
  const T moment = scaled_gaussian_moment(order, d);
  if (twice(order) >= 2)
    return value_of<T>(order) * scaled_gaussian_moment(lower(order), d) / moment;
  if (order == Order::zero)
    return (d > 0 ? T(1) : T(std::exp(-d * d / 2))) / (sqrt_two_pi<T>() * moment);
  return d + scaled_gaussian_moment(Order::three_halves, d) / moment;
}

// Overload resolution prefers these functions to the templates of the model.
inline Dual scaled_gaussian_moment(Order n, const Dual& d) {
  const long double x = d.value, moment = tribo::scaled_gaussian_moment(n, x);
  return called(moment, moment * ((x > 0 ? x : 0) - moment_hazard(n, x)), d);
}
// Gives the root without derivatives. The step that refines it (InletCurve::correction) adds them.
template <class Function>
Dual bracketed_root(Function&& f, const Dual& low, const Dual& high, const Dual& least_width) {
  return tribo::bracketed_root<long double>([&](long double x) { return f(Dual(x)).value; },
                                            low.value, high.value, least_width.value);
}

}  // namespace tribo::verification

template <>
class std::numeric_limits<tribo::verification::Dual> : public std::numeric_limits<long double> {};

namespace tribo {

namespace detail {

// The scene's numbers, with derivatives with respect to each number that the scene gives.
template <>
inline SceneNumbers<verification::Dual> numbers_of(const Scene& scene) {
  const SceneNumbers<double> n = numbers_of<double>(scene);
  std::size_t input = 1;
  SceneNumbers<verification::Dual> numbers =
      numbers_by<verification::Dual>(n, [&](const double& x) -> verification::Dual {
        const bool is_held = &x == &n.offset_planes || &x == &n.rms_roughness ||
                             &x == &n.conductivity || &x == &n.temperature_coefficient;
        if (is_held) return x;
        return {x, input++};
      });
  if (input != verification::Dual::inputs)
    throw std::logic_error("Dual::inputs is not the number of inputs of a scene");
  if (scene.bodies.shape() == ContactShape::ellipse) numbers.set_ellipse();
  return numbers;
}

}  // namespace detail

namespace verification {

// The condition of each number of an operating point.
using Conditions = std::array<double, number_count>;
inline Conditions conditions_at(const Scene& scene, double speed) {
  const auto numbers = numbers_of(MixedContact<Dual>(scene).solve(Dual(speed, 0)));
  Conditions conditions{};
  for (std::size_t i = 0; i < number_count; ++i) conditions[i] = numbers[i].condition();
  return conditions;
}

// The conditions of the root λ(λ₀, K, δ), of F_n(d), and of y(r, γ).
inline double root_condition(AsperityModel model, double stiffness, double offset, double film0,
                             const FilmLaw& film = hamrock_dowson_central_law) {
  return LoadSharing<Dual>(model, Dual(stiffness, 0), Dual(offset, 1), film)
      .solve(Dual(film0, 2))
      .film_parameter.condition();
}
inline double moment_condition(Order order, double d) {
  return gaussian_moment(order, Dual(d, 0)).condition();
}
inline double film_ratio_condition(StarvationClosure closure, double r, double gamma) {
  return starvation_ratio(closure, Dual(r, 0), Dual(gamma, 1)).condition();
}

// `multiple` times what a contract allows, relative to the expected value. One ulp is the spacing
// of doubles there.
inline double allowed_by(const Contract& contract, const Reference& expected, double condition,
                         double multiple) {
  if (expected == 0) return 0;
  const double value = std::abs(static_cast<double>(expected));
  const double ulp = std::ldexp(1.0, std::max(std::ilogb(value), -1022) - 52);
  return multiple * std::max(contract.ulp, contract.ulp_per_condition * condition) * ulp / value;
}

// Is a number as near to the expected one as `multiple` times its contract and `more` allow?
template <class Real>
testing::AssertionResult keeps(const Contract& contract, Real got, const Reference& expected,
                               double condition, double multiple,
                               std::initializer_list<Input> inputs, double more = 0) {
  return is_close(got, expected, allowed_by(contract, expected, condition, multiple) + more,
                  inputs);
}

}  // namespace verification
}  // namespace tribo
