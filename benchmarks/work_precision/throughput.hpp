// SPDX-License-Identifier: Apache-2.0
// How fast the batches are: against their size, against threads, and against what the memory gives
// in the same run.
#pragma once

#include "work_precision/effort.hpp"
#include "work_precision/table.hpp"

namespace tribo::benchmarks {

// kernel, points, ns, points_per_second, bytes, gigabytes_per_second, share_of_copy
Rows throughput_by_size(const Effort& effort);

// kernel, threads, points_per_second, gigabytes_per_second, speedup; wall time.
Rows throughput_by_threads(const Effort& effort);

}  // namespace tribo::benchmarks
