// SPDX-License-Identifier: Apache-2.0
// Chunks by their numbers: cases, columns, summaries, packed values.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sweep/chunk.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// Two threads must not use one solver at once: each thread has its own. The plan must outlive it.
class ChunkSolver {
 public:
  // stopped() is asked many times a second while a chunk is solved; once it gives true, solve()
  // throws Stopped.
  explicit ChunkSolver(const SweepPlan& plan, std::function<bool()> stopped = {});
  ~ChunkSolver();

  // number: below plan.chunks(). The bits of a chunk depend on the plan and the arithmetic alone,
  // not on the machine, the threads or other chunks.
  Chunk solve(std::uint64_t number);

 private:
  struct OfScene;

  const SweepPlan& plan_;
  std::function<bool()> stopped_;
  std::vector<std::unique_ptr<OfScene>> scenes_;  // made when first asked for
};

// Gives the next chunk for a thread; nothing where no chunk is left. Any thread may call.
using NextChunk = std::function<std::optional<std::uint64_t>()>;

// Computes the chunks that next() gives, on `threads` threads (0: as many as the machine has),
// until it gives no more, or until stopped(), which is asked many times a second, is true: chunks
// in hand are given up then. Any of these threads calls keep(chunk), several of them at once; an
// exception of keep() ends the work and is thrown on. Returns how many threads there were: fewer
// where the system does not allow so many.
int compute(const SweepPlan& plan, int threads, const NextChunk& next,
            const std::function<void(const Chunk&)>& keep,
            const std::function<bool()>& stopped = {});

}  // namespace tribo::sweep
