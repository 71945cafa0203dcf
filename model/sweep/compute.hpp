// SPDX-License-Identifier: Apache-2.0
// The threads of one process at work on chunks.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sweep/chunk.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// The next chunk for a thread; nothing: no more. Any thread may ask.
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
