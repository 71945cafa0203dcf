// SPDX-License-Identifier: Apache-2.0
#include "ehl/line_conditions.hpp"

#include <cmath>

#include "tribo/contact_numbers.hpp"
#include "tribo/friction.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/liquids.hpp"

namespace tribo::ehl {

LineConditions conditions_of(const Scene& scene, double speed) {
  const detail::SceneNumbers<double> numbers = detail::numbers_of<double>(scene);
  return {.speed = speed,
          .viscosity = numbers.viscosity,
          .pressure_viscosity = numbers.pressure_viscosity,
          .load_per_length = numbers.load / numbers.across,
          .effective_modulus = numbers.effective_modulus,
          .radius = numbers.radius_x,
          .viscosity_law = scene.friction.viscosity == ViscosityLaw::roelands
                               ? ViscosityLaw::roelands
                               : ViscosityLaw::barus};
}

LineScale scale_of(const LineConditions& c) {
  const HertzLine<double> hertz = hertz_line(c.load_per_length, c.effective_modulus, c.radius);
  return {hertz.half_width, hertz.peak_pressure, hertz.half_width * (hertz.half_width / c.radius),
          c.viscosity * c.speed / (2 * c.effective_modulus * c.radius)};
}

LineContact contact_of(const LineConditions& c) {
  const LineScale scale = scale_of(c);
  const double root = std::sqrt(2 * scale.speed_number);
  const double load = c.load_per_length / (2 * c.effective_modulus * c.radius);
  LineContact contact{load / root,
                      2 * c.pressure_viscosity * c.effective_modulus * std::sqrt(root),
                      {.exponent = c.pressure_viscosity * scale.peak_pressure}};
  if (c.viscosity_law == ViscosityLaw::ambient)
    contact.material_number = contact.fluid.exponent = 0;
  // A liquid of constant viscosity has no z.
  if (c.viscosity_law == ViscosityLaw::roelands && contact.fluid.exponent > 0) {
    const double pressure = roelands_pressure<double>();
    contact.fluid.roelands_pressure = scale.peak_pressure / pressure;
    contact.fluid.roelands_index = c.pressure_viscosity * pressure /
                                   (std::log(c.viscosity) + roelands_log_viscosity<double>());
  }
  if (c.density_law == LineDensity::dowson_higginson)
    contact.fluid.density_pressure = scale.peak_pressure / dowson_higginson_pressure;
  return contact;
}

}  // namespace tribo::ehl
