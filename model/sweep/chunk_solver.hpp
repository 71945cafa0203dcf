// SPDX-License-Identifier: Apache-2.0
// A solver of chunks, each given by its number. It makes the cases of a chunk, computes the
// columns, sums them up and packs the values that are kept.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sweep/chunk.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// A solver must not be used by two threads at once: each thread has a solver of its own. The plan
// must outlive the solver.
class ChunkSolver {
 public:
  // stopped() is asked many times a second while a chunk is solved; once it gives true, solve()
  // throws Stopped.
  explicit ChunkSolver(const SweepPlan& plan, std::function<bool()> stopped = {});
  ~ChunkSolver();

  // `number` is below plan.chunks(). The bits of a chunk depend on the plan and the arithmetic
  // alone, not on the machine, the threads or other chunks.
  Chunk solve(std::uint64_t number);

 private:
  struct OfScene;

  const SweepPlan& plan_;
  std::function<bool()> stopped_;
  std::vector<std::unique_ptr<OfScene>> scenes_;  // each one made for its first chunk
};

// Gives the number of the next chunk, or no value if no chunk is left. Any thread may call it.
using NextChunk = std::function<std::optional<std::uint64_t>()>;

// Computes the chunks whose numbers next() gives, on `threads` threads; 0 means as many as the
// machine has. It ends when next() gives no more numbers, or when stopped(), which it asks many
// times a second, is true; chunks that are not finished are then lost. Any of these threads calls
// keep(chunk), several of them at once. An exception of next(), of keep() or of the solver ends the
// work, and compute() throws it to its caller. Returns the number of threads, which is smaller
// where the system does not allow so many.
int compute(const SweepPlan& plan, int threads, const NextChunk& next,
            const std::function<void(const Chunk&)>& keep,
            const std::function<bool()>& stopped = {});

}  // namespace tribo::sweep
