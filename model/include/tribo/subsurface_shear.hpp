// SPDX-License-Identifier: Apache-2.0
// Shear stress below a circular contact. Source: K. L. Johnson: Contact Mechanics (1985), section
// 3.4, equations 3.45.
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract subsurface_shear_contract{8, 4};

// The greatest shear stress |σ_z − σ_r|/2 in Pa on the axis below the circle of contact of Hertz,
// without friction. peak_pressure p₀ > 0 in Pa, radius a > 0 in m of the circle, depth z ≥ 0 in m,
// poisson_ratio ν of the body, above −1 and at most 1/2:
//   σ_r = −p₀[(1 + ν)(1 − ζ atan(1/ζ)) − q/2],  σ_z = −p₀q,  ζ = z/a,  q = 1/(1 + ζ²).
// On the axis it is greatest at 0.481a for ν = 0.3: 0.310p₀. Error: subsurface_shear_contract.
template <class T>
T subsurface_shear(const T& peak_pressure, const T& radius, const T& depth,
                   const T& poisson_ratio) {
  using std::atan;
  const T zeta = depth / radius;
  const T q = 1 / (1 + zeta * zeta);
  if (!(zeta > 1)) {
    const T rise = (1 + poisson_ratio) * atan(T(1 / zeta)) - 3 * zeta * q / 2;
    return peak_pressure * ((ratio<T>(1, 2) - poisson_ratio) + zeta * rise) / 2;
  }
  // 1 − ζ atan(1/ζ) as a sum of positive numbers: Σ qⁿ/(2n + 1) · (2·4···(2n − 2))/(3·5···(2n −
  // 1)).
  T term = q, arc = q / 3;
  for (int n = 2; term > epsilon<T>() * arc / 4; ++n) {
    term = term * q * (2 * n - 2) / (2 * n - 1);
    arc = arc + term / (2 * n + 1);
  }
  return peak_pressure * (3 * q / 2 - (1 + poisson_ratio) * arc) / 2;
}

}  // namespace tribo
