// SPDX-License-Identifier: Apache-2.0
// Density of an oil under pressure over that at ambient pressure: D. Dowson, G. R. Higginson,
// Elasto-hydrodynamic Lubrication (1966).
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract oil_density_contract{4, 0};

// ρ/ρ₀ = (5.9·10⁸ + 1.34 p)/(5.9·10⁸ + p), pressure p ≥ 0 in Pa. Error: oil_density_contract.
template <class T>
T oil_density(const T& pressure) {
  const T scale = T(590000000);
  return (scale + ratio<T>(134, 100) * pressure) / (scale + pressure);
}

}  // namespace tribo
