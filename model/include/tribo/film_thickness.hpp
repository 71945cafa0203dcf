// SPDX-License-Identifier: Apache-2.0
// Film thickness of the fully flooded, smooth contact, by a regression that is a row of numbers
// (model/README.md, section 5):
//
//   h/R = C U^a G^b W^c (1 − m e^{−nk}),   U = η₀u/(E_HD R), G = αE_HD, W = F/(E_HD R²)
//
// R is R_x, along the direction of entrainment, E_HD is 2E*, and u the mean of the speeds of the
// two surfaces; but readings of a law may take E* or the sum. Of a line W = (F/L)/(E_HD R), which
// is that of a point with F = (F/L) R, and m is 0.
//
// The default is Hamrock and Dowson's central film (paper, eqs 1.20 to 1.22, with 0.61 for the
// misprinted 0.6): B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point
// contacts, part III. J. Lubr. Technol. 99 (1977) 264, doi 10.1115/1.3453074.
#pragma once

#include <array>
#include <cstddef>

#include "tribo/contract.hpp"
#include "tribo/real.hpp"
#include "tribo/scene.hpp"

namespace tribo {

inline constexpr Contract film_contract{20, 0};

// A row, and what follows from it. Contacts keep the address of their law, which must outlive them:
// laws are constants.
struct FilmLaw {
  Fraction constant;           // C
  Fraction speed_exponent;     // a, of U
  Fraction material_exponent;  // b, of G
  Fraction load_exponent;      // c, of W
  Fraction side_leakage;       // m; 0: the constant does not depend on k
  Fraction side_decay;         // n
  // E_HD/E* in U, in G and in W, and what U has over the mean of the speeds.
  int speed_modulus = 2;
  int material_modulus = 2;
  int load_modulus = 2;
  int speed_multiple = 1;
  bool is_of_lines = false;  // or of points
  // The ellipticities that it was fitted to; of lines not used.
  double least_ellipticity = 1, greatest_ellipticity = 8;

