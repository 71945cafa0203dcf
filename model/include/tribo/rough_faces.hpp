// SPDX-License-Identifier: Apache-2.0
// Numbers of rough faces that other models have: how plastic their summits are, the load on a
// summit that yields, the area of contact by Persson's theory, and how roughness hinders a flow.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract plasticity_index_contract{6, 0};
inline constexpr Contract kogut_etsion_contract{6, 0};
inline constexpr Contract persson_contract{6, 0};
inline constexpr Contract patir_cheng_contract{6, 0};

// ψ = (E*/H) √(σ_s/β): summits are elastic below some 0.6, and plastic above 1. effective_modulus
// E* and hardness H of the softer body in Pa, summit_height_sd σ_s and summit_radius β in m, all
// > 0. Source: J. A. Greenwood, J. B. P. Williamson: Contact of nominally flat surfaces. Proc. R.
// Soc. Lond. A 295 (1966) 300. Error: plasticity_index_contract.
template <class T>
T plasticity_index(const T& effective_modulus, const T& hardness, const T& summit_height_sd,
                   const T& summit_radius) {
  using std::sqrt;
  return effective_modulus / hardness * sqrt(T(summit_height_sd / summit_radius));
}

// Two values of the interference ratio ω/ω_c: the greatest for which the fit of Kogut and Etsion
// holds, and the one at which the second row of numbers of the fit begins.
inline constexpr int greatest_kogut_etsion_interference = 110;
inline constexpr int second_kogut_etsion_interference = 6;

// F/F_c, the load on a ball that a rigid flat presses, over the load F_c at first yield.
// interference_ratio x = ω/ω_c > 0, the interference over that at first yield:
//   x^1.5 below 1 (Hertz), 1.03 x^1.425 from 1 to 6, 1.40 x^1.263 from 6 to 110;
// NaN beyond. At 1 and at 6 the fit has steps of 3 % and of 1.7 %. Source: L. Kogut, I. Etsion:
// Elastic-plastic contact analysis of a sphere and a rigid flat. J. Appl. Mech. 69 (2002) 657, doi
// 10.1115/1.1490373. Error: kogut_etsion_contract.
template <class T>
T kogut_etsion_load(const T& interference_ratio) {
  using std::sqrt;
  if (!(interference_ratio <= greatest_kogut_etsion_interference)) return quiet_nan<T>();
  if (interference_ratio < 1) return interference_ratio * sqrt(interference_ratio);
  if (interference_ratio < second_kogut_etsion_interference)
    return ratio<T>(103, 100) * decimal_power(interference_ratio, Fraction{1425, 1000});
  return ratio<T>(14, 10) * decimal_power(interference_ratio, Fraction{1263, 1000});
}

// A/A₀ = erf(√2 p/(E*h′)), the part of the nominal area where rough elastic faces touch. pressure
// p ≥ 0 in Pa, the load over the nominal area, effective_modulus E* > 0 in Pa, rms_gradient h′ > 0,
// the root mean square of the gradient of the gap's height, in both directions together. Source: B.
// N. J. Persson: Theory of rubber friction and contact mechanics. J. Chem. Phys. 115 (2001) 3840,
// doi 10.1063/1.1388626. Error: persson_contract.
template <class T>
T persson_contact_area(const T& pressure, const T& effective_modulus, const T& rms_gradient) {
  using std::erf;
  using std::sqrt;
  return erf(T(sqrt(T(2)) * (pressure / effective_modulus / rms_gradient)));
}

// φ = 1 − 0.90 e^(−0.56H), the pressure-driven flow between isotropic rough faces over that between
// smooth ones at the same nominal film. film_ratio H = h/σ > 0, the nominal film over the composite
// rms roughness; fitted from 0.5 on. Source: N. Patir, H. S. Cheng: An average flow model for
// determining effects of three-dimensional roughness on partial hydrodynamic lubrication. J. Lubr.
// Technol. 100 (1978) 12, doi 10.1115/1.3453103. Error: patir_cheng_contract.
template <class T>
T patir_cheng_pressure_flow(const T& film_ratio) {
  using std::expm1;
  return ratio<T>(1, 10) - ratio<T>(9, 10) * expm1(T(-ratio<T>(56, 100) * film_ratio));
}

}  // namespace tribo
