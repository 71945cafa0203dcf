// SPDX-License-Identifier: Apache-2.0
// Two elastic bodies as one: the effective modulus, and the radii of the gap between two curved
// faces (model/README.md, section 3). Sources: H. Hertz: Über die Berührung fester elastischer
// Körper. J. reine angew. Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), sections
// 4.1 and 4.2. R of both directions together: B. J. Hamrock, D. Dowson: Isothermal
// elastohydrodynamic lubrication of point contacts, part I. J. Lubr. Technol. 98 (1976) 223.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

// Six roundings each, and nothing cancels.
inline constexpr Contract effective_modulus_contract{6, 0};
inline constexpr Contract reduced_radius_contract{6, 0};

// E* in Pa, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂; E′ of film formulas is 2E*. Young's moduli E above 0 in
// Pa, ∞ for a rigid body; Poisson's ratios ν above −1, at most 1/2. Error:
// effective_modulus_contract, for moduli of 1e-290 to 1e290; two rigid bodies give ∞.
template <class T>
T effective_modulus(const T& first_modulus, const T& first_poisson_ratio, const T& second_modulus,
                    const T& second_poisson_ratio) {
  // (1−ν)(1+ν), as 1−ν² cancels near ν = −1
  const auto compliance = [](const T& modulus, const T& poisson) {
    return T((1 - poisson) * (1 + poisson) / modulus);
  };
  return 1 / (compliance(first_modulus, first_poisson_ratio) +
              compliance(second_modulus, second_poisson_ratio));
}

// 1/(1/a + 1/b) in m, of two radii in m: above 0 convex, below 0 concave, ∞ flat. The result is 0
// or below, or infinite, where two such faces do not meet at a point. Error: 3 ulp, for radii of
// 1e-290 or more and results in the range of double.
//
// In the sum of two curvatures of opposite signs the rounding of each would remain. a + b has no
// such error, because a and b are exact.
template <class T>
T relative_radius(const T& a, const T& b) {
  using std::abs;
  const bool is_a_flatter = abs(a) > abs(b);
  const T& flatter = is_a_flatter ? a : b;
  const T& rounder = is_a_flatter ? b : a;
  if (2 * flatter == flatter) return rounder;  // ∞
  // The halves are exact, and their sum does not overflow. The quotient is 1/2 or more.
  return rounder * (flatter / 2 / (flatter / 2 + rounder / 2));
}

template <class T>
struct ReducedRadius {
  T radius_x;        // R_x, m: 1/R_x = 1/R₁x + 1/R₂x
  T radius_y;        // R_y, m
  T reduced_radius;  // R, m: 1/R = 1/R_x + 1/R_y; for a ball on a flat half the ball's radius
};

// Radii of two faces along x, the direction of entrainment, and along y across it, in m: above 0
// convex, below 0 concave, ∞ (or as large as 1e30) flat; not 0. Three NaN where the faces do not
// meet at a point: where 1/R_x or 1/R_y is not above 0. Error: reduced_radius_contract, for radii
// of 1e-290 or more, whatever cancels.
//
// hertz_point() and hamrock_dowson_central() are for R_x = R_y; their argument R is radius_x here,
// not reduced_radius.
template <class T>
ReducedRadius<T> reduced_radius(const T& first_radius_x, const T& second_radius_x,
                                const T& first_radius_y, const T& second_radius_y) {
  const T x = relative_radius(first_radius_x, second_radius_x);
  const T y = relative_radius(first_radius_y, second_radius_y);
  if (!(x > 0 && y > 0 && is_finite(x) && is_finite(y)))
    return {quiet_nan<T>(), quiet_nan<T>(), quiet_nan<T>()};
  return {x, y, relative_radius(x, y)};
}

}  // namespace tribo
