// SPDX-License-Identifier: Apache-2.0
// A contact in SI units, and its conversion to numbers without units.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "ehl/line_contact.hpp"
#include "ehl/point_contact.hpp"
#include "tribo/scene.hpp"

namespace tribo::ehl {

enum class FilmDensity : std::uint8_t { incompressible, dowson_higginson };

// All > 0; pressure_viscosity may be 0.
struct FilmConditions {
  double speed;               // u, m/s: entrainment, the mean of the two surfaces
  double viscosity;           // η₀, Pa·s
  double pressure_viscosity;  // α, 1/Pa
  double load;                // F, N; of a line F/L, N/m
  double effective_modulus;   // E*, Pa (never 2E*)
  double radius;              // R_x, m
  ViscosityLaw viscosity_law = ViscosityLaw::barus;  // never ambient
  FilmDensity density_law = FilmDensity::incompressible;
  double radius_ratio = std::numeric_limits<double>::infinity();  // R_y/R_x; ∞ of a line
  double inlet_film = std::numeric_limits<double>::infinity();    // h_oil, m; ∞: flooded

  bool is_line() const { return std::isinf(radius_ratio); }
  bool is_starved() const { return std::isfinite(inlet_film); }
};

// Factors that turn X, P and H into SI units, and two numbers without units.
struct FilmScale {
  double half_width;     // b of a line, a_x of an ellipse, m
  double peak_pressure;  // p₀, Pa
  double film;           // b²/R or a_x²/R_x, m
  double speed_number;   // U = η₀u/(2E*R)
  double ellipticity;    // a_y/a_x; ∞ of a line
};

// The conditions of a scene at a speed. The law of viscosity is Roelands' where friction.viscosity
// is; else it is Barus', because `ambient` is meant for friction alone. Scenes name no law of
// density, so the default is used. A circle's bodies.ellipticity is not used, because only film
// laws need it. The inlet of a line is taken as flooded.
FilmConditions conditions_of(const Scene& scene, double speed);

FilmScale scale_of(const FilmConditions& conditions);
// M = W(2U)^{−1/2}, L = G(2U)^{1/4}; Roelands' z is α · 196 MPa/(ln η₀ + 9.67).
LineContact contact_of(const FilmConditions& conditions);
// The same for a circle or an ellipse, with M = W(2U)^{−3/4}.
PointContact point_contact_of(const FilmConditions& conditions);

}  // namespace tribo::ehl
