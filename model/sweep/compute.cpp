// SPDX-License-Identifier: Apache-2.0
#include "sweep/compute.hpp"

#include <atomic>

#include "sweep/chunk_solver.hpp"
#include "sweep/on_threads.hpp"

namespace tribo::sweep {

int compute(const SweepPlan& plan, int threads, const NextChunk& next,
            const std::function<void(const Chunk&)>& keep, const std::function<bool()>& stopped) {
  std::atomic<bool> failed = false;
  // More threads than the machine has are allowed, as they are elsewhere.
  return on_threads(thread_count(threads), [&] {
    ChunkSolver solver(plan, [&] { return failed || (stopped && stopped()); });
    try {
      while (!failed) {
        const auto chunk = next();
        if (!chunk) return;
        keep(solver.solve(*chunk));
      }
    } catch (const Stopped&) {  // in the middle of a chunk, which is computed anew
    } catch (...) {
      failed = true;
      throw;
    }
  });
}

}  // namespace tribo::sweep
