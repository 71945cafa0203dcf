// SPDX-License-Identifier: Apache-2.0
#include "ehl/point_formulas.hpp"

#include <cmath>
#include <limits>

#include "tribo/film_thickness.hpp"

namespace tribo::ehl {

double film_thickness(const PointFormula& formula, const FilmConditions& c) {
  if (formula.law == nullptr) {
    // The formula has a limit at α = 0.
    const double pressure_viscosity =
        std::fmax(c.pressure_viscosity, std::numeric_limits<double>::min());
    return nijenbanning_venner_moes(c.speed, c.viscosity, pressure_viscosity, c.load,
                                    c.effective_modulus, c.radius, c.radius * c.radius_ratio,
                                    formula.exponent, formula.bracket);
  }
  if (c.pressure_viscosity == 0) return std::numeric_limits<double>::quiet_NaN();
  const double side =
      formula.takes_radii ? std::cbrt(c.radius_ratio * c.radius_ratio) : scale_of(c).ellipticity;
  return tribo::film_thickness(*formula.law, c.speed, c.viscosity, c.pressure_viscosity, c.load,
                               c.effective_modulus, c.radius, side);
}

}  // namespace tribo::ehl
