// SPDX-License-Identifier: Apache-2.0
// Dolan and Moré's performance profile (Math. Program. 91, 2002) of the root solvers: the fraction
// of cases that each solves to 1e-10 within τ times the best solver's time for that case.
#pragma once

#include <vector>

#include "contenders/root_contender.hpp"
#include "work_precision/effort.hpp"
#include "work_precision/table.hpp"

namespace tribo::benchmarks {

// Rows of solver, tau and fraction, over the certified cases of the wide job. The solvers are the
// contenders without SciPy and the batches, and then `others`.
Rows performance_profile(const Effort& effort, const std::vector<RootContender>& others = {});

}  // namespace tribo::benchmarks
