// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "conformance/point_mistake.hpp"
#include "tribo/friction.hpp"

namespace tribo::conformance {
namespace {

using Value = std::optional<double>;
using Point = OperatingPoint<double>;

Mistake viscosity_swapped(std::size_t asked, std::size_t given) {
  const std::string_view right = viscosity_law_words[asked], wrong = viscosity_law_words[given];
  return changed(fmt::format("viscosity-{}-for-{}", wrong, right),
                 fmt::format("the viscosity law `{}` where `{}` is asked for", wrong, right),
                 [=](Scene& s) {
                   if (s.friction.viscosity == static_cast<ViscosityLaw>(asked))
                     s.friction.viscosity = static_cast<ViscosityLaw>(given);
                 });
}
Mistake shear_swapped(std::size_t asked, std::size_t given) {
  const std::string_view right = fluid_shear_words[asked], wrong = fluid_shear_words[given];
  return changed(fmt::format("shear-{}-for-{}", wrong, right),
                 fmt::format("the shear law `{}` where `{}` is asked for", wrong, right),
                 [=](Scene& s) {
                   if (s.friction.fluid == static_cast<FluidShear>(asked))
                     s.friction.fluid = static_cast<FluidShear>(given);
                 });
}

// Roelands' law with the decimal logarithm of η₀ in place of the natural one.
Value with_decimal_logarithm(const Scene& s, const Point& p, double dry) {
  if (s.friction.viscosity != ViscosityLaw::roelands) return p.friction;
  const double pressure =
      p.fluid_load_share *
      hertz_point(s.load, s.bodies.effective_modulus, s.bodies.reduced_radius).mean_pressure;
  const double scale = std::log10(s.lubricant.viscosity) + roelands_log_viscosity<double>();
  const double z = s.lubricant.pressure_viscosity * roelands_pressure<double>() / scale;
  const double thickening = scale * (std::pow(1 + pressure / roelands_pressure<double>(), z) - 1);
  const double fluid_area = 1 - p.real_area_ratio;
  if (!(fluid_area > 0)) return dry;
  const double stress =
      fluid_shear_stress(s.friction.fluid, *s.lubricant.eyring_stress, s.lubricant.viscosity,
                         thickening, s.friction.slide_roll_ratio * p.speed, p.separation);
  return dry +
         stress * fluid_area /
             hertz_point(s.load, s.bodies.effective_modulus, s.bodies.reduced_radius).mean_pressure;
}

}  // namespace

std::vector<Mistake> friction_mistakes() {
  std::vector<Mistake> all{
      changed("slide-roll-ignored", "the slide-roll ratio taken as 1",
              [](Scene& s) { s.friction.slide_roll_ratio = 1; }),
      with_friction("viscosity-decimal-logarithm", "log₁₀ η₀ in place of ln η₀ in Roelands' law",
                    with_decimal_logarithm),
      with_friction(
          "friction-share-swapped", "μ_b times the fluid's share in place of the asperities'",
          [](const Scene& s, const Point& p, double dry) -> Value {
            return p.friction - dry + *s.friction.boundary_coefficient * p.fluid_load_share;
          }),
      with_friction("friction-boundary-unshared", "μ_b whole, in place of μ_b A",
                    [](const Scene& s, const Point& p, double dry) -> Value {
                      return p.friction - dry + *s.friction.boundary_coefficient;
                    }),
      with_friction("friction-fluid-missing", "μ_b A alone, without the film's shear",
                    [](const Scene&, const Point&, double dry) -> Value { return dry; }),
      with_friction(
          "friction-boundary-missing", "the film's shear alone, without μ_b A",
          [](const Scene&, const Point& p, double dry) -> Value { return p.friction - dry; }),
      with_friction("friction-area-not-subtracted",
                    "the film sheared over A_nom in place of A_nom − A_r",
                    [](const Scene&, const Point& p, double dry) -> Value {
                      const double fluid_area = 1 - p.real_area_ratio;
                      if (!(fluid_area > 1e-3)) return std::nullopt;
                      return dry + (p.friction - dry) / fluid_area;
                    })};
  for (std::size_t asked = 0; asked < 3; ++asked)
    for (std::size_t given = 0; given < 3; ++given)
      if (asked != given) all.push_back(viscosity_swapped(asked, given));
  all.push_back(shear_swapped(0, 1));
  all.push_back(shear_swapped(1, 0));
  return all;
}

}  // namespace tribo::conformance
