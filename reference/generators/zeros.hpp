// SPDX-License-Identifier: Apache-2.0
// Zeros of functions of balls, in two ways: bisection by certain signs, and Newton's method with a
// proof by signs afterwards.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>

#include "generators/ball.hpp"

namespace tribo::reference {

// −1 or 1 if the sign is certain; 0 if it is undecided, or x is 0.
inline int sign(const Ball& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

// The zero of an increasing function in [low, high] > 0 by bisection with certain signs. It divides
// at geometric means while the ends are far apart, and stops at an undecided sign or at 230 bits.
inline Ball bisect(const std::function<int(const Ball&)>& certain_sign, Ball low, Ball high) {
  for (int i = 0; i < 4000; ++i) {
    const Ball middle = (high > 2 * low ? sqrt(low * high) : (low + high) / 2).midpoint();
    const int s = certain_sign(middle);
    if (s == 0 || (high - low) < low * pow(Ball(2), Ball(-230))) break;
    (s < 0 ? low : high) = middle;
  }
  Ball result;
  arb_union(result.get(), low.get(), high.get(), ball_precision);
  return result;
}
// The same for a function in place of its sign.
inline Ball zero_between(const std::function<Ball(const Ball&)>& function, const Ball& low,
                         const Ball& high) {
  return bisect([&](const Ball& x) { return sign(function(x)); }, low, high);
}

// The zero of an increasing function by Newton's method on midpoints, from t. No step is longer
// than 2, and the slope is a difference over 2^-120. The radius of the result is the first 2^−bits
// for which the function is certainly negative at the lower end and certainly positive at the upper
// one. Where no radius fulfils that, the result is empty.
inline std::optional<Ball> zero_by_newton(const std::function<Ball(const Ball&)>& function, Ball t,
                                          std::initializer_list<int> bits) {
  const Ball h = pow(Ball(2), Ball(-120));
  for (int i = 0; i < 300; ++i) {
    const Ball value = function(t);
    const Ball slope = (function((t + h).midpoint()) - value) / h;
    Ball step = (value / slope).midpoint();
    if (step > 2) step = 2;
    if (step < -2) step = -2;
    t = (t - step).midpoint();
    if (abs(step) < pow(Ball(2), Ball(-250))) break;
  }
  for (const int one : bits) {
    const Ball radius = pow(Ball(2), Ball(-one));
    if (!(function((t - radius).midpoint()) < 0 && function((t + radius).midpoint()) > 0)) continue;
    arb_add_error(t.get(), radius.get());
    return t;
  }
  return std::nullopt;
}

inline Ball with_relative_radius(const Ball& midpoint, int bits) {
  Ball result = midpoint;
  const Ball radius = abs(midpoint) * pow(Ball(2), Ball(-bits));
  arb_add_error(result.get(), radius.get());
  return result;
}

}  // namespace tribo::reference
