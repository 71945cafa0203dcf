// SPDX-License-Identifier: Apache-2.0
// Chunks by their numbers: cases, columns, summaries, packed values.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sweep/chunk.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// Not for two threads at once: each has its own. The plan must outlive it.
class ChunkSolver {
 public:
  // stopped: asked many times a second while a chunk is solved; once it is true, solve() throws
  // Stopped.
  explicit ChunkSolver(const SweepPlan& plan, std::function<bool()> stopped = {});
  ChunkSolver(ChunkSolver&&) noexcept;
  ~ChunkSolver();

  // number: below plan.chunks(). The same bits wherever, whenever and beside whatever it is
  // computed, with one arithmetic.
  Chunk solve(std::uint64_t number);

 private:
  struct OfScene;

  const SweepPlan& plan_;
  std::function<bool()> stopped_;
  std::vector<std::unique_ptr<OfScene>> scenes_;  // made when first asked for
};

}  // namespace tribo::sweep
