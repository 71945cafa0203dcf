// SPDX-License-Identifier: Apache-2.0
// Registers with Google Benchmark, under the names "sweep/contender", whole sweeps, the work that
// no sweep can avoid, and the stages of a sweep. The counter `points` says how many points an
// iteration has.
#pragma once

#include <string_view>

namespace tribo::benchmarks {

// The contender that does only the work that no sweep can avoid: the others are compared with its
// CPU time on one thread.
inline constexpr std::string_view alone = "alone";
// The counter of a contender that runs on several threads, which is judged by real time.
inline constexpr std::string_view threads_counter = "threads";

void register_sweeps();

}  // namespace tribo::benchmarks
