// SPDX-License-Identifier: Apache-2.0
// Minimum films of point contacts in the regimes of lubrication, by dimensionless numbers that do
// not hold the speed twice (model/README.md, section 5): with U, G and W of film_thickness.hpp,
//
//   Ĥ = (h_min/R_x) (W/U)²,   g_V = G W³/U²,   g_E = W^{8/3}/U².
//
// Sources: B. J. Hamrock, D. Dowson: Minimum film thickness in elliptical contacts for different
// regimes of fluid-film lubrication. NASA TP-1342 (1978); B. J. Hamrock: Fundamentals of Fluid Film
// Lubrication. NASA RP-1255 (1991), chapter on regimes; of viscous_rigid_roelands Y.-R. Jeng, B. J.
// Hamrock, D. E. Brewe: Piezoviscous effects in nonconformal contacts lubricated hydrodynamically.
// ASLE Trans. 30 (1987) 452.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tribo/real.hpp"

namespace tribo {

// Rigid bodies in a liquid that pressure thickens have two fits: by Barus' law, from 1978, and by
// Roelands' law, which gives thinner films.
enum class FilmRegime : std::uint8_t {
  isoviscous_rigid,
  viscous_rigid_barus,
  viscous_rigid_roelands,
  isoviscous_elastic,
  viscous_elastic
};
inline constexpr auto film_regime_words = std::to_array<std::string_view>(
    {"isoviscous_rigid", "viscous_rigid_barus", "viscous_rigid_roelands", "isoviscous_elastic",
     "viscous_elastic"});

// Ĥ:
//   isoviscous_rigid        128 α φ² (0.131 atan(α/2) + 1.683)²,  φ = 1/(1 + 2/(3α))
//   viscous_rigid_barus     1.66 g_V^{2/3} (1 − e^{−0.68k})
//   viscous_rigid_roelands  141 g_V^{0.375} (1 − e^{−0.0387α})
//   isoviscous_elastic      8.70 g_E^{0.67} (1 − 0.85 e^{−0.31k})
//   viscous_elastic         3.42 g_V^{0.49} g_E^{0.17} (1 − e^{−0.68k})
// viscosity_parameter g_V, elasticity_parameter g_E, radius_ratio α = R_y/R_x and ellipticity k of
// the contact's ellipse; all > 0, and what a regime does not have is not looked at. Error:
// film_contract.
template <class T>
T regime_film(FilmRegime regime, const T& viscosity_parameter, const T& elasticity_parameter,
              const T& radius_ratio, const T& ellipticity) {
  using std::atan;
  using std::exp;
  using std::expm1;
  // 1 − e^{−nx}
  const auto bracket = [](const Fraction& n, const T& x) { return T(-expm1(T(-ratio<T>(n) * x))); };
  switch (regime) {
    case FilmRegime::isoviscous_rigid: {
      const T root = (ratio<T>(131, 1000) * atan(T(radius_ratio / 2)) + ratio<T>(1683, 1000)) /
                     (1 + 2 / (3 * radius_ratio));
      return 128 * radius_ratio * root * root;
    }
    case FilmRegime::viscous_rigid_barus:
      return ratio<T>(166, 100) * decimal_power(viscosity_parameter, Fraction{2, 3}) *
             bracket({68, 100}, ellipticity);
    case FilmRegime::viscous_rigid_roelands:
      return 141 * decimal_power(viscosity_parameter, Fraction{375, 1000}) *
             bracket({387, 10000}, radius_ratio);
    case FilmRegime::isoviscous_elastic:
      return ratio<T>(870, 100) * decimal_power(elasticity_parameter, Fraction{67, 100}) *
             (1 - ratio<T>(85, 100) * exp(T(-ratio<T>(31, 100) * ellipticity)));
    default:
      return ratio<T>(342, 100) * decimal_power(viscosity_parameter, Fraction{49, 100}) *
             decimal_power(elasticity_parameter, Fraction{17, 100}) *
             bracket({68, 100}, ellipticity);
  }
}

}  // namespace tribo
