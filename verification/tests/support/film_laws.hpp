// SPDX-License-Identifier: Apache-2.0
// Films of each law, computed by hand; and film laws other than the default one. These are a law of
// the minimum film, a law of soft bodies (a − b = 0.64), and made-up laws whose exponent a − b is
// the least (0.01) and the greatest (0.7) that load sharing takes, and a small one (0.05).
#pragma once

#include <array>

#include "tribo/film_thickness.hpp"

namespace tribo::verification {

// h₀ by hand, with the paper's Table 1 at 1 m/s, of a circle or of a line with 1e5 N/m.
struct FilmByHand {
  FilmFormula film;
  double nanometres;
};
inline constexpr FilmByHand films_of_table_one[] = {
    {FilmFormula::hamrock_dowson_central, 152.460},
    {FilmFormula::hamrock_dowson_minimum, 86.247},
    {FilmFormula::hamrock_dowson_soft_central, 48.624},
    {FilmFormula::hamrock_dowson_soft_minimum, 27.822},
    {FilmFormula::dowson_higginson_minimum, 165.939},
    {FilmFormula::dowson_toyoda_central, 216.688},
    {FilmFormula::pan_hamrock_minimum, 154.850},
    {FilmFormula::pan_hamrock_central, 178.321}};

constexpr FilmLaw law_with_exponents(Fraction speed, Fraction material) {
  return {{2, 1}, speed, material, {-7, 100}, {1, 2}, {7, 10}};
}
inline constexpr FilmLaw least_exponent_law = law_with_exponents({7, 10}, {69, 100});
inline constexpr FilmLaw small_exponent_law = law_with_exponents({13, 20}, {3, 5});
inline constexpr FilmLaw greatest_exponent_law = law_with_exponents({4, 5}, {1, 10});

inline constexpr std::array<const FilmLaw*, 5> other_film_laws{
    &hamrock_dowson_minimum_law, &hamrock_dowson_soft_central_law, &least_exponent_law,
    &small_exponent_law, &greatest_exponent_law};
static_assert(least_exponent_law.sharing_power.value == 0.01 &&
              small_exponent_law.sharing_power.value == 0.05 &&
              greatest_exponent_law.sharing_power.value == 0.7);
static_assert(is_law_of_load_sharing(least_exponent_law) &&
              is_law_of_load_sharing(greatest_exponent_law));

}  // namespace tribo::verification
