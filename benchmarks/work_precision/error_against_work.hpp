// SPDX-License-Identifier: Apache-2.0
// True error against CPU time and evaluations, every contender from coarse to fine.
#pragma once

#include <vector>

#include "cases/measured.hpp"
#include "work_precision/effort.hpp"
#include "work_precision/table.hpp"

namespace tribo::benchmarks {

// job, family, series, name, ns, evaluations, max_ulp, p99_ulp, mean_ulp, failures,
// no_numbers, judged; of all contenders, and of others besides.
Rows errors_against_work(const Effort& effort, std::vector<Measured> others = {});

// Greatest error of each way to F_{5/2} in ulp, by ranges of d.
Rows errors_by_range();

}  // namespace tribo::benchmarks
