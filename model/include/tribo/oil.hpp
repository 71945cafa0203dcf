// SPDX-License-Identifier: Apache-2.0
// The viscosity of an oil at its running temperature, from what its data sheet says. Sources: ASTM
// D341 (liquids.hpp) and ASTM D2270 (viscosity_index.hpp).
#pragma once

#include "tribo/liquids.hpp"
#include "tribo/scene.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo {

// The two kinematic viscosities of an oil: as given, or, for a grade, those at 40 and 100 °C. The
// one at 100 °C is 0 where no viscosity from 2 to 1000 mm²/s has the index.
inline std::array<KinematicViscosity, 2> viscosities_of(const Oil& oil) {
  if (!(oil.iso_vg > 0)) return oil.viscosities;
  const long double at_40 = static_cast<long double>(oil.iso_vg) / 1000000;
  const long double at_100 =
      viscosity_at_100_celsius(at_40, static_cast<long double>(oil.viscosity_index));
  return {{{lower_index_temperature, static_cast<double>(at_40)},
           {upper_index_temperature, at_100 > 0 ? static_cast<double>(at_100) : 0}}};
}

// η₀ in Pa·s: ρ times the kinematic viscosity at the oil's temperature. Error: 4 ε times the
// condition of astm_d341_viscosity; for a grade each of the two viscosities is also rounded to
// double. NaN where the two viscosities give no line of ASTM D341.
template <class T>
T oil_viscosity(const Oil& oil) {
  const auto [first, second] = viscosities_of(oil);
  return T(oil.density) * astm_d341_viscosity(T(first.temperature), T(first.viscosity),
                                              T(second.temperature), T(second.viscosity),
                                              T(oil.temperature));
}

}  // namespace tribo
