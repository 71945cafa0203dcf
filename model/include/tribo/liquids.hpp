// SPDX-License-Identifier: Apache-2.0
// Density and viscosity of liquids under pressure and temperature. Sources: D. Dowson, G. R.
// Higginson: Elasto-hydrodynamic Lubrication (1966); C. Barus: Isothermals, isopiestics and
// isometrics relative to viscosity. Am. J. Sci. 45 (1893) 87; C. J. A. Roelands: Correlational
// aspects of the viscosity-temperature-pressure relationship of lubricating oils. Thesis, Delft
// (1966); ASTM D341: Standard practice for viscosity-temperature equations and charts for liquid
// petroleum or hydrocarbon products; P. J. Carreau: Rheological equations from molecular network
// theories. Trans. Soc. Rheol. 16 (1972) 99, and K. Yasuda: Investigation of the analogies between
// viscometric and linear viscoelastic properties of polystyrene fluids. Thesis, MIT (1979).
#pragma once

#include "tribo/contract.hpp"
#include "tribo/friction.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract density_contract{2, 0};
// The condition counts all arguments, because exponents multiply their errors.
inline constexpr Contract barus_contract{4, 1};
inline constexpr Contract roelands_contract{8, 4};
inline constexpr Contract astm_d341_contract{8, 4};
inline constexpr Contract carreau_yasuda_contract{16, 4};

// The pressure in Pa at which the density by Dowson and Higginson's law has risen by half of its
// greatest rise.
inline constexpr double dowson_higginson_pressure = 5.9e8;

// ρ/ρ₀ = (5.9·10⁸ + 1.34p)/(5.9·10⁸ + p), pressure p ≥ 0 in Pa: at most 1.34. Error:
// density_contract.
template <class T>
T dowson_higginson_density(const T& pressure) {
  return 1 + ratio<T>(34, 100) * (pressure / (T(dowson_higginson_pressure) + pressure));
}

// η in Pa·s at pressure p ≥ 0 in Pa, by `law` (friction.hpp): viscosity η₀ > 0 in Pa·s at ambient
// pressure, pressure_viscosity α > 0 in 1/Pa. Error: barus_contract, roelands_contract; overflow
// gives ∞. Roelands' law gives NaN where η₀ is not above 6.315e-5 Pa·s: ln η₀ + 9.67 has to be
// above 0.
template <class T>
T viscosity_at(ViscosityLaw law, const T& viscosity, const T& pressure_viscosity,
               const T& pressure) {
  using std::exp;
  using std::log;
  if (law == ViscosityLaw::roelands && !(log(viscosity) + roelands_log_viscosity<T>() > 0))
    return quiet_nan<T>();
  return viscosity * exp(log_viscosity_ratio(law, viscosity, pressure_viscosity, pressure));
}

// Kinematic viscosity ν in m²/s at `temperature`, from those at two others, by
//   log log(ν + 0.7) = A − B log T,  ν in mm²/s, T in K,
// with logarithms of any base. The law holds for viscosities of 2 mm²/s or more; below, the
// standard has another term. Temperatures > 0 in K. Viscosities in m²/s, above 0.3 mm²/s, so that
// log(ν + 0.7) > 0. NaN otherwise, and where the first two temperatures are the same. Error:
// astm_d341_contract; overflow gives ∞.
template <class T>
T astm_d341_viscosity(const T& first_temperature, const T& first_viscosity,
                      const T& second_temperature, const T& second_viscosity,
                      const T& temperature) {
  using std::exp;
  using std::log;
  using std::log1p;
  const T millions = T(1000000), offset = ratio<T>(7, 10);
  const T first = log(T(millions * first_viscosity + offset));
  const T second = log(T(millions * second_viscosity + offset));
  if (!(first > 0 && second > 0) || first_temperature == second_temperature) return quiet_nan<T>();
  // ln(T/T₁), without the rounding of a quotient near 1
  const auto log_ratio = [&](const T& to) {
    return T(log1p(T((to - first_temperature) / first_temperature)));
  };
  const T part = log_ratio(temperature) / log_ratio(second_temperature);
  return (exp(T(first * exp(T(part * log(T(second / first)))))) - offset) / millions;
}

// η in Pa·s of a liquid that shear thins:
//   η = η_∞ + (η₀ − η_∞)[1 + (λγ̇)^a]^((n − 1)/a).
// viscosity η₀ > 0 at rest and high_shear_viscosity η_∞ ≥ 0 in Pa·s, relaxation_time λ > 0 in s,
// shear_rate γ̇ ≥ 0 in 1/s, transition_exponent a > 0 (2: Carreau's law), power_law_index n > 0
// and at most 1; NaN above. Error: carreau_yasuda_contract.
template <class T>
T carreau_yasuda_viscosity(const T& viscosity, const T& high_shear_viscosity,
                           const T& relaxation_time, const T& shear_rate,
                           const T& transition_exponent, const T& power_law_index) {
  using std::exp;
  using std::log;
  using std::log1p;
  using std::pow;
  if (!(power_law_index <= 1)) return quiet_nan<T>();
  const T rate = relaxation_time * shear_rate;
  // ln(1 + (λγ̇)^a), without a power that overflows
  const T logarithm =
      rate > 1 ? T(transition_exponent * log(rate) + log1p(T(pow(rate, T(-transition_exponent)))))
               : T(log1p(T(pow(rate, transition_exponent))));
  const T part = exp(T((power_law_index - 1) / transition_exponent * logarithm));
  return high_shear_viscosity + (viscosity - high_shear_viscosity) * part;
}

}  // namespace tribo
