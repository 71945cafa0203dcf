// SPDX-License-Identifier: Apache-2.0
// tribocheck sweep diff: two results side by side.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "messages.hpp"

namespace tribo::cli {

struct SweepDiffArguments {
  std::vector<std::string> files;  // two results
  std::string format = "table";
  double tolerance = 0;
  std::size_t most = 20;
};

// Adds the subcommand to `tribocheck sweep`.
CLI::App* add_sweep_diff(CLI::App& sweep, SweepDiffArguments& arguments);

// Returns the exit code. Throws what sweep::compare_results() throws.
int diff_sweeps(const SweepDiffArguments& arguments, OutputStream& output);

}  // namespace tribo::cli
