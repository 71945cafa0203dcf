// SPDX-License-Identifier: Apache-2.0
// Measures the speed of somebody's solver (a subject or a plug-in), or of two solvers in turns,
// each beside a control. This does not need the program tribocheck_bench.
#pragma once

#include <string>
#include <vector>

#include "bench_rows.hpp"

namespace tribo::cli {

struct SolverRun {
  std::vector<std::string> solvers;  // one or two; the second is the base
  bool are_plugins = false;          // else command lines
  bool is_quick = false;
  double timeout = 1800;  // s, of the whole run
};

// A row for each solver and each function that it offers, if `is_asked` takes the row of one of the
// solvers. Throws std::invalid_argument if it takes no row, and conformance::SolverFailed.
BenchResults measure_solvers(const SolverRun& run, const IsAsked& is_asked);

}  // namespace tribo::cli
