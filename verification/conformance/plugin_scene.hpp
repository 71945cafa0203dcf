// SPDX-License-Identifier: Apache-2.0
// Converts scenes to the structures of tribocheck_plugin.h, and back.
#pragma once

#include <array>

#include "conformance/tribocheck_plugin.h"
#include "tribo/operating_point.hpp"
#include "tribo/scene.hpp"

namespace tribo::conformance {

// Both convert a circle with the default film law, without id, speeds and outputs.
tribocheck_scene plugin_scene(const Scene& scene);
Scene model_scene(const tribocheck_scene& scene);

// The numbers of a plug-in's point, in the order of Output.
inline constexpr auto plugin_numbers = std::to_array<double tribocheck_point::*>({
    &tribocheck_point::film_flooded,
    &tribocheck_point::film,
    &tribocheck_point::separation,
    &tribocheck_point::film_parameter,
    &tribocheck_point::asperity_load_share,
    &tribocheck_point::fluid_load_share,
    &tribocheck_point::real_area_ratio,
    &tribocheck_point::summit_count,
    &tribocheck_point::friction,
});
static_assert(plugin_numbers.size() == number_count);

// A point before it is solved: no number and no code is offered.
tribocheck_point empty_point();

}  // namespace tribo::conformance
