// SPDX-License-Identifier: Apache-2.0
// The least value of a function between two points. Golden section finds it where the function has
// one minimum. Where it has several, a walk in steps finds each, and the least is taken.
#pragma once

#include "tribo/real.hpp"

namespace tribo {

// The argument of the least value of f in (low, high), by golden section, until the interval is
// shorter than `width`·(1 + |low|). A `width` below about √ε of the scale on which f varies gains
// nothing, because f is flat at a minimum.
template <class T, class Function>
T golden_section_minimum(Function&& f, T low, T high, const T& width) {
  using std::abs;
  using std::sqrt;
  const T golden = (sqrt(T(5)) - 1) / 2;
  T left = high - golden * (high - low), right = low + golden * (high - low);
  T f_left = f(left), f_right = f(right);
  while (abs(high - low) > width * (1 + abs(low))) {
    if (f_left < f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - golden * (high - low);
      f_left = f(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + golden * (high - low);
      f_right = f(right);
    }
  }
  return (low + high) / 2;
}

// The argument of the least interior minimum of f; NaN where f has none. f is computed at `count` +
// 1 places: next(i, before) gives the i-th place from the place before it, and `first` stands
// before the 0-th.
template <class T, class Function, class Next>
T least_interior_minimum(Function&& f, const T& first, int count, Next&& next) {
  using std::sqrt;
  T s[3] = {}, value[3] = {};
  T lowest = quiet_nan<T>(), lowest_at = quiet_nan<T>();
  s[2] = first;
  for (int i = 0; i <= count; ++i) {
    s[0] = s[1], value[0] = value[1];
    s[1] = s[2], value[1] = value[2];
    s[2] = next(i, s[2]);
    value[2] = f(s[2]);
    const T margin = 1 + 1000 * epsilon<T>();  // a dip within rounding is no minimum
    const bool is_minimum = i >= 2 && value[1] * margin < value[0] && value[1] * margin < value[2];
    if (!is_minimum || value[1] >= lowest) continue;
    lowest = value[1];
    lowest_at = golden_section_minimum(f, s[0], s[2], T(sqrt(epsilon<T>()) / 4));
  }
  return lowest_at;
}

}  // namespace tribo
