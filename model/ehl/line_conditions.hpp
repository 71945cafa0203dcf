// SPDX-License-Identifier: Apache-2.0
// A line contact in SI units, and its conversion to numbers without units.
#pragma once

#include <cstdint>

#include "ehl/line_contact.hpp"
#include "tribo/scene.hpp"

namespace tribo::ehl {

enum class LineDensity : std::uint8_t { incompressible, dowson_higginson };

// All > 0; pressure_viscosity may be 0.
struct LineConditions {
  double speed;               // u, m/s: entrainment, the mean of the two surfaces
  double viscosity;           // η₀, Pa·s
  double pressure_viscosity;  // α, 1/Pa
  double load_per_length;     // F/L, N/m
  double effective_modulus;   // E*, Pa (never 2E*)
  double radius;              // R_x, m
  ViscosityLaw viscosity_law = ViscosityLaw::barus;  // ambient: of constant viscosity
  LineDensity density_law = LineDensity::incompressible;
};

// Factors that turn H, P and X into SI units.
struct LineScale {
  double half_width;     // b, m
  double peak_pressure;  // p₀, Pa
  double film;           // b²/R, m
  double speed_number;   // U = η₀u/(2E*R)
};

// The conditions of a scene whose bodies make a line, at a speed. The law of viscosity is Roelands'
// where friction.viscosity is; else it is Barus', because `ambient` is meant for friction alone.
// Scenes name no law of density: the default holds.
LineConditions conditions_of(const Scene& scene, double speed);

LineScale scale_of(const LineConditions& conditions);
// M = W(2U)^{−1/2}, L = G(2U)^{1/4}; Roelands' z is that of α: z = α · 196 MPa/(ln η₀ + 9.67).
LineContact contact_of(const LineConditions& conditions);

}  // namespace tribo::ehl
