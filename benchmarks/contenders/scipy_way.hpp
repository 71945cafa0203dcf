// SPDX-License-Identifier: Apache-2.0
// SciPy's quad and fsolve in a Python process of their own, which times itself: its start costs
// nothing here.
#pragma once

#include <span>
#include <vector>

#include "contenders/moment_contender.hpp"
#include "contenders/root_contender.hpp"

namespace tribo::benchmarks {

std::vector<MomentContender> scipy_moments();
std::vector<RootContender> scipy_roots();

}  // namespace tribo::benchmarks
