// SPDX-License-Identifier: Apache-2.0
// Readings of printed formulas for the film of a point contact that scenes do not name (they name
// those of named_film_laws): those of Chittenden, Dowson, Dunn and Taylor, and the ones of
// Nijenbanning, Venner and Moes that are not the default (nijenbanning_venner_moes.hpp).
//
//   h/R_e = C U^0.68 G^0.49 W^−0.073 [1 − exp(−n (R_s/R_e)^{2/3})],  U = η₀u/(E′R_e),  G = αE′,
//   W = F/(E′R_e²),  E′ = 2E*
//
// R_e is along the direction of entrainment and R_s across it, here R_x and R_y; u is the mean of
// the two surfaces' speeds. Source: R. J. Chittenden, D. Dowson, J. F. Dunn, C. M. Taylor: A
// theoretical analysis of the isothermal elastohydrodynamic lubrication of concentrated contacts.
// Proc. R. Soc. Lond. A 397 (1985) 245 and 271. The print is not at hand, so that neither its
// liquid nor its constants are known here. Commonly cited are C = 4.31 and n = 1.23 for the central
// film, 3.68 and 0.67 for the least film. R. S. Zhou, M. R. Hoeprich: Torque of tapered roller
// bearings, J. Tribol. 113 (1991) 590, equation 31, cite 4.30 and 1.28, and k, the ratio of the
// ellipse's axes, in place of (R_s/R_e)^{2/3}.
#pragma once

#include <array>
#include <string_view>

#include "ehl/film_conditions.hpp"
#include "ehl/line_formulas.hpp"
#include "tribo/nijenbanning_venner_moes.hpp"

namespace tribo::ehl {

namespace detail {
constexpr FilmLaw chittenden_law(Fraction constant, Fraction side_decay) {
  return {.constant = constant,
          .speed_exponent = {68, 100},
          .material_exponent = {49, 100},
          .load_exponent = {-73, 1000},
          .side_leakage = {1, 1},
          .side_decay = side_decay};
}
}  // namespace detail
inline constexpr FilmLaw chittenden_central_431_law =
    detail::chittenden_law({431, 100}, {123, 100});
inline constexpr FilmLaw chittenden_central_430_law =
    detail::chittenden_law({430, 100}, {128, 100});
inline constexpr FilmLaw chittenden_minimum_368_law = detail::chittenden_law({368, 100}, {67, 100});

struct PointFormula {
  std::string_view name;
  FilmQuantity quantity;
  const FilmLaw* law = nullptr;  // null: Nijenbanning, Venner and Moes' reading
  bool takes_radii = false;      // (R_y/R_x)^{2/3} in place of k
  MoesExponent exponent = MoesExponent::elastic_over_rigid;
  MoesBracket bracket = MoesBracket::three_halves;
};

inline constexpr auto point_formulas = std::to_array<PointFormula>({
    {"chittenden_central_431", FilmQuantity::central, &chittenden_central_431_law, true},
    {"chittenden_central_430", FilmQuantity::central, &chittenden_central_430_law},
    {"chittenden_minimum_368", FilmQuantity::minimum, &chittenden_minimum_368_law, true},
    {.name = "nijenbanning_three_halves_of_s",
     .quantity = FilmQuantity::central,
     .bracket = MoesBracket::three_halves_of_s},
    {.name = "nijenbanning_ei_over_ep",
     .quantity = FilmQuantity::central,
     .exponent = MoesExponent::elastic_over_piezoviscous},
    {.name = "nijenbanning_ei_over_ep_of_s",
     .quantity = FilmQuantity::central,
     .exponent = MoesExponent::elastic_over_piezoviscous,
     .bracket = MoesBracket::three_halves_of_s},
});

// The film of a circle or an ellipse, with a flooded inlet, in m; NaN where the formula has none
// because the liquid's viscosity does not rise with pressure. Error: 60 ulp.
double film_thickness(const PointFormula& formula, const FilmConditions& conditions);

}  // namespace tribo::ehl
