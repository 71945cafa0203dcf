// SPDX-License-Identifier: Apache-2.0
// Film laws of a fully flooded, smooth contact. Regressions (film_thickness.hpp) are rows of
// numbers. The laws without fixed exponents (moes_film.hpp) are two that join limits, and the films
// that were solved.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "tribo/real.hpp"

namespace tribo {

enum class FilmForm : std::uint8_t {
  power,                     // C U^a G^b W^c (1 − m e^{−nk})
  moes_line,                 // moes_line.hpp
  nijenbanning_venner_moes,  // nijenbanning_venner_moes.hpp, the default reading
  solved,                    // solved_films.hpp, the central film
  solved_minimum             // the least film, by the same tables
};

// A row of numbers, and the exponents that follow from it. A law without fixed exponents has no
// constant, and has the exponents of a typical elastic contact, from which searches start. Contacts
// keep the address of their law, which must outlive them. Therefore laws are constants.
struct FilmLaw {
  Fraction constant;               // C
  Fraction speed_exponent;         // a, of U
  Fraction material_exponent;      // b, of G
  Fraction load_exponent;          // c, of W
  Fraction side_leakage = {0, 1};  // m; 0: the constant does not depend on k
  Fraction side_decay = {0, 1};    // n
  // The modulus E_HD in U, in G and in W divided by E*, and the speed in U divided by the mean of
  // the two speeds.
  int speed_modulus = 2;
  int material_modulus = 2;
  int load_modulus = 2;
  int speed_multiple = 1;
  bool is_of_lines = false;  // else of point contacts
  FilmForm form = FilmForm::power;
  // The range of ellipticities to which the law was fitted. It is 0 to ∞ if the source does not
  // tell the range.
  double least_ellipticity = 0, greatest_ellipticity = std::numeric_limits<double>::infinity();

  // a − b. The film of load sharing has E*/γ and F/γ with γ = 1/(1−A), so that U becomes γU, G
  // becomes G/γ, and W stays. This gives h = h₀ γ^{a−b}. For laws without fixed exponents the
  // number is an upper bound of d ln h/d ln γ.
  Fraction sharing_exponent = speed_exponent - material_exponent;
  // The two exponents in the form that the engine takes.
  Exponent speed_power = speed_exponent;
  Exponent sharing_power = sharing_exponent;

