// SPDX-License-Identifier: Apache-2.0
// The operating points of one scene on several threads.
#pragma once

#include <span>

#include "tribo/operating_points.hpp"

namespace tribo {

// solve() of operating_points.hpp on at most `threads` threads, 0: as many as the machine has. The
// bits are the same for any number of threads.
void solve_in_parallel(const MixedContact<double>& contact, std::span<const double> speeds,
                       OutputSet outputs, OperatingPoints& points, int threads = 0);

}  // namespace tribo
