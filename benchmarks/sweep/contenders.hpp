// SPDX-License-Identifier: Apache-2.0
// A sweep, the work that no sweep can avoid, and the sweep's stages, as Google Benchmarks
// "sweep/contender". The counter `points` says how many points an iteration has.
#pragma once

#include <string_view>

namespace tribo::benchmarks {

// Contenders by CPU time of one thread; `stages` are those of the profile.
inline constexpr std::string_view alone = "alone";
// The counter of threads; the whole sweep on threads is judged by real time.
inline constexpr std::string_view threads_counter = "threads";

void register_sweeps();

}  // namespace tribo::benchmarks
