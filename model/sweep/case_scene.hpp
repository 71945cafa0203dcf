// SPDX-License-Identifier: Apache-2.0
// A case of a sweep by itself, as a scene that other commands read.
#pragma once

#include <cstdint>
#include <string>

#include "sweep/plan.hpp"

namespace tribo::sweep {

// The scene of a case in TOML, with the id "<scene>, case <number>". `number`: as `sweep show
// --cases` counts, below sweep.cases().
std::string case_scene(const SceneSweep& sweep, std::uint64_t number);

}  // namespace tribo::sweep
