// SPDX-License-Identifier: Apache-2.0
// Scenes in the words of tribocheck_plugin.h, and back.
#pragma once

#include <array>

#include "conformance/tribocheck_plugin.h"
#include "tribo/operating_point.hpp"
#include "tribo/scene.hpp"

namespace tribo::conformance {

// All of a scene but id, speeds and outputs.
tribocheck_scene plugin_scene(const Scene& scene);
Scene model_scene(const tribocheck_scene& scene);

// The outputs that a plug-in can offer as numbers, with their places in its point.
struct PluginNumber {
  Output output;
  double tribocheck_point::*place;
};
inline constexpr auto plugin_numbers = std::to_array<PluginNumber>({
    {Output::film_flooded, &tribocheck_point::film_flooded},
    {Output::film, &tribocheck_point::film},
    {Output::separation, &tribocheck_point::separation},
    {Output::film_parameter, &tribocheck_point::film_parameter},
    {Output::asperity_load_share, &tribocheck_point::asperity_load_share},
    {Output::fluid_load_share, &tribocheck_point::fluid_load_share},
    {Output::real_area_ratio, &tribocheck_point::real_area_ratio},
    {Output::summit_count, &tribocheck_point::summit_count},
    {Output::friction, &tribocheck_point::friction},
});

// A point before it is solved: nothing offered.
tribocheck_point empty_point();

}  // namespace tribo::conformance