  constexpr bool has_fixed_exponents() const { return form == FilmForm::power; }
  constexpr bool is_solved() const {
    return form == FilmForm::solved || form == FilmForm::solved_minimum;
  }
  // Does it take a viscosity that does not rise with pressure?
  constexpr bool takes_constant_viscosity() const {
    return material_exponent.p == 0 || is_solved();
  }
};

// Central film (a − b = 0.14) and minimum film (a − b = 0.19) of Hamrock and Dowson: J. Lubr.
// Technol. 99 (1977) 264. Its abstract has k from 1 to 8.
inline constexpr FilmLaw hamrock_dowson_central_law{.constant = {269, 100},
                                                    .speed_exponent = {67, 100},
                                                    .material_exponent = {53, 100},
                                                    .load_exponent = {-67, 1000},
                                                    .side_leakage = {61, 100},
                                                    .side_decay = {73, 100},
                                                    .least_ellipticity = 1,
                                                    .greatest_ellipticity = 8};
inline constexpr FilmLaw hamrock_dowson_minimum_law{.constant = {363, 100},
                                                    .speed_exponent = {68, 100},
                                                    .material_exponent = {49, 100},
                                                    .load_exponent = {-73, 1000},
                                                    .side_leakage = {1, 1},
                                                    .side_decay = {68, 100},
                                                    .least_ellipticity = 1,
                                                    .greatest_ellipticity = 8};

// Films of soft bodies in liquids whose viscosity does not rise with pressure: B. J. Hamrock, D.
// Dowson: Elastohydrodynamic lubrication of elliptical contacts for materials of low elastic
// modulus, part I. J. Lubr. Technol. 100 (1978) 236. The range of k that they were fitted to is not
// known here.
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
// Central film: D. Dowson, S. Toyoda: A central film thickness formula for elastohydrodynamic line
// contacts. Proc. 5th Leeds–Lyon Symp. (1979) 60.
inline constexpr FilmLaw dowson_higginson_minimum_law{.constant = {265, 100},
                                                      .speed_exponent = {70, 100},
                                                      .material_exponent = {54, 100},
                                                      .load_exponent = {-13, 100},
                                                      .is_of_lines = true};
inline constexpr FilmLaw dowson_toyoda_central_law{.constant = {306, 100},
                                                   .speed_exponent = {69, 100},
                                                   .material_exponent = {56, 100},
                                                   .load_exponent = {-10, 100},
                                                   .is_of_lines = true};
// Both films of P. Pan, B. J. Hamrock: Simple formulas for performance parameters used in
// elastohydrodynamically lubricated line contacts. J. Tribol. 111 (1989) 246.
inline constexpr FilmLaw pan_hamrock_minimum_law{.constant = {1714, 1000},
                                                 .speed_exponent = {694, 1000},
                                                 .material_exponent = {568, 1000},
                                                 .load_exponent = {-128, 1000},
                                                 .is_of_lines = true};
inline constexpr FilmLaw pan_hamrock_central_law{.constant = {2922, 1000},
                                                 .speed_exponent = {692, 1000},
                                                 .material_exponent = {470, 1000},
                                                 .load_exponent = {-166, 1000},
                                                 .is_of_lines = true};
// A. N. Grubin's film (1949), from A. M. Ertel's inlet. As a = b, load sharing leaves it as it is.
inline constexpr FilmLaw ertel_grubin_law{.constant = {195, 100},
                                          .speed_exponent = {8, 11},
                                          .material_exponent = {8, 11},
                                          .load_exponent = {-1, 11},
                                          .is_of_lines = true};

// Laws without fixed exponents.
namespace detail {
constexpr FilmLaw law_by(FilmForm form, bool is_of_lines) {
  return {.constant = {0, 1},
          .speed_exponent = {7, 10},
          .material_exponent = {56, 100},
          .load_exponent = {-1, 10},
          .is_of_lines = is_of_lines,
          .form = form,
          .sharing_exponent = {2, 1}};  // d ln h/d ln γ of rigid bodies; for lines it is 1
}
}  // namespace detail
inline constexpr FilmLaw moes_line_law = detail::law_by(FilmForm::moes_line, true);
inline constexpr FilmLaw nijenbanning_venner_moes_law =
    detail::law_by(FilmForm::nijenbanning_venner_moes, false);
inline constexpr FilmLaw solved_point_law = detail::law_by(FilmForm::solved, false);
inline constexpr FilmLaw solved_line_law = detail::law_by(FilmForm::solved, true);
inline constexpr FilmLaw solved_point_minimum_law = detail::law_by(FilmForm::solved_minimum, false);
inline constexpr FilmLaw solved_line_minimum_law = detail::law_by(FilmForm::solved_minimum, true);

// The laws that scenes name. A law has its row above, its value here and its word below. Messages,
// sweeps and the JSON Schema are made from these. Results of sweeps store a law by its place in
// this list, so that a new law must be the last one.
enum class FilmFormula : std::uint8_t {
  hamrock_dowson_central,
  hamrock_dowson_minimum,
  hamrock_dowson_soft_central,
  hamrock_dowson_soft_minimum,
  dowson_higginson_minimum,
  dowson_toyoda_central,
  pan_hamrock_minimum,
  pan_hamrock_central,
  ertel_grubin,
  moes_line,
  nijenbanning_venner_moes,
  solved
};
struct NamedFilmLaw {
  std::string_view word;
  const FilmLaw* law;
  const FilmLaw* law_of_lines = nullptr;  // where a word has a law of points and one of lines

  // The law of lines, or that of points. It is null if the word has no such law.
  constexpr const FilmLaw* of(bool is_line) const {
    if (is_line && law_of_lines != nullptr) return law_of_lines;
    return law->is_of_lines == is_line ? law : nullptr;
  }
};
// The laws stand in the order of FilmFormula.
inline constexpr auto named_film_laws = std::to_array<NamedFilmLaw>({
    {"hamrock_dowson_central", &hamrock_dowson_central_law},
    {"hamrock_dowson_minimum", &hamrock_dowson_minimum_law},
    {"hamrock_dowson_soft_central", &hamrock_dowson_soft_central_law},
    {"hamrock_dowson_soft_minimum", &hamrock_dowson_soft_minimum_law},
    {"dowson_higginson_minimum", &dowson_higginson_minimum_law},
    {"dowson_toyoda_central", &dowson_toyoda_central_law},
    {"pan_hamrock_minimum", &pan_hamrock_minimum_law},
    {"pan_hamrock_central", &pan_hamrock_central_law},
    {"ertel_grubin", &ertel_grubin_law},
    {"moes_line", &moes_line_law},
    {"nijenbanning_venner_moes", &nijenbanning_venner_moes_law},
    {"solved", &solved_point_law, &solved_line_law},
});
inline constexpr auto film_formula_words = [] {
  std::array<std::string_view, named_film_laws.size()> words;
  std::transform(named_film_laws.begin(), named_film_laws.end(), words.begin(),
                 [](const NamedFilmLaw& named) { return named.word; });
  return words;
}();

// The law of a word. If the word has two laws, it is the law of points.
constexpr const FilmLaw& film_law(FilmFormula formula) {
  return *named_film_laws[static_cast<std::size_t>(formula)].law;
}
// The law of a word for lines or for points. If the word has no such law, it is its only law.
constexpr const FilmLaw& film_law(FilmFormula formula, bool is_line) {
  const FilmLaw* const fitting = named_film_laws[static_cast<std::size_t>(formula)].of(is_line);
  return fitting == nullptr ? film_law(formula) : *fitting;
}

}  // namespace tribo
