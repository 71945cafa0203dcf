// SPDX-License-Identifier: Apache-2.0
// How long it takes to ask for chunks: rank 0 only answers and the other ranks only ask; no rank
// computes. So few chunks are left that each answer holds one chunk, as in the last seconds of a
// sweep. Started by mpirun with two ranks or more; each rank prints one line with tabs.
#include "sweep/ranks.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <vector>

#include "sweep/chunk_queue.hpp"

namespace {

using Clock = std::chrono::steady_clock;

// A chunk that is there takes some tens of nanoseconds, one that has to be asked for much more.
constexpr double least_asked_seconds = 1e-6;
constexpr int rounds = 200;

double cpu_seconds_of_this_thread() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

int main() {
  const tribo::sweep::Ranks ranks;
  if (ranks.count() < 2) {
    std::fputs("tribocheck_bench_ranks: start it with mpirun -n 2 or more\n", stderr);
    return 2;
  }
  std::vector<double> asked;
  const auto ask_for_all = [&](const tribo::sweep::NextChunk& next) {
    if (ranks.rank() == 0) return;
    for (bool is_there = true; is_there;) {
      const auto before = Clock::now();
      is_there = next().has_value();
      const double seconds = std::chrono::duration<double>(Clock::now() - before).count();
      if (seconds >= least_asked_seconds) asked.push_back(seconds);
    }
  };
  // Messages of each rank but the first in a round: two chunks, one that no chunks are left, and
  // one that the rank leaves.
  const std::uint64_t chunks = 2 * (static_cast<std::uint64_t>(ranks.count()) - 1);
  const std::uint64_t messages = rounds * 2 * chunks;
  double wall = 0, cpu = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::uint64_t> pending(ranks.rank() == 0 ? chunks : 0);
    std::iota(pending.begin(), pending.end(), std::uint64_t{0});
    tribo::sweep::ChunkQueue queue(std::move(pending));
    ranks.everywhere(true);
    const auto start = Clock::now();
    const double cpu_before = cpu_seconds_of_this_thread();
    ranks.share(
        queue, ask_for_all, [](std::uint64_t) {}, [] { return false; });
    cpu += cpu_seconds_of_this_thread() - cpu_before;
    wall += std::chrono::duration<double>(Clock::now() - start).count();
  }
  std::fputs(ranks.rank() == 0
                 ? fmt::format("answered\t{}\t{:.9f}\t{:.9f}\n", messages, wall, cpu).c_str()
                 : fmt::format("asked\t{}\t{:.9f}\n", asked.size(), median(asked)).c_str(),
             stdout);
  return 0;
}
