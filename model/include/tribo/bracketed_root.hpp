// SPDX-License-Identifier: Apache-2.0
// The zero of a continuous function between two points where it has opposite signs: Chandrupatla's
// choice between inverse quadratic interpolation and bisection (Adv. Eng. Software 28 (1997) 145).
#pragma once

#include "tribo/real.hpp"

namespace tribo {

// Needs f(low) and f(high) of opposite sign, or one of them 0. The bracket shrinks until it is
// narrower than the sum of 4ε times the result and `least_width`. At most 400 evaluations; after
// them the end with the lesser |f| is returned.
// Failure: NaN, where the ends have one sign or f gives NaN there.
template <class T, class Function>
T bracketed_root(Function&& f, T low, T high, const T& least_width) {
  using std::abs;
  using std::sqrt;
  T b = low, a = high;
  T fb = f(b), fa = f(a);
  if (fa == 0) return a;
  if (fb == 0) return b;
  if (!((fa < 0) != (fb < 0)) || fa != fa || fb != fb) return quiet_nan<T>();
  T c = a, fc = fa;
  T t = ratio<T>(1, 2);
  for (int evaluations = 2; evaluations < 400; ++evaluations) {
    const T x = a + t * (b - a);
    const T fx = f(x);
    if ((fx < 0) == (fa < 0)) {
      c = a;
      fc = fa;
    } else {
      c = b;
      b = a;
      fc = fb;
      fb = fa;
    }
    a = x;
    fa = fx;
    const T best = abs(fa) < abs(fb) ? a : b;
    const T tolerance = 2 * epsilon<T>() * abs(best) + least_width / 2;
    const T least_step = tolerance / abs(b - a);
    if (fa == 0 || least_step > ratio<T>(1, 2)) return best;
    const T xi = (a - b) / (c - b);
    const T phi = (fa - fb) / (fc - fb);
    t = ratio<T>(1, 2);
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      t = fa / (fb - fa) * (fc / (fb - fc)) +
          (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb));
    if (t < least_step) t = least_step;
    if (t > 1 - least_step) t = 1 - least_step;
  }
  return abs(fa) < abs(fb) ? a : b;
}

}  // namespace tribo
