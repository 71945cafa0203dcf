// SPDX-License-Identifier: Apache-2.0
#include "conformance/plugin_scene.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "conformance/serve.hpp"

namespace tribo::conformance {
namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

// A code of the header is the place in the enumeration.
template <class Enum>
constexpr bool is_code_of(Enum word, int code) {
  return static_cast<int>(word) == code;
}
static_assert(is_code_of(AsperityModel::greenwood_tripp, TRIBOCHECK_GREENWOOD_TRIPP));
static_assert(is_code_of(AsperityModel::greenwood_williamson, TRIBOCHECK_GREENWOOD_WILLIAMSON));
static_assert(is_code_of(StarvationClosure::flooded_inlet, TRIBOCHECK_FLOODED_INLET));
static_assert(is_code_of(StarvationClosure::starved_inlet, TRIBOCHECK_STARVED_INLET));
static_assert(is_code_of(StarvationClosure::printed_exponents, TRIBOCHECK_PRINTED_EXPONENTS));
static_assert(is_code_of(StarvationClosure::damiens, TRIBOCHECK_DAMIENS));
static_assert(is_code_of(SupplyKind::flooded, TRIBOCHECK_SUPPLY_FLOODED));
static_assert(is_code_of(SupplyKind::inlet_film, TRIBOCHECK_INLET_FILM));
static_assert(is_code_of(SupplyKind::inlet_film_ratio, TRIBOCHECK_INLET_FILM_RATIO));
static_assert(is_code_of(SupplyKind::inlet_flow, TRIBOCHECK_INLET_FLOW));
static_assert(is_code_of(FluidShear::eyring, TRIBOCHECK_EYRING));
static_assert(is_code_of(FluidShear::limiting, TRIBOCHECK_LIMITING));
static_assert(is_code_of(ViscosityLaw::barus, TRIBOCHECK_BARUS));
static_assert(is_code_of(ViscosityLaw::ambient, TRIBOCHECK_AMBIENT));
static_assert(is_code_of(ViscosityLaw::roelands, TRIBOCHECK_ROELANDS));

std::optional<double> given(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace

tribocheck_scene plugin_scene(const Scene& scene) {
  return {scene.load,
          scene.surface.summit_density,
          scene.surface.summit_radius,
          scene.surface.summit_height_sd,
          scene.surface.summit_plane_offset,
          scene.bodies.effective_modulus,
          scene.bodies.reduced_radius,
          scene.bodies.ellipticity,
          scene.lubricant.viscosity,
          scene.lubricant.pressure_viscosity,
          scene.lubricant.eyring_stress.value_or(not_given),
          scene.supply.value,
          scene.friction.boundary_coefficient.value_or(not_given),
          scene.friction.slide_roll_ratio,
          scene.closures.damiens_exponent,
          scene.surface.offset_planes,
          static_cast<int>(scene.supply.kind),
          static_cast<int>(scene.closures.asperity),
          static_cast<int>(scene.closures.starvation),
          static_cast<int>(scene.friction.fluid),
          static_cast<int>(scene.friction.viscosity)};
}

Scene model_scene(const tribocheck_scene& scene) {
  Scene result;
  result.load = scene.load;
  result.surface = {scene.summit_density, scene.summit_radius, scene.summit_height_sd,
                    scene.summit_plane_offset, scene.offset_planes};
  result.bodies = {scene.effective_modulus, scene.reduced_radius, scene.ellipticity};
  result.lubricant = {scene.viscosity, scene.pressure_viscosity, given(scene.eyring_stress)};
  result.supply = {static_cast<SupplyKind>(scene.supply), scene.supply_value};
  result.friction = {given(scene.boundary_coefficient), scene.slide_roll_ratio,
                     static_cast<FluidShear>(scene.fluid),
                     static_cast<ViscosityLaw>(scene.viscosity_law)};
  result.closures = {static_cast<AsperityModel>(scene.asperity),
                     static_cast<StarvationClosure>(scene.starvation), scene.damiens_exponent};
  return result;
}

tribocheck_point empty_point() {
  constexpr double none = not_offered;
  return {
      none, none, none, none, none, none, none, none, none, TRIBOCHECK_NO_CODE, TRIBOCHECK_NO_CODE};
}

}  // namespace tribo::conformance
