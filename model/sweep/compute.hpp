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

// Computes the chunks that next() gives, on `threads` threads, until it gives no more. Any of these
// threads calls keep(chunk), several of them at once; an exception of keep() ends the work and is
// thrown on.
void compute(const SweepPlan& plan, int threads, const NextChunk& next,
             const std::function<void(const Chunk&)>& keep);

}  // namespace tribo::sweep
