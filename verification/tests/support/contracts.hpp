// SPDX-License-Identifier: Apache-2.0
// A contract (tribo/contract.hpp) as a bound for is_close.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/condition.hpp"
#include "support/judge.hpp"
#include "tribo/contract.hpp"

namespace tribo::verification {

// `multiple` times what a contract allows, relative to the expected value. One ulp is the spacing
// of doubles there.
inline double allowed_by(const Contract& contract, const Reference& expected, double condition,
                         double multiple) {
  if (expected == 0) return 0;
  const double value = std::abs(static_cast<double>(expected));
  const double ulp = std::ldexp(1.0, std::max(std::ilogb(value), -1022) - 52);
  return multiple * std::max(contract.ulp, contract.ulp_per_condition * condition) * ulp / value;
}

// The condition numbers of a scene's outputs at a speed.
inline Conditions conditions_at(const Scene& scene, double speed) {
  const MixedContact<long double> contact(scene);
  const FloodedFilm<long double> film = contact.flooded(static_cast<long double>(speed));
  const InletState<long double> inlet = contact.inlet(film);
  return operating_point_conditions(scene, contact, film, inlet,
                                    contact.complete(film, inlet, OutputSet::all()));
}

}  // namespace tribo::verification
