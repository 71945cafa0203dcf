// SPDX-License-Identifier: Apache-2.0
// The arguments at which moments are timed and judged.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/errors.hpp"
#include "cases/measured.hpp"
#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {

// d spread evenly over (0, 6), in a seeded random order.
std::vector<double> moment_arguments(std::size_t count);

// The errors over the certified rows (reference/exact) of the contender's order with from < d < to,
// within the range that the contender claims.
Errors judge(const MomentContender& contender, double from = 0, double to = 6);

// Each contender at the job of its order.
std::vector<Measured> jobs_of(const std::vector<MomentContender>& contenders);

}  // namespace tribo::benchmarks
