// SPDX-License-Identifier: Apache-2.0
// A contender as a Google Benchmark "job/family/name".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/jobs.hpp"

namespace tribo::benchmarks {

void register_benchmark(Measured measured);
// "job/family/name" of all that were registered.
const std::vector<std::string>& registered_names();
// One line on stderr that each step overwrites, where a person watches; empty: wipes the line.
void show_progress(std::string_view step);

}  // namespace tribo::benchmarks
