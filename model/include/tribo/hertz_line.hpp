// SPDX-License-Identifier: Apache-2.0
// Hertz' line contact of two smooth elastic cylinders with parallel axes (model/README.md, section
// 3). Source: H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. Math. 92
// (1881) 156; K. L. Johnson: Contact Mechanics (1985), eqs 4.42 to 4.46.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract hertz_line_contract{1, 0};

template <class T>
struct HertzLine {
  T half_width;     // b, m: b² = 4(F/L)R/(πE*)
  T mean_pressure;  // F/(2bL), Pa
  T peak_pressure;  // p₀ = 2F/(πbL), Pa
  T peak_shear;     // the greatest shear stress, Pa: below the surface, at a depth of 0.786 b
};

// The greatest shear stress below a line contact over p₀, for any Poisson's ratio:
// g − g²/√(1+g²) = 0.300283… at the depth g b, g = √((√5 − 1)/2) = 0.786151…
template <class T>
T line_peak_shear_ratio() {
  using std::sqrt;
  const T square = (sqrt(T(5)) - 1) / 2;
  return sqrt(square) - square / sqrt(1 + square);
}

// load_per_length F/L > 0 in N/m, effective_modulus E* > 0 in Pa (never 2E*), reduced_radius R > 0
// in m, 1/R = 1/R₁ + 1/R₂. Error: hertz_line_contract; overflow gives ∞ or NaN, underflow 0.
template <class T>
HertzLine<T> hertz_line(const T& load_per_length, const T& effective_modulus,
                        const T& reduced_radius) {
  using std::sqrt;
  using Wide = WiderType<T>;  // roundings of Wide together are less than one of T
  const Wide load = load_per_length;
  const Wide half_width = sqrt(Wide(4 * load * reduced_radius / (pi<Wide>() * effective_modulus)));
  const Wide peak_pressure = two_over_pi<Wide>() * (load / half_width);
  return {T(half_width), T(load / (2 * half_width)), T(peak_pressure),
          T(line_peak_shear_ratio<Wide>() * peak_pressure)};
}

}  // namespace tribo
