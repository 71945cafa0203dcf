// SPDX-License-Identifier: Apache-2.0
// Film thickness of the fully flooded, smooth contact, by a regression that is a row of numbers
// (model/README.md, section 5):
//
//   h/R = C U^a G^b W^c (1 − m e^{−nk}),   U = η₀u/(E_HD R), G = αE_HD, W = F/(E_HD R²)
//
// R is R_x, along the direction of entrainment. E_HD is 2E*, and u is the mean of the speeds of the
// two surfaces. Readings of a law may take E* instead of 2E*, or the sum of the speeds. A line has
// m = 0 and W = (F/L)/(E_HD R), which is W of a point with F = (F/L) R.
//
// The default is Hamrock and Dowson's central film (paper, eqs 1.20 to 1.22, with 0.61 for the
// misprinted 0.6): B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point
// contacts, part III. J. Lubr. Technol. 99 (1977) 264, doi 10.1115/1.3453074.
#pragma once

#include <algorithm>

#include "tribo/contract.hpp"
#include "tribo/film_laws.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract film_contract{20, 0};

// Does load sharing take this law? It takes laws without fixed exponents, and laws with a = b:
// their film does not change with γ. It takes other laws if 0.01 ≤ a − b ≤ 0.7 and the exponents
// have at most three decimals.
constexpr bool is_law_of_load_sharing(const FilmLaw& law) {
  if (!law.has_fixed_exponents() || law.sharing_exponent.p == 0) return true;
  return law.sharing_power.value >= 0.01 && law.sharing_power.value <= 0.7 &&
         1000 % law.speed_exponent.q == 0 && 1000 % law.material_exponent.q == 0 &&
         1000 % law.load_exponent.q == 0;
}
static_assert(std::all_of(named_film_laws.begin(), named_film_laws.end(),
                          [](const NamedFilmLaw& named) {
                            return is_law_of_load_sharing(*named.law);
                          }));

// C (1 − m e^{−nk}).
template <class T>
T film_constant(const FilmLaw& law, const T& ellipticity) {
  using std::exp;
  using std::expm1;
  const T decay = -ratio<T>(law.side_decay) * ellipticity;
  if (law.side_leakage.p == law.side_leakage.q)  // the difference cancels where k is small
    return ratio<T>(law.constant) * -expm1(decay);
  return ratio<T>(law.constant) * (1 - ratio<T>(law.side_leakage) * exp(decay));
}

// 2.69 (1 − 0.61 e^{−0.73k}), 1.8992… for a circular contact, k = 1.
template <class T>
T hamrock_dowson_constant(const T& ellipticity) {
  return film_constant(hamrock_dowson_central_law, ellipticity);
}

// h in m. speed u in m/s (entrainment, the mean of the two surfaces), viscosity η₀ in Pa·s,
// pressure_viscosity α in 1/Pa, load F in N, effective_modulus E* in Pa, reduced_radius R in m,
// ellipticity k; all > 0. Error: film_contract.
template <class T>
T film_thickness(const FilmLaw& law, const T& speed, const T& viscosity,
                 const T& pressure_viscosity, const T& load, const T& effective_modulus,
                 const T& reduced_radius, const T& ellipticity) {
  const T speed_number = viscosity * (T(law.speed_multiple) * speed) /
                         (T(law.speed_modulus) * effective_modulus * reduced_radius);
  const T material_number = pressure_viscosity * (T(law.material_modulus) * effective_modulus);
  const T load_number =
      load / (T(law.load_modulus) * effective_modulus * reduced_radius * reduced_radius);
  return reduced_radius * film_constant(law, ellipticity) *
         decimal_power(speed_number, law.speed_exponent) *
         decimal_power(material_number, law.material_exponent) *
         decimal_power(load_number, law.load_exponent);
}

// h in m of a line: load_per_length F/L in N/m, reduced_radius R in m, 1/R = 1/R₁ + 1/R₂; the
// others as above, all > 0. Error: film_contract.
template <class T>
T line_film_thickness(const FilmLaw& law, const T& speed, const T& viscosity,
                      const T& pressure_viscosity, const T& load_per_length,
                      const T& effective_modulus, const T& reduced_radius) {
  return film_thickness(law, speed, viscosity, pressure_viscosity,
                        T(load_per_length * reduced_radius), effective_modulus, reduced_radius,
                        T(1));
}

// h₀ in m: film_thickness() by the default law.
template <class T>
T hamrock_dowson_central(const T& speed, const T& viscosity, const T& pressure_viscosity,
                         const T& load, const T& effective_modulus, const T& reduced_radius,
                         const T& ellipticity) {
  return film_thickness(hamrock_dowson_central_law, speed, viscosity, pressure_viscosity, load,
                        effective_modulus, reduced_radius, ellipticity);
}

}  // namespace tribo
