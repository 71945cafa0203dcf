// SPDX-License-Identifier: Apache-2.0
// The changes that the options of a command make in a scene, for the program and for the library of
// other languages. The prepare functions return why the scene cannot be taken, or an empty text if
// it can.
#pragma once

#include <string>
#include <string_view>

#include "film_case.hpp"
#include "tribo/scene.hpp"

namespace tribo::cli {

// Replaces the speeds of the scene by those of its Stribeck curve. A list is sorted, the least
// speed first; a range keeps its number of speeds, which are spaced evenly in their logarithm.
std::string prepare_curve(Scene& scene);

// Puts one speed in m/s (0 keeps the scene's own speeds) and the settings into a scene that was
// read with SceneUse::film.
std::string prepare_film(Scene& scene, double speed, const FilmSettings& settings);

// Whether FilmSettings::is_flooded changes a scene, and why it is refused where it changes none.
bool has_supply_of_film(const Scene& scene);
inline constexpr std::string_view no_supply_of_film =
    "leaves out the [supply] of circles and ellipses, and no scene here has one";

}  // namespace tribo::cli
