// SPDX-License-Identifier: Apache-2.0
// The threads of one process at work on chunks.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "sweep/chunk.hpp"
#include "sweep/plan.hpp"
#include "sweep/ranks.hpp"

namespace tribo::sweep {

// How many threads `threads` means, of which 0 is as many as the machine has.
int thread_count(int threads);

// Computes what next() gives, on so many threads, until it gives nothing. keep(chunk) is called by
// any of them, by several at once; what it throws ends the work and is thrown on.
void compute(const SweepPlan& plan, int threads, const NextChunk& next,
             const std::function<void(const Chunk&)>& keep);

}  // namespace tribo::sweep
