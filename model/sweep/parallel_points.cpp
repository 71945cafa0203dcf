// SPDX-License-Identifier: Apache-2.0
#include "sweep/parallel_points.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace tribo {
namespace {

// Some tenths of a millisecond: long enough for a task, short enough to share out.
constexpr std::size_t grain = 2048;

}  // namespace

void solve_in_parallel(const MixedContact<double>& contact, std::span<const double> speeds,
                       OutputSet outputs, OperatingPoints& points, int threads) {
  if (threads == 1 || speeds.size() <= grain) return solve(contact, speeds, outputs, points);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, speeds.size(), grain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        solve(contact, speeds.subspan(range.begin(), range.size()), outputs, points,
                              range.begin());
                      });
  });
}

}  // namespace tribo
