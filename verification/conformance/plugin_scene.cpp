// SPDX-License-Identifier: Apache-2.0
#include "conformance/plugin_scene.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "conformance/serve.hpp"

namespace tribo::conformance {
namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

// A code in tribocheck_plugin.h equals the value of the enumerator.
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

// Calls copy(theirs, ours) for each field of a tribocheck_scene and its counterpart in a Scene.
template <class Theirs, class Ours, class Copy>
void for_each_field(Theirs& theirs, Ours& ours, const Copy& copy) {
  copy(theirs.load, ours.load);
  copy(theirs.summit_density, ours.surface.summit_density);
  copy(theirs.summit_radius, ours.surface.summit_radius);
  copy(theirs.summit_height_sd, ours.surface.summit_height_sd);
  copy(theirs.summit_plane_offset, ours.surface.summit_plane_offset);
  copy(theirs.offset_planes, ours.surface.offset_planes);
  copy(theirs.effective_modulus, ours.bodies.effective_modulus);
  copy(theirs.reduced_radius, ours.bodies.reduced_radius);
  copy(theirs.ellipticity, ours.bodies.ellipticity);
  copy(theirs.viscosity, ours.lubricant.viscosity);
  copy(theirs.pressure_viscosity, ours.lubricant.pressure_viscosity);
  copy(theirs.eyring_stress, ours.lubricant.eyring_stress);
  copy(theirs.supply, ours.supply.kind);
  copy(theirs.supply_value, ours.supply.value);
  copy(theirs.boundary_coefficient, ours.friction.boundary_coefficient);
  copy(theirs.slide_roll_ratio, ours.friction.slide_roll_ratio);
  copy(theirs.fluid, ours.friction.fluid);
  copy(theirs.viscosity_law, ours.friction.viscosity);
  copy(theirs.asperity, ours.closures.asperity);
  copy(theirs.starvation, ours.closures.starvation);
  copy(theirs.damiens_exponent, ours.closures.damiens_exponent);
}

template <class Value>
constexpr bool may_be_absent = std::is_same_v<std::remove_cvref_t<Value>, std::optional<double>>;

}  // namespace

tribocheck_scene plugin_scene(const Scene& scene) {
  tribocheck_scene result;
  for_each_field(result, scene, [](auto& to, const auto& from) {
    if constexpr (may_be_absent<decltype(from)>)
      to = from.value_or(not_given);
    else
      to = static_cast<std::remove_reference_t<decltype(to)>>(from);
  });
  return result;
}

Scene model_scene(const tribocheck_scene& scene) {
  Scene result;
  for_each_field(scene, result, [](const auto& from, auto& to) {
    if constexpr (may_be_absent<decltype(to)>)
      to = std::isnan(from) ? std::nullopt : std::optional(from);
    else
      to = static_cast<std::remove_reference_t<decltype(to)>>(from);
  });
  return result;
}

tribocheck_point empty_point() {
  tribocheck_point point;
  for (const auto number : plugin_numbers) point.*number = not_offered;
  point.regime = point.inlet = TRIBOCHECK_NO_CODE;
  return point;
}

}  // namespace tribo::conformance
