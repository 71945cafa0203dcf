// SPDX-License-Identifier: Apache-2.0
// What a sweep will take, from its plan and a few chunks that are computed for it.
#pragma once

#include "output.hpp"
#include "sweep/plan.hpp"

namespace tribo::cli {

void append_estimate(Text& to, const sweep::SweepPlan& plan, int threads);

}  // namespace tribo::cli
