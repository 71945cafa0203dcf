// SPDX-License-Identifier: Apache-2.0
// How much thinner a film is because shear heats the oil in the inlet. Sources: P. K. Gupta, H. S.
// Cheng, D. Zhu, N. H. Forster, J. B. Schrand: Viscoelastic effects in MIL-L-7808-type lubricant,
// part I, analytical formulation. Tribol. Trans. 35 (1992) 269, doi 10.1080/10402009208982117; L.
// E. Murch, W. R. D. Wilson: A thermal elastohydrodynamic inlet zone analysis. J. Lubr. Technol. 97
// (1975) 212, doi 10.1115/1.3452559.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

// Digits cancel in the numerator: 4 ulp times the condition of all seven arguments are allowed.
inline constexpr Contract gupta_thermal_contract{8, 4};
inline constexpr Contract murch_wilson_thermal_contract{8, 0};

// φ_T, the film over that of an isothermal inlet:
//   φ_T = [1 − 13.2 (p₀/E′) L^{0.42}]/[1 + 0.213 (1 + 2.23 S^{0.83}) L^{0.64}],  L = βη₀u²/k_f.
// peak_pressure p₀ of Hertz in Pa, effective_modulus E* in Pa (E′ = 2E*), slide_roll_ratio S ≥ 0,
// the sliding speed over the mean speed, temperature_viscosity β = −d ln η/dT in 1/K, viscosity η₀
// in Pa·s, speed u in m/s (the mean of the two surfaces), thermal_conductivity k_f of the oil in
// W/(m·K). All arguments but S are > 0. NaN where the numerator is not above 0, beyond the range of
// the fit. Error: gupta_thermal_contract.
template <class T>
T gupta_thermal_reduction(const T& peak_pressure, const T& effective_modulus,
                          const T& slide_roll_ratio, const T& temperature_viscosity,
                          const T& viscosity, const T& speed, const T& thermal_conductivity) {
  const T heating = temperature_viscosity * viscosity * speed * speed / thermal_conductivity;  // L
  const T numerator = 1 - ratio<T>(132, 10) * (peak_pressure / (2 * effective_modulus)) *
                              decimal_power(heating, Fraction{42, 100});
  if (!(numerator > 0)) return quiet_nan<T>();
  const T sliding = 1 + ratio<T>(223, 100) * decimal_power(slide_roll_ratio, Fraction{83, 100});
  return numerator /
         (1 + ratio<T>(213, 1000) * sliding * decimal_power(heating, Fraction{64, 100}));
}

// φ_T of pure rolling by Murch and Wilson, without the pressure: 3.94/(3.94 + L^{0.62}), L as
// above. W. R. D. Wilson and S. Sheu print it as 1/(1 + 0.254 L^{0.62}) and say that u is the mean
// speed (Effect of inlet shear heating due to sliding on elastohydrodynamic film thickness. J.
// Lubr. Technol., manuscript of 1980). The arguments have the units and ranges of
// gupta_thermal_reduction(). Error: murch_wilson_thermal_contract.
template <class T>
T murch_wilson_thermal_reduction(const T& temperature_viscosity, const T& viscosity, const T& speed,
                                 const T& thermal_conductivity) {
  const T heating = temperature_viscosity * viscosity * speed * speed / thermal_conductivity;  // L
  const T scale = ratio<T>(394, 100);
  return scale / (scale + decimal_power(heating, Fraction{62, 100}));
}

}  // namespace tribo
