// SPDX-License-Identifier: Apache-2.0
// Random line contacts with liquids that exist, for the survey and for its sample in the tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "ehl/line_contact.hpp"

namespace tribo::verification {

struct SampledContact {
  ehl::LineContact contact;
  bool is_roelands, is_compressible;
};

// M from 1 to 1000, evenly in its logarithm, L from 0 to 25; half of the liquids Roelands', half of
// them compressible. M and L fix αp₀ alone: p₀ is drawn from the part of 0.2 to 3 GPa that leaves α
// in 5 to 40 /GPa. Where no part does, p₀ is the nearer end, and α follows, up to 59 /GPa, with
// which Roelands' z is still 1.2 for a viscosity of 1 Pa·s; beyond, p₀ is more than 3 GPa. η₀ is
// drawn from the part of 1e-3 to 1 Pa·s that leaves z at most 1.2.
class ContactSampler {
 public:
  explicit ContactSampler(std::uint64_t seed) : random_(seed) {}

  SampledContact next() {
    const double load_number = between(1, 1000), material_number = 25 * part();
    SampledContact drawn{ehl::barus_contact(load_number, material_number), part() < 0.5,
                         part() < 0.5};
    ehl::Fluid& fluid = drawn.contact.fluid;
    constexpr double greatest_index = 1.2, scale = 196e6, log_scale = 9.67;
    const double low = std::max(0.2e9, fluid.exponent / 40e-9);
    const double high = std::min(3e9, fluid.exponent / 5e-9);
    const double place = part();
    double pressure = low * std::pow(high / low, place);
    if (low > high)
      pressure = fluid.exponent < 1
                     ? 0.2e9
                     : std::max(3e9, fluid.exponent * scale / (greatest_index * log_scale));
    const double rise = fluid.exponent / pressure * scale;  // z (ln η₀ + 9.67)
    const double least = std::clamp(std::exp(rise / greatest_index - log_scale), 1e-3, 1.);
    const double viscosity = between(least, 1);
    if (drawn.is_roelands) {
      fluid.roelands_pressure = pressure / scale;
      fluid.roelands_index = rise / (std::log(viscosity) + log_scale);
    }
    if (drawn.is_compressible) fluid.density_pressure = pressure / 5.9e8;
    return drawn;
  }

 private:
  double part() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low * std::pow(high / low, part()); }

  std::mt19937_64 random_;
};

}  // namespace tribo::verification
