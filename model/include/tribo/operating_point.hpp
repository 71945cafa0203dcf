// SPDX-License-Identifier: Apache-2.0
// One operating point of a scene: its numbers and its words.
#pragma once

#include <array>

#include "tribo/contract.hpp"
#include "tribo/outputs.hpp"
#include "tribo/real.hpp"

namespace tribo {

// The error of each output of an operating point. The film formula is good to 10 ε (its decimal
// exponents are rounded, and the logarithms of its numbers are near 20); the moments and the root
// add as much again.
inline constexpr Contract operating_point_contract{8, 16};

// The regime where the load is balanced, from the load shares of asperities and film.
template <class T>
Regime regime_of(const T& asperity_share, const T& fluid_share) {
  const T little = ratio<T>(1, 100);
  return fluid_share < little      ? Regime::boundary
         : asperity_share < little ? Regime::elastohydrodynamic
                                   : Regime::mixed;
}

// One operating point; units and meaning in outputs.hpp. An output that was not asked for is 0, or
// a number that an asked output was computed from. The regime is there with each output of
// balance_outputs(), because it says whether these are defined: both shares and friction are NaN
// where the regime is `collapsed`. An overflow of the number type shows as ∞ or NaN.
template <class T>
struct OperatingPoint {
  T speed{};
  T film_flooded{};
  T film{};
  T separation{};
  T film_parameter{};
  T asperity_load_share{};
  T fluid_load_share{};
  T real_area_ratio{};
  T summit_count{};
  T friction{};
  Regime regime = Regime::mixed;
  Inlet inlet = Inlet::flooded;
};

// The numbers of a point, in the order of Output.
template <class T>
std::array<T, number_count> numbers_of(const OperatingPoint<T>& point) {
  const auto numbers =
      std::to_array<T>({point.film_flooded, point.film, point.separation, point.film_parameter,
                        point.asperity_load_share, point.fluid_load_share, point.real_area_ratio,
                        point.summit_count, point.friction});
  static_assert(numbers.size() == number_count);
  return numbers;
}

namespace detail {

// The point with its numbers rounded to double.
template <class T>
OperatingPoint<double> in_double(const OperatingPoint<T>& p) {
  const auto to_double = [](const T& x) { return static_cast<double>(x); };
  return {to_double(p.speed),
          to_double(p.film_flooded),
          to_double(p.film),
          to_double(p.separation),
          to_double(p.film_parameter),
          to_double(p.asperity_load_share),
          to_double(p.fluid_load_share),
          to_double(p.real_area_ratio),
          to_double(p.summit_count),
          to_double(p.friction),
          p.regime,
          p.inlet};
}

}  // namespace detail

}  // namespace tribo
