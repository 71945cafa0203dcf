// SPDX-License-Identifier: Apache-2.0
// Registers benchmarks named "workload/contender" with Google Benchmark: whole sweeps, the work
// that no sweep can avoid, and the stages of a sweep. The counter `points` says how many points an
// iteration has.
#pragma once

#include <string_view>

namespace tribo::benchmarks {

// The contender that does only the work that no sweep can avoid. The other contenders are compared
// with its CPU time on one thread.
inline constexpr std::string_view alone = "alone";
// A counter that only contenders on threads have. They are judged by real time.
inline constexpr std::string_view threads_counter = "threads";

void register_sweeps();

}  // namespace tribo::benchmarks
