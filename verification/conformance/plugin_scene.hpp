// SPDX-License-Identifier: Apache-2.0
// Scenes in the words of tribocheck_plugin.h, and back.
#pragma once

#include "conformance/tribocheck_plugin.h"
#include "tribo/scene.hpp"

namespace tribo::conformance {

// All but id, speeds and outputs.
tribocheck_scene plugin_scene(const Scene& scene);
Scene model_scene(const tribocheck_scene& scene);

// A point before it is solved: nothing offered.
tribocheck_point empty_point();

}  // namespace tribo::conformance
