// SPDX-License-Identifier: Apache-2.0
// A contender as a Google Benchmark "job/family/name".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/jobs.hpp"

namespace tribo::benchmarks {

void register_benchmark(Measured measured);
// The names "job/family/name" of all registered contenders.
const std::vector<std::string>& registered_names();
// A line on stderr that each step overwrites, shown on a terminal only; empty: wipes the line.
void show_progress(std::string_view step);

}  // namespace tribo::benchmarks
