// SPDX-License-Identifier: Apache-2.0
// The operating points of one scene on several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "sweep/on_threads.hpp"
#include "tribo/operating_points.hpp"

namespace tribo {

// Calls solve() of operating_points.hpp on at most `threads` threads; 0 means as many as the
// machine has. The results have the same bits for any number of threads.
inline void solve_in_parallel(const MixedContact<double>& contact, std::span<const double> speeds,
                              OutputSet outputs, OperatingPoints& points, int threads = 0) {
  // So many points take some tenths of a millisecond: enough for a task, and not too many to share.
  constexpr std::size_t grain = 2048;
  if (threads == 1 || speeds.size() <= grain) return solve(contact, speeds, outputs, points);
  each_on_threads(threads, (speeds.size() + grain - 1) / grain, [&](std::size_t part) {
    const std::size_t first = part * grain;
    solve(contact, speeds.subspan(first, std::min(grain, speeds.size() - first)), outputs, points,
          first);
  });
}

}  // namespace tribo