  // a − b: load sharing divides E* and F by the γ of the film, so that U is multiplied by γ, G is
  // divided by it, and W stays: h = h₀ γ^{a−b}.
  Fraction sharing_exponent = speed_exponent - material_exponent;
  // In the engine's form.
  Exponent speed_power = speed_exponent;
  Exponent sharing_power = sharing_exponent;
};

// Central film (0.67 − 0.53 = 0.14 after load sharing) and minimum film (0.19) of Hamrock and
// Dowson (1977).
inline constexpr FilmLaw hamrock_dowson_central_law{.constant = {269, 100},
                                                    .speed_exponent = {67, 100},
                                                    .material_exponent = {53, 100},
                                                    .load_exponent = {-67, 1000},
                                                    .side_leakage = {61, 100},
                                                    .side_decay = {73, 100}};
inline constexpr FilmLaw hamrock_dowson_minimum_law{.constant = {363, 100},
                                                    .speed_exponent = {68, 100},
                                                    .material_exponent = {49, 100},
                                                    .load_exponent = {-73, 1000},
                                                    .side_leakage = {1, 1},
                                                    .side_decay = {68, 100}};

// Films of soft bodies in liquids whose viscosity does not rise with pressure: B. J. Hamrock, D.
// Dowson: Elastohydrodynamic lubrication of elliptical contacts for materials of low elastic
// modulus, part I. J. Lubr. Technol. 100 (1978) 236.
inline constexpr FilmLaw hamrock_dowson_soft_central_law{.constant = {732, 100},
                                                         .speed_exponent = {64, 100},
                                                         .material_exponent = {0, 1},
                                                         .load_exponent = {-22, 100},
                                                         .side_leakage = {72, 100},
                                                         .side_decay = {28, 100}};
inline constexpr FilmLaw hamrock_dowson_soft_minimum_law{.constant = {743, 100},
                                                         .speed_exponent = {65, 100},
                                                         .material_exponent = {0, 1},
                                                         .load_exponent = {-21, 100},
                                                         .side_leakage = {85, 100},
                                                         .side_decay = {31, 100}};

// Lines. Minimum film: D. Dowson: Elastohydrodynamics. Proc. Inst. Mech. Eng. 182 (1967) 151.
// Central film: D. Dowson, A. Toyoda: A central film thickness formula for elastohydrodynamic line
// contacts. Proc. 5th Leeds–Lyon Symp. (1979) 60.
inline constexpr FilmLaw dowson_higginson_minimum_law{.constant = {265, 100},
                                                      .speed_exponent = {70, 100},
                                                      .material_exponent = {54, 100},
                                                      .load_exponent = {-13, 100},
                                                      .side_leakage = {0, 1},
                                                      .side_decay = {0, 1},
                                                      .is_of_lines = true};
inline constexpr FilmLaw dowson_toyoda_central_law{.constant = {306, 100},
                                                   .speed_exponent = {69, 100},
                                                   .material_exponent = {56, 100},
                                                   .load_exponent = {-10, 100},
                                                   .side_leakage = {0, 1},
                                                   .side_decay = {0, 1},
                                                   .is_of_lines = true};
// Both films of J. Pan, B. J. Hamrock: Simple formulas for performance parameters used in
// elastohydrodynamically lubricated line contacts. J. Tribol. 111 (1989) 246.
inline constexpr FilmLaw pan_hamrock_minimum_law{.constant = {1714, 1000},
                                                 .speed_exponent = {694, 1000},
                                                 .material_exponent = {568, 1000},
                                                 .load_exponent = {-128, 1000},
                                                 .side_leakage = {0, 1},
                                                 .side_decay = {0, 1},
                                                 .is_of_lines = true};
inline constexpr FilmLaw pan_hamrock_central_law{.constant = {2922, 1000},
                                                 .speed_exponent = {692, 1000},
                                                 .material_exponent = {470, 1000},
                                                 .load_exponent = {-166, 1000},
                                                 .side_leakage = {0, 1},
                                                 .side_decay = {0, 1},
                                                 .is_of_lines = true};
// A. N. Grubin's film (1949) of A. M. Ertel's inlet: a = b, so that load sharing does not move it.
inline constexpr FilmLaw ertel_grubin_law{.constant = {195, 100},
                                          .speed_exponent = {8, 11},
                                          .material_exponent = {8, 11},
                                          .load_exponent = {-1, 11},
                                          .side_leakage = {0, 1},
                                          .side_decay = {0, 1},
                                          .is_of_lines = true};

// The law that a scene names.
constexpr const FilmLaw& film_law(FilmFormula formula) {
  constexpr std::array<const FilmLaw*, film_formula_words.size()> laws{
      &hamrock_dowson_central_law,      &hamrock_dowson_minimum_law,
      &hamrock_dowson_soft_central_law, &hamrock_dowson_soft_minimum_law,
      &dowson_higginson_minimum_law,    &dowson_toyoda_central_law,
      &pan_hamrock_minimum_law,         &pan_hamrock_central_law};
  return *laws[static_cast<std::size_t>(formula)];
}

// Laws that load sharing takes: 0.01 ≤ a − b ≤ 0.7, and exponents of at most three decimals.
constexpr bool is_law_of_load_sharing(const FilmLaw& law) {
  return law.sharing_power.value >= 0.01 && law.sharing_power.value <= 0.7 &&
         1000 % law.speed_exponent.q == 0 && 1000 % law.material_exponent.q == 0 &&
         1000 % law.load_exponent.q == 0;
}
static_assert([] {
  for (std::size_t i = 0; i < film_formula_words.size(); ++i)
    if (!is_law_of_load_sharing(film_law(static_cast<FilmFormula>(i)))) return false;
  return true;
}());

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

// h₀ in m: film_thickness() by the default law.
template <class T>
T hamrock_dowson_central(const T& speed, const T& viscosity, const T& pressure_viscosity,
                         const T& load, const T& effective_modulus, const T& reduced_radius,
                         const T& ellipticity) {
  return film_thickness(hamrock_dowson_central_law, speed, viscosity, pressure_viscosity, load,
                        effective_modulus, reduced_radius, ellipticity);
}

}  // namespace tribo
