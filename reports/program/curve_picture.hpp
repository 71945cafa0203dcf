// SPDX-License-Identifier: Apache-2.0
// The data of the picture that `tribocheck curve --picture` draws: curves of scenes over speed,
// with the onset of starvation, and measured points beside them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "measured_data.hpp"
#include "tribo/scene.hpp"

namespace tribo::cli {

inline constexpr std::size_t most_drawn_scenes = 6;  // so many can be told apart by colours

// The outputs that the picture shows: friction, film and the asperities' share, each if a scene
// asks for it, and every output that was measured.
std::vector<Output> drawn_outputs(const std::vector<Scene>& scenes,
                                  const std::vector<Comparison>& measured);

nlohmann::ordered_json curve_picture(const std::vector<Scene>& scenes,
                                     const std::vector<Comparison>& measured);

}  // namespace tribo::cli
