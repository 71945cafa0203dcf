// SPDX-License-Identifier: Apache-2.0
#include "ehl/line_formulas.hpp"

#include <cmath>
#include <limits>

#include "tribo/film_thickness.hpp"
#include "tribo/moes_line.hpp"

namespace tribo::ehl {

std::string_view name(FitLiquid liquid) {
  constexpr auto names = std::to_array<std::string_view>(
      {"unknown", "barus, incompressible", "roelands, compressible"});
  return names[static_cast<std::size_t>(liquid)];
}

double film_number(const LineFormula& formula, double load_number, double material_number,
                   double speed_number) {
  // Moes' formula has a limit at L = 0; the others are powers of L.
  if (formula.law == nullptr)
    return moes_line_number(load_number, std::fmax(material_number, 1e-30));
  if (material_number == 0) return std::numeric_limits<double>::quiet_NaN();
  // A contact with these numbers: E* and R of 1, and so η₀u of 2U, F/L of 2M(2U)^{1/2} and α of
  // L(2U)^{−1/4}/2.
  const double root = std::sqrt(2 * speed_number);
  return line_film_thickness(*formula.law, 2 * speed_number, 1.,
                             material_number / std::sqrt(root) / 2, 2 * load_number * root, 1.,
                             1.) /
         root;
}

const Estimate& compared_film(const LineFormula& formula, const SolvedFilm& solved) {
  switch (formula.quantity) {
    case FilmQuantity::central:
      return solved.central;
    case FilmQuantity::minimum:
      return solved.minimum;
    case FilmQuantity::at_greatest_pressure:
      break;
  }
  return solved.at_greatest_pressure;
}

}  // namespace tribo::ehl
