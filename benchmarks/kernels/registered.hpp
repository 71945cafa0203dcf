// SPDX-License-Identifier: Apache-2.0
// A contender as a Google Benchmark "job/family/name".
#pragma once

#include <string>
#include <vector>

#include "cases/measured.hpp"

namespace tribo::benchmarks {

void register_benchmark(Measured measured);
// "job/family/name" of all that were registered.
const std::vector<std::string>& registered_names();

}  // namespace tribo::benchmarks
