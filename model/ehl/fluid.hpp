// SPDX-License-Identifier: Apache-2.0
// The liquid between the bodies, as functions of P = p/p₀.
#pragma once

#include <cmath>

namespace tribo::ehl {

struct Fluid {
  double exponent = 0;           // ᾱ = αp₀: the slope of ln η̄ at P = 0
  double roelands_pressure = 0;  // p₀/196 MPa; 0: Barus, ln η̄ = ᾱP
  double roelands_index = 1;     // z: ln η̄ = ᾱ/(zκ)[(1 + κP)^z − 1]
  double density_pressure = 0;   // p₀/590 MPa; 0: incompressible. ρ̄ = (1 + 1.34κP)/(1 + κP)

  double log_viscosity(double p) const {
    if (roelands_pressure == 0) return exponent * p;
    const double grown = std::expm1(roelands_index * std::log1p(roelands_pressure * p));
    return exponent / (roelands_index * roelands_pressure) * grown;
  }
  double log_viscosity_slope(double p) const {
    if (roelands_pressure == 0) return exponent;
    return exponent * std::pow(1 + roelands_pressure * p, roelands_index - 1);
  }
  double density(double p) const {
    return 1 + 0.34 * density_pressure * p / (1 + density_pressure * p);
  }
  double density_slope(double p) const {
    const double below = 1 + density_pressure * p;
    return 0.34 * density_pressure / (below * below);
  }
};

}  // namespace tribo::ehl
