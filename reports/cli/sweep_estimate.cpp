// SPDX-License-Identifier: Apache-2.0
#include "sweep_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "sweep/chunk_solver.hpp"
#include "sweep/compute.hpp"

namespace tribo::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Sample {
  double seconds = 0;       // a chunk, on one thread
  double kept_bytes = 0;    // a chunk, of points
  double record_bytes = 0;  // a chunk, in the journal
};

// Chunks from all over a scene, for a quarter of a second or two of them, whichever is more.
Sample sample_of(const sweep::SweepPlan& plan, std::uint64_t first, std::uint64_t chunks) {
  sweep::ChunkSolver solver(plan);
  solver.solve(first);  // what is made once is not counted
  const Clock::time_point start = Clock::now();
  Sample sum;
  int count = 0;
  for (const std::uint64_t i : {1, 5, 3, 7, 2, 6, 4}) {
    const sweep::Chunk chunk = solver.solve(first + i * (chunks - 1) / 8);
    for (const sweep::PackedValues& values : chunk.values)
      sum.kept_bytes += static_cast<double>(values.bytes.size());
    sum.record_bytes += static_cast<double>(chunk.bytes().size());
    ++count;
    if (count >= 2 && Clock::now() - start > std::chrono::milliseconds(250)) break;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return {seconds / count, sum.kept_bytes / count, sum.record_bytes / count};
}

std::string bytes_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
  if (bytes < 1e9) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} GB", bytes / 1e9);
}
std::string time_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.2g} min", seconds / 60);
  if (seconds < 2e5) return fmt::format("{:.2g} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86400);
}

}  // namespace

void append_estimate(Text& to, const sweep::SweepPlan& plan, int threads) {
  const int count = sweep::thread_count(threads);
  double seconds = 0, file = 0, journal = 0, memory = 0, points = 0, first = 0;
  for (const sweep::SceneSweep& scene : plan.scenes) {
    const Sample sample = sample_of(plan, static_cast<std::uint64_t>(first), scene.chunks);
    const auto chunks = static_cast<double>(scene.chunks);
    first += chunks;
    seconds += sample.seconds * chunks / std::min<double>(count, chunks);
    file += sample.kept_bytes * chunks + 20e3 * static_cast<double>(scene.width());
    journal += sample.record_bytes * chunks;
    // Each thread has a chunk as numbers, packed and as a record.
    const double numbers = static_cast<double>(scene.keep_points ? scene.chunk_cases() : 0) *
                           static_cast<double>(scene.width() + scene.variables.size());
    memory = std::max(memory, 8 * numbers + sample.kept_bytes + 2 * sample.record_bytes);
    points += static_cast<double>(scene.points());
    append(to, fmt::format("{}: {} cases in the result, {:.4g} points to compute, {:.3g} µs each\n",
                           scene.scene.id, scene.cases(), static_cast<double>(scene.points()),
                           1e6 * sample.seconds * chunks / static_cast<double>(scene.points())));
  }
  append(to, fmt::format("points {:.4g}, chunks {}\n", points, plan.chunks()));
  append(to, fmt::format("time   {} on {} {}\n", time_text(seconds), count,
                         count == 1 ? "thread" : "threads"));
  append(to, fmt::format("memory {}\n", bytes_text(30e6 + count * memory)));
  append(to, fmt::format("file   {}, and a journal of {} until it is done\n", bytes_text(file),
                         bytes_text(journal)));
}

}  // namespace tribo::cli
