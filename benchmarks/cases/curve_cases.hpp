// SPDX-License-Identifier: Apache-2.0
// A Stribeck curve of the paper's rough surface: its scene, speeds, and the film in long double.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/errors.hpp"
#include "cases/measured.hpp"
#include "contenders/curve_contender.hpp"

namespace tribo::benchmarks {

// reference/published/rough.toml
const Scene& curve_scene();
// Log-spaced over the scene's range, ascending.
std::vector<double> curve_speeds(std::size_t count);

// The films of `count` points at the speeds that the contender has chosen, against the same model
// in long double.
Errors judge(const CurveContender& contender, std::size_t count = 200);

// Each contender at both jobs, curve_200 and points_1e6.
std::vector<Measured> jobs_of(const std::vector<CurveContender>& contenders);

}  // namespace tribo::benchmarks
