// SPDX-License-Identifier: Apache-2.0
// Estimates time, memory and files of a sweep, from its plan and a few chunks computed for that.
#pragma once

#include "messages.hpp"
#include "sweep/plan.hpp"

namespace tribo::cli {

void append_estimate(Text& to, const sweep::SweepPlan& plan, int threads);

}  // namespace tribo::cli
