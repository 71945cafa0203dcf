// SPDX-License-Identifier: Apache-2.0
#include "ehl/film_conditions.hpp"

#include <cmath>

#include "tribo/contact_numbers.hpp"
#include "tribo/friction.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/liquids.hpp"

namespace tribo::ehl {
namespace {

// The liquid's numbers, with pressures over Hertz' peak pressure.
Fluid fluid_of(const FilmConditions& c, double peak_pressure) {
  Fluid fluid{.exponent = c.pressure_viscosity * peak_pressure};
  // A liquid of constant viscosity has no z.
  if (c.viscosity_law == ViscosityLaw::roelands && fluid.exponent > 0) {
    const double pressure = roelands_pressure<double>();
    fluid.roelands_pressure = peak_pressure / pressure;
    fluid.roelands_index = c.pressure_viscosity * pressure /
                           (std::log(c.viscosity) + roelands_log_viscosity<double>());
  }
  if (c.density_law == FilmDensity::dowson_higginson)
    fluid.density_pressure = peak_pressure / dowson_higginson_pressure;
  return fluid;
}

// L = G(2U)^{1/4}; `root` is √(2U).
double material_number_of(const FilmConditions& c, double root) {
  return 2 * c.pressure_viscosity * c.effective_modulus * std::sqrt(root);
}

}  // namespace

FilmConditions conditions_of(const Scene& scene, double speed) {
  const detail::SceneNumbers<double> numbers = detail::numbers_of<double>(scene);
  const ContactShape shape = scene.bodies.shape();
  FilmConditions conditions{.speed = speed,
                            .viscosity = numbers.viscosity,
                            .pressure_viscosity = numbers.pressure_viscosity,
                            .load = numbers.load,
                            .effective_modulus = numbers.effective_modulus,
                            .radius = numbers.radius_x,
                            .viscosity_law = scene.friction.viscosity == ViscosityLaw::roelands
                                                 ? ViscosityLaw::roelands
                                                 : ViscosityLaw::barus};
  if (shape == ContactShape::line) {
    conditions.load /= numbers.across;
    return conditions;
  }
  conditions.radius_ratio = shape == ContactShape::circle ? 1 : numbers.across / numbers.radius_x;
  const double supply = scene.supply.value;
  switch (scene.supply.kind) {
    case SupplyKind::flooded:
      break;
    case SupplyKind::inlet_film:
      conditions.inlet_film = supply;
      break;
    case SupplyKind::inlet_film_ratio:
      conditions.inlet_film = supply * numbers.summit_height_sd;
      break;
    case SupplyKind::inlet_flow:
      conditions.inlet_film = supply / speed;
      break;
  }
  return conditions;
}

FilmScale scale_of(const FilmConditions& c) {
  const double speed_number = c.viscosity * c.speed / (2 * c.effective_modulus * c.radius);
  if (c.is_line()) {
    const HertzLine<double> hertz = hertz_line(c.load, c.effective_modulus, c.radius);
    return {hertz.half_width, hertz.peak_pressure, hertz.half_width * (hertz.half_width / c.radius),
            speed_number, c.radius_ratio};
  }
  const HertzEllipse<double> hertz =
      hertz_ellipse(c.load, c.effective_modulus, c.radius, c.radius_ratio * c.radius);
  return {hertz.semi_axis_x, hertz.peak_pressure,
          hertz.semi_axis_x * (hertz.semi_axis_x / c.radius), speed_number, hertz.ellipticity};
}

LineContact contact_of(const FilmConditions& c) {
  const FilmScale scale = scale_of(c);
  const double root = std::sqrt(2 * scale.speed_number);
  const double load = c.load / (2 * c.effective_modulus * c.radius);
  return {load / root, material_number_of(c, root), fluid_of(c, scale.peak_pressure)};
}

PointContact point_contact_of(const FilmConditions& c) {
  const FilmScale scale = scale_of(c);
  const double root = std::sqrt(2 * scale.speed_number);
  const double load = c.load / (2 * c.effective_modulus * c.radius) / c.radius;
  return {load / root / std::sqrt(root), material_number_of(c, root), c.radius_ratio,
          fluid_of(c, scale.peak_pressure), c.inlet_film / scale.film};
}

}  // namespace tribo::ehl
