// SPDX-License-Identifier: Apache-2.0
// A single case of a sweep as a scene, which other commands read.
#pragma once

#include <cstdint>
#include <string>

#include "sweep/plan.hpp"

namespace tribo::sweep {

// The scene of a case in TOML, with the id "<scene>, case <number>". `number` counts as in `sweep
// show --cases`, and is below sweep.cases().
std::string case_scene(const SceneSweep& sweep, std::uint64_t number);

}  // namespace tribo::sweep
