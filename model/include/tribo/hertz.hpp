// SPDX-License-Identifier: Apache-2.0
// Hertz' circular contact of two smooth elastic bodies (model/README.md, section 3). Source: H.
// Hertz: Über die Berührung fester elastischer Körper. J. reine angew. Math. 92 (1881) 156; K. L.
// Johnson: Contact Mechanics (1985), eqs 4.22 to 4.24.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract hertz_contract{10, 0};

template <class T>
struct HertzPoint {
  T radius;         // a, m: a³ = 3FR/(4E*)
  T nominal_area;   // A_nom = πa², m²
  T mean_pressure;  // p̄ = F/A_nom, Pa
  T peak_pressure;  // 3p̄/2, Pa
  T approach;       // a²/R of the two bodies, m
};

// load F > 0 in N, effective_modulus E* > 0 in Pa (1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, not 2E*),
// reduced_radius R > 0 in m. Error: hertz_contract; overflow gives ∞ or NaN, underflow 0.
template <class T>
HertzPoint<T> hertz_point(const T& load, const T& effective_modulus, const T& reduced_radius) {
  using Wide = WiderType<T>;  // roundings of Wide together are less than one of T
  const Wide wide_load = load;
  const Wide radius =
      cube_root(Wide(3 * wide_load * reduced_radius / (4 * Wide(effective_modulus))));
  const Wide nominal_area = pi<Wide>() * radius * radius;
  const Wide mean_pressure = wide_load / nominal_area;
  return {T(radius), T(nominal_area), T(mean_pressure), T(3 * mean_pressure / 2),
          T(radius * radius / reduced_radius)};
}

}  // namespace tribo
