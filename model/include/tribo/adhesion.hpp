// SPDX-License-Identifier: Apache-2.0
// Adhesion of smooth elastic bodies at a point. Sources: K. L. Johnson, K. Kendall, A. D. Roberts:
// Surface energy and the contact of elastic solids. Proc. R. Soc. Lond. A 324 (1971) 301 (JKR, for
// soft bodies); B. V. Derjaguin, V. M. Muller, Yu. P. Toporov: Effect of contact deformations on
// the adhesion of particles. J. Colloid Interface Sci. 53 (1975) 314 (DMT, for hard ones).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract pull_off_contract{4, 0};
// Near the pull-off, digits cancel under the root.
inline constexpr Contract jkr_contract{6, 4};

enum class Adhesion : std::uint8_t { jkr, dmt };
inline constexpr auto adhesion_words = std::to_array<std::string_view>({"jkr", "dmt"});

// The tensile force that parts the bodies, in N, as a number above 0: (3/2)πwR by JKR, 2πwR by DMT.
// work_of_adhesion w > 0 in J/m², of both faces: γ₁ + γ₂ − γ₁₂; reduced_radius R > 0 in m; for a
// ball on a flat it is the radius of the ball. Error: pull_off_contract.
template <class T>
T pull_off_force(Adhesion theory, const T& work_of_adhesion, const T& reduced_radius) {
  const T force = pi<T>() * work_of_adhesion * reduced_radius;
  return theory == Adhesion::jkr ? T(3 * force / 2) : T(2 * force);
}

// Radius a in m of the circle of contact by JKR:
//   a³ = 3R/(4E*) · [F + 3πwR + √(6πwRF + (3πwR)²)].
// load F in N, below 0 where it pulls; effective_modulus E* > 0 in Pa; w and R as for
// pull_off_force(). Gives NaN where F pulls with more than (3/2)πwR, because the bodies have
// parted. Error: jkr_contract.
template <class T>
T jkr_radius(const T& load, const T& work_of_adhesion, const T& effective_modulus,
             const T& reduced_radius) {
  using std::sqrt;
  const T adhesive = 3 * pi<T>() * work_of_adhesion * reduced_radius;  // 3πwR
  const T margin = 2 * load + adhesive;
  if (!(margin >= 0)) return quiet_nan<T>();
  const T bracket = (load + adhesive) + sqrt(adhesive) * sqrt(margin);
  return cube_root(T(3 * (reduced_radius / effective_modulus) * bracket / 4));
}

}  // namespace tribo
