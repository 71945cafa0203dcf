// SPDX-License-Identifier: Apache-2.0
// Bulk modulus of an oil under pressure, from its density by D. Dowson, G. R. Higginson:
// Elasto-hydrodynamic Lubrication (1966).
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract oil_bulk_modulus_contract{6, 0};

// ρ dp/dρ = (5.9·10⁸ + 1.34p)(5.9·10⁸ + p)/(0.34 · 5.9·10⁸) in Pa, pressure p ≥ 0 in Pa. Error:
// oil_bulk_modulus_contract.
template <class T>
T oil_bulk_modulus(const T& pressure) {
  const T scale = T(590000000);
  return (scale + ratio<T>(134, 100) * pressure) *
         ((scale + pressure) / (ratio<T>(34, 100) * scale));
}

}  // namespace tribo
