// SPDX-License-Identifier: Apache-2.0
#include "prepared_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tribo/friction.hpp"
#include "tribo/onset.hpp"

namespace tribo::cli {

std::string prepare_curve(Scene& scene) {
  const detail::SpeedSpan span = detail::speed_span(scene.speeds);
  if (!(span.low < span.high))
    return fmt::format(
        "speed: {} alone is no curve; allowed: a range, or a list of at least two different speeds",
        span.low);
  std::sort(scene.speeds.list.begin(), scene.speeds.list.end());
  scene.speeds.spacing = Spacing::log;
  return {};
}

bool has_supply_of_film(const Scene& scene) {
  return scene.supply.kind != SupplyKind::flooded && scene.bodies.shape() != ContactShape::line;
}

std::string prepare_film(Scene& scene, double speed, const FilmSettings& settings) {
  if (speed > 0) scene.speeds = {.list = {speed}};
  if (!settings.viscosity.empty())
    scene.friction.viscosity =
        settings.viscosity == "roelands" ? ViscosityLaw::roelands : ViscosityLaw::barus;
  if (settings.is_flooded) scene.supply = {};
  if (scene.speeds.empty())
    return "speed: missing; allowed: a number above 0, in m/s, a list or a range of such numbers, "
           "or the option speed in their place";
  if (scene.friction.viscosity == ViscosityLaw::roelands &&
      !(scene.lubricant.viscosity > least_roelands_viscosity))
    return fmt::format(
        "lubricant.viscosity: {} is not allowed with viscosity roelands; allowed: a number above "
        "{}, in Pa·s",
        scene.lubricant.viscosity, least_roelands_viscosity);
  if (scene.supply.kind == SupplyKind::inlet_film_ratio && scene.surface.is_smooth())
    return "supply.inlet_film_ratio: it is a ratio to σ_s, and without summits the bodies are "
           "smooth; allowed: inlet_film or inlet_flow, or the summits in a table surface";
  return {};
}

}  // namespace tribo::cli
