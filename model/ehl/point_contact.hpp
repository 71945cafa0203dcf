// SPDX-License-Identifier: Apache-2.0
// The smooth point contact on a film, without units: lengths over the semi-axis a_x of Hertz'
// ellipse along the direction of entrainment, X = x/a_x and Y = y/a_x; pressures over Hertz' peak
// p₀; films as H = hR_x/a_x². Then (model/README.md, section 13)
//
//   ∇·[ρ̄H³/(λ̄η̄) ∇P] = ∂(ρ̄H)/∂X where P > 0;  P ≥ 0;
//   H = H₀ + X²/2 + (R_x/R_y)Y²/2 + c ∬ P(X′, Y′)/√((X − X′)² + (Y − Y′)²) dX′dY′;  ∬ P = 2πk/3,
//
// steady, isothermal, Newtonian; k = a_y/a_x. A circle has λ̄ = 6π(3M/2)^{−4/3},
// c = 2/π² and ᾱ = αp₀ = L(3M/2)^{1/3}/π, with Moes' numbers M of load and L of material
// (similarity_numbers.hpp). Moes' film number is (h/R_x)(2U)^{−1/2}.
//
// A starved contact meets a layer of liquid of thickness H_oil far ahead. Θ is the part of the gap
// that is filled. Mass is conserved: P > 0 → Θ = 1; P = 0 → Θ ≤ 1 and ∂(Θρ̄H)/∂X = 0, and Θρ̄H =
// H_oil ahead of the meniscus. No liquid flows back into the track behind the contact.
//
// Sources: O. Reynolds: On the theory of lubrication. Phil. Trans. R. Soc. 177 (1886) 157; C. H.
// Venner, A. A. Lubrecht: Multilevel Methods in Lubrication. Elsevier (2000), chapter 6; of Θ: H.
// G. Elrod: A cavitation algorithm. J. Lubr. Technol. 103 (1981) 350.
#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include "ehl/fluid.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::ehl {

struct PointContact {
  double load_number = 1;                                       // M > 0
  double material_number = 0;                                   // L ≥ 0
  double radius_ratio = 1;                                      // R_y/R_x > 0
  Fluid fluid = {};                                             // its exponent is ᾱ
  double inlet_film = std::numeric_limits<double>::infinity();  // H_oil > 0; ∞: flooded
  // Liquid that is added at each node (X, Y), in the unit of PlaneBalance. Contacts have none. In
  // tests it gives the equations a known solution.
  std::function<double(double x, double y)> source = {};

  bool is_starved() const { return std::isfinite(inlet_film); }
};

// The numbers in the equations above.
struct PointNumbers {
  double ellipticity;        // k
  double wedge;              // λ̄
  double deflection;         // c
  double load;               // ∬ P
  double pressure_exponent;  // ᾱ of this M and L
  double film_number;        // the film number of H = 1
};

inline PointNumbers numbers_of(const PointContact& contact) {
  // The result does not depend on R_x, E* and 2U; they are taken as 1.
  const HertzEllipse<double> hertz =
      hertz_ellipse(2 * contact.load_number, 1., 1., contact.radius_ratio);
  const double axis = hertz.semi_axis_x, peak = hertz.peak_pressure;
  return {.ellipticity = hertz.ellipticity,
          .wedge = 12 / (axis * axis * axis * peak),
          .deflection = peak / (pi<double>() * axis),
          .load = 2 * pi<double>() / 3 * hertz.ellipticity,
          .pressure_exponent = contact.material_number / 2 * peak,
          .film_number = axis * axis};
}

// An incompressible Barus liquid between the bodies.
inline PointContact barus_point(double load_number, double material_number,
                                double radius_ratio = 1) {
  PointContact contact{load_number, material_number, radius_ratio};
  contact.fluid.exponent = numbers_of(contact).pressure_exponent;
  return contact;
}

}  // namespace tribo::ehl
