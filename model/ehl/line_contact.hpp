// SPDX-License-Identifier: Apache-2.0
// The smooth line contact on a film, without units: lengths across the contact over Hertz'
// half-width b, X = x/b; pressures over Hertz' peak p₀; films as H = hR/b². Then (model/README.md,
// section 13)
//
//   d/dX[ρ̄H³/(θη̄) dP/dX] = d(ρ̄H)/dX where P > 0;  P ≥ 0;
//   H = H₀ + X²/2 − (1/π) ∫ P(X′) ln|X − X′| dX′;  ∫ P dX = π/2,
//
// steady, isothermal, Newtonian, fully flooded. θ = 3π²/(8M²), and ᾱ = αp₀ = L√M/√(2π), with the
// numbers of load M and of material L of moes_line.hpp. Moes' film number is 8M/π · H.
//
// Sources: O. Reynolds: On the theory of lubrication. Phil. Trans. R. Soc. 177 (1886) 157; where
// the film breaks, M. M. Kostreva: Elasto-hydrodynamic lubrication: a non-linear complementarity
// problem. Int. J. Numer. Methods Fluids 4 (1984) 377.
#pragma once

#include <cmath>
#include <numbers>

#include "ehl/fluid.hpp"

namespace tribo::ehl {

struct LineContact {
  double load_number = 1;      // M > 0
  double material_number = 0;  // L ≥ 0
  Fluid fluid = {};            // its exponent is ᾱ

  double theta() const {
    return 3 * std::numbers::pi * std::numbers::pi / (8 * load_number * load_number);
  }
  // The film number of a film H: (h/R)(2U)^{−1/2}.
  double film_number(double film) const { return 8 * load_number / std::numbers::pi * film; }
};

// αp₀ of Moes' two numbers.
inline double pressure_exponent(double load_number, double material_number) {
  return material_number * std::sqrt(load_number / (2 * std::numbers::pi));
}

// An incompressible Barus liquid between the bodies.
inline LineContact barus_contact(double load_number, double material_number) {
  return {load_number, material_number,
          Fluid{.exponent = pressure_exponent(load_number, material_number)}};
}

}  // namespace tribo::ehl
