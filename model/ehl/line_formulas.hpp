// SPDX-License-Identifier: Apache-2.0
// The films that printed formulas give for a line contact, as film numbers of M and L
// (moes_line.hpp), and the number of the solved film that each formula stands for.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ehl/solved_film.hpp"
#include "tribo/film_laws.hpp"

namespace tribo::ehl {

enum class FilmQuantity : std::uint8_t { central, minimum, at_greatest_pressure };

// The liquid of the films that a formula was fitted to, or derived for; unknown where no text at
// hand tells it. Two books of Hamrock's tell that Pan and Hamrock's liquid was compressible. The
// solved films tell that its viscosity followed Roelands: films of Roelands' law are nearer to Pan
// and Hamrock's formulas than films of Barus' law (held by test_film).
enum class FitLiquid : std::uint8_t { unknown, barus_incompressible, roelands_compressible };

struct LineFormula {
  std::string_view name;  // as in scenes and in the catalogue of functions
  std::string_view authors;
  FilmQuantity quantity;
  const FilmLaw* law;  // null: Moes' formula
  FitLiquid liquid;
};

inline constexpr auto line_formulas = std::to_array<LineFormula>({
    {"moes_line", "Moes", FilmQuantity::at_greatest_pressure, nullptr,
     FitLiquid::barus_incompressible},
    {"ertel_grubin", "Ertel and Grubin", FilmQuantity::at_greatest_pressure, &ertel_grubin_law,
     FitLiquid::barus_incompressible},
    {"dowson_higginson_minimum", "Dowson and Higginson", FilmQuantity::minimum,
     &dowson_higginson_minimum_law, FitLiquid::unknown},
    {"dowson_toyoda_central", "Dowson and Toyoda", FilmQuantity::central,
     &dowson_toyoda_central_law, FitLiquid::unknown},
    {"pan_hamrock_minimum", "Pan and Hamrock", FilmQuantity::minimum, &pan_hamrock_minimum_law,
     FitLiquid::roelands_compressible},
    {"pan_hamrock_central", "Pan and Hamrock", FilmQuantity::central, &pan_hamrock_central_law,
     FitLiquid::roelands_compressible},
});

// "unknown", "barus, incompressible" or "roelands, compressible".
std::string_view name(FitLiquid liquid);

// (h/R)(2U)^{−1/2} by a formula, at M > 0, L ≥ 0 (NaN where it has no film at L = 0) and the speed
// number U = η₀u/(2E*R): Pan and Hamrock's films contain U^−0.012 and U^−0.0085; the others do not
// depend on it.
double film_number(const LineFormula& formula, double load_number, double material_number,
                   double speed_number);

// The number of a solved film that a formula stands for: H of film_features.hpp.
const Estimate& compared_film(const LineFormula& formula, const SolvedFilm& solved);

}  // namespace tribo::ehl
