// SPDX-License-Identifier: Apache-2.0
#include "sweep/compute.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "sweep/chunk_solver.hpp"

namespace tribo::sweep {

int thread_count(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

void compute(const SweepPlan& plan, int threads, const NextChunk& next,
             const std::function<void(const Chunk&)>& keep) {
  const int count = thread_count(threads);
  std::atomic<bool> failed = false;
  const auto work = [&] {
    ChunkSolver solver(plan);
    try {
      while (!failed) {
        const auto chunk = next();
        if (!chunk) return;
        keep(solver.solve(*chunk));
      }
    } catch (...) {
      failed = true;
      throw;
    }
  };
  if (count == 1) return work();
  // More than the machine has are allowed, as they are elsewhere.
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute([&] {
    tbb::task_group group;
    for (int i = 1; i < count; ++i) group.run(work);
    group.run_and_wait(work);
  });
}

}  // namespace tribo::sweep
