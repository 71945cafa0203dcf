// SPDX-License-Identifier: Apache-2.0
#include "sweep_estimate.hpp"

#include <fmt/format.h>

#include <string>

#include "sweep/needs.hpp"
#include "sweep/on_threads.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

std::string time_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.2g} min", seconds / 60);
  if (seconds < 2e5) return fmt::format("{:.2g} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86400);
}

}  // namespace

void append_estimate(Text& to, const sweep::SweepPlan& plan, int threads) {
  const sweep::Needs needs = sweep::needs_of(plan, threads);
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    const sweep::SceneSweep& scene = plan.scenes[i];
    append_line(to,
                fmt::format("{}: {} cases in the result, {:.4g} points to compute, {:.3g} µs each",
                            scene.scene.id, scene.cases(), static_cast<double>(scene.points()),
                            1e6 * needs.point_seconds[i]));
  }
  const int count = thread_count(threads);
  append(to, fmt::format("points {:.4g}, chunks {}\n", static_cast<double>(plan.points()),
                         plan.chunks()));
  append(to, fmt::format("time   {} on {} {}\n", time_text(needs.seconds), count,
                         count == 1 ? "thread" : "threads"));
  append(to, fmt::format("memory {}\n", sweep::bytes_text(needs.memory)));
  append(to, fmt::format("file   {}, and parts of {} until it is done\n",
                         sweep::bytes_text(needs.file), sweep::bytes_text(needs.parts)));
}

}  // namespace tribo::cli
