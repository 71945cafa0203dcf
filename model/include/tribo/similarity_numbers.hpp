// SPDX-License-Identifier: Apache-2.0
// Dimensionless numbers of a contact, and the regime of lubrication that follows from them
// (model/README.md, section 5).
//
// Sources. U, G and W: B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of point
// contacts, part III. J. Lubr. Technol. 99 (1977) 264. g_V and g_E: B. J. Hamrock, D. Dowson:
// Minimum film thickness in elliptical contacts for different regimes of fluid-film lubrication.
// NASA TP-1342 (1978). The map of points: B. J. Hamrock: Fundamentals of Fluid Film Lubrication.
// NASA RP-1255 (1991); M. Esfahanian, B. J. Hamrock: Fluid-film lubrication regimes revisited.
// Tribol. Trans. 34 (1991) 628. M and L, and the map of lines: H. Moes: Optimum similarity analysis
// with applications to elastohydrodynamic lubrication. Wear 159 (1992) 57; of points: C. H. Venner,
// A. A. Lubrecht: Multilevel Methods in Lubrication. Elsevier (2000), chapter 1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tribo/film_regimes.hpp"
#include "tribo/moes_line.hpp"
#include "tribo/real.hpp"

namespace tribo {

// U = η₀u/(E_HD R), G = αE_HD and W = F/(E_HD R²), with E_HD = 2E* and R = R_x.
template <class T>
struct SimilarityNumbers {
  T speed;     // U
  T material;  // G
  T load;      // W
};

// speed u in m/s (entrainment, the mean of the two surfaces), viscosity η₀ in Pa·s,
// pressure_viscosity α in 1/Pa, load F in N, of a line F R/L, effective_modulus E* in Pa,
// reduced_radius R_x in m; all > 0, α may be 0. Error: 4 ulp; overflow gives ∞, underflow 0.
template <class T>
SimilarityNumbers<T> similarity_numbers(const T& speed, const T& viscosity,
                                        const T& pressure_viscosity, const T& load,
                                        const T& effective_modulus, const T& reduced_radius) {
  const T modulus = 2 * effective_modulus;
  return {T(viscosity * speed / (modulus * reduced_radius)), T(pressure_viscosity * modulus),
          T(load / (modulus * reduced_radius * reduced_radius))};
}

// Moes' numbers: M of the load and L of the material. L is G (2U)^{1/4}; M is W (2U)^{−3/4} for a
// point, and W (2U)^{−1/2} for a line. 2U is U with the sum of the speeds of both surfaces.
template <class T>
struct MoesNumbers {
  T load;      // M
  T material;  // L
};

// numbers: U, G and W, all > 0, G may be 0. Error: 6 ulp; overflow gives ∞, underflow 0.
template <class T>
MoesNumbers<T> moes_numbers(const SimilarityNumbers<T>& numbers, bool is_line) {
  using std::sqrt;
  const T root = sqrt(T(2 * numbers.speed)), fourth_root = sqrt(root);
  return {T(is_line ? T(numbers.load / root) : T(numbers.load / root / fourth_root)),
          T(numbers.material * fourth_root)};
}

// g_V = G W³/U² and g_E = W^{8/3}/U² of point contacts (film_regimes.hpp).
template <class T>
struct RegimeNumbers {
  T viscosity;   // g_V
  T elasticity;  // g_E
};

// numbers: as for moes_numbers(). Error: 8 ulp; overflow gives ∞, underflow 0.
template <class T>
RegimeNumbers<T> regime_numbers(const SimilarityNumbers<T>& numbers) {
  const T load_over_speed = numbers.load / numbers.speed;
  const T common = load_over_speed * load_over_speed;
  return {T(numbers.material * numbers.load * common),
          T(common * decimal_power(numbers.load, Fraction{2, 3}))};
}

// A regime says whether the bodies stay rigid or are flattened, and whether pressure thickens the
// liquid.
enum class LubricationRegime : std::uint8_t {
  isoviscous_rigid,
  piezoviscous_rigid,
  isoviscous_elastic,
  piezoviscous_elastic
};
inline constexpr auto lubrication_regime_words = std::to_array<std::string_view>(
    {"isoviscous_rigid", "piezoviscous_rigid", "isoviscous_elastic", "piezoviscous_elastic"});

constexpr std::string_view name(LubricationRegime regime) {
  return lubrication_regime_words[static_cast<std::size_t>(regime)];
}

// The film of a point contact in each regime, in the order of LubricationRegime.
inline constexpr std::array regime_formulas{
    FilmRegime::isoviscous_rigid, FilmRegime::viscous_rigid_roelands,
    FilmRegime::isoviscous_elastic, FilmRegime::viscous_elastic};

// The regime of a point contact on Hamrock's map: the one whose film by regime_film() is the
// thickest. Rigid bodies have Roelands' law; by Barus' law, as on the map of 1978, steel balls in
// oil would be rigid from some 1 GPa on. radius_ratio α = R_y/R_x and ellipticity k of the
// contact's ellipse, both > 0. On a border of the map two films are alike, and rounding may choose
// either.
template <class T>
LubricationRegime point_regime(const RegimeNumbers<T>& numbers, const T& radius_ratio,
                               const T& ellipticity) {
  std::size_t thickest = 0;
  T most{};
  for (std::size_t i = 0; i < regime_formulas.size(); ++i) {
    const T film = regime_film(regime_formulas[i], numbers.viscosity, numbers.elasticity,
                               radius_ratio, ellipticity);
    if (!(film > most)) continue;
    most = film;
    thickest = i;
  }
  return static_cast<LubricationRegime>(thickest);
}

// The regime of a line contact on Moes' map. The films RI, EI, RP and EP are those of
// moes_line.hpp: the film is the thicker one of max(RI, EI) and min(RP, EP). M > 0; L may be 0. On
// a border of the map rounding may choose either side.
template <class T>
LubricationRegime line_regime(const MoesNumbers<T>& numbers) {
  const MoesFilms<T> films = moes_films(numbers.load, numbers.material);
  const bool is_rigid = films.rigid > films.elastic;
  const bool is_rigid_if_thick = films.rigid_piezoviscous < films.elastic_piezoviscous;
  const T& isoviscous = is_rigid ? films.rigid : films.elastic;
  const T& piezoviscous = is_rigid_if_thick ? films.rigid_piezoviscous : films.elastic_piezoviscous;
  if (isoviscous >= piezoviscous)
    return is_rigid ? LubricationRegime::isoviscous_rigid : LubricationRegime::isoviscous_elastic;
  return is_rigid_if_thick ? LubricationRegime::piezoviscous_rigid
                           : LubricationRegime::piezoviscous_elastic;
}

}  // namespace tribo
