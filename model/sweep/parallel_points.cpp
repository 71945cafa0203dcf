// SPDX-License-Identifier: Apache-2.0
#include "sweep/parallel_points.hpp"

#include <algorithm>
#include <cstddef>

#include "sweep/on_threads.hpp"

namespace tribo {
namespace {

// Points that take some tenths of a millisecond: long enough for a task, short enough to share.
constexpr std::size_t grain = 2048;

}  // namespace

void solve_in_parallel(const MixedContact<double>& contact, std::span<const double> speeds,
                       OutputSet outputs, OperatingPoints& points, int threads) {
  if (threads == 1 || speeds.size() <= grain) return solve(contact, speeds, outputs, points);
  each_on_threads(threads, (speeds.size() + grain - 1) / grain, [&](std::size_t part) {
    const std::size_t first = part * grain;
    solve(contact, speeds.subspan(first, std::min(grain, speeds.size() - first)), outputs, points,
          first);
  });
}

}  // namespace tribo
