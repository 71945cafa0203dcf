// SPDX-License-Identifier: Apache-2.0
// The regime of lubrication of a scene's smooth, flooded contact, and whether a film law is one of
// that regime (model/README.md, section 5).
#pragma once

#include <array>
#include <cstddef>

#include "tribo/similarity_numbers.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo {

// U, G and W of a scene's contact at a speed in m/s.
template <class T>
SimilarityNumbers<T> similarity_of(ContactShape shape, const detail::SceneNumbers<T>& scene,
                                   const T& speed) {
  return similarity_numbers(speed, scene.viscosity, scene.pressure_viscosity,
                            load_of_film(shape, scene), scene.effective_modulus, scene.radius_x);
}

// R_y/R_x of a point contact.
template <class T>
T radius_ratio_of(ContactShape shape, const detail::SceneNumbers<T>& scene) {
  return shape == ContactShape::circle ? T(1) : T(scene.across / scene.radius_x);
}

// The regime of a scene's contact: of a point on Hamrock's map, of a line on Moes'.
template <class T>
LubricationRegime regime_of(ContactShape shape, const detail::SceneNumbers<T>& scene,
                            const SimilarityNumbers<T>& numbers) {
  if (shape == ContactShape::line) return line_regime(moes_numbers(numbers, true));
  return point_regime(regime_numbers(numbers), radius_ratio_of(shape, scene), scene.ellipticity);
}

// The regime that a film law of fixed exponents was fitted to. All such laws that scenes name are
// for elastic bodies; where the exponent of G is 0, the viscosity of the liquid does not rise with
// pressure. A law without fixed exponents holds in all regimes and gives piezoviscous_elastic here.
constexpr LubricationRegime regime_of(const FilmLaw& law) {
  return law.material_exponent.p == 0 ? LubricationRegime::isoviscous_elastic
                                      : LubricationRegime::piezoviscous_elastic;
}

// Films of two regimes that differ by no more than this factor are alike: formulas scatter by as
// much, next to a border of the maps.
inline constexpr double greatest_factor_of_regimes = 1.2;

// The greater of the films of two regimes at these numbers over the lesser one, on the map of the
// contact's shape; 1 where both regimes are the same.
template <class T>
T factor_between(LubricationRegime one, LubricationRegime other, ContactShape shape,
                 const detail::SceneNumbers<T>& scene, const SimilarityNumbers<T>& numbers) {
  if (one == other) return T(1);
  const auto film = [&](LubricationRegime regime) {
    const auto place = static_cast<std::size_t>(regime);
    if (shape == ContactShape::line) {
      const MoesNumbers<T> moes = moes_numbers(numbers, true);
      const MoesFilms<T> films = moes_films(moes.load, moes.material);
      return std::array{films.rigid, films.rigid_piezoviscous, films.elastic,
                        films.elastic_piezoviscous}[place];
    }
    const RegimeNumbers<T> map = regime_numbers(numbers);
    return regime_film(regime_formulas[place], map.viscosity, map.elasticity,
                       radius_ratio_of(shape, scene), scene.ellipticity);
  };
  const T factor = film(one) / film(other);
  return factor < 1 ? T(1 / factor) : factor;
}

}  // namespace tribo
