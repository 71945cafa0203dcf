// SPDX-License-Identifier: Apache-2.0
// Friction of the shared contact (model/README.md, section 8; paper, eqs 1.24 to 1.31):
//
//   μ = μ_b A + τ A_H/F,   A_H = A_nom max(0, 1 − A_r/A_nom),   γ̇ = S u/separation,
//   eyring τ = τ₀ asinh(ηγ̇/τ₀),   limiting τ = τ₀ (1 − e^{−ηγ̇/τ₀}),
//
// with the viscosity η at the pressure p_L that the film carries.
//
// Source: H. Eyring: Viscosity, plasticity, and diffusion as examples of absolute reaction rates.
// J. Chem. Phys. 4 (1936) 283, doi 10.1063/1.1749836; S. Bair, W. O. Winer: A rheological model for
// elastohydrodynamic contacts based on primary laboratory data. J. Lubr. Technol. 101 (1979) 258;
// C. Barus: Isothermals, isopiestics and isometrics relative to viscosity. Am. J. Sci. 45 (1893)
// 87; C. J. A. Roelands: Correlational aspects of the viscosity-temperature-pressure relationship
// of lubricating oils. Thesis, Delft (1966).
#pragma once

#include "tribo/real.hpp"
#include "tribo/scene.hpp"

namespace tribo {

// Roelands' constants: pressure in Pa, viscosity in Pa·s.
template <class T>
T roelands_pressure() {
  return T(196000000);  // p_R, 0.196 GPa
}
template <class T>
T roelands_log_viscosity() {
  return ratio<T>(967, 100);  // 9.67
}
// ln η₀ + 9.67 is a denominator and has to be above 0. This bounds η₀ from below: e^−9.67 =
// 6.31499e-5 Pa·s.
inline constexpr double least_roelands_viscosity = 6.315e-5;

// ln(η/η₀) at pressure p ≥ 0 in Pa:
//   barus αp;  ambient 0;  roelands (ln η₀ + 9.67)[(1 + p/p_R)^z − 1], z = αp_R/(ln η₀ + 9.67).
// viscosity η₀ in Pa·s, pressure_viscosity α in 1/Pa. Error: 10 ε absolute + relative.
template <class T>
T log_viscosity_ratio(ViscosityLaw law, const T& viscosity, const T& pressure_viscosity,
                      const T& pressure) {
  using std::expm1;
  using std::log;
  using std::log1p;
  if (law == ViscosityLaw::ambient) return T(0);
  if (law == ViscosityLaw::barus) return pressure_viscosity * pressure;
  const T log_scale = log(viscosity) + roelands_log_viscosity<T>();
  const T z = pressure_viscosity * roelands_pressure<T>() / log_scale;
  return log_scale * expm1(T(z * log1p(T(pressure / roelands_pressure<T>()))));
}

// Shear stress τ in Pa of a film: eyring_stress τ₀ in Pa, viscosity η₀ in Pa·s, log_viscosity_ratio
// as above, sliding_speed S·u ≥ 0 in m/s, separation > 0 in m. Where x = ηγ̇/τ₀ overflows, `eyring`
// still gives τ₀(ln 2 + ln x), and `limiting` gives τ₀. Error: 20 ε × (1 + ln(η/η₀)).
template <class T>
T fluid_shear_stress(FluidShear law, const T& eyring_stress, const T& viscosity,
                     const T& log_viscosity_ratio, const T& sliding_speed, const T& separation) {
  using std::asinh;
  using std::exp;
  using std::expm1;
  using std::log;
  if (sliding_speed == 0) return T(0);
  T x = viscosity / eyring_stress * (sliding_speed / separation) * exp(log_viscosity_ratio);
  T log_x = 0;
  if (!(x > 0 && x < 1 / epsilon<T>())) {  // x may be in the range of T, a factor not
    log_x = log(viscosity) - log(eyring_stress) + log(sliding_speed) - log(separation) +
            log_viscosity_ratio;
    x = exp(log_x);
  }
  if (law == FluidShear::limiting) return -eyring_stress * expm1(T(-x));
  // asinh x = ln(2x) + 1/(4x²) − …
  if (x < 1 / epsilon<T>()) return eyring_stress * asinh(x);
  return eyring_stress * (log(T(2)) + log_x);
}

}  // namespace tribo
