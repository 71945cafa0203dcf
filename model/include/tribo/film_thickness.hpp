// SPDX-License-Identifier: Apache-2.0
// Central film thickness of the fully flooded, smooth point contact after Hamrock and Dowson
// (model/README.md, section 5; paper, eqs 1.20 to 1.22, with 0.61 for the misprinted 0.6):
//
//   h₀/R = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^{−0.73k}),
//   U = η₀u/(E_HD R), G = αE_HD, W = F/(E_HD R²), E_HD = 2E*.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract film_contract{20, 0};

// The exponents of U, G and W.
inline constexpr Fraction speed_exponent{67, 100};
inline constexpr Fraction material_exponent{53, 100};
inline constexpr Fraction load_exponent{-67, 1000};

// d ln h₀/d ln u.
template <class T>
T film_speed_exponent() {
  return ratio<T>(speed_exponent);
}

// d ln h₀/d ln α, and the exponent of γ that remains after load sharing is 0.67 − 0.53 = 0.14.
template <class T>
T film_material_exponent() {
  return ratio<T>(material_exponent);
}

// 2.69 (1 − 0.61 e^{−0.73k}), 1.8992… for a circular contact, k = 1.
template <class T>
T hamrock_dowson_constant(const T& ellipticity) {
  using std::exp;
  return ratio<T>(269, 100) * (1 - ratio<T>(61, 100) * exp(-ratio<T>(73, 100) * ellipticity));
}

// h₀ in m. speed u in m/s (entrainment, the mean of the two surfaces), viscosity η₀ in Pa·s,
// pressure_viscosity α in 1/Pa, load F in N, effective_modulus E* in Pa, reduced_radius R in m,
// ellipticity k; all > 0. Error: film_contract.
template <class T>
T hamrock_dowson_central(const T& speed, const T& viscosity, const T& pressure_viscosity,
                         const T& load, const T& effective_modulus, const T& reduced_radius,
                         const T& ellipticity) {
  const T modulus = 2 * effective_modulus;
  const T speed_number = viscosity * speed / (modulus * reduced_radius);
  const T material_number = pressure_viscosity * modulus;
  const T load_number = load / (modulus * reduced_radius * reduced_radius);
  return reduced_radius * hamrock_dowson_constant(ellipticity) *
         decimal_power(speed_number, speed_exponent) *
         decimal_power(material_number, material_exponent) *
         decimal_power(load_number, load_exponent);
}

}  // namespace tribo
