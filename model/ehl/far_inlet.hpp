// SPDX-License-Identifier: Apache-2.0
// The pressure far from a point contact, at the distance r. There the bodies keep their shape, the
// film grows with r² and the viscosity hardly rises, so that P = f(φ)/r³, φ the angle from the
// direction that the liquid comes from. With H = r²g(φ), g = (cos² φ + R_x/R_y sin² φ)/2,
//
//   (g³f′)′ − 9g³f = −λ̄ cos φ, f′(0) = 0, and f = f′ = 0 where the film breaks.
//
// f is the sum of P. L. Kapitza's λ̄ cos φ/((3 + 2R_x/R_y)g²) and a multiple of the solution of the
// homogeneous equation. For circles this solution is cosh 3φ, and the film breaks at 108.4°, where
// tan φ = −3 tanh 3φ. With this pressure at its edge, not 0, a grid may be far smaller. Source:
// P. L. Kapitza: Hydrodynamic theory of lubrication during rolling. Zh. Tekh. Fiz. 25 (1955) 747.
#pragma once

#include <vector>

#include "ehl/plane_grid.hpp"
#include "ehl/point_contact.hpp"

namespace tribo::ehl {

class FarInlet {
 public:
  explicit FarInlet(const PointContact& contact);

  // P at (x, y), y ≥ 0, where H = `film`. Viscosity follows Barus' law, because at the low
  // pressures far away all laws are alike.
  double pressure(double x, double y, double film) const;
  // ∬ P outside a grid, on both sides of Y = 0, for a film with H₀ = `separation`.
  double load_outside(const PlaneGrid& grid, double separation) const;
  // φ where the film breaks.
  double break_angle() const { return break_angle_; }

 private:
  static constexpr int angles = 4000;  // steps of half a turn

  double curvature_ratio_;  // R_x/R_y
  double exponent_, deflection_of_load_;
  double break_angle_ = 0;
  std::vector<double> shape_;  // f g² at equal angles from 0 to the break
};

}  // namespace tribo::ehl
