// SPDX-License-Identifier: Apache-2.0
// Random contacts for the survey and for its sample in the tests. The line contacts have liquids
// with realistic numbers, the point contacts Barus liquids.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "ehl/line_contact.hpp"
#include "ehl/point_film.hpp"

namespace tribo::verification {

// Numbers that a seed alone determines.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  double part() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low * std::pow(high / low, part()); }

 private:
  std::mt19937_64 random_;
};

struct SampledContact {
  ehl::LineContact contact;
  bool is_roelands, is_compressible;
};

// Line contacts. M is 1 to 1000, drawn evenly in its logarithm, and L is 0 to 25. A liquid is
// Roelands' with probability 1/2, and compressible with probability 1/2. M and L fix only αp₀.
// Therefore p₀ is drawn from the part of 0.2 to 3 GPa where α is 5 to 40 /GPa. If there is no such
// part, p₀ is the nearer end. At 3 GPa α may then be up to 59 /GPa, where Roelands' z is 1.2 for a
// viscosity of 1 Pa·s. Where α would be greater, it stays 59 /GPa, and p₀ is more than 3 GPa. η₀ is
// drawn from the part of 1e-3 to 1 Pa·s where z is at most 1.2.
class ContactSampler : Draws {
 public:
  using Draws::Draws;

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
};

struct SampledPoint {
  ehl::PointContact contact;
  double supply;  // layer of liquid divided by the expected flooded film; 0: flooded
};

// Contacts with Barus liquids without compression. There are three kinds in turn. The first is a
// flooded circle (M from 5 to 2000, L from 0 to 15). The second is a flooded ellipse (M from 5 to
// 200, R_y/R_x from 1/4 to 8, L from 0 to 15). The third is a circle behind a layer of 1/4 to 4
// times the film (M from 20 to 2000, L from 2.5 to 12.5). M, R_y/R_x and the layer are drawn evenly
// in their logarithms.
class PointSampler : Draws {
 public:
  using Draws::Draws;

  SampledPoint next() {
    const int kind = count_++ % 3;
    SampledPoint drawn{};
    if (kind < 2) {
      const double load_number = between(5, kind == 0 ? 2000 : 200), material_number = 15 * part();
      drawn.contact =
          ehl::barus_point(load_number, material_number, kind == 0 ? 1 : between(0.25, 8));
      return drawn;
    }
    const double load_number = between(20, 2000);
    drawn.contact = ehl::barus_point(load_number, 2.5 + 10 * part());
    drawn.supply = between(0.25, 4);
    drawn.contact.inlet_film = drawn.supply * ehl::expected_film(drawn.contact);
    return drawn;
  }

 private:
  int count_ = 0;
};

}  // namespace tribo::verification
